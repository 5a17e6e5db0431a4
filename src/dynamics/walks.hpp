// The lists of a world, which are linked by index, as ranges for loops.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/island_store.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"

#include <cstdint>

namespace carom::detail
{

/// A list from its first index on. What comes next is read before a loop sees an index, so that the loop may end what it sees.
/// @tparam Next the index after one, null_index after the last
/// @tparam Show what the loop sees of an index
template <class Next, class Show>
class IndexList
{
public:
    struct End
    {
    };

    class Iterator
    {
    public:
        Iterator(const IndexList& list, std::uint32_t first) : list_(list) { go_to(first); }
        auto operator*() const { return list_.show_(at_); }
        Iterator& operator++()
        {
            go_to(next_);
            return *this;
        }
        bool operator!=(End) const { return at_ != null_index; }

    private:
        void go_to(std::uint32_t index)
        {
            at_ = index;
            next_ = index == null_index ? null_index : list_.next_(index);
        }

        const IndexList& list_;
        std::uint32_t at_ = null_index;
        std::uint32_t next_ = null_index;
    };

    IndexList(std::uint32_t first, Next next, Show show) : first_(first), next_(next), show_(show) {}
    Iterator begin() const { return {*this, first_}; }
    End end() const { return {}; }

private:
    std::uint32_t first_;
    Next next_;
    Show show_;
};

/// What ties a body to another: a contact or a joint.
struct Tie
{
    std::uint32_t slot;  ///< of the contact or joint
    std::uint32_t other; ///< body; null_index where a joint ties to the world
};

/// @param items contacts or joints
/// @param edge  the first, see dynamics/edge_list.hpp
template <class Items>
auto ties_from(const Items& items, std::uint32_t edge)
{
    return IndexList(edge, [&items](std::uint32_t e) { return items[e / 2].next[e % 2]; },
                     [&items](std::uint32_t e) { return Tie{e / 2, e % 2 == 0 ? items[e / 2].body_b : items[e / 2].body_a}; });
}

inline auto contacts_of(const BodyStore& bodies, const ContactStore& contacts, std::uint32_t body)
{
    return ties_from(contacts.contacts, bodies.records[body].first_contact);
}

inline auto joints_of(const BodyStore& bodies, const JointStore& joints, std::uint32_t body)
{
    return ties_from(joints.joints, bodies.records[body].first_joint);
}

/// Slots of a body's shapes.
inline auto shapes_of(const BodyStore& bodies, const ShapeStore& shapes, std::uint32_t body)
{
    return IndexList(bodies.records[body].first_shape, [&shapes](std::uint32_t shape) { return shapes.records[shape].next_of_body; },
                     [](std::uint32_t shape) { return shape; });
}

/// Slots of an island's bodies.
inline auto bodies_of(const BodyStore& bodies, const IslandStore& islands, std::uint32_t island)
{
    return IndexList(islands[island].first_body, [&bodies](std::uint32_t body) { return bodies.records[body].next_in_island; },
                     [](std::uint32_t body) { return body; });
}

} // namespace carom::detail
