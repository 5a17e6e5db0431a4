// What a back end adds to <carom/profile.hpp> for the engine's own use. One of backend_none.cpp, backend_chrome.cpp and
// backend_tracy.cpp is built, as the CMake option CAROM_PROFILER says.
#pragma once

#include <carom/profile.hpp>

#include <chrono>

namespace carom::profile
{

// begin_zone and end_zone for who has read the clock already.
std::uint64_t begin_zone_at(const ZoneSite& site, std::chrono::steady_clock::time_point now);
void end_zone_at(const ZoneSite& site, std::uint64_t token, std::chrono::steady_clock::time_point now);

} // namespace carom::profile
