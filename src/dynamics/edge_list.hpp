// The lists of what lies between two bodies: a body's contacts, a body's joints.
//
// Each item stands in two lists, that of its body A and that of its body B. Edge 2 i is item i in the list of its body A, edge 2 i + 1
// in that of its body B; `previous[side]` and `next[side]` of an item are the neighbours of its edge, and are edges themselves.
#pragma once

#include "dynamics/slot_pool.hpp"

#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// Puts an edge at the head of a list.
/// @param first the head: an edge, or null_index
template <class Item>
void link_edge(std::pmr::vector<Item>& items, std::uint32_t edge, std::uint32_t& first)
{
    items[edge / 2].previous[edge % 2] = null_index;
    items[edge / 2].next[edge % 2] = first;
    if (first != null_index) items[first / 2].previous[first % 2] = edge;
    first = edge;
}

/// Takes an edge out of the list that it is in.
template <class Item>
void unlink_edge(std::pmr::vector<Item>& items, std::uint32_t edge, std::uint32_t& first)
{
    const std::uint32_t previous = items[edge / 2].previous[edge % 2];
    const std::uint32_t next = items[edge / 2].next[edge % 2];
    if (previous != null_index)
        items[previous / 2].next[previous % 2] = next;
    else
        first = next;
    if (next != null_index) items[next / 2].previous[next % 2] = previous;
}

} // namespace carom::detail
