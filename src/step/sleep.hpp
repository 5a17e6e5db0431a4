// The stage of a step that puts islands to sleep.
#pragma once

#include "fields/field_store.hpp"
#include "state/event_buffers.hpp"
#include "state/wake_graph.hpp"

#include <carom/world.hpp>

#include <cstdint>

namespace carom::detail
{

/// What the stage asks of the step that it is in.
struct SleepMoment
{
    bool is_allowed;          ///< lets_sleep()
    float rest_time;          ///< how long a body has to be slow [s]
    bool must_review;         ///< contacts may be awake of which no body is
    std::uint64_t step_count; ///< steps before this one
    std::uint32_t world;      ///< the number that ids carry
};

/// Puts islands to sleep that have been slow for long enough, and takes apart one that no longer hangs together.
void put_islands_to_sleep(const WakeGraph& graph, EventBuffers& events, const SleepMoment& now);

/// Whether bodies fall asleep at all.
bool lets_sleep(const SleepTuning& tuning, const FieldStore& fields);

} // namespace carom::detail
