// By what this program was built, and from what.
#pragma once

#include <string>

namespace carom::lab::build_info
{

extern const char* const compiler; ///< "GNU 12.2.0"
extern const char* const flags;    ///< of the engine
/// Of the repository that this was built from, read now; "+" behind it when files were changed since. Empty when there is none.
std::string commit();

} // namespace carom::lab::build_info
