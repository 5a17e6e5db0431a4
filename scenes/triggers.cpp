// Triggers: shapes that drift through each other and light up while they overlap. Every one is a sensor: nothing pushes
// anything, and what the scene shows comes from sensor events and from the broad phase.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float field_area_per_shape = 13; // [m^2], leaves about half of the shapes alone at any time
constexpr Color touching_color = rgb(1.0f, 0.84f, 0.25f);

WorldDef weightless(const SceneSetup&) { return {.gravity = {}}; }

class Triggers : public Scene
{
public:
    explicit Triggers(const SceneSetup& setup);

private:
    struct Look
    {
        Color calm;
        int overlaps = 0; ///< shapes that overlap it now
        Flash entered;
        Flash left;
    };

    Geometry random_geometry(int kind);
    void add_drifter(Vec2 position, const Geometry& geometry);
    void add_pointer_shape();
    void bounce(BodyId id);

    void on_pointer(const PointerEvent& event) override;
    void before_step() override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    Aabb field_;
    std::vector<BodyId> drifters_;
    PerShape<Look> looks_;
    BodyId pointer_body_;
    ShapeId pointer_shape_;
    float pointer_radius_ = 1.2f; ///< [m]
    bool has_pointer_ = false;    ///< a person has moved the pointer; until then it goes round by itself
};

Triggers::Triggers(const SceneSetup& setup) : Scene(setup, weightless(setup)), random_(seed(), 1)
{
    const int counts[] = {integer("circles"), integer("boxes"), integer("polygons")};
    const int total = counts[0] + counts[1] + counts[2];
    constexpr float aspect = 16.0f / 9;
    const float area = field_area_per_shape * std::max(40.0f, static_cast<float>(total));
    const Vec2 half{0.5f * std::sqrt(area * aspect), 0.5f * std::sqrt(area / aspect)};
    field_ = {-half, half};
    camera_ = framed_field({-half, half});

    const Aabb inner = expanded(field_, -1.5f);
    for (int kind = 0; kind < 3; ++kind)
    {
        for (int i = 0; i < counts[kind]; ++i)
        {
            const Vec2 position = random_.point_in(inner);
            add_drifter(position, random_geometry(kind));
        }
    }
    add_pointer_shape();
}

Geometry Triggers::random_geometry(int kind)
{
    if (kind == 0) return circle(random_.uniform(0.3f, 1.0f));
    if (kind == 2) return random_polygon(random_, random_.uniform(0.5f, 1.2f));
    const float width = random_.uniform(0.6f, 2.0f);
    const float height = random_.uniform(0.6f, 2.0f);
    return box(width, height);
}

void Triggers::add_drifter(Vec2 position, const Geometry& geometry)
{
    const float speed = real("speed") * random_.uniform(0.4f, 1.0f);
    const Vec2 velocity = speed * random_.direction();
    const float angle = random_.uniform(-pi, pi);
    const float spin = random_.uniform(-0.6f, 0.6f);
    const BodyDef def{.position = position, .angle = angle, .linear_velocity = velocity, .angular_velocity = spin};
    const BodyId body = world().create_body(def);
    const ShapeId shape = world().create_shape(body, geometry, {.is_sensor = true});
    looks_[shape].calm = from_hue(random_.uniform(0.48f, 0.78f), 0.42f, 0.46f);
    drifters_.push_back(body);
}

/// Kinematic, so that it goes where the pointer is and nowhere else.
void Triggers::add_pointer_shape()
{
    pointer_body_ = world().create_body({.type = BodyType::Kinematic, .name = "pointer"});
    pointer_shape_ = world().create_shape(pointer_body_, circle(pointer_radius_), {.is_sensor = true});
    looks_[pointer_shape_].calm = rgb(0.85f, 0.87f, 0.92f);
}

void Triggers::on_pointer(const PointerEvent& event)
{
    has_pointer_ = true;
    world().body(pointer_body_).set_transform(event.position, 0);
    if (event.action == PointerEvent::Action::Wheel)
    {
        pointer_radius_ = std::clamp(pointer_radius_ * (1 + 0.1f * std::clamp(event.wheel, -5.0f, 5.0f)), 0.2f, 5.0f);
        world().shape(pointer_shape_).set_geometry(circle(pointer_radius_));
    }
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left) return;
    if (!contains(expanded(field_, -1.5f), event.position)) return say("Shapes can be added only inside the field.");
    if (may_add_at(event.position)) add_drifter(event.position, random_geometry(random_.integer(0, 2)));
}

