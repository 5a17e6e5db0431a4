// One lane: the reference.
#include "fields/isa/pull_passes_impl.hpp"

namespace carom::detail
{

const PullPasses& scalar_pull_passes() { return pull_passes<float>; }

} // namespace carom::detail
