// The parts of the narrow phase. Every kernel works in the frame of A's body, or in that frame moved by `origin` to where the shapes
// are, so that shapes far from their body's origin keep their digits.
#pragma once

#include "geometry/manifold.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <cstdint>

namespace carom::detail
{

/// A shape that is the neighbourhood of a segment: a capsule, or a segment with radius 0.
struct SegmentCore
{
    Vec2 p1;          ///< [m]
    Vec2 p2;          ///< [m]
    float radius = 0; ///< [m]
};

inline LaneVec<float> lane_vec(Vec2 v) { return {v.x, v.y}; }

/// How near two shapes have to be, how near is near enough, and what is found on the way.
struct Nearness
{
    float margin; ///< shapes farther apart make no points [m]
    const Tolerances& tolerances;
    FaceSearch& search;
};

/// @param gap see FaceSearch
inline LocalManifold no_contact(float gap, FaceSearch& search)
{
    search.gap = gap;
    return {};
}

LocalManifold collide_segments(const SegmentCore& a, const SegmentCore& b, const Transform& b_in_a, const Nearness& near);
LocalManifold collide_polygons(const Polygon& a, const Polygon& b, const Transform& b_in_a, const Nearness& near);
LocalManifold collide_polygon_segment(const Polygon& a, const SegmentCore& b, const Transform& b_in_a, const Nearness& near);
LocalManifold collide_segment_polygon(const SegmentCore& a, const Polygon& b, const Transform& b_in_a, const Nearness& near);

/// An edge and the numbers of its ends in its shape. The shape lies to the left of the way from v1 to v2.
struct Edge
{
    Vec2 v1;
    Vec2 v2;
    std::uint32_t i1 = 0;
    std::uint32_t i2 = 0;
};

/// Two edges face to face. The reference edge gives the normal.
///
///        w1 <-------- w2       incident edge
///              ^ n
///        v2 <-------- v1       reference edge, its shape below
///         t: from v1 to v2
struct EdgePair
{
    Edge reference;
    Edge incident;
    Vec2 normal;                ///< unit, outward from the reference edge
    float reference_radius = 0; ///< [m]
    float incident_radius = 0;  ///< [m]
    bool reference_is_b = false;
    Vec2 origin;     ///< added to the positions [m]
    float slack = 0; ///< how far beyond the ends of the reference edge still counts as over it [m]
};

/// Two ends that are nearest to each other, whatever their edges do.
struct CornerPair
{
    Vec2 reference;
    Vec2 incident;
    std::uint32_t reference_index = 0;
    std::uint32_t incident_index = 0;
};

/// Points where the incident edge lies above the reference edge, at most one for each end of the common stretch. When there is no common
/// stretch, one point between the corners that are nearest to each other.
LocalManifold clip(const EdgePair& pair, float margin);

/// One point between two corners with a normal along the line that joins them.
/// @param pair gives the radii, the fallback for the normal, the order of A and B, and the origin
LocalManifold join_corners(const EdgePair& pair, const CornerPair& corners, float margin);

/// A point between two corners keeps its name while the same corners are nearest, whether as clipped ends or as bare corners, and
/// whichever edge was the reference.
constexpr std::uint32_t feature_of(std::uint32_t vertex_of_a, std::uint32_t vertex_of_b) { return vertex_of_a | (vertex_of_b << 8); }

} // namespace carom::detail
