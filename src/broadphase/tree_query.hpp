// Queries of one tree of boxes.
#pragma once

#include "broadphase/box_tree.hpp"

namespace carom::detail
{

/// Visits the proxies whose boxes overlap the given one, those that wait to be built in among them. The tree is refit.
/// @return false when the visitor ended the query
bool query_tree(const BoxTree& tree, const Aabb& box, BoxVisitor& visitor);

/// Visits the proxies whose boxes the sweep meets up to the fraction that matters, nodes from the near to the far.
/// @return the fraction that matters for what is left to be asked
float query_tree(const BoxTree& tree, const BoxSweep& sweep, float most, SweepVisitor& visitor);

} // namespace carom::detail
