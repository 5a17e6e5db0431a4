// Contacts of shapes with faces that are known and face each other: a block of them is updated several at once.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "geometry/isa/touch_passes.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

class KnownContacts
{
public:
    static constexpr std::uint8_t no_place = 255;

    /// @param passes of the world's instruction set
    KnownContacts(const TouchPasses& passes, const TouchLimits& limits) : passes_(passes) { batch_.limits = limits; }

    void clear() { batch_.count = 0; }
    /// @return where the contact stands in the block, or no_place when it is none of these
    std::uint8_t add(std::uint32_t slot, const ContactStore& contacts);
    /// Writes the manifolds of those whose memory still holds and whose points lie along the faces.
    void update(const BodyStore& bodies, ContactStore& contacts);
    /// @param place as add() gave it
    bool is_updated(std::uint8_t place) const { return place != no_place && (results_.are_known >> place & 1) != 0; }

private:
    void write(ContactManifold& manifold, const CollisionMemory& memory, std::size_t place, Vec2 center_a) const;

    const TouchPasses& passes_;
    TouchBatch batch_;
    TouchResults results_;
};

} // namespace carom::detail
