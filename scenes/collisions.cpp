// Collisions: circles and boxes between four walls that bounce without losing energy. With 500 circles and 500 boxes, its
// defaults, it is the benchmark that Carom inherited from the engine that it grew from.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"
#include "scenes/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carom::scenes
{

namespace
{

/// Random places are found for hundreds of shapes up to here; from 66 on, seldom [%]. A few dozen may not fit a little below.
/// Test: Collisions.finds_room_at_the_highest_cover.
constexpr double most_cover = 60;

constexpr Material elastic{.friction = 0, .restitution = 1};

/// Weightless, and bouncing at every speed, however slow.
WorldDef elastic_world(const SceneSetup& setup)
{
    const int bodies = setup.parameters.integer("circles") + setup.parameters.integer("boxes");
    return {.gravity = {}, .solver = {.restitution_threshold = 0}, .capacity = {.bodies = bodies + 1, .shapes = bodies + 4}};
}

class Collisions : public Scene
{
public:
    explicit Collisions(const SceneSetup& setup);

private:
    struct Look
    {
        Color color = slate;
        Flash entered;
        Flash left;
    };

    void add_body(Vec2 position, const Geometry& geometry);
    std::vector<Geometry> random_shapes(int circles, int boxes);
    void fit_field(const std::vector<Geometry>& shapes);
    std::string no_room() const;

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;
    float step_length() const override { return boolean("frozen") ? 0 : time_step(); }

    Random random_;
    Random color_random_;
    Aabb field_;
    PerShape<Look> looks_;
};

Circle random_circle(Random& random) { return circle(random.uniform(0.5f, 1.5f)); }

Polygon random_box(Random& random)
{
    const float width = random.uniform(0.2f, 4.5f);
    const float height = random.uniform(0.2f, 4.5f);
    return box(width, height);
}

/// mass_of() with a density of 1 kg/m^2 is the area [m^2].
float area_of(const Geometry& geometry) { return mass_of(geometry, 1).mass; }

/// The order in which to place shapes: the large ones while there is room for them.
std::vector<std::size_t> largest_first(const std::vector<Geometry>& shapes)
{
    std::vector<std::size_t> order(shapes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) { return std::pair(-area_of(shapes[i]), i); }; // equal areas in their order, everywhere
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return order;
}

Collisions::Collisions(const SceneSetup& setup) : Scene(setup, elastic_world(setup)), random_(seed(), 1), color_random_(seed(), 2)
{
    const std::vector<Geometry> shapes = random_shapes(integer("circles"), integer("boxes"));
    fit_field(shapes);
    add_walls(world(), field_, elastic);
    Placement placement(field_);
    for (const std::size_t index : largest_first(shapes))
    {
        const std::optional<Vec2> place = placement.find(shapes[index], random_);
        if (!place) throw SceneError("cover", no_room(), "give less, or another seed");
        add_body(*place, shapes[index]);
    }
}

std::vector<Geometry> Collisions::random_shapes(int circles, int boxes)
{
    std::vector<Geometry> shapes;
    for (int i = 0; i < circles; ++i) shapes.emplace_back(random_circle(random_));
    for (int i = 0; i < boxes; ++i) shapes.emplace_back(random_box(random_));
    return shapes;
}

/// A field of 31 : 18 of which the shapes cover the wanted part, and the camera that shows it.
void Collisions::fit_field(const std::vector<Geometry>& shapes)
{
    constexpr float aspect = 31.0f / 18;
    constexpr float least_area = 100; // room for a few bodies from the pointer
    float area = 0;
    for (const Geometry& shape : shapes) area += area_of(shape);
    const float field_area = std::max(least_area, 100 * area / real("cover"));
    const Vec2 half{0.5f * std::sqrt(field_area * aspect), 0.5f * std::sqrt(field_area / aspect)};
    field_ = {-half, half};
    camera_ = framed_field({-half, half});
}

std::string Collisions::no_room() const
{
    const int shapes = integer("circles") + integer("boxes");
    return to_text(parameters().value("cover")) + " % leaves no room to place " + std::to_string(shapes) + " shapes apart";
}

void Collisions::add_body(Vec2 position, const Geometry& geometry)
{
    const Vec2 velocity = real("speed") * random_.direction();
    const BodyId body = world().create_body({.position = position, .linear_velocity = velocity, .locks = {.rotation = !boolean("spin")}});
    const ShapeId shape = world().create_shape(body, geometry, {.material = elastic});
    looks_[shape].color = from_hue(color_random_.uniform(0.46f, 1.14f), 0.25f, 0.56f);
}

void Collisions::on_pointer(const PointerEvent& event)
{
    const bool is_left = event.button == PointerEvent::Button::Left;
    const bool is_right = event.button == PointerEvent::Button::Right;
    if (event.action != PointerEvent::Action::Down || (!is_left && !is_right)) return;
    if (!contains(field_, event.position)) return say("Bodies can be added only between the walls.");
    if (!may_add_at(event.position)) return;
    add_body(event.position, is_left ? Geometry(random_circle(random_)) : Geometry(random_box(random_)));
}

void Collisions::on_key(std::string_view name)
{
    if (name == "f") toggle("frozen");
}

void Collisions::after_step(const StepReport&)
{
    for (const ContactBegin& contact : world().events().contact_begin)
    {
        const Color common = from_hue(color_random_.uniform(0.46f, 1.14f), 0.55f, 0.56f); // all but green, for the marks
        for (const ShapeId shape : {contact.shape_a, contact.shape_b})
        {
            looks_[shape].color = common;
            looks_[shape].entered.start(time());
        }
    }
    for (const ContactEnd& contact : world().events().contact_end)
    {
        for (const ShapeId shape : {contact.shape_a, contact.shape_b}) looks_[shape].left.start(time());
    }
}

void Collisions::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Look* look = looks_.find(id);
        if (world().body(world().shape(id).body()).type() == BodyType::Static)
            return list.shape(Layer::Bodies, geometry, transform, {.fill = slate});
        if (!look) return; // a guest
        list.shape(Layer::Bodies, geometry, transform, {.fill = look->color});
        // Both can be on, so the later one is the smaller.
        if (look->entered.is_on(time())) list.shape(Layer::Marks, scaled(geometry, 0.5f), transform, {.fill = fresh});
        if (look->left.is_on(time())) list.shape(Layer::Marks, scaled(geometry, 0.25f), transform, {.fill = gone});
    });
}

