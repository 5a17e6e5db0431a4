// Draws shapes and joints, and makes painted bodies.
#include "scenes/painted_scene.hpp"

#include <cmath>
#include <utility>

namespace carom::scenes
{

namespace
{

constexpr Color pin_color = rgb(0.86f, 0.88f, 0.92f);
constexpr Color rod_color = rgb(0.72f, 0.76f, 0.83f);
constexpr Color rope_color = rgb(0.83f, 0.70f, 0.50f);
constexpr Color spring_color = rgb(0.55f, 0.80f, 0.72f);

/// A coil, as a zigzag.
void draw_spring(DrawList& list, Vec2 from, Vec2 to, float size)
{
    constexpr int turns = 12;
    const Vec2 along = (1.0f / turns) * (to - from);
    const Vec2 aside = 1.6f * size * normalize(left_perp(to - from));
    Vec2 before = from;
    for (int i = 1; i <= turns; ++i)
    {
        const bool is_end = i == turns;
        const Vec2 next = from + static_cast<float>(i) * along + (is_end ? Vec2{} : (i % 2 == 0 ? aside : -aside));
        list.line(Layer::Marks, before, next, spring_color, 1.8f);
        before = next;
    }
}

/// A parabola of the rope's length, which is a straight line when the rope is taut.
void draw_rope(DrawList& list, Vec2 from, Vec2 to, float rope)
{
    constexpr int pieces = 12;
    const float reach = distance(from, to);
    const float slack = std::max(rope - reach, 0.0f);
    // An arc that sags by s over a chord d has about the length d + 8 s^2 / (3 d); a rope that is folded hangs half its slack deep.
    const float sag = std::min(std::sqrt(0.375f * reach * slack), 0.5f * slack);
    Vec2 before = from;
    for (int i = 1; i <= pieces; ++i)
    {
        const float t = static_cast<float>(i) / pieces;
        const Vec2 next = from + t * (to - from) - Vec2{0, 4 * sag * t * (1 - t)};
        list.line(Layer::Marks, before, next, rope_color, 2);
        before = next;
    }
}

void draw_joint(const World& world, const JointView& joint, DrawList& list, float size)
{
    const auto body = [&](BodyId id) { return id ? world.body(id).transform() : Transform{}; };
    const Transform a = body(joint.body_a()) * joint.frame_a();
    const Transform b = body(joint.body_b()) * joint.frame_b();
    const auto pin = [&](Vec2 place) { list.disc(Layer::Marks, place, size, {.fill = pin_color, .line = night}); };
    switch (joint.type())
    {
    case JointType::Revolute: return pin(b.p);
    case JointType::Weld:
        return list.box(Layer::Marks, {b.p - Vec2{0.8f * size, 0.8f * size}, b.p + Vec2{0.8f * size, 0.8f * size}},
                        {.fill = pin_color, .line = night});
    case JointType::Prismatic:
    case JointType::Wheel:
    {
        const auto* wheel = std::get_if<WheelJoint>(&joint.spec());
        const auto* rail = std::get_if<PrismaticJoint>(&joint.spec());
        const bool has_spring = wheel ? wheel->suspension.has_value() : rail->spring.has_value();
        if (has_spring && distance(a.p, b.p) > 2 * size)
            draw_spring(list, a.p, b.p, size);
        else
            list.line(Layer::Marks, a.p, b.p, rod_color, 1.5f);
        return pin(b.p);
    }
    case JointType::Distance:
    {
        const auto& rod = std::get<DistanceJoint>(joint.spec());
        if (rod.spring)
            draw_spring(list, a.p, b.p, size);
        else if (rod.limit)
            draw_rope(list, a.p, b.p, rod.limit->upper);
        else
            list.line(Layer::Marks, a.p, b.p, rod_color, 3);
        pin(a.p);
        return pin(b.p);
    }
    case JointType::Pulley:
    {
        const auto& pulley = std::get<PulleyJoint>(joint.spec());
        list.line(Layer::Marks, a.p, pulley.ground_a, rope_color, 2);
        list.line(Layer::Marks, pulley.ground_a, pulley.ground_b, rope_color, 2);
        list.line(Layer::Marks, pulley.ground_b, b.p, rope_color, 2);
        for (const Vec2 wheel : {pulley.ground_a, pulley.ground_b})
            list.disc(Layer::Marks, wheel, 2 * size, {.fill = slate, .line = rod_color});
        return;
    }
    case JointType::Motor:
    case JointType::Mouse:
    case JointType::Gear: return;
    }
}

} // namespace

void draw_joints(const World& world, DrawList& list, float size)
{
    for (const JointId id : world.joints()) draw_joint(world, world.joint(id), list, size);
}

void draw_painted(const World& world, const PerShape<Color>& colors, DrawList& list)
{
    for_each_shape(world, [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors.find(id);
        if (!color)
        {
            const bool is_line = std::holds_alternative<Segment>(geometry);
            return list.shape(Layer::Bodies, geometry, transform,
                              is_line ? Paint{.line = lighter(slate, 0.25f), .line_width = 3} : Paint{.fill = slate});
        }
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.4f)});
        const auto* disc = std::get_if<Circle>(&geometry);
        if (!disc) return;
        const Vec2 center = transform * disc->center;
        list.line(Layer::Bodies, center, center + rotate(transform.q, Vec2{0.9f * disc->radius, 0}), darker(*color, 0.4f));
    });
}

BodyId PaintedScene::add(const BodyDef& def, const Geometry& geometry, Color color, const ShapeDef& shape)
{
    const BodyId body = world().create_body(def);
    add_shape(body, geometry, color, shape);
    return body;
}

void PaintedScene::add_shape(BodyId body, const Geometry& geometry, Color color, const ShapeDef& shape)
{
    colors_[world().create_shape(body, geometry, shape)] = color;
}

BodyId PaintedScene::add_static(const Geometry& geometry, const ShapeDef& shape)
{
    return world().create_body({.type = BodyType::Static}, geometry, shape);
}

void PaintedScene::add_ground(const std::vector<Vec2>& points, const Material& material, const Filter& filter)
{
    const BodyId ground = world().create_body({.type = BodyType::Static, .name = "ground"});
    world().create_chain(ground, {.points = points, .materials = {&material, 1}, .filter = filter});
}

void PaintedScene::on_draw(DrawList& list) const
{
    draw_painted(world(), colors_, list);
    draw_joints(world(), list, 0.006f * camera_.height);
    draw_marks(list);
    grabber_.draw(world(), list);
}

void PaintedScene::label(DrawList& list, Vec2 place, std::string text, float size) const
{
    list.text({.text = std::move(text), .color = with_alpha(paper, 0.85f), .size = size, .place = Place::World, .position = place});
}

Control drag_control() { return {Control::Kind::Pointer, "left", "drag a body"}; }

} // namespace carom::scenes
