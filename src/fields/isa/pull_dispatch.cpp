// From an instruction set to its passes.
#include "fields/isa/pull_passes.hpp"

namespace carom::detail
{

const PullPasses& pull_passes_of(Simd simd)
{
    switch (simd)
    {
#if defined(__x86_64__)
    case Simd::Avx512:
    case Simd::Avx2: return avx2_pull_passes();
#endif
    case Simd::Scalar: return scalar_pull_passes();
    default: return four_lane_pull_passes();
    }
}

} // namespace carom::detail
