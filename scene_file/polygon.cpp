// Makes polygons from their corners in the two ways in which the engine does.
#include "scene_file/polygon.hpp"

#include <algorithm>
#include <bit>

namespace carom::scene_file
{

namespace
{

bool are_same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool are_same_bits(Vec2 a, Vec2 b) { return are_same_bits(a.x, b.x) && are_same_bits(a.y, b.y); }

/// Whether the corners are those of box() or rounded_box(), whose normals are exact.
bool is_centered_box(const std::vector<Vec2>& v)
{
    return v.size() == 4 && v[2].x > 0 && v[2].y > 0 && are_same_bits(v[0], -v[2]) && are_same_bits(v[1], {v[2].x, -v[2].y}) &&
           are_same_bits(v[3], {-v[2].x, v[2].y});
}

Polygon derived(const std::vector<Vec2>& vertices, float radius, float length_unit)
{
    Polygon polygon;
    polygon.count = static_cast<int>(vertices.size());
    polygon.radius = radius;
    std::copy(vertices.begin(), vertices.end(), polygon.vertices.begin());
    if (is_centered_box(vertices))
    {
        polygon.normals = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
        return polygon;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
        polygon.normals[i] = normalize(right_perp(vertices[(i + 1) % vertices.size()] - vertices[i]));
    polygon.centroid = vertices.front(); // any place within will do: the next line makes it anew
    polygon = std::get<Polygon>(transformed(polygon, {}, length_unit));
    std::copy(vertices.begin(), vertices.end(), polygon.vertices.begin()); // -0 stays -0
    return polygon;
}

} // namespace

Polygon polygon_from(const PolygonFields& fields, float length_unit)
{
    Polygon polygon = derived(fields.vertices, fields.radius, length_unit);
    std::copy(fields.normals.begin(), fields.normals.end(), polygon.normals.begin());
    if (fields.centroid) polygon.centroid = *fields.centroid;
    static_cast<void>(transformed(polygon, {}, length_unit)); // checks all of it
    return polygon;
}

PolygonFields fields_of(const Polygon& polygon)
{
    const auto count = static_cast<std::ptrdiff_t>(polygon.count);
    PolygonFields fields{.vertices = {polygon.vertices.begin(), polygon.vertices.begin() + count}, .radius = polygon.radius};
    const Polygon plain = derived(fields.vertices, fields.radius, min_length_unit);
    const auto same = [](Vec2 a, Vec2 b) { return are_same_bits(a, b); };
    if (!std::equal(polygon.normals.begin(), polygon.normals.begin() + count, plain.normals.begin(), same))
        fields.normals.assign(polygon.normals.begin(), polygon.normals.begin() + count);
    if (!same(polygon.centroid, plain.centroid)) fields.centroid = polygon.centroid;
    return fields;
}

} // namespace carom::scene_file