void Triggers::before_step()
{
    for (const BodyId id : drifters_) bounce(id);
    if (has_pointer_) return;
    // Three rounds up and down while it goes round two times: it sweeps over the whole field.
    const auto t = static_cast<float>(time());
    const Vec2 half = field_.half_extent();
    world().body(pointer_body_).set_transform({0.75f * half.x * sin_cos(0.5f * t).sin, 0.7f * half.y * sin_cos(0.75f * t).sin}, 0);
}

/// Turns a velocity around that leads out of the field.
void Triggers::bounce(BodyId id)
{
    Body body = world().body(id);
    const Aabb bounds = body.bounds();
    const Vec2 velocity = body.linear_velocity();
    Vec2 reflected = velocity;
    if (bounds.min.x < field_.min.x) reflected.x = std::abs(velocity.x);
    if (bounds.max.x > field_.max.x) reflected.x = -std::abs(velocity.x);
    if (bounds.min.y < field_.min.y) reflected.y = std::abs(velocity.y);
    if (bounds.max.y > field_.max.y) reflected.y = -std::abs(velocity.y);
    if (reflected != velocity) body.set_linear_velocity(reflected);
}

/// Two sensors that overlap make two events, one for each as the sensor, so each looks after itself.
void Triggers::after_step(const StepReport&)
{
    for (const SensorEvent& event : world().events().sensor_begin)
    {
        Look& look = looks_[event.sensor];
        ++look.overlaps;
        look.entered.start(time());
    }
    for (const SensorEvent& event : world().events().sensor_end)
    {
        Look& look = looks_[event.sensor];
        --look.overlaps;
        look.left.start(time());
    }
}

void Triggers::on_draw(DrawList& list) const
{
    list.box(Layer::Background, field_, {.line = slate, .line_width = 2});
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Look* const found = looks_.find(id);
        if (!found) return; // a guest
        const Look& look = *found;
        const Color color = look.overlaps > 0 ? touching_color : look.calm;
        list.shape(Layer::Bodies, geometry, transform, {.fill = with_alpha(color, 0.62f), .line = color});
        // Both can be on: then green stands outside of red.
        if (look.entered.is_on(time())) list.shape(Layer::Marks, scaled(geometry, 1.08f), transform, {.line = fresh, .line_width = 3.5f});
        if (look.left.is_on(time())) list.shape(Layer::Marks, geometry, transform, {.line = gone, .line_width = 3.5f});
    });
}

std::string Triggers::status() const
{
    const auto is_touching = [&](BodyId id) { return looks_.find(world().body(id).shapes().front())->overlaps > 0; };
    const auto touching = std::count_if(drifters_.begin(), drifters_.end(), is_touching);
    return std::to_string(touching) + " of " + std::to_string(drifters_.size()) + " shapes overlap another";
}

} // namespace

SceneInfo triggers_scene()
{
    return {
        .name = "triggers",
        .title = "Triggers",
        .description = "Circles, boxes and polygons drift through each other and through the shape at the pointer. Each is yellow while it "
                       "overlaps another, with a green border when an overlap begins and a red one when it ends. The squares behind them "
                       "are the quadtree's.",
        .group = "Collision",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "move", "move the pointer's own shape"},
            {Control::Kind::Pointer, "wheel", "make the pointer's shape larger or smaller"},
            {Control::Kind::Pointer, "left", "add a shape"},
        }),
        .parameters = with_common_parameters(
            {
                integer("circles", {0, 24, 5000}, "", Applies::OnRestart, "circles of radius 0.3 m to 1 m"),
                integer("boxes", {0, 24, 5000}, "", Applies::OnRestart, "boxes with sides of 0.6 m to 2 m"),
                integer("polygons", {0, 24, 5000}, "", Applies::OnRestart, "polygons of 3 to 8 corners and radius 0.5 m to 1.2 m"),
                real("speed", {0, 2.5, 20}, "m/s", Applies::OnRestart, "of the fastest shape"),
            },
            BroadPhaseType::Quadtree),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Triggers>(setup); },
        .own_code = "a body is led around, and others turn back at the edge",
    };
}

} // namespace carom::scenes
