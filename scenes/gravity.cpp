// Gravity: things fall onto a ground, pile up and get knocked over, and more can be dropped with the pointer.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float brick = 0.9f;       // side of the pyramid's bricks [m]
constexpr Vec2 pyramid_foot{9, 0};  // middle of its base [m]
constexpr float lost_below = -60;   // height at which a body that fell off the ground is taken away [m]
constexpr float lost_beyond = 1000; // distance to the side or above at which it is too [m]

const std::vector<std::string> kinds = {"circle", "box", "rounded_box", "polygon", "capsule"};

Vec2 gravity_from(const Parameters& parameters) { return {parameters.real("gravity_x"), parameters.real("gravity_y")}; }

class Gravity : public Scene
{
public:
    explicit Gravity(const SceneSetup& setup);

private:
    void add_ground(float right_kerb);
    void add_pyramid(Vec2 foot, int rows);
    void add_pile(int count);
    void add_body(Vec2 position, const Geometry& geometry, Color color, float density = 1);
    Geometry random_geometry(const std::string& kind, float size);
    Color random_color();
    void remove_at(Vec2 position);
    void clear();

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;
    void change_size(float factor);

    Random random_;
    std::vector<BodyId> bodies_;
    PerShape<Color> colors_; ///< the ground has none
};

Gravity::Gravity(const SceneSetup& setup) : Scene(setup, {.gravity = gravity_from(setup.parameters)}), random_(seed(), 1)
{
    const int rows = integer("pyramid");
    const float height = std::max(22.0f, 1.2f * brick * static_cast<float>(rows));
    camera_ = framed({{-0.87f * height, -0.04f * height}, {0.87f * height, 0.84f * height}});
    add_ground(pyramid_foot.x + std::max(9.4f, 0.6f * brick * static_cast<float>(rows)));
    add_pyramid(pyramid_foot, rows);
    add_pile(integer("pile"));
    // High enough to arrive when the pyramid has shown that it stands.
    if (boolean("ball")) add_body({8.2f, 85}, circle(1.6f), rgb(0.93f, 0.36f, 0.30f), 4);
}

void Gravity::add_ground(float right_kerb)
{
    const BodyId ground = world().create_body({.type = BodyType::Static, .name = "ground"});
    world().create_shape(ground, offset_box(80, 6, {0, -3}));
    // Two slippery chutes, down which the pile comes, a wall that keeps it on them, and a low kerb on either side.
    const ShapeDef slippery{.material = {.friction = 0.02f}};
    world().create_shape(ground, offset_box(9, 0.5f, {-13.5f, 13}, -0.35f), slippery);
    world().create_shape(ground, offset_box(12, 0.5f, {-6, 7.8f}, 0.3f), slippery);
    world().create_shape(ground, offset_box(0.8f, 16, {-18.1f, 22}), slippery);
    world().create_shape(ground, offset_box(0.8f, 3.2f, {-18.4f, 1.6f}));
    world().create_shape(ground, offset_box(0.8f, 1.6f, {right_kerb, 0.8f}));
}

void Gravity::add_pyramid(Vec2 foot, int rows)
{
    for (int row = 0; row < rows; ++row)
    {
        const int bricks = rows - row;
        const Color color = from_hue(0.56f + 0.30f * static_cast<float>(row) / static_cast<float>(rows), 0.5f, 0.58f);
        for (int i = 0; i < bricks; ++i)
        {
            const float right = static_cast<float>(i) - 0.5f * static_cast<float>(bricks - 1);
            const float up = static_cast<float>(row) + 0.5f;
            add_body(foot + brick * Vec2{1.02f * right, up}, box(brick, brick), color);
        }
    }
}

/// Rows of mixed shapes above the upper chute.
void Gravity::add_pile(int count)
{
    constexpr int columns = 5;
    constexpr float spacing = 1.3f; // [m], more than the largest shape
    for (int i = 0; i < count; ++i)
    {
        const Vec2 cell{static_cast<float>(i % columns), static_cast<float>(i / columns)};
        const Vec2 jitter = random_.point_in({{-0.05f, -0.05f}, {0.05f, 0.05f}});
        const std::string& kind = kinds[static_cast<std::size_t>(random_.integer(0, 4))];
        const float size = random_.uniform(0.6f, 1.1f);
        const Geometry geometry = random_geometry(kind, size);
        add_body(Vec2{-17, 17} + spacing * cell + jitter, geometry, random_color());
    }
}

void Gravity::add_body(Vec2 position, const Geometry& geometry, Color color, float density)
{
    const ShapeDef def{.density = density, .material = {.friction = real("friction"), .restitution = real("restitution")}};
    const BodyId body = world().create_body({.position = position});
    const ShapeId shape = world().create_shape(body, geometry, def);
    colors_[shape] = color;
    bodies_.push_back(body);
}

/// @param size the diameter or the longer side [m]
Geometry Gravity::random_geometry(const std::string& kind, float size)
{
    if (kind == "circle") return circle(0.5f * size);
    if (kind == "polygon") return random_polygon(random_, 0.5f * size);
    if (kind == "capsule") return capsule({-0.25f * size, 0}, {0.25f * size, 0}, 0.25f * size);
    const float height = size * random_.uniform(0.6f, 1.0f);
    return kind == "box" ? box(size, height) : rounded_box(size, height, 0.2f * height);
}

