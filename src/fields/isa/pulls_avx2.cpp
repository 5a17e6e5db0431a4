// Eight lanes. Compiled for AVX2.
#include "math/wide_lanes.hpp"

#include "fields/isa/pull_passes_impl.hpp"

#if defined(__x86_64__)

namespace carom::detail
{

const PullPasses& avx2_pull_passes() { return pull_passes<Lanes<8>>; }

} // namespace carom::detail

#endif
