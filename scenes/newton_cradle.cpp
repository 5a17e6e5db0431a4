// Newton's cradle: balls on rods hand their momentum on, as many at the far end as were lifted at this one.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom::scenes
{

namespace
{

constexpr float radius = 0.5f;
constexpr float rod = 4;                                  // [m]
constexpr float push_speed = 2;                           // [m/s]
constexpr float degree = std::numbers::pi_v<float> / 180; // [rad]

class NewtonCradle : public Scene
{
public:
    explicit NewtonCradle(const SceneSetup& setup);

private:
    Vec2 top(std::size_t ball) const;
    void lift();
    float momentum() const;

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    std::vector<BodyId> balls_; ///< from left to right
};

NewtonCradle::NewtonCradle(const SceneSetup& setup)
    : Scene(setup, {.gravity = {0, -9.81f}, .solver = {.restitution_threshold = 0.05f}}),
      random_(seed(), 1)
{
    const auto count = static_cast<std::size_t>(integer("balls"));
    for (std::size_t i = 0; i < count; ++i)
    {
        // Neither rubbing nor losing speed.
        const ShapeDef def{.material = {.friction = 0, .restitution = 1}};
        const float x = 2 * radius * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
        balls_.push_back(world().create_body({.position = {x, 0}}, circle(radius), def));
        world().create_joint(world().joint_between({}, balls_.back(), {x, rod}, {x, 0}), DistanceJoint{.length = rod});
    }
    lift();
    camera_ = framed(world(), {{-5.7f, -0.7f}, {5.7f, 4.5f}});
}

/// Where the rod of a ball hangs.
Vec2 NewtonCradle::top(std::size_t ball) const
{
    return {2 * radius * (static_cast<float>(ball) - 0.5f * static_cast<float>(balls_.size() - 1)), rod};
}

/// All balls at rest, the first ones lifted to the left.
void NewtonCradle::lift()
{
    const auto lifted = static_cast<std::size_t>(integer("lifted"));
    const float angle = -degree * (real("angle") + random_.uniform(-0.5f, 0.5f));
    for (std::size_t i = 0; i < balls_.size(); ++i)
    {
        const Rot q = rotation(i < lifted ? angle : 0);
        Body ball = world().body(balls_[i]);
        ball.set_transform(top(i) + rotate(q, Vec2{0, -rod}), 0);
        ball.set_linear_velocity({});
        ball.set_angular_velocity(0);
    }
}

void NewtonCradle::on_parameter(std::string_view name)
{
    if (name == "lifted" || name == "angle") lift();
}

void NewtonCradle::on_pointer(const PointerEvent& event)
{
    if (event.action != PointerEvent::Action::Down) return;
    const bool is_left = event.button == PointerEvent::Button::Left;
    if (!is_left && event.button != PointerEvent::Button::Right) return;
    const std::optional<ShapeId> shape = shape_at(world(), event.position);
    if (!shape) return say("There is no ball there.");
    Body ball = world().body(world().shape(*shape).body());
    const float speed = is_left ? -push_speed : push_speed;
    ball.apply_impulse_to_center({speed * ball.mass_data().mass, 0});
}

void NewtonCradle::on_key(std::string_view name)
{
    if (name == "space") return lift();
    const int lifted = integer("lifted") + (name == "up" ? 1 : -1);
    const int most = static_cast<int>(balls_.size());
    set_parameter("lifted", std::clamp(lifted, 1, most));
}

void NewtonCradle::on_draw(DrawList& list) const
{
    const auto count = static_cast<float>(balls_.size());
    const Vec2 half{radius * count + 0.3f, 0.15f};
    list.box(Layer::Bodies, {Vec2{0, rod} - half, Vec2{0, rod} + half}, {.fill = slate});
    for (std::size_t i = 0; i < balls_.size(); ++i)
    {
        const Vec2 place = world().body(balls_[i]).position();
        const Color color = from_hue(0.55f + 0.4f * static_cast<float>(i) / count, 0.5f, 0.6f);
        list.line(Layer::Trails, top(i), place, with_alpha(paper, 0.6f), 2);
        list.disc(Layer::Bodies, place, radius, {.fill = color, .line = darker(color, 0.35f)});
    }
}

/// To the right, of all balls [N s].
float NewtonCradle::momentum() const
{
    float sum = 0;
    for (const BodyId ball : balls_) sum += world().body(ball).mass_data().mass * world().body(ball).linear_velocity().x;
    return sum;
}

std::string NewtonCradle::status() const
{
    return std::to_string(integer("lifted")) + " of " + std::to_string(balls_.size()) + " balls lifted, momentum " +
           to_text(std::round(10 * momentum()) / 10.0) + " N s";
}

} // namespace

SceneInfo newton_cradle_scene()
{
    return {
        .name = "newton-cradle",
        .title = "Newton's cradle",
        .description = "Balls hang on rods and touch. As many leave at the far end as came down at this one, and equally fast.",
        .group = "Joints",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "push a ball to the left"},
            {Control::Kind::Pointer, "right", "push a ball to the right"},
            {Control::Kind::Key, "space", "lift again"},
            {Control::Kind::Key, "up", "lift one ball more"},
            {Control::Kind::Key, "down", "lift one ball less"},
        }),
        .parameters = with_common_parameters({
            integer("balls", {3, 5, 9}, "", Applies::OnRestart, "on rods"),
            integer("lifted", {1, 1, 9}, "", Applies::Live, "balls that are lifted"),
            real("angle", {5, 50, 80}, "deg", Applies::Live, "to which they are lifted, give or take half a degree"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<NewtonCradle>(setup); },
    };
}

} // namespace carom::scenes
