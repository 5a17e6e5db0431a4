// What the search for leaks has to know about graphics drivers.
#pragma once

namespace carom::gallery
{

/// In builds with the address sanitizer, keeps all libraries that are loaded now until the process ends: what a driver holds when it is unloaded
/// would count as a leak of nobody's. Elsewhere it does nothing.
void keep_libraries_loaded();

} // namespace carom::gallery
