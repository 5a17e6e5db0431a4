// Chains: what their segments have in common. The segments are shapes, linked to their neighbours in the shape store.
#pragma once

#include "dynamics/slot_pool.hpp"
#include "memory/make_room.hpp"

#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

struct ChainRecord
{
    std::uint32_t body = null_index;
    std::uint32_t first_shape = null_index; ///< follow ShapeRecord::next_in_chain; a loop's last segment leads back to it
    std::uint32_t segment_count = 0;
    bool is_loop = false;
    bool is_one_sided = false;
    std::uint64_t user_data = 0;
};

/// All chains of a world, by slot.
class ChainStore
{
public:
    explicit ChainStore(std::pmr::memory_resource& memory) : slots(memory), records(&memory) {}

    /// Changes nothing when memory runs out.
    std::uint32_t create(const ChainRecord& record)
    {
        make_room(records, records.size() + 1);
        const std::uint32_t slot = slots.acquire();
        if (slot == records.size()) records.emplace_back();
        records[slot] = record;
        return slot;
    }
    void destroy(std::uint32_t slot) { slots.release(slot); }
    /// Gives back the memory of what lies behind the last chain, and spare room.
    void shrink()
    {
        slots.drop_tail();
        cut(records, slots.size());
    }

    SlotPool slots;
    std::pmr::vector<ChainRecord> records;
};

} // namespace carom::detail