Color Gravity::random_color()
{
    // Warm against the pyramid's cold.
    return from_hue(random_.uniform(-0.06f, 0.19f), 0.6f, 0.58f);
}

void Gravity::on_parameter(std::string_view name)
{
    if (name == "gravity_x" || name == "gravity_y") world().set_gravity(gravity_from(parameters()));
}

void Gravity::on_pointer(const PointerEvent& event)
{
    if (event.action == PointerEvent::Action::Wheel) return change_size(1 + 0.1f * std::clamp(event.wheel, -5.0f, 5.0f));
    if (event.action != PointerEvent::Action::Down) return;
    if (event.button == PointerEvent::Button::Right) return remove_at(event.position);
    if (event.button != PointerEvent::Button::Left || !may_add_at(event.position)) return;
    const Geometry geometry = random_geometry(choice("kind"), real("size"));
    add_body(event.position, geometry, random_color());
}

void Gravity::on_key(std::string_view name)
{
    if (name == "c") return clear();
    if (name == "up") return change_size(1.1f);
    if (name == "down") return change_size(1 / 1.1f);
    if (name == "g") return set_parameter("gravity_y", static_cast<double>(-real("gravity_y")));
    const std::size_t number = static_cast<std::size_t>(name.front() - '1');
    set_parameter("kind", kinds[number]);
    say("The next shape is a " + kinds[number] + ".");
}

void Gravity::change_size(float factor)
{
    const ParameterInfo& size = find_parameter(parameters().infos(), "size");
    set_parameter("size", std::clamp(static_cast<double>(real("size") * factor), size.min, size.max));
}

void Gravity::remove_at(Vec2 position)
{
    const std::optional<ShapeId> shape = shape_at(world(), position);
    if (!shape) return;
    const BodyId body = world().shape(*shape).body();
    std::erase(bodies_, body);
    world().destroy_body(body);
}

void Gravity::clear()
{
    for (const BodyId body : bodies_) world().destroy_body(body);
    bodies_.clear();
}

void Gravity::after_step(const StepReport&)
{
    const auto is_lost = [&](BodyId body)
    {
        const Vec2 position = world().body(body).position();
        const bool is_near = position.y > lost_below && position.y < lost_beyond && std::abs(position.x) < lost_beyond;
        if (!is_near) world().destroy_body(body);
        return !is_near;
    };
    std::erase_if(bodies_, is_lost);
}

void Gravity::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        if (!color) return list.shape(Layer::Bodies, geometry, transform, {.fill = slate});
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f)});
        const auto* disc = std::get_if<Circle>(&geometry);
        if (!disc) return;
        // A spoke, to see it roll.
        const Vec2 rim = transform * Vec2{0.95f * disc->radius, 0};
        list.line(Layer::Marks, transform.p, rim, darker(*color, 0.35f));
    });
}

std::string Gravity::status() const
{
    return std::to_string(bodies_.size()) + " bodies, next a " + choice("kind") + " of " + to_text(std::round(10 * real("size")) / 10.0) +
           " m";
}

} // namespace

SceneInfo gravity_scene()
{
    return {
        .name = "gravity",
        .title = "Gravity",
        .description =
            "A pyramid stands, mixed shapes tumble down two chutes, and a heavy ball comes from far above. Drop more shapes with "
            "the pointer.",
        .group = "Gravity",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a shape"},
            {Control::Kind::Pointer, "right", "take away the shape under the pointer"},
            {Control::Kind::Pointer, "wheel", "make the next shape larger or smaller"},
            {Control::Kind::Key, "1", "the next shape is a circle"},
            {Control::Kind::Key, "2", "the next shape is a box"},
            {Control::Kind::Key, "3", "the next shape is a rounded box"},
            {Control::Kind::Key, "4", "the next shape is a polygon"},
            {Control::Kind::Key, "5", "the next shape is a capsule"},
            {Control::Kind::Key, "up", "make the next shape larger"},
            {Control::Kind::Key, "down", "make the next shape smaller"},
            {Control::Kind::Key, "g", "turn gravity around"},
            {Control::Kind::Key, "c", "clear: take away everything but the ground"},
        }),
        .parameters = with_common_parameters({
            integer("pyramid", {0, 12, 30}, "", Applies::OnRestart, "rows of the pyramid"),
            integer("pile", {0, 70, 2000}, "", Applies::OnRestart, "shapes that come down the chutes"),
            boolean("ball", true, Applies::OnRestart, "a heavy ball falls onto the pyramid"),
            choice("kind", kinds, Applies::Live, "of the next shape"),
            real("size", {0.2, 1, 5}, "m", Applies::Live, "diameter or longer side of the next shape"),
            real("gravity_x", {-50, 0, 50}, "m/s^2", Applies::Live, "gravity to the right"),
            real("gravity_y", {-50, -9.81, 50}, "m/s^2", Applies::Live, "gravity upwards"),
            real("restitution", {0, 0.1, 1}, "", Applies::Live, "of the next shape: part of the speed that comes back in a bounce"),
            real("friction", {0, 0.6, 2}, "", Applies::Live, "of the next shape: Coulomb's coefficient"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Gravity>(setup); },
        .own_code = "bodies that fall out of the scene are taken away",
    };
}

} // namespace carom::scenes
