// Narrow phase: where two shapes touch, as at most two points with the features that made them.
#pragma once

#include "geometry/kernels/known_faces.hpp"
#include "geometry/tolerances.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <array>
#include <cstdint>

namespace carom::detail
{

/// One point of a local manifold.
struct LocalPoint
{
    Vec2 position;             ///< in A's frame, halfway between the surfaces [m]
    float separation = 0;      ///< negative when the shapes overlap [m]
    std::uint32_t feature = 0; ///< which corners or edges made the point
};

/// Where B touches A, in the frame of A's body.
struct LocalManifold
{
    Vec2 normal; ///< unit, from A to B, in A's frame
    std::array<LocalPoint, 2> points;
    int count = 0;
};

/// What collide() searches for, and what spares it the next search.
///
/// Of two polygons, or a polygon and a capsule or segment, it looks for the face of each that separates it best from the other, and for the
/// edges that face these. When they are known, the contact is the same to the bit without that search.
struct FaceSearch
{
    bool are_known = false; ///< whether the faces are given to collide()
    std::uint8_t face_a = 0;
    std::uint8_t face_b = 0;
    std::uint8_t facing_a = 0; ///< the edge of A that faces face_b
    std::uint8_t facing_b = 0;
    /// By how much these faces separate better than any other face of their shape; 0 when no faces were looked for [m].
    float lead = 0;
    /// By how much the facing edges face them more squarely than any other edge of their shape: a difference of cosines.
    float turn_lead = 0;
    /// Of a contact without points: the shapes are farther apart than the margin by at least this [m].
    float gap = 0;
};

/// Whether each of the faces found is the edge that faces the other one, as with shapes that lie on each other.
inline bool face_each_other(const FaceSearch& search) { return search.facing_a == search.face_a && search.facing_b == search.face_b; }

/// Two faces that face each other, without their shapes: what touch_faces() needs.
struct FacingFaces
{
    FacePair<float> pair;
    /// Of the points at the start and at the end of A's face. Where B's face is the reference, they come in the other order.
    std::array<std::uint16_t, 2> features;
};

/// @param search found faces that face each other
FacingFaces facing_faces(const Geometry& a, const Geometry& b, const FaceSearch& search);

inline TouchLimits touch_limits(float margin, const Tolerances& tolerances)
{
    return {margin, tolerances.least_core_distance, tolerances.reference_preference};
}

/// The contact of two shapes; no points when they are farther apart than `margin`.
/// @param b_in_a     the frame of B's body seen from A's
/// @param margin     [m], >= 0
/// @param tolerances of the world that they are in
LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin, const Tolerances& tolerances,
                      FaceSearch& search);

inline LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin, const Tolerances& tolerances = {})
{
    FaceSearch search;
    return collide(a, b, b_in_a, margin, tolerances, search);
}

/// No points when they are farther apart than the world's speculative distance.
inline LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, const Tolerances& tolerances = {})
{
    return collide(a, b, b_in_a, tolerances.speculative_distance, tolerances);
}

} // namespace carom::detail
