// From boxes that overlap to contacts: asks the broad phase, and keeps the pairs that may meet and are new.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "broadphase/pair_set.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"

#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// Whether a pair of shapes makes a contact, and whether that is a sensor's.
struct PairVerdict
{
    bool makes_contact = false;
    bool is_sensor = false;
};

/// Decides by bodies, types, flags, filters and joints; everything about two shapes but where they are.
PairVerdict judge_pair(const ShapeStore& shapes, const BodyStore& bodies, const JointStore& joints, ProxyPair pair);

/// What a search for pairs has come to.
struct PairSearch
{
    bool has_idle = false;      ///< a new contact is between bodies of which none is active: it is awake all the same, to be looked at once
    bool is_over_limit = false; ///< there would be more pairs than most_pairs: nothing was done
    std::uint32_t crowded_shape = null_index; ///< then, the shape of a dynamic body that is in the most of them
    std::uint32_t crowd = 0;                  ///< and in how many of those that were counted
};

/// How many pairs of near shapes a world may have.
std::size_t most_pairs(const ContactRules& rules, const ShapeStore& shapes);

/// Finds the pairs of the shapes that moved and makes contacts of the new ones, ordered by shape, so that the broad phase does not show.
/// Changes nothing when there would be more pairs than the rules allow.
/// @param known pairs that are contacts already; grows by the new ones
/// @param scratch for the list of pairs
PairSearch find_pairs(BroadPhase& broad_phase, ShapeStore& shapes, BodyStore& bodies, const JointStore& joints, ContactStore& contacts,
                      PairSet& known, const ContactRules& rules, std::pmr::memory_resource& scratch);

} // namespace carom::detail
