// Counts the heap allocations of the whole program. Linked into the program alone: it replaces operator new for everyone.
#pragma once

#include <cstdint>

namespace carom::cli
{

/// Calls of operator new since the program started, by all threads.
std::uint64_t heap_allocations();

} // namespace carom::cli
