// The pull of what is far, as a Taylor series about the middle of the points where it is asked for. Offsets count in units of half the longer side
// of the box around the points, so that no term overflows where the pull itself does not.
#pragma once

#include "fields/kernels/pull.hpp"

#include <carom/math.hpp>

namespace carom::detail
{

/// About the middle of a box, without terms.
LocalPull series_around(const Aabb& box);
/// The field of a series, as one about another place.
/// @param child without terms, within the box of the parent
void inherit(LocalPull& child, const LocalPull& parent);

} // namespace carom::detail
