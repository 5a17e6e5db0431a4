// Lets the user's hooks see each contact before it is solved.
#pragma once

#include "dynamics/contact_rules.hpp"
#include "dynamics/narrow_phase.hpp"

namespace carom::detail
{

/// Calls ContactHooks::pre_solve for every contact with points that asks for it and is awake. A disabled contact loses its points for
/// this step, and the lists of changes follow.
/// @param first where in the list of awake contacts to begin
void ask_pre_solve(const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts, const ContactRules& rules, std::size_t first,
                   ContactChanges& changes);

} // namespace carom::detail
