// Character: a player that walks a course of stairs, slopes, platforms and crates. It is moved by queries, not by forces.
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

constexpr Vec2 start{-11.8f, 1}; // [m]
constexpr Vec2 ferry_middle{0.75f, -0.2f};
constexpr float ferry_way = 1.45f; // to either side of its middle [m]
constexpr Vec2 lift_middle{7.85f, 1.3f};
constexpr float lift_way = 1.5f; // up and down from its middle [m]
constexpr Vec2 ferry_size{1.55f, 0.4f};
constexpr Vec2 lift_size{1.6f, 0.4f};
constexpr float lost_below = -8; // [m]
constexpr std::size_t trail_points = 150;

constexpr Color player_color = rgb(0.35f, 0.85f, 0.50f);
constexpr Color air_color = rgb(0.45f, 0.70f, 1.0f);
constexpr Color steep_color = rgb(1.0f, 0.62f, 0.25f);
constexpr Color mover_color = rgb(0.45f, 0.50f, 0.75f);
constexpr Color crate_color = rgb(0.72f, 0.54f, 0.34f);

CharacterDef player_def(const Parameters& parameters)
{
    return {.geometry = capsule({0, -0.3f}, {0, 0.3f}, 0.25f),
            .position = start,
            .max_slope = parameters.real("max_slope") * pi / 180,
            .step_height = parameters.real("step_height"),
            .push_force = parameters.real("push_force")};
}

class CharacterCourse : public Scene
{
public:
    explicit CharacterCourse(const SceneSetup& setup);

private:
    void add_course();
    void add_crates();
    BodyId add_mover(Vec2 middle, Vec2 size);
    void drive(BodyId id, Vec2 target);
    void drive_movers();
    void decide();
    bool has_ground_ahead() const;
    void renew_player();

    void on_parameter(std::string_view name) override;
    void on_key(std::string_view name) override;
    void before_step() override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    BodyId ground_;
    BodyId ferry_;
    BodyId lift_;
    BodyId player_body_; ///< goes with the player, so that the world's sensors and queries see it
    std::vector<BodyId> crates_;
    Character player_;
    Vec2 velocity_;
    float heading_ = 1; ///< -1 left, 0 stands, 1 right
    bool wants_jump_ = false;
    bool has_person_ = false; ///< a key was pressed; until then it walks by itself
    float last_x_ = 0;
    int stuck_steps_ = 0;
    std::vector<Vec2> trail_;
};

CharacterCourse::CharacterCourse(const SceneSetup& setup) : Scene(setup, {}), random_(seed(), 1), player_(player_def(setup.parameters))
{
    add_course();
    ferry_ = add_mover(ferry_middle, ferry_size);
    lift_ = add_mover(lift_middle, lift_size);
    add_crates();
    player_body_ = world().create_body({.type = BodyType::Kinematic, .position = start, .name = "player"}, player_.def().geometry,
                                       {.is_sensor = true});
    camera_ = framed(world(), {{-13.6f, -2.4f}, {13.4f, 6.2f}});
}

void CharacterCourse::add_course()
{
    ground_ = world().create_body({.type = BodyType::Static, .name = "course"});
    const auto block = [&](float left, float right, float bottom, float top)
    { world().create_shape(ground_, offset_box(right - left, top - bottom, {0.5f * (left + right), 0.5f * (bottom + top)})); };
    block(-16, -1.5f, -6, 0); // up to the pit
    block(-16, -13, 0, 8);
    for (int i = 0; i < 6; ++i) block(-10.5f + 0.6f * static_cast<float>(i), -6, 0, 0.25f * static_cast<float>(i + 1));
    world().create_shape(ground_, convex_hull(std::array{Vec2{-6, 0}, Vec2{-6, 1.5f}, Vec2{-3, 0}}));
    // The pit, with a way out.
    block(-1.5f, 3, -6, -2);
    world().create_shape(ground_, convex_hull(std::array{Vec2{0.8f, -2}, Vec2{3, -0.01f}, Vec2{3, -2}}));
    block(3, 7, -6, 0);
    block(6.5f, 6.8f, 0, 0.25f); // keeps crates from the lift
    block(7, 8.7f, -6, -0.42f);  // below the lift
    block(8.7f, 16, -6, 2.8f);
    // Steeper than it walks, and a wall.
    world().create_shape(ground_, convex_hull(std::array{Vec2{11, 2.8f}, Vec2{12.6f, 5.6f}, Vec2{12.6f, 2.8f}}));
    block(12.6f, 16, 2.8f, 8);
}

