// What decides who is awake.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/island_store.hpp"
#include "dynamics/joint_store.hpp"

namespace carom::detail
{

/// Bodies and what ties them together: waking and falling asleep spread along contacts, joints and islands.
struct WakeGraph
{
    BodyStore& bodies;
    ContactStore& contacts;
    JointStore& joints;
    IslandStore& islands;
};

} // namespace carom::detail
