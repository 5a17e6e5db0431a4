// Random calls to a world, good and bad, with every promise about bad ones checked as they are made.
#pragma once

#include <carom/carom.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <optional>
#include <vector>

namespace carom::fuzz
{

/// Uniform numbers, the same everywhere (SplitMix64).
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    float from(float min, float max) { return min + (max - min) * static_cast<float>(bits() >> 40) / 16777216.0f; }

private:
    std::uint64_t state_;
};

/// A memory resource that calls back from inside an allocation: the one way into a world's step from outside.
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

/// How the calls of a run ended.
struct Tally
{
    int calls = 0;
    int refused = 0;     ///< threw UsageError
    int during_step = 0; ///< of those, edits from inside a step
    int quarantined = 0; ///< bodies that steps reported
    int most_bodies = 0;
    int most_chains = 0;
    int hook_calls = 0;
    int most_joints = 0;
    int breaks = 0; ///< joints that steps broke
};

/// Makes random calls to one world.
class RandomApi
{
public:
    explicit RandomApi(std::uint64_t seed);

    /// Makes one call. Failed promises are reported through GoogleTest.
    void call();
    Tally tally() const;

private:
    float number(float min, float max); ///< now and then a nasty one
    Vec2 vector(float size);
    Geometry geometry();
    BodyDef body_def();
    ShapeDef shape_def();
    Field field();
    std::optional<Spring> spring();
    std::optional<Range> range();
    std::optional<Motor> motor();
    JointSpec joint_spec();
    JointDef joint_def();
    BodyId body_id(); ///< now and then stale, null or of another world
    ShapeId shape_id();
    FieldId field_id();
    ChainId chain_id();
    JointId joint_id();

    template <class Call>
    void try_call(const char* function, Call&& call);
    void must_refuse(); ///< a call that is wrong beyond doubt

    void create();
    void destroy();
    void edit_body();
    void push_body();
    void edit_shape();
    void make_chain();
    void edit_chain();
    void edit_rules();
    void create_joint();
    void edit_joint();
    void edit_world();
    void read();
    void query();
    void cast();
    void walk();
    QueryFilter query_filter();
    Transform transform();
    void step();
    void edit_during_step();

    Random random_;
    Hook hook_;
    RandomHooks hooks_;
    World world_;
    World other_;
    BodyId foreign_;
    std::vector<BodyId> bodies_; ///< stale ones stay in
    std::vector<ShapeId> shapes_;
    std::vector<FieldId> fields_;
    std::vector<ChainId> chains_;
    Character character_;
    std::vector<JointId> joints_;
    Tally tally_;
};

} // namespace carom::fuzz