/// Of random sizes, in two heaps.
void CharacterCourse::add_crates()
{
    for (int i = 0; i < integer("crates"); ++i)
    {
        const float side = random_.uniform(0.45f, 0.75f);
        const Vec2 at = {4.4f + 0.85f * static_cast<float>(i % 2) + random_.uniform(-0.05f, 0.05f),
                         0.5f + 0.9f * static_cast<float>(i / 2)};
        crates_.push_back(world().create_body({.position = at, .name = "crate"}, rounded_box(side, side, 0.04f),
                                              {.density = 40, .material = {.friction = 0.5f}}));
    }
}

BodyId CharacterCourse::add_mover(Vec2 middle, Vec2 size)
{
    return world().create_body({.type = BodyType::Kinematic, .position = middle}, rounded_box(size.x, size.y, 0.06f));
}

/// To where it shall be at the end of the coming step, so that things ride on it.
void CharacterCourse::drive(BodyId id, Vec2 target)
{
    Body body = world().body(id);
    body.set_linear_velocity((target - body.position()) / time_step());
}

void CharacterCourse::drive_movers()
{
    const auto then = static_cast<float>(time()) + time_step();
    // Slow at the ends, so that there is time to get on.
    const auto swing = [](float t) { return std::clamp(1.5f * sin_cos(t).sin, -1.0f, 1.0f); };
    drive(ferry_, ferry_middle + Vec2{ferry_way * swing(0.9f * then), 0});
    drive(lift_, lift_middle + Vec2{0, lift_way * swing(0.8f * then)});
}

/// By a ball that is dropped a little ahead of its toes: a ray would fall through the gap before the ferry.
bool CharacterCourse::has_ground_ahead() const
{
    const Vec2 ahead = player_.position() + Vec2{0.5f * heading_, 0};
    return world().cast_circle(ahead, 0.1f, {0, -0.9f}).has_value();
}

/// While nobody plays: walks on, waits at edges, jumps when something is in the way, and turns when that does not help.
void CharacterCourse::decide()
{
    const bool is_on_ground = player_.ground().state == GroundState::OnGround;
    const bool is_on_crate = is_on_ground && world().body(player_.ground().body).type() == BodyType::Dynamic;
    const bool waits = is_on_ground && !is_on_crate && !has_ground_ahead();
    const bool is_stuck = !waits && std::abs(player_.position().x - last_x_) < 0.3f * time_step() * real("speed");
    last_x_ = player_.position().x;
    stuck_steps_ = is_stuck ? stuck_steps_ + 1 : std::max(0, stuck_steps_ - 2);
    wants_jump_ = is_stuck && stuck_steps_ % 30 == 15;
    if (stuck_steps_ > 120)
    {
        heading_ = -heading_;
        stuck_steps_ = 0;
    }
    velocity_.x = waits ? 0 : heading_ * real("speed");
}

void CharacterCourse::before_step()
{
    drive_movers();
    if (has_person_)
        velocity_.x = heading_ * real("speed");
    else
        decide();
    velocity_ += time_step() * world().gravity();
    if (wants_jump_ && player_.ground().state == GroundState::OnGround) velocity_.y = real("jump");
    wants_jump_ = false;
    velocity_ = player_.move(world(), velocity_, time_step());
    if (player_.position().y < lost_below) renew_player();
    drive(player_body_, player_.position());

    trail_.push_back(player_.position());
    if (trail_.size() > trail_points) trail_.erase(trail_.begin());
}

void CharacterCourse::renew_player()
{
    player_.set_position(start);
    world().body(player_body_).set_transform(start, 0);
    velocity_ = {};
    trail_.clear();
}

void CharacterCourse::on_parameter(std::string_view name)
{
    if (name != "max_slope" && name != "step_height" && name != "push_force") return;
    CharacterDef def = player_def(parameters());
    def.position = player_.position();
    player_ = Character(def);
}

void CharacterCourse::on_key(std::string_view name)
{
    has_person_ = true;
    if (name == "left") heading_ = -1;
    if (name == "right") heading_ = 1;
    if (name == "down") heading_ = 0;
    if (name == "up") wants_jump_ = true;
    if (name == "h") renew_player();
}

