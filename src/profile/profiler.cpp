// The back ends' names.
#include <carom/profile.hpp>

namespace carom
{

std::string_view name_of(Profiler profiler)
{
    switch (profiler)
    {
    case Profiler::None: return "none";
    case Profiler::Tracy: return "tracy";
    case Profiler::Chrome: return "chrome";
    }
    return "?";
}

} // namespace carom
