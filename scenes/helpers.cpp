// Walls, random polygons, and the drawing of what a world holds.
#include "scenes/helpers.hpp"

#include <array>
#include <span>

namespace carom::scenes
{

void add_walls(World& world, const Aabb& field, const Material& material)
{
    const Vec2 middle = field.center();
    const Vec2 half = field.half_extent();
    const float t = wall_thickness;
    const BodyId walls = world.create_body({.type = BodyType::Static, .name = "walls"});
    const ShapeDef def{.material = material};
    // The upright walls reach over the corners.
    world.create_shape(walls, offset_box(t, 2 * half.y + 2 * t, {field.min.x - 0.5f * t, middle.y}), def);
    world.create_shape(walls, offset_box(t, 2 * half.y + 2 * t, {field.max.x + 0.5f * t, middle.y}), def);
    world.create_shape(walls, offset_box(2 * half.x, t, {middle.x, field.min.y - 0.5f * t}), def);
    world.create_shape(walls, offset_box(2 * half.x, t, {middle.x, field.max.y + 0.5f * t}), def);
}

Polygon random_polygon(Random& random, float radius)
{
    const int corners = random.integer(3, max_polygon_vertices);
    const float sector = 2 * pi / static_cast<float>(corners);
    std::array<Vec2, max_polygon_vertices> points;
    for (int i = 0; i < corners; ++i)
    {
        // Each corner stays within the middle of its sector, so that no two come close.
        const float angle = sector * (static_cast<float>(i) + random.uniform(-0.25f, 0.25f));
        const SinCos v = sin_cos(angle);
        points[static_cast<std::size_t>(i)] = {radius * v.cos, radius * v.sin};
    }
    return convex_hull(std::span(points).first(static_cast<std::size_t>(corners)));
}

std::optional<ShapeId> shape_at(const World& world, Vec2 point)
{
    std::optional<ShapeId> found;
    for_each_shape(world, [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        if (found || !contains(geometry, inverse_transform(transform, point))) return;
        if (world.body(world.shape(id).body()).type() == BodyType::Dynamic) found = id;
    });
    return found;
}

void draw_broad_phase(const World& world, DrawList& list)
{
    struct Visitor : DebugDraw
    {
        explicit Visitor(DrawList& l) : list(l) {}
        void broad_phase_node(const Aabb& box, int depth) override
        {
            constexpr Color shallow = rgb(0.35f, 0.55f, 0.85f);
            const float alpha = 0.16f + 0.06f * static_cast<float>(std::min(depth, 5));
            list.box(Layer::Background, box, {.line = with_alpha(shallow, alpha), .line_width = 1});
        }
        DrawList& list;
    };
    Visitor visitor(list);
    world.debug_draw(visitor, DrawPart::BroadPhase);
}

void draw_bounds(const World& world, DrawList& list)
{
    struct Visitor : DebugDraw
    {
        explicit Visitor(DrawList& l) : list(l) {}
        void bounds(ShapeId, const Aabb& tight, const Aabb& fat) override
        {
            list.box(Layer::Marks, fat, {.line = {1, 0.75f, 0.3f, 0.35f}, .line_width = 1});
            list.box(Layer::Marks, tight, {.line = {1, 0.75f, 0.3f, 0.9f}, .line_width = 1});
        }
        DrawList& list;
    };
    Visitor visitor(list);
    world.debug_draw(visitor, DrawPart::Bounds);
}

} // namespace carom::scenes
