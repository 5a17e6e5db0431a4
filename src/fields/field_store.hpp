// The gravity fields of a world, and the acceleration that they give to its bodies.
#pragma once

#include "dynamics/body_store.hpp"
#include "fields/gravity.hpp"

#include <carom/fields.hpp>

#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Fields by slot.
struct FieldStore
{
    explicit FieldStore(std::pmr::memory_resource& memory) : slots(memory), fields(&memory) {}

    SlotPool slots;
    std::pmr::vector<Field> fields;
};

/// Evaluates fields where the bodies are within a step.
class FieldForces
{
public:
    explicit FieldForces(std::pmr::memory_resource& memory);

    /// @param is_new_step no: the bodies are those of the last call, with their masses, and have moved within a step
    /// @param passes of the instruction set that the world uses
    /// @return acceleration by motion index [m/s^2], before each body's gravity scale; empty when there is no field. Valid until the next call.
    std::span<const Vec2> at_bodies(const FieldStore& fields, const BodyStore& bodies, const PullPasses& passes, bool is_new_step);

    /// Acceleration at one point, all sources included [m/s^2].
    static Vec2 at_point(const FieldStore& fields, const BodyStore& bodies, Vec2 point);

private:
    void list_sources(NBodySources which, const BodyStore& bodies);
    void place_sources(const BodyStore& bodies);

    std::pmr::vector<Vec2> targets_;
    std::pmr::vector<Vec2> acceleration_;
    std::pmr::vector<std::uint32_t> source_slots_;
    std::pmr::vector<Vec2> source_positions_;
    std::pmr::vector<float> source_masses_;
    NBodySolver n_body_;
};

} // namespace carom::detail
