// Why the gallery can't go on.
#pragma once

#include <stdexcept>

namespace carom::gallery
{

/// Something outside of the program failed: a display, a graphics driver, a disk. The words say to a person what it was and what helps.
struct Failure : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

} // namespace carom::gallery
