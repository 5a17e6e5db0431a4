// Half-planes and edges: every question is answered by walking round a few corners.
#include "geometry/surface.hpp"

#include "geometry/nearest.hpp"

#include <limits>

namespace carom::detail
{

namespace
{

constexpr float far_away = std::numeric_limits<float>::max();

Vec2 point_of(const ConvexPoints& shape, int i) { return shape.points[static_cast<std::size_t>(i)]; }

/// Keeps the part of a stretch where  offset + rate t <= limit.
void cut(Stretch& stretch, float offset, float rate, float limit)
{
    constexpr float parallel = 1e-6f; // a line across 1 m that comes nearer by less than a micrometre does not cross
    const float room = limit - offset;
    if (rate > parallel)
        stretch.end = std::min(stretch.end, room / rate);
    else if (rate < -parallel)
        stretch.start = std::max(stretch.start, room / rate);
    else if (room < 0)
        stretch.end = stretch.start - 1;
}

/// The part of the line  origin + t along  that lies in a circle.
Stretch in_circle(Vec2 origin, Vec2 along, Vec2 center, float radius)
{
    const float middle = dot(center - origin, along);
    const float height = cross(along, center - origin);
    const float half2 = radius * radius - height * height;
    if (half2 <= 0) return {0, -1};
    const float half = std::sqrt(half2);
    return {middle - half, middle + half};
}

} // namespace

Edge face_of(const ConvexPoints& shape, int face)
{
    const int next = face + 1 < shape.count ? face + 1 : 0;
    return {point_of(shape, face), point_of(shape, next), static_cast<std::uint32_t>(face), static_cast<std::uint32_t>(next)};
}

Vec2 normal_of(const Edge& face) { return normalize(right_perp(face.v2 - face.v1)); }

ConvexPoints moved(const ConvexPoints& shape, const Transform& transform)
{
    ConvexPoints result = shape;
    for (int i = 0; i < shape.count; ++i) result.points[static_cast<std::size_t>(i)] = transform * point_of(shape, i);
    return result;
}

LocalManifold moved(const LocalManifold& manifold, const Transform& transform)
{
    LocalManifold result = manifold;
    result.normal = rotate(transform.q, manifold.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
        result.points[i].position = transform * manifold.points[i].position;
    return result;
}

bool is_behind(const ConvexPoints& other, const ConvexPoints& shape, int face, float gap)
{
    const Edge edge = face_of(shape, face);
    const Vec2 normal = normal_of(edge);
    for (int i = 0; i < other.count; ++i)
    {
        if (dot(normal, point_of(other, i) - edge.v1) + other.radius - shape.radius > gap) return false;
    }
    return true;
}

Vec2 middle_of(const ConvexPoints& shape)
{
    Vec2 sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape.count); ++i) sum += shape.points[i];
    return sum / static_cast<float>(shape.count);
}

float distance_to(const ConvexPoints& shape, Vec2 point)
{
    if (shape.count == 1) return distance(shape.points[0], point) - shape.radius;
    float highest = -far_away; // over all faces' lines
    float nearest2 = far_away;
    for (int i = 0; i < shape.count; ++i)
    {
        const Edge face = face_of(shape, i);
        const Vec2 edge = face.v2 - face.v1;
        const Vec2 d = point - face.v1;
        highest = std::max(highest, dot(normal_of(face), d));
        const float t = std::clamp(dot(d, edge) / dot(edge, edge), 0.0f, 1.0f);
        nearest2 = std::min(nearest2, length_squared(d - t * edge));
    }
    if (highest <= 0 && shape.count > 2) return highest - shape.radius;
    return std::sqrt(nearest2) - shape.radius;
}

Stretch hidden_stretch(const ConvexPoints& shape, int face, const ConvexPoints& other, Vec2 viewer, float gap)
{
    const Edge edge = face_of(shape, face);
    const Vec2 normal = normal_of(edge);
    const Vec2 along = left_perp(normal);
    const Vec2 origin = edge.v1 + (shape.radius + gap) * normal;
    if (other.count == 1) return in_circle(origin, along, other.points[0], other.radius);

    Stretch hidden = {0, dot(edge.v2 - edge.v1, along)};
    const bool is_segment = other.count == 2 && other.radius == 0;
    if (is_segment && is_behind(other, shape, face, gap)) return {};
    for (int i = 0; i < other.count; ++i)
    {
        const Edge side = face_of(other, i);
        const Vec2 n = normal_of(side);
        const bool is_back = is_segment && dot(n, viewer - side.v1) < 0;
        if (!is_back) cut(hidden, dot(n, origin - side.v1), dot(n, along), other.radius);
        if (other.count != 2) continue;
        const Vec2 end = left_perp(n);
        cut(hidden, dot(end, origin - side.v2), dot(end, along), std::max(other.radius, gap));
    }
    return hidden;
}

float rise_before(const ConvexPoints& other, Vec2 point, Vec2 normal, float gap)
{
    float rise = 0;
    for (int i = 0; i < other.count; ++i)
    {
        const Vec2 way = point_of(other, i) + other.radius * normal - point;
        const float far = length(way);
        if (far > gap) rise = std::max(rise, dot(way, normal) / far);
    }
    return rise;
}

FaceContact collide_on_face(const ConvexPoints& shape, int face, const ConvexPoints& other, float slack, bool shape_is_b, float margin)
{
    EdgePair pair;
    pair.reference = face_of(shape, face);
    pair.normal = normal_of(pair.reference);
    pair.reference_radius = shape.radius;
    pair.incident_radius = other.radius;
    pair.reference_is_b = shape_is_b;
    pair.slack = slack;

    FaceContact contact;
    float lowest = far_away;
    for (int i = 0; i < other.count; ++i) lowest = std::min(lowest, dot(pair.normal, point_of(other, i) - pair.reference.v1));
    contact.face_separation = lowest - shape.radius - other.radius;
    if (contact.face_separation > margin) return contact;

    const Vec2 along = left_perp(pair.normal);
    const float face_length = dot(pair.reference.v2 - pair.reference.v1, along);
    if (other.count == 1)
    {
        const float t = dot(other.points[0] - pair.reference.v1, along);
        if (t < -slack || t > face_length + slack) return contact;
        LocalManifold& manifold = contact.manifold;
        manifold.normal = shape_is_b ? -pair.normal : pair.normal;
        manifold.count = 1;
        const float middle = 0.5f * (lowest - other.radius + shape.radius);
        manifold.points[0].position = pair.reference.v1 + t * along + middle * pair.normal;
        manifold.points[0].separation = contact.point_separation = contact.face_separation;
        return contact;
    }

    float least_facing = far_away;
    for (int i = 0; i < other.count; ++i)
    {
        const Edge edge = face_of(other, i);
        const float facing = dot(normal_of(edge), pair.normal);
        if (facing >= least_facing) continue;
        least_facing = facing;
        pair.incident = edge;
    }
    const float t1 = dot(pair.incident.v1 - pair.reference.v1, along);
    const float t2 = dot(pair.incident.v2 - pair.reference.v1, along);
    if (std::max(t1, t2) <= -slack || std::min(t1, t2) >= face_length + slack) return contact;
    contact.manifold = clip(pair, margin);
    contact.point_separation = far_away;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i)
        contact.point_separation = std::min(contact.point_separation, contact.manifold.points[i].separation);
    return contact;
}

} // namespace carom::detail
