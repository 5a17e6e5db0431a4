// Bullets: things far too fast for the step meet thin walls, a swinging bat, and each other. Nothing passes through anything, until continuous
// collision is switched off.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <array>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float field_half = 20;      // half the width of the field [m]
constexpr float field_height = 22;    // [m]
constexpr float bullet_radius = 0.1f; // [m]
constexpr double volley_every = 1.2;  // [s]
constexpr std::array wall_places = {-6.0f, 0.0f, 6.0f};
constexpr Color bullet_color = rgb(0.95f, 0.45f, 0.30f);
constexpr Color crate_color = rgb(0.45f, 0.60f, 0.80f);

class Bullets : public Scene
{
public:
    explicit Bullets(const SceneSetup& setup);

private:
    void add_field();
    void shoot(Vec2 from, Vec2 velocity);
    void volley();

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void before_step() override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    std::vector<BodyId> bullets_;
    BodyId bat_;
    double next_volley_ = volley_every;
    int shots_ = 0;
    int escaped_ = 0;
    std::vector<std::pair<Vec2, Vec2>> tracers_; ///< where each bullet went in the last step
};

Bullets::Bullets(const SceneSetup& setup)
    : Scene(setup, {.gravity = {0, -10}, .continuous = setup.parameters.boolean("continuous")}),
      random_(seed(), 1)
{
    add_field();
    volley();
    camera_ = framed_field({{-field_half, -0.5f}, {field_half, field_height}});
}

void Bullets::add_field()
{
    // Walls of no thickness: the hardest case.
    const BodyId frame = world().create_body({.type = BodyType::Static, .name = "frame"});
    const std::array corners = {Vec2{-field_half, 0}, Vec2{field_half, 0}, Vec2{field_half, field_height}, Vec2{-field_half, field_height}};
    for (std::size_t i = 0; i < corners.size(); ++i) world().create_shape(frame, segment(corners[i], corners[(i + 1) % corners.size()]));
    for (const float x : wall_places) world().create_shape(frame, offset_box(0.05f, 7, {x, 3.5f}));

    for (std::size_t i = 0; i < wall_places.size(); ++i)
        for (int level = 0; level < 4; ++level)
            world().create_body({.position = {wall_places[i] + 2.5f, 0.5f + static_cast<float>(level)}}, box(1, 1));
    bat_ = world().create_body({.type = BodyType::Kinematic, .position = {0, 15}, .angular_velocity = 25, .name = "bat"}, box(7, 0.15f));
}

void Bullets::shoot(Vec2 from, Vec2 velocity)
{
    if (!may_add_at(from)) return;
    if (bullets_.size() >= static_cast<std::size_t>(integer("bullets")))
    {
        world().destroy_body(bullets_.front());
        bullets_.erase(bullets_.begin());
    }
    const Geometry geometry = shots_ % 2 == 0 ? Geometry(circle(bullet_radius)) : Geometry(box(0.25f, 0.16f));
    bullets_.push_back(world().create_body({.position = from, .linear_velocity = velocity, .is_bullet = true}, geometry,
                                           {.density = 4, .material = {.restitution = real("restitution")}}));
    ++shots_;
}

/// From both sides at once, at heights where they may meet.
void Bullets::volley()
{
    const float speed = real("speed");
    for (int i = 0; i < 3; ++i)
    {
        const float height = random_.uniform(1, field_height - 1);
        const float slant = random_.uniform(-0.15f, 0.15f);
        shoot({-field_half + 0.5f, height}, speed * normalize(Vec2{1, slant}));
        shoot({field_half - 0.5f, height + random_.uniform(-0.05f, 0.05f)}, speed * normalize(Vec2{-1, -slant}));
    }
}

void Bullets::on_parameter(std::string_view name)
{
    if (name == "continuous") world().set_continuous(boolean("continuous"));
}

void Bullets::on_pointer(const PointerEvent& event)
{
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left) return;
    const Vec2 muzzle = {-field_half + 0.5f, 8};
    const Vec2 aim = normalize(event.position - muzzle);
    shoot(muzzle, real("speed") * (aim == Vec2{} ? Vec2{1, 0} : aim));
}

void Bullets::on_key(std::string_view name)
{
    if (name == "space") volley();
    if (name == "c") toggle("continuous");
}

void Bullets::before_step()
{
    if (time() < next_volley_) return;
    next_volley_ = time() + volley_every;
    volley();
}

void Bullets::after_step(const StepReport&)
{
    tracers_.clear();
    const auto has_left = [&](BodyId body)
    {
        const Body bullet = world().body(body);
        const Vec2 p = bullet.position();
        tracers_.emplace_back(p - time_step() * bullet.linear_velocity(), p);
        if (std::abs(p.x) <= field_half && p.y >= 0 && p.y <= field_height) return false;
        world().destroy_body(body);
        ++escaped_;
        return true;
    };
    std::erase_if(bullets_, has_left);
}

void Bullets::on_draw(DrawList& list) const
{
    for (const auto& [from, to] : tracers_) list.line(Layer::Trails, from, to, with_alpha(bullet_color, 0.35f), 3);
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const BodyView body = world().body(world().shape(id).body());
        if (std::holds_alternative<Segment>(geometry))
            return list.shape(Layer::Bodies, geometry, transform, {.line = paper, .line_width = 3});
        const Color color = body.is_bullet() ? bullet_color : body.type() == BodyType::Dynamic ? crate_color : slate;
        list.shape(Layer::Bodies, geometry, transform, {.fill = color, .line = darker(color, 0.35f)});
    });
}

std::string Bullets::status() const
{
    return std::to_string(shots_) + " shots at " + to_text(static_cast<double>(real("speed"))) + " m/s, " + std::to_string(escaped_) +
           " escaped; continuous collision " + (boolean("continuous") ? "on" : "off");
}

} // namespace

SceneInfo bullets_scene()
{
    return {
        .name = "bullets",
        .title = "Bullets",
        .description =
            "Volleys from both sides, several metres a step, against walls of 5 cm, lines without thickness, a whirling bat, and each "
            "other. Switch continuous collision off and see them leave.",
        .group = "Motion",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "shoot from the left at the pointer"},
            {Control::Kind::Key, "space", "a volley from both sides"},
            {Control::Kind::Key, "c", "switch continuous collision"},
        }),
        .parameters = with_common_parameters({
            boolean("continuous", true, Applies::Live, "stop fast bodies at what they would pass through"),
            real("speed", {10, 250, 2000}, "m/s", Applies::Live, "of the next bullets"),
            real("restitution", {0, 0.3, 1}, "", Applies::Live, "of the next bullets"),
            integer("bullets", {1, 60, 1000}, "", Applies::Live, "most at a time; the oldest go"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Bullets>(setup); },
        .own_code = "volleys are fired, and bullets that leave the field are taken away",
    };
}

} // namespace carom::scenes
