// Asks for memory that will be read or written soon, where the processor cannot guess it.
#pragma once

#include <cstddef>

namespace carom::detail
{

/// Begins to bring all lines of an object into the cache. Only worth it some objects ahead of their use.
template <class T>
void fetch_lines(const T& object)
{
    constexpr std::size_t line = 64;
    const auto* const bytes = reinterpret_cast<const std::byte*>(&object);
    for (std::size_t i = 0; i < sizeof(T); i += line) __builtin_prefetch(bytes + i);
    if (alignof(T) < line) __builtin_prefetch(bytes + sizeof(T) - 1); // it may begin in the middle of a line
}

} // namespace carom::detail
