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

#include <array>
#include <cstdint>

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

    // What tells whether it holds comes first, in the order of SearchedAt.
    Transform made_at; ///< T0
    Vec2 arm;          ///< from p0 to m, in A's frame [m]
    float radius = 0;  ///< R, or more where B may not turn by as much as points may move [m]
    float allowed = 0; ///< how far points may move [m]
    Result result = Result::Nothing;
    std::uint8_t faces_a = 0; ///< of A: its face, and 16 times the edge that faces B's
    std::uint8_t faces_b = 0;
    bool has_face_pair = false;              ///< these faces face each other: their contact needs no shapes
    std::array<std::uint16_t, 2> features{}; ///< see FacingFaces
};

/// What collide() is told of a search that holds.
inline FaceSearch known_faces(const CollisionMemory& memory)
{
    const auto face = [](std::uint8_t faces) { return static_cast<std::uint8_t>(faces & 15); };
    const auto facing = [](std::uint8_t faces) { return static_cast<std::uint8_t>(faces >> 4); };
    return {.are_known = true,
            .face_a = face(memory.faces_a),
            .face_b = face(memory.faces_b),
            .facing_a = facing(memory.faces_a),
            .facing_b = facing(memory.faces_b)};
}

/// Whether the result of the search still holds.
inline bool holds(const CollisionMemory& memory, const Transform& b_in_a)
{
    if (memory.result == CollisionMemory::Result::Nothing) return false;
    const auto lanes = [](const Transform& t) { return LaneTransform<float>{{t.p.x, t.p.y}, {t.q.c, t.q.s}}; };
    const SearchedAt<float> search = {lanes(memory.made_at), {memory.arm.x, memory.arm.y}, memory.radius, memory.allowed};
    return holds(search, lanes(b_in_a));
}

/// One of two shapes that were searched.
struct Searched
{
    const Geometry& geometry;
    const Extent& extent;
};

/// Whether nothing is to be remembered of a search: shapes that touch with no faces found, or with two faces equally good.
inline bool spares_no_search(const FaceSearch& search) { return search.gap == 0 && search.lead == 0; }

/// @param search as collide() left it
CollisionMemory remember(const FaceSearch& search, const Searched& a, const Searched& b, const Transform& b_in_a);

} // namespace carom::detail
