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
    /// @param passes of the world's instruction set
    /// @param slop   Tolerances::linear_slop [m]
    KnownContacts(const TouchPasses& passes, const TouchLimits& limits, float slop) : passes_(passes), slop_(slop)
    {
        batch_.limits = limits;
    }

    /// Adds a contact of a block when it is one of these.
    /// @param place its bit
    void add(std::size_t place, std::uint32_t slot, const BodyStore& bodies, const ContactStore& contacts);
    /// Writes the manifolds of those whose memory still holds and whose points lie along the faces, and forgets the block.
    /// @return the bits of these
    std::uint64_t update(const BodyStore& bodies, ContactStore& contacts);

private:
    void write(ContactManifold& manifold, const CollisionMemory& memory, std::size_t i, Vec2 center_a) const;

    const TouchPasses& passes_;
    float slop_;
    TouchBatch batch_;
    TouchResults results_;
    std::uint8_t places_[touch_batch]; ///< of the batch's contacts in the block
};

} // namespace carom::detail
