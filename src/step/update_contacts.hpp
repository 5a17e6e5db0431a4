// The stage of a step that brings contacts up to date: their points, whom they wake, who is in an island with whom, what the solver works on.
#pragma once

#include "broadphase/pair_set.hpp"
#include "dynamics/contact_rules.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/isa/touch_passes.hpp"
#include "state/event_buffers.hpp"
#include "state/wake_graph.hpp"

#include <cstdint>
#include <memory_resource>

namespace carom::detail
{

/// What contacts are made of, and where their ends go.
struct ContactStage
{
    const TouchPasses& passes; ///< of the world's instruction set
    WakeGraph graph;
    ShapeStore& shapes;
    PairSet& pairs;
    EventBuffers& events;
    const ContactRules& rules;
    std::uint64_t step_count; ///< steps before this one
};

/// Collides what is awake, and what that wakes in turn, so that an island which is hit is whole, and held together by its contacts, in the step
/// in which it is hit. Contacts between sleepers are looked at once, when they are new: they join the sleepers' islands, and wake no one.
void update_contacts(const ContactStage& stage, std::pmr::memory_resource& scratch);

} // namespace carom::detail
