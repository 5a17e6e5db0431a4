// What the last search between two shapes found, and how far they may move against each other until it has to be done again. The result of
// the narrow phase is the same to the bit with and without it, so it is no part of a world's hash.
//
// T is the frame of B seen from A, T0 what it was at the search. Seen from A, a point x of B has moved since by
//
//   D(x) = T T0^-1 x - x = (p - p0) + (Q - I)(x - p0),     Q = q q0^-1
//
// and no point within R of a point m by more than |D(m)| + |Q - I| R. Seen from B, a point of A has moved by as much. So
//
// - shapes that were farther apart than the margin by a gap are so until the points of one of them have moved by that gap. Of two
//   shapes the smaller moves less in a turn, and a disc that turns around its middle stays where it is;
// - the separation along a face changes by no more than the corners move. A face that separated better than the others by a lead is the best
//   one until the corners have moved by half of it. The cosine between a face's normal and an edge's changes by no more than |Q - I|, so
//   that an edge that faced it more squarely than the others by a lead does so until half of that.
#pragma once

#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"

namespace carom::detail
{

/// The frame of B seen from A at the search, and for what motion its result holds.
struct CollisionMemory
{
    enum class Result : std::uint8_t
    {
        Nothing, ///< that would spare a search
        Gap,     ///< the shapes are farther apart than the margin
        Faces    ///< these separate best
    };

    Transform made_at; ///< T0
    Vec2 arm;          ///< from p0 to m, in A's frame [m]
    float radius = 0;  ///< R [m]
    float allowed = 0; ///< how far points may move [m]
    float turn = 0;    ///< how far B may turn: |Q - I|
    Result result = Result::Nothing;
    std::uint8_t face_a = 0;
    std::uint8_t face_b = 0;
    std::uint8_t facing_a = 0;
    std::uint8_t facing_b = 0;
};

/// Whether the result of the search still holds.
inline bool holds(const CollisionMemory& memory, const Transform& b_in_a)
{
    if (memory.result == CollisionMemory::Result::Nothing) return false;
    const Rot turn = relative(memory.made_at.q, b_in_a.q);
    const float less = turn.c - 1;
    const float turned = std::abs(turn.s) - less; // at least |Q - I|
    const float rest = memory.allowed - turned * memory.radius;
    const Vec2 arm = memory.arm;
    const Vec2 way = b_in_a.p - memory.made_at.p + Vec2{less * arm.x - turn.s * arm.y, turn.s * arm.x + less * arm.y};
    return rest >= 0 && turned <= memory.turn && length_squared(way) <= rest * rest;
}

/// One of two shapes that were searched.
struct Searched
{
    const Geometry& geometry;
    const Extent& extent;
};

/// @param search as collide() left it
CollisionMemory remember(const FaceSearch& search, const Searched& a, const Searched& b, const Transform& b_in_a);

} // namespace carom::detail
