// Islands: sets of dynamic bodies that touch each other or are joined, and so come to rest together.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/joint_store.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

struct Island
{
    std::uint32_t first_body = null_index; ///< a list through BodyRecord
    std::uint32_t last_body = null_index;
    std::uint32_t body_count = 0;
    std::uint32_t place_in_awake = null_index; ///< null_index while it sleeps
    bool lost_links = false;                   ///< may have come apart since it was made
    bool is_restless = false;                  ///< scratch of the sleep stage
};

/// Islands persist from step to step. A new link merges two at once; a lost one only marks the island, which is taken apart when one of its
/// bodies would like to sleep: until then it does no harm to have it too large.
class IslandStore
{
public:
    explicit IslandStore(std::pmr::memory_resource& memory) : slots_(memory), islands_(&memory), awake_(&memory), stack_(&memory) {}

    /// Room for as many islands as bodies, so that none of the calls below allocates.
    void make_room_for(std::size_t bodies);
    /// Gives back the memory of what lies behind the last island, and spare room but for as many islands as bodies.
    void shrink(std::size_t bodies);

    /// A dynamic body becomes an island of its own, awake.
    void add(std::uint32_t body, BodyStore& bodies);
    /// The body has no links any more.
    void remove(std::uint32_t body, BodyStore& bodies);
    /// A link between two dynamic bodies: their islands become one. Both are awake, or both asleep.
    void link(std::uint32_t a, std::uint32_t b, BodyStore& bodies);
    /// A link between two dynamic bodies is gone.
    void unlink(std::uint32_t a, std::uint32_t b, const BodyStore& bodies);

    void mark_asleep(std::uint32_t island);
    void mark_awake(std::uint32_t island);
    bool is_awake(std::uint32_t island) const { return islands_[island].place_in_awake != null_index; }

    /// Makes islands of the parts that no link holds together any more.
    void split(std::uint32_t island, BodyStore& bodies, const ContactStore& contacts, const JointStore& joints);

    std::span<const std::uint32_t> awake() const { return awake_; }
    Island& operator[](std::uint32_t island) { return islands_[island]; }
    const Island& operator[](std::uint32_t island) const { return islands_[island]; }
    int count() const { return slots_.live_count(); }
    std::uint32_t size() const { return slots_.size(); }
    bool is_live(std::uint32_t island) const { return slots_.is_live(island); }

private:
    std::uint32_t create();
    void destroy(std::uint32_t island);
    void append(std::uint32_t island, std::uint32_t body, BodyStore& bodies);
    void unchain(std::uint32_t island, std::uint32_t body, BodyStore& bodies);

    SlotPool slots_;
    std::pmr::vector<Island> islands_;
    std::pmr::vector<std::uint32_t> awake_;
    std::pmr::vector<std::uint32_t> stack_; ///< scratch of split()
};

} // namespace carom::detail
