// Places of a store: which are taken, which are free, and by which generation of tenant.
#pragma once

#include "memory/make_room.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// No place, no neighbour.
inline constexpr std::uint32_t null_index = std::numeric_limits<std::uint32_t>::max();
/// A number of steps that no world reaches.
inline constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

/// Hands out indices 0, 1, 2, ... and takes them back. The next one is the one that came back last. An index whose generations
/// are used up never comes again, so an old id can't name a new tenant. Nor can it after drop_tail(): indices that come anew begin
/// above all generations that were dropped.
class SlotPool
{
public:
    explicit SlotPool(std::pmr::memory_resource& memory) : slots_(&memory) {}

    std::uint32_t acquire()
    {
        if (first_free_ == null_index)
        {
            slots_.push_back({.generation = dropped_generation_ + 1, .is_live = true}); // may throw: nothing has changed before
            ++live_count_;
            return static_cast<std::uint32_t>(slots_.size() - 1);
        }
        const std::uint32_t index = first_free_;
        Slot& slot = slots_[index];
        first_free_ = slot.next_free;
        ++slot.generation;
        slot.is_live = true;
        ++live_count_;
        return index;
    }

    void release(std::uint32_t index)
    {
        --live_count_;
        Slot& slot = slots_[index];
        slot.is_live = false;
        if (slot.generation == std::numeric_limits<std::uint32_t>::max()) return;
        slot.next_free = first_free_;
        first_free_ = index;
    }

    bool is_live(std::uint32_t index) const { return index < slots_.size() && slots_[index].is_live; }
    bool is_live(std::uint32_t index, std::uint32_t generation) const { return is_live(index) && slots_[index].generation == generation; }
    std::uint32_t generation(std::uint32_t index) const { return slots_[index].generation; }
    /// The place that acquire() takes next, and the one after a free place; null_index at the end.
    std::uint32_t first_free() const { return first_free_; }
    std::uint32_t next_free(std::uint32_t index) const { return slots_[index].next_free; }

    /// One past the highest index ever handed out; arrays beside the pool have this length.
    std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
    int live_count() const { return live_count_; }
    void reserve(std::size_t count) { slots_.reserve(count); }
    /// Whether the id named something once, and no longer does.
    bool was_live(std::uint32_t index, std::uint32_t generation) const
    {
        return generation <= (index < slots_.size() ? slots_[index].generation : dropped_generation_) && !is_live(index, generation);
    }
    /// The highest generation among the places that drop_tail() took off.
    std::uint32_t dropped_generation() const { return dropped_generation_; }

    /// Takes off the free places behind the last one in use, and gives their memory back. The other free places keep their order.
    void drop_tail()
    {
        std::size_t size = slots_.size();
        while (size > 0 && !slots_[size - 1].is_live && slots_[size - 1].generation < std::numeric_limits<std::uint32_t>::max())
            dropped_generation_ = std::max(dropped_generation_, slots_[--size].generation);

        std::uint32_t* link = &first_free_;
        for (std::uint32_t place = first_free_; place != null_index; place = slots_[place].next_free)
        {
            if (place >= size) continue;
            *link = place;
            link = &slots_[place].next_free;
        }
        *link = null_index;
        cut(slots_, size);
    }
    /// So that acquire() does not allocate up to this size.
    void make_room(std::size_t size) { detail::make_room(slots_, size); }

private:
    struct Slot
    {
        std::uint32_t generation = 0;
        std::uint32_t next_free = null_index;
        bool is_live = false;
    };

    std::pmr::vector<Slot> slots_;
    std::uint32_t first_free_ = null_index;
    std::uint32_t dropped_generation_ = 0;
    int live_count_ = 0;
};

} // namespace carom::detail
