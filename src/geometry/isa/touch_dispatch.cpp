// From an instruction set to its passes.
#include "geometry/isa/touch_passes.hpp"

namespace carom::detail
{

const TouchPasses& touch_passes_of(Simd simd)
{
    switch (simd)
    {
#if defined(__x86_64__)
    case Simd::Avx512:
    case Simd::Avx2: return avx2_touch_passes();
#endif
    case Simd::Scalar: return scalar_touch_passes();
    default: return four_lane_touch_passes();
    }
}

} // namespace carom::detail
