// One-way: platforms through which bodies jump up and on which they land. Four are boxes that a hook lets be passed from below; the
// curved one is a one-sided chain and needs no hook.
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

constexpr float level_height = 3;   // from platform to platform [m]
constexpr float jump_speed = 9;     // [m/s], 4.1 m high
constexpr float jumper_size = 0.8f; // [m]
constexpr float field_half = 16;    // half the width of the field [m]
constexpr double drop_time = 0.45;  // for which platforms let a jumper down [s]
constexpr Color platform_color = rgb(0.40f, 0.62f, 0.90f);
constexpr Color chain_color = rgb(0.95f, 0.70f, 0.30f);

struct Platform
{
    Vec2 center;
    float width;
};
constexpr std::array platforms = {
    Platform{{-10, 1 * level_height}, 9},
    Platform{{-8, 2 * level_height}, 8},
    Platform{{-10.5f, 3 * level_height}, 8},
    Platform{{-8.5f, 4 * level_height}, 7},
};

class OneWay : public Scene, private ContactHooks
{
public:
    explicit OneWay(const SceneSetup& setup);

private:
    struct Jumper
    {
        BodyId body;
        Color color;
        float run = 1; ///< speed along the ground, signed [m/s]
        double next_jump = 0;
        double drops_until = 0;
    };

    void add_field();
    void add_jumper(Vec2 position);
    bool has_footing(BodyId body) const;
    void move(Jumper& jumper);
    const Jumper* find(BodyId body) const;

    void pre_solve(PreSolve& contact) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void before_step() override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    std::vector<ShapeId> platforms_; ///< those of the hook
    std::vector<Jumper> jumpers_;
    int passes_ = 0; ///< contacts that the hook took away in the last step
};

OneWay::OneWay(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -10}}), random_(seed(), 1)
{
    world().set_hooks(this);
    add_field();
    for (int i = 0; i < integer("jumpers"); ++i)
    {
        const float x = random_.uniform(-field_half + 2, field_half - 2);
        const float row = static_cast<float>(i / 12);
        add_jumper({x, 0.6f + row});
    }
    camera_ = framed(world(), {{-field_half, -1}, {field_half, 16.5f}});
}

void OneWay::add_field()
{
    add_walls(world(), {{-field_half, 0}, {field_half, 40}}, {.friction = 0.1f});
    const BodyId boxes = world().create_body({.type = BodyType::Static, .name = "platforms"});
    for (const Platform& platform : platforms)
        platforms_.push_back(world().create_shape(boxes, offset_box(platform.width, 0.3f, platform.center), {.pre_solve = true}));

    // Three shells, one above the other, from right to left: the front is above.
    const BodyId shells = world().create_body({.type = BodyType::Static, .name = "shells"});
    for (int level = 1; level <= 3; ++level)
    {
        std::vector<Vec2> points;
        for (int i = 0; i <= 24; ++i)
        {
            const float t = 1 - static_cast<float>(i) / 12;
            points.push_back({8 + 5.5f * t, level_height * static_cast<float>(level) + 0.9f * (level % 2 == 1 ? -t * t : t * t - 1)});
        }
        world().create_chain(shells, {.points = points, .sides = ChainSides::OneSided});
    }
}

void OneWay::add_jumper(Vec2 position)
{
    const bool is_round = random_.integer(0, 1) == 1;
    const Geometry geometry = is_round ? Geometry(capsule({0, -0.15f}, {0, 0.15f}, 0.5f * jumper_size - 0.05f))
                                       : Geometry(rounded_box(jumper_size, jumper_size, 0.1f));
    const float run = random_.uniform(1.5f, 3.5f);
    const float way = random_.integer(0, 1) == 1 ? run : -run;
    const double first_jump = time() + static_cast<double>(random_.uniform(0.1f, 1.5f));
    const BodyId body =
        world().create_body({.position = position, .locks = {.rotation = true}}, geometry, {.material = {.friction = 0.2f}});
    jumpers_.push_back({.body = body, .color = from_hue(random_.uniform(0.25f, 0.5f), 0.5f, 0.58f), .run = way, .next_jump = first_jump});
}

const OneWay::Jumper* OneWay::find(BodyId body) const
{
    for (const Jumper& jumper : jumpers_)
        if (jumper.body == body) return &jumper;
    return nullptr;
}

