// Sleep: a city of towers that has come to rest and costs nothing, and what wakes when something happens.
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

constexpr float brick = 1;   // [m]
constexpr float spacing = 3; // between towers [m]
constexpr std::array awake_colors = {rgb(0.95f, 0.62f, 0.25f), rgb(0.90f, 0.40f, 0.45f), rgb(0.55f, 0.75f, 0.35f), rgb(0.35f, 0.70f, 0.80f),
                                     rgb(0.70f, 0.50f, 0.85f)};
constexpr Color asleep_color = rgb(0.33f, 0.37f, 0.45f);

class Sleep : public Scene
{
public:
    explicit Sleep(const SceneSetup& setup);

private:
    void drop_ball(Vec2 position);

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void before_step() override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    double next_ball_ = 6;
    int islands_ = 0;
    int awake_ = 0;
    float half_width_ = 0;
    float drop_height_ = 0; ///< of balls that come by themselves [m]
};

Sleep::Sleep(const SceneSetup& setup)
    : Scene(setup, {.gravity = {0, -10}, .sleep = {.is_enabled = setup.parameters.boolean("sleep")}}),
      random_(seed(), 1)
{
    const int towers = integer("towers");
    const int floors = integer("floors");
    half_width_ = 0.5f * spacing * static_cast<float>(towers);
    world().create_body({.type = BodyType::Static, .name = "ground"}, offset_box(2 * half_width_ + 40, 4, {0, -2}));
    for (int tower = 0; tower < towers; ++tower)
    {
        const float x = spacing * (static_cast<float>(tower) + 0.5f) - half_width_;
        for (int floor = 0; floor < floors; ++floor)
        {
            // They drop into place.
            const float drop = 0.6f + 0.02f * static_cast<float>(floor);
            const float aside = random_.uniform(-0.02f, 0.02f);
            world().create_body({.position = {x + aside, brick * (static_cast<float>(floor) + 0.5f) + drop}}, box(brick, brick));
        }
    }
    const float height = std::max(1.2f * half_width_, brick * static_cast<float>(floors) + 8);
    drop_height_ = 0.42f * height + 0.5f * height;
    camera_ = framed({{-half_width_ - 1, -0.06f * height}, {half_width_ + 1, 0.8f * height}});
}

void Sleep::drop_ball(Vec2 position)
{
    if (!may_add_at(position)) return;
    world().create_body({.position = position, .linear_velocity = {random_.uniform(-3, 3), -5}}, circle(0.7f), {.density = 2});
}

void Sleep::on_parameter(std::string_view name)
{
    if (name != "sleep") return;
    SleepTuning tuning = world().sleep_tuning();
    tuning.is_enabled = boolean("sleep");
    world().set_sleep_tuning(tuning);
}

void Sleep::on_pointer(const PointerEvent& event)
{
    if (event.action == PointerEvent::Action::Down && event.button == PointerEvent::Button::Left) drop_ball(event.position);
}

void Sleep::on_key(std::string_view name)
{
    if (name == "w") world().wake_all();
    if (name == "s") toggle("sleep");
}

void Sleep::before_step()
{
    if (time() < next_ball_) return;
    next_ball_ = time() + 5;
    if (boolean("balls")) drop_ball({random_.uniform(-half_width_, half_width_), drop_height_});
}

void Sleep::after_step(const StepReport& report)
{
    islands_ = report.islands;
    awake_ = report.awake_bodies;
}

/// Those that are awake shine.
void Sleep::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const BodyView body = world().body(world().shape(id).body());
        const bool is_static = body.type() == BodyType::Static;
        const Color bright = awake_colors[static_cast<std::size_t>(std::abs(body.position().x) / spacing) % awake_colors.size()];
        const Color color = is_static ? slate : body.is_awake() ? bright : asleep_color;
        list.shape(Layer::Bodies, geometry, transform, {.fill = color, .line = darker(color, 0.35f)});
    });
}

std::string Sleep::status() const
{
    return std::to_string(awake_) + " of " + std::to_string(world().body_count() - 1) + " bodies awake, in " + std::to_string(islands_) +
           " islands";
}

} // namespace

SceneInfo sleep_scene()
{
    return {
        .name = "sleep",
        .title = "Sleep",
        .description =
            "Towers come to rest, fall asleep and cost nothing. A ball wakes the tower that it hits and no other. Bright bodies are awake.",
        .group = "Gravity",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a ball"},
            {Control::Kind::Key, "w", "wake all"},
            {Control::Kind::Key, "s", "switch sleep"},
        }),
        .parameters = with_common_parameters({
            integer("towers", {1, 16, 1000}, "", Applies::OnRestart, "number of towers"),
            integer("floors", {1, 6, 12}, "", Applies::OnRestart, "bricks of each"),
            boolean("sleep", true, Applies::Live, "let what has come to rest sleep"),
            boolean("balls", true, Applies::Live, "a ball falls every five seconds"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Sleep>(setup); },
        .own_code = "balls are dropped",
    };
}

} // namespace carom::scenes
