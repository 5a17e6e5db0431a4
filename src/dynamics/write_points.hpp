// Writes what the narrow phase found into a contact's manifold, and matches new points with old ones.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "geometry/manifold.hpp"

#include <array>
#include <cstdint>

namespace carom::detail
{

/// Gives the manifold the features of new points. Points that go on keep the impulses of the old point that the same features made.
/// @param features of `count` points
inline void match_points(ContactManifold& manifold, int count, const std::array<std::uint32_t, 2>& features)
{
    const auto goes_on = [&](std::size_t i) { return manifold.features[i] == features[i]; };
    if (manifold.count == count && goes_on(0) && (count == 1 || goes_on(1))) return;
    const ContactManifold old = manifold;
    const auto impulse_of = [&](std::uint32_t feature) -> ContactImpulse
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(old.count); ++i)
            if (old.features[i] == feature) return old.impulses[i];
        return {};
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
        manifold.features[i] = features[i];
        manifold.impulses[i] = impulse_of(features[i]);
    }
    manifold.count = count;
}

/// Writes a contact as it is now.
inline void write(ContactManifold& manifold, const LocalManifold& local, const BodyPose& pose_a, const BodyPose& pose_b)
{
    manifold.has_result = false;
    manifold.normal = rotate(pose_a.transform.q, local.normal);
    if (local.count == 0)
    {
        manifold.count = 0;
        manifold.rolling_impulse = manifold.carried_impulse = 0;
        return;
    }
    match_points(manifold, local.count, {local.points[0].feature, local.points[1].feature});
    manifold.center_a = pose_a.center;
    const Vec2 centers = pose_b.center - pose_a.center;
    for (std::size_t i = 0; i < static_cast<std::size_t>(local.count); ++i)
    {
        ContactArms& arms = manifold.arms[i];
        arms.r_a = rotate(pose_a.transform.q, local.points[i].position - pose_a.local_center);
        arms.r_b = arms.r_a - centers;
        manifold.separation[i] = local.points[i].separation;
    }
}

} // namespace carom::detail
