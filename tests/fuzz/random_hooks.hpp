// Ways into a world's step from outside: an allocation, and the contact hooks.
#pragma once

#include "tests/fuzz/random.hpp"

#include <carom/carom.hpp>

#include <memory_resource>

namespace carom::fuzz
{

/// Every part of the message is there, and it is in the name of the function that was called.
void expect_complete(const UsageError& error, const char* function);

/// A memory resource that calls back from inside an allocation.
class Hook : public std::pmr::memory_resource
{
public:
    void (*action)(void*) = nullptr;
    void* argument = nullptr;

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override
    {
        if (action) action(argument);
        return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override
    {
        std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

/// Looks at a world from all sides, and expects what it is shown to exist.
class CuriousVisitor : public DebugDraw
{
public:
    explicit CuriousVisitor(const World& world) : world_(world) {}

    void shape(ShapeId id, BodyId body, const Geometry& geometry, const Transform& transform) override;
    void bounds(ShapeId id, const Aabb& tight, const Aabb& fat) override;
    void body(const DebugBody& body) override;
    void pair(ShapeId a, ShapeId b, bool is_new) override;
    void contact(const DebugContact& contact) override;
    void joint(const DebugJoint& joint) override;
    void broad_phase_node(const Aabb& bounds, int depth) override;

private:
    const World& world_;
};

/// Looks at some stages of a step, and tries to edit the world in others.
class RandomProbe : public StepProbe
{
public:
    RandomProbe(World& world, std::uint64_t seed) : world_(world), random_(seed) {}

    int refused = 0; ///< edits

    void after_stage(const StepMoment& moment, const StepView& view) override;

private:
    World& world_;
    Random random_;
};

/// Hooks that answer at random, now and then with nonsense, and try to edit the world that calls them. Their own numbers, so that
/// the calls don't depend on how often they are asked.
class RandomHooks : public ContactHooks
{
public:
    explicit RandomHooks(std::uint64_t seed) : random_(seed) {}

    World* world = nullptr;
    int calls = 0;
    int refused = 0; ///< edits

    bool should_collide(ShapeId a, ShapeId b) override;
    float mix_friction(const Material& a, const Material& b, float mixed) override;
    float mix_restitution(const Material& a, const Material& b, float mixed) override;
    void pre_solve(PreSolve& contact) override;

private:
    float nonsense(float sense);
    void try_to_edit();

    Random random_;
};

} // namespace carom::fuzz