std::string Collisions::status() const
{
    return std::to_string(world().body_count() - 1) + " bodies" + (boolean("frozen") ? " (frozen)" : "");
}

} // namespace

SceneInfo collisions_scene()
{
    return {
        .name = "collisions",
        .title = "Elastic collisions",
        .description = "Circles and boxes bounce off each other and four walls without losing energy. Two that meet take a new common "
                       "colour, with a green mark when they touch and a red one when they part.",
        .group = "Collision",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "add a circle"},
            {Control::Kind::Pointer, "right", "add a box"},
            {Control::Kind::Key, "f", "freeze time, and let it go on as if nothing had happened"},
        }),
        .parameters = with_common_parameters({
            integer("circles", {0, 500, 20000}, "", Applies::OnRestart, "circles of radius 0.5 m to 1.5 m"),
            integer("boxes", {0, 500, 20000}, "", Applies::OnRestart, "boxes with sides of 0.2 m to 4.5 m"),
            real("cover", {1, 34, most_cover}, "%", Applies::OnRestart,
                 "part of the field that shapes cover; the field's size follows from it"),
            real("speed", {0, 6, 50}, "m/s", Applies::OnRestart, "of each body at the start, in any direction"),
            boolean("spin", true, Applies::OnRestart, "let bodies turn"),
            boolean("frozen", false, Applies::Live, "hold time: contacts are still found, but nothing moves"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Collisions>(setup); },
    };
}

} // namespace carom::scenes