void CharacterCourse::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const BodyId body = world().shape(id).body();
        if (body == player_body_) return;
        const Color color = body == ground_ ? slate : body == ferry_ || body == lift_ ? mover_color : crate_color;
        list.shape(Layer::Bodies, geometry, transform, {.fill = color, .line = body == ground_ ? Color{} : darker(color, 0.35f)});
    });
    for (std::size_t i = 1; i < trail_.size(); ++i)
    {
        const float age = static_cast<float>(i) / static_cast<float>(trail_points);
        list.line(Layer::Trails, trail_[i - 1], trail_[i], with_alpha(player_color, 0.5f * age), 2);
    }

    const CharacterGround& ground = player_.ground();
    const Color color = ground.state == GroundState::OnGround   ? player_color
                        : ground.state == GroundState::TooSteep ? steep_color
                                                                : air_color;
    list.shape(Layer::Marks, player_.def().geometry, player_.transform(), {.fill = with_alpha(color, 0.85f), .line = lighter(color, 0.3f)});
    list.disc(Layer::Marks, player_.position() + Vec2{0.1f * (heading_ == 0 ? 1 : heading_), 0.3f}, 0.06f, {.fill = night});
    if (ground.state != GroundState::InAir)
    {
        list.disc(Layer::Marks, ground.point, 0.06f, {.fill = paper});
        list.line(Layer::Marks, ground.point, ground.point + 0.7f * ground.normal, paper, 2);
    }
    const auto label = [&](const char* text, Vec2 at)
    { list.text({.text = text, .color = with_alpha(paper, 0.75f), .size = 16, .place = Place::World, .position = at}); };
    label("stairs", {-8.6f, 2.6f});
    label("slope", {-4.2f, 1.9f});
    label("ferry", {0.75f, 1.1f});
    label("crates to push", {4.8f, 3.4f});
    label("lift", {7.85f, 5.1f});
    label("too steep", {11.3f, 6.1f});
}

std::string CharacterCourse::status() const
{
    const CharacterGround& ground = player_.ground();
    const std::string speed = to_text(std::round(10 * static_cast<double>(std::abs(velocity_.x))) / 10.0) + " m/s";
    if (ground.state == GroundState::InAir) return "in the air, " + speed;
    const auto slope = static_cast<int>(std::round(std::abs(atan2(ground.normal.x, ground.normal.y)) * 180 / pi));
    const char* const what = ground.body == ferry_ ? "on the ferry, " : ground.body == lift_ ? "on the lift, " : "on ground, ";
    return (ground.state == GroundState::TooSteep ? "on ground that is too steep, " : what) + std::to_string(slope) + " degrees, " + speed;
}

} // namespace

SceneInfo character_scene()
{
    return {
        .name = "character",
        .title = "Character",
        .description =
            "A player walks a course: stairs, a slope, a ferry across a pit, crates, a lift, and a slope that is too steep. It is green "
            "on ground, blue in the air and orange where it slides; the line is the normal of what it stands on. Until a key is pressed it "
            "walks by itself.",
        .group = "Queries",
        .controls = with_common_controls({
            {Control::Kind::Key, "left", "walk to the left"},
            {Control::Kind::Key, "right", "walk to the right"},
            {Control::Kind::Key, "down", "stand"},
            {Control::Kind::Key, "up", "jump"},
            {Control::Kind::Key, "h", "home: back to the start"},
        }),
        .parameters = with_common_parameters({
            real("speed", {0.5, 3, 20}, "m/s", Applies::Live, "of walking"),
            real("jump", {0, 5.5, 20}, "m/s", Applies::Live, "speed of a jump"),
            real("max_slope", {0, 50, 85}, "degrees", Applies::Live, "steepest slope that it walks on"),
            real("step_height", {0, 0.3, 2}, "m", Applies::Live, "highest step that it walks up"),
            real("push_force", {0, 400, 5000}, "N", Applies::Live, "with which it pushes crates"),
            integer("crates", {0, 4, 20}, "", Applies::OnRestart, "in two heaps"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<CharacterCourse>(setup); },
        .own_code = "the player walks, and platforms are driven",
    };
}

} // namespace carom::scenes
