// Counts what a whole program takes from the heap. Counting needs operator new for itself, so the tests that use it are a program of their own.
#pragma once

#include <cstddef>

namespace carom
{

/// Calls of operator new since the program began, in any thread.
std::size_t heap_allocations();
/// Bytes from operator new that are in use.
std::size_t heap_bytes();
/// Starts to watch for heap_peak().
void watch_heap_peak();
/// The most bytes that were in use at a time since watch_heap_peak().
std::size_t heap_peak();

} // namespace carom
