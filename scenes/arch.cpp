// Arch: wedges of stone in a half circle between two abutments. Nothing but their weight and friction holds them.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <array>

namespace carom::scenes
{

namespace
{

constexpr float inner_radius = 4;    // [m]
constexpr float abutment_height = 2; // [m]
constexpr float drop_height = 12;    // [m]
constexpr Color stone_color = rgb(0.80f, 0.72f, 0.58f);
constexpr Color weight_color = rgb(0.93f, 0.36f, 0.30f);

class Arch : public Scene
{
public:
    explicit Arch(const SceneSetup& setup);

private:
    void add_ground();
    void add_stones(int count);
    void drop_weight(Vec2 position);

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void on_draw(DrawList& list) const override;

    Random random_;
    PerShape<Color> colors_; ///< the ground has none
};

Arch::Arch(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -9.81f}}), random_(seed(), 1)
{
    add_ground();
    add_stones(integer("stones"));
    camera_ = framed(world(), {{-6.5f, -0.3f}, {6.5f, 8.5f}});
}

void Arch::add_ground()
{
    const BodyId ground = world().create_body({.type = BodyType::Static, .name = "ground"});
    const ShapeDef rough{.material = {.friction = real("friction")}};
    world().create_shape(ground, offset_box(80, 6, {0, -3}), rough);
    const float width = real("thickness") + 1;
    for (const float side : {-1.0f, 1.0f})
    {
        const float x = side * (inner_radius + 0.5f * width - 0.5f);
        world().create_shape(ground, offset_box(width, abutment_height, {x, 0.5f * abutment_height}), rough);
    }
}

/// Each stone is a body in the middle of its sector, and shares both its joints exactly with its neighbours. No two weigh quite the same.
void Arch::add_stones(int count)
{
    const float half = 0.5f * pi / static_cast<float>(count);
    const float outer_radius = inner_radius + real("thickness");
    const float middle = 0.5f * (inner_radius + outer_radius);
    const SinCos v = sin_cos(half);
    const std::array corners = {
        Vec2{inner_radius * v.cos - middle, -inner_radius * v.sin}, Vec2{outer_radius * v.cos - middle, -outer_radius * v.sin},
        Vec2{outer_radius * v.cos - middle, outer_radius * v.sin}, Vec2{inner_radius * v.cos - middle, inner_radius * v.sin}};
    const Polygon wedge = convex_hull(corners);
    for (int i = 0; i < count; ++i)
    {
        const float angle = half * static_cast<float>(2 * i + 1);
        const SinCos at = sin_cos(angle);
        const Vec2 position = Vec2{0, abutment_height} + middle * Vec2{at.cos, at.sin};
        const BodyId body = world().create_body({.position = position, .angle = angle});
        const ShapeId shape =
            world().create_shape(body, wedge, {.density = random_.uniform(1.95f, 2.05f), .material = {.friction = real("friction")}});
        colors_[shape] = i % 2 == 0 ? stone_color : darker(stone_color, 0.15f);
    }
}

void Arch::drop_weight(Vec2 position)
{
    if (!may_add_at(position)) return;
    const BodyId body = world().create_body({.position = position});
    colors_[world().create_shape(body, box(0.8f, 0.8f), {.density = real("weight") / 0.64f})] = weight_color;
}

void Arch::on_pointer(const PointerEvent& event)
{
    if (event.action == PointerEvent::Action::Down && event.button == PointerEvent::Button::Left) drop_weight(event.position);
}

void Arch::on_key(std::string_view) { drop_weight({1.5f, drop_height}); }

void Arch::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        if (!color) return list.shape(Layer::Bodies, geometry, transform, {.fill = slate});
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f)});
    });
}

} // namespace

SceneInfo arch_scene()
{
    return {
        .name = "arch",
        .title = "Arch",
        .description =
            "Wedges of stone in a half circle carry each other: their weight and friction alone hold the arch. Drop a weight on it.",
        .group = "Statics",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a weight"},
            {Control::Kind::Key, "space", "drop a weight beside the keystone"},
        }),
        .parameters = with_common_parameters({
            integer("stones", {5, 13, 31}, "", Applies::OnRestart, "of the arch"),
            real("thickness", {0.3, 1, 2}, "m", Applies::OnRestart, "of the arch"),
            real("friction", {0, 0.7, 2}, "", Applies::OnRestart, "of the stones: Coulomb's coefficient"),
            real("weight", {0.1, 20, 1000}, "kg", Applies::Live, "of what is dropped next"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Arch>(setup); },
        .is_calm = true,
    };
}

} // namespace carom::scenes
