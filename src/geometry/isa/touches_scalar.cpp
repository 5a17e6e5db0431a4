// One lane: the reference.
#include "geometry/isa/touch_passes_impl.hpp"

namespace carom::detail
{

const TouchPasses& scalar_touch_passes() { return touch_passes<float>; }

} // namespace carom::detail
