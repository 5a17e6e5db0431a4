// What is kept of two faces that face each other, so that a contact of them needs no shapes.
#include "geometry/faces.hpp"

#include <variant>

namespace carom::detail
{

namespace
{

struct Shift
{
    Vec2 origin;
    Vec2 point(Vec2 p) const { return p - origin; }
    Vec2 direction(Vec2 d) const { return d; }
};

/// @param action of a polygon or the core of a capsule or segment; circles have no faces
template <class Action>
auto with_faces_of(const Geometry& geometry, const Action& action)
{
    switch (geometry.index())
    {
    case 1: return action(core_of(*std::get_if<Capsule>(&geometry)));
    case 2: return action(core_of(*std::get_if<Segment>(&geometry)));
    default: return action(*std::get_if<Polygon>(&geometry));
    }
}

} // namespace

FacingFaces facing_faces(const Geometry& a, const Geometry& b, const FaceSearch& search)
{
    const Vec2 origin = with_faces_of(a, [](const auto& shape) { return origin_of(shape); });
    const Face on_a = with_faces_of(a, [&](const auto& shape) { return face_of(shape, search.face_a, Shift{origin}); });
    const Face on_b = with_faces_of(b, [&](const auto& shape) { return face_of(shape, search.face_b, Shift{}); });
    const auto feature = [](std::uint32_t of_a, std::uint32_t of_b) { return static_cast<std::uint16_t>(feature_of(of_a, of_b)); };
    return {{lane_vec(on_a.edge.v1), lane_vec(on_a.edge.v2), lane_vec(on_a.normal), lane_vec(origin), lane_vec(on_b.edge.v1),
             lane_vec(on_b.edge.v2), lane_vec(on_b.normal), on_a.radius, on_b.radius},
            {feature(on_a.edge.i1, on_b.edge.i2), feature(on_a.edge.i2, on_b.edge.i1)}};
}

} // namespace carom::detail