/// A platform carries what already stands on it, and what comes down from above.
void OneWay::pre_solve(PreSolve& contact)
{
    const bool platform_is_a = std::find(platforms_.begin(), platforms_.end(), contact.shape_a) != platforms_.end();
    const BodyId body = world().shape(platform_is_a ? contact.shape_b : contact.shape_a).body();
    const Vec2 outward = platform_is_a ? contact.manifold.normal : -contact.manifold.normal;
    const Jumper* jumper = find(body);
    const bool drops = jumper && jumper->drops_until > time();
    float deepest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.point_count); ++i)
        deepest = std::min(deepest, contact.manifold.points[i].separation);
    const bool comes_from_above = outward.y > 0.7f && deepest > -0.1f && world().body(body).linear_velocity().y < 0.5f;
    contact.is_enabled = !drops && (contact.was_touching || comes_from_above);
    passes_ += contact.is_enabled ? 0 : 1;
}

bool OneWay::has_footing(BodyId body) const
{
    const ShapeId shape = world().body(body).shapes().front();
    const std::vector<ShapeId> touching = world().shape(shape).touching();
    return std::any_of(touching.begin(), touching.end(), [&](ShapeId other) { return world().manifold(other, shape).normal.y > 0.6f; });
}

void OneWay::move(Jumper& jumper)
{
    Body body = world().body(jumper.body);
    const Vec2 position = body.position();
    if (std::abs(position.x) > field_half - 1) jumper.run = position.x > 0 ? -std::abs(jumper.run) : std::abs(jumper.run);
    if (!has_footing(jumper.body)) return;
    Vec2 velocity = {jumper.run, body.linear_velocity().y};
    if (time() >= jumper.next_jump)
    {
        // Up to the top, and down again through everything.
        const bool is_on_top = position.y > 4 * level_height;
        if (is_on_top) jumper.drops_until = time() + drop_time;
        if (!is_on_top) velocity.y = jump_speed;
        jumper.next_jump = time() + static_cast<double>(random_.uniform(0.5f, 1.6f));
    }
    body.set_linear_velocity(velocity);
}

void OneWay::before_step()
{
    passes_ = 0;
    for (Jumper& jumper : jumpers_) move(jumper);
}

void OneWay::on_pointer(const PointerEvent& event)
{
    const Aabb field = {{-field_half + 1, 0.5f}, {field_half - 1, 30}};
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left) return;
    if (!contains(field, event.position)) return say("Jumpers can be added only inside the field.");
    if (may_add_at(event.position)) add_jumper(event.position);
}

void OneWay::on_key(std::string_view name)
{
    for (Jumper& jumper : jumpers_)
    {
        if (name == "space") jumper.next_jump = time();
        if (name == "down") jumper.drops_until = time() + drop_time;
    }
}

void OneWay::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        if (std::holds_alternative<Segment>(geometry))
            return list.shape(Layer::Bodies, geometry, transform, {.line = chain_color, .line_width = 5});
        const Jumper* jumper = find(world().shape(id).body());
        const bool is_platform = std::find(platforms_.begin(), platforms_.end(), id) != platforms_.end();
        const Color color = jumper ? jumper->color : is_platform ? platform_color : slate;
        list.shape(Layer::Bodies, geometry, transform, {.fill = color, .line = darker(color, 0.35f)});
    });
    // Arrows: this way up.
    const auto arrow = [&](Vec2 tip, Color color)
    {
        for (const float side : {-0.25f, 0.25f}) list.line(Layer::Marks, tip, tip + Vec2{side, -0.3f}, color, 2.5f);
    };
    for (const Platform& platform : platforms)
        for (const float x : {-0.25f, 0.0f, 0.25f})
            arrow(platform.center + Vec2{x * platform.width, -0.35f}, with_alpha(platform_color, 0.7f));
    for (int level = 1; level <= 3; ++level)
        arrow({8, level_height * static_cast<float>(level) - (level % 2 == 1 ? 0.25f : 1.15f)}, with_alpha(chain_color, 0.7f));
    list.text(
        {.text = "boxes, passed from below by a pre-solve hook", .color = platform_color, .place = Place::World, .position = {-9, 15.2f}});
    list.text({.text = "one-sided chains: no hook needed", .color = chain_color, .place = Place::World, .position = {8, 15.2f}});
}

std::string OneWay::status() const
{
    return std::to_string(jumpers_.size()) + " jumpers; contacts let pass in this step: " + std::to_string(passes_);
}

} // namespace

SceneInfo one_way_scene()
{
    return {
        .name = "one-way",
        .title = "One-way platforms",
        .description =
            "Jumpers go up through platforms and land on them: boxes with a pre-solve hook on the left, one-sided chains on the right. On "
            "the topmost box they let themselves down again.",
        .group = "Terrain",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "add a jumper"},
            {Control::Kind::Key, "space", "all that stand jump"},
            {Control::Kind::Key, "down", "all drop through the boxes"},
        }),
        .parameters = with_common_parameters({
            integer("jumpers", {0, 24, 300}, "", Applies::OnRestart, "at the start"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<OneWay>(setup); },
        .own_code = "things jump, and hooks let them through",
    };
}

} // namespace carom::scenes
