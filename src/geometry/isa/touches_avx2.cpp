// Eight lanes. Compiled for AVX2.
#include "math/wide_records.hpp"

#include "geometry/isa/touch_passes_impl.hpp"

#if defined(__x86_64__)

namespace carom::detail
{

const TouchPasses& avx2_touch_passes() { return touch_passes<Lanes<8>>; }

} // namespace carom::detail

#endif
