// Growing arrays ahead of a change, so that the change itself can't fail, and shrinking them after one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// Gives a list capacity for `size` elements; grows by half at least, so that growing one by one stays cheap. A change of several lists
/// calls this for each first: when memory runs out, nothing has changed yet.
template <class T>
void make_room(std::pmr::vector<T>& list, std::size_t size)
{
    if (list.capacity() < size) list.reserve(std::max(size, list.capacity() + list.capacity() / 2));
}

/// Takes off all elements from `size` on, and gives back what the list does not need any more.
template <class T>
void cut(std::pmr::vector<T>& list, std::size_t size)
{
    if (size < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(size), list.end());
    list.shrink_to_fit();
}

} // namespace carom::detail
