// What the moments of a step are called, what they are about, and what there is to count.
#pragma once

#include "gallery/step_film.hpp"

#include <string>

namespace carom::gallery
{

/// "solve, substep 2 of 4".
std::string title_of(const Moment& moment);
/// What the stage does, for someone who sees it for the first time.
std::string explanation_of(const Moment& moment);
/// What there is to count: "31 pairs, 4 of them new".
std::string counts_of(const Moment& moment);

} // namespace carom::gallery
