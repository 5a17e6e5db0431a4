// A car with two sprung wheels drives over bumps, a seesaw, a hanging bridge and a jump, through a stack of boxes.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/painted_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float wheel_radius = 0.5f; // [m]
constexpr float start_wall = -10;    // [m]
constexpr float bumps_at = 9;        // [m]
constexpr int bumps = 6;             // every 2 m
constexpr float hills_at = 23;       // [m]
constexpr float hill_length = 11;    // [m]
constexpr int hills = 2;             // [m]
constexpr float seesaw_at = 54;      // [m]
constexpr float gap_from = 68;       // [m]
constexpr float gap_to = 82;         // [m]
constexpr int planks = 14;           // of the bridge over the gap
constexpr float sag = 0.5f;          // of the bridge [m]
constexpr float boxes_at = 122;      // [m]
constexpr float ramp_at = 90;        // [m]
constexpr float ramp_length = 10;    // [m]
constexpr float ramp_height = 2;     // [m]
constexpr float goal = 142;          // behind it the car brakes [m]
constexpr float end_wall = 162;      // [m]
constexpr int car_group = -1;        // its parts do not touch each other
constexpr int bridge_group = -2;     // nor do the planks touch the banks
constexpr double patience = 2.5;     // of a car that stands still before it starts again [s]
constexpr float lost_beyond = 60;    // [m]
constexpr Vec2 car_place{0, 1.05f};  // of the car at the start [m]
constexpr Vec2 ahead{2.8f, 1.1f};    // of the car is the middle of what the picture is about [m]
constexpr Vec2 look_around{6.4f, 3}; // half of its size [m]
constexpr float deepest = -12;       // to which the ground is drawn [m]
constexpr Color wood = rgb(0.68f, 0.52f, 0.36f);
constexpr Color paint = rgb(0.85f, 0.33f, 0.30f);

class Car : public PaintedScene
{
public:
    explicit Car(const SceneSetup& setup);

private:
    void add_road();
    void add_seesaw();
    void add_bridge();
    void add_boxes();
    void add_car();
    void drive(int direction);
    void start_again();
    bool is_stuck() const;

    void on_parameter(std::string_view name) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    void draw_marks(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    BodyId chassis_;
    std::array<BodyId, 2> wheels_;
    std::array<JointId, 2> axles_;
    std::vector<BodyId> boxes_;
    std::vector<Vec2> road_;
    int direction_ = 1;     ///< 1 to the right, -1 to the left, 0 brakes
    Vec2 seen_from_car_;    ///< the middle of the picture [m]
    double last_moved_ = 0; ///< when the car was last seen to move [s]
};

Car::Car(const SceneSetup& setup) : PaintedScene(setup, WorldDef{}), random_(seed(), 1)
{
    camera_ = framed({car_place + ahead - look_around, car_place + ahead + look_around});
    seen_from_car_ = camera_.center - car_place;
    add_road();
    add_seesaw();
    add_bridge();
    add_boxes();
    add_car();
    drive(1);
}

void Car::add_road()
{
    std::vector<Vec2> points = {{start_wall, 12}, {start_wall, 0}, {bumps_at, 0}};
    for (int i = 0; i < bumps; ++i)
    {
        const float x = bumps_at + 2 * static_cast<float>(i);
        const float height = 0.1f + 0.03f * static_cast<float>(i) + random_.uniform(0, 0.06f);
        points.insert(points.end(), {{x + 1, height}, {x + 2, 0}});
    }
    constexpr int pieces = 22; // of a hill
    for (int i = 0; i <= hills * pieces; ++i)
    {
        const float x = hill_length * static_cast<float>(i) / pieces;
        points.push_back({hills_at + x, 0.75f - 0.75f * sin_cos(2 * pi * x / hill_length).cos});
    }
    points.insert(points.end(), {{gap_from, 0},
                                 {gap_from + 1.5f, -4},
                                 {gap_to - 1.5f, -4},
                                 {gap_to, 0},
                                 {ramp_at, 0},
                                 {ramp_at + ramp_length, ramp_height},
                                 {ramp_at + ramp_length + 1.5f, ramp_height},
                                 {ramp_at + ramp_length + 1.6f, 0},
                                 {end_wall, 0},
                                 {end_wall, 12}});
    add_ground(points, {.friction = 0.9f}, {.group = bridge_group});
    road_ = points;
}

/// Its ends are wedges, so that a wheel gets onto it without a blow. A weight under its left half lets it come down again on the side from
/// which the car comes.
void Car::add_seesaw()
{
    const Vec2 pivot{seesaw_at, 0.9f};
    add_static(convex_hull(std::array{pivot - Vec2{0, 0.12f}, Vec2{seesaw_at - 0.7f, 0}, Vec2{seesaw_at + 0.7f, 0}}));
    constexpr float tilt = 0.205f; // its ends then lie on the ground [rad]
    const ShapeDef plank{.density = 1.2f, .material = {.friction = 0.9f}};
    const std::array corners = {Vec2{-5, 0.12f}, Vec2{-3.8f, -0.12f}, Vec2{3.8f, -0.12f}, Vec2{5, 0.12f}};
    const BodyId seesaw = add({.position = pivot, .angle = tilt, .name = "seesaw"}, convex_hull(corners), wood, plank);
    add_shape(seesaw, offset_box(0.8f, 0.3f, {-2.2f, -0.27f}), darker(wood, 0.3f), {.density = 4});
    JointDef def = world().joint_at({}, seesaw, pivot);
    def.frame_b.q = {}; // its angle is that of the plank
    world().create_joint(def, RevoluteJoint{.limit = Range{-tilt, tilt}});
}

/// Along a parabola, so that the chain has slack and its tension stays finite.
void Car::add_bridge()
{
    const auto pin = [](int i)
    {
        const float t = 2 * static_cast<float>(i) / static_cast<float>(planks) - 1;
        return Vec2{0.5f * (gap_from + gap_to + (gap_to - gap_from) * t), sag * (t * t - 1) - 0.1f};
    };
    BodyId before;
    for (int i = 0; i < planks; ++i)
    {
        const Vec2 along = pin(i + 1) - pin(i);
        const BodyId plank =
            add({.position = 0.5f * (pin(i) + pin(i + 1)), .angle = atan2(along.y, along.x)}, box(length(along) - 0.04f, 0.2f), wood,
                {.density = 2, .material = {.friction = 0.9f}, .filter = {.group = bridge_group}});
        world().create_joint(world().joint_at(before, plank, pin(i)), RevoluteJoint{});
        before = plank;
    }
    world().create_joint(world().joint_at({}, before, pin(planks)), RevoluteJoint{});
}

void Car::add_boxes()
{
    constexpr float size = 0.8f;
    for (int row = 0; row < 3; ++row)
    {
        for (int i = 0; i < 3 - row; ++i)
        {
            const Vec2 place{boxes_at + 1.03f * size * (static_cast<float>(i) + 0.5f * static_cast<float>(row)),
                             size * (0.5f + static_cast<float>(row))};
            boxes_.push_back(add({.position = place}, box(size, size), from_hue(0.05f + 0.03f * static_cast<float>(row), 0.55f, 0.55f),
                                 {.density = 0.05f}));
        }
    }
}

void Car::add_car()
{
    const Filter apart{.group = car_group};
    const ShapeDef metal{.material = {.friction = 0.3f}, .filter = apart};
    const Vec2 place = car_place;
    const std::array body = {Vec2{-1.9f, -0.3f}, Vec2{1.85f, -0.3f}, Vec2{2, 0.05f}, Vec2{1.1f, 0.3f}, Vec2{-1.95f, 0.32f}};
    chassis_ = add({.position = place, .name = "car"}, convex_hull(body), paint, metal);
    const std::array cabin = {Vec2{-1.3f, 0.3f}, Vec2{0.9f, 0.3f}, Vec2{0.3f, 0.88f}, Vec2{-0.9f, 0.88f}};
    add_shape(chassis_, convex_hull(cabin), lighter(slate, 0.35f), {.density = 0.2f, .material = {.friction = 0.3f}, .filter = apart});
    const ShapeDef tyre{.density = 0.9f, .material = {.friction = 1.2f}, .filter = apart};
    for (std::size_t i = 0; i < wheels_.size(); ++i)
    {
        const Vec2 hub = place + Vec2{i == 0 ? -1.2f : 1.2f, -0.5f};
        wheels_[i] = add({.position = hub}, circle(wheel_radius), rgb(0.30f, 0.32f, 0.37f), tyre);
        axles_[i] = world().create_joint(world().joint_at(chassis_, wheels_[i], hub, pi / 2), WheelJoint{});
    }
}

/// Both wheels are driven; a motor that holds them is the brake.
void Car::drive(int direction)
{
    direction_ = direction;
    last_moved_ = time();
    const float speed = -real("speed") / wheel_radius * static_cast<float>(direction);
    const WheelJoint wheel{
        .suspension = Spring{real("suspension"), 0.7f}, .limit = Range{-0.25f, 0.25f}, .motor = Motor{speed, real("torque")}};
    for (const JointId axle : axles_) world().joint(axle).set_spec(wheel);
}

/// A new car, and the boxes stacked again.
void Car::start_again()
{
    world().destroy_body(chassis_);
    for (const BodyId wheel : wheels_) world().destroy_body(wheel);
    for (const BodyId box : boxes_) world().destroy_body(box);
    boxes_.clear();
    add_boxes();
    add_car();
    drive(1);
    camera_.center = car_place + seen_from_car_;
}

/// At the goal, on its back, in the gap or far away: it has stood still though it should not, or can't be seen any more.
bool Car::is_stuck() const
{
    const Vec2 place = world().body(chassis_).position();
    const bool is_lost = std::abs(place.y) > lost_beyond || place.x < start_wall - lost_beyond || place.x > end_wall + lost_beyond;
    const bool should_move = direction_ != 0 || place.x > goal;
    return is_lost || (should_move && time() > last_moved_ + patience);
}

void Car::on_parameter(std::string_view name)
{
    if (name == "speed" || name == "torque" || name == "suspension") drive(direction_);
}

void Car::on_key(std::string_view name) { drive(name == "right" ? 1 : name == "left" ? -1 : 0); }

void Car::after_step(const StepReport&)
{
    const BodyView car = world().body(chassis_);
    if (length(car.linear_velocity()) > 0.3f) last_moved_ = time();
    if (direction_ > 0 && car.position().x > goal) drive(0);
    if (is_stuck()) start_again();
    const Vec2 wanted = world().body(chassis_).position() + seen_from_car_;
    camera_.center += 0.08f * (wanted - camera_.center);
}

/// The ground under the road, as far as it can be seen.
void Car::on_draw(DrawList& list) const
{
    constexpr Color soil = darker(slate, 0.35f);
    for (std::size_t i = 1; i < road_.size(); ++i)
    {
        const Vec2 a = road_[i - 1];
        const Vec2 b = road_[i];
        if (std::abs(0.5f * (a.x + b.x) - camera_.center.x) > 3 * camera_.height + 0.5f * std::abs(b.x - a.x)) continue;
        if (std::abs(b.x - a.x) < 0.01f) continue; // the walls at the ends
        const std::array corners = {a, b, Vec2{b.x, deepest}, Vec2{a.x, deepest}};
        list.shape(Layer::Background, convex_hull(corners), {}, {.fill = soil, .line = soil, .line_width = 1});
    }
    PaintedScene::on_draw(list);
}

void Car::draw_marks(DrawList& list) const
{
    for (const BodyId wheel : wheels_)
    {
        const Transform hub = world().body(wheel).transform();
        constexpr float rim = 0.55f * wheel_radius;
        list.disc(Layer::Marks, hub.p, rim, {.fill = rgb(0.72f, 0.74f, 0.78f)});
        for (const float turn : {0.0f, 2 * pi / 3, 4 * pi / 3})
        {
            const SinCos v = sin_cos(turn);
            list.line(Layer::Marks, hub.p, hub * (rim * Vec2{v.cos, v.sin}), rgb(0.30f, 0.32f, 0.37f), 2);
        }
    }
    const auto sign = [&](float x, const char* words) { label(list, {x, -0.9f}, words); };
    sign(2, "left and right drive, space brakes");
    sign(bumps_at + bumps, "bumps");
    sign(hills_at + 0.5f * hills * hill_length, "hills");
    sign(seesaw_at, "a seesaw");
    label(list, {0.5f * (gap_from + gap_to), -4.7f}, "a bridge of " + std::to_string(planks) + " planks on pins");
    sign(boxes_at + 1, "boxes");
    sign(ramp_at + ramp_length, "a jump");
    sign(goal, "the goal");
}

std::string Car::status() const
{
    const BodyView car = world().body(chassis_);
    const float speed = length(car.linear_velocity());
    const std::string words = direction_ > 0 ? "drives to the right" : direction_ < 0 ? "drives to the left" : "brakes";
    return words + ", " + to_text(std::round(10 * static_cast<double>(speed)) / 10) + " m/s, at " +
           std::to_string(static_cast<int>(std::round(car.position().x))) + " m";
}

} // namespace

SceneInfo car_scene()
{
    return {
        .name = "car",
        .title = "Car",
        .description =
            "A car on two sprung, driven wheels goes over bumps, hills, a seesaw and a hanging bridge, over a jump and through boxes, then "
            "starts again.",
        .group = "Joints",
        .controls = with_common_controls({
            drag_control(),
            {Control::Kind::Key, "right", "drive to the right"},
            {Control::Kind::Key, "left", "drive to the left"},
            {Control::Kind::Key, "space", "brake"},
        }),
        .parameters = with_common_parameters({
            real("speed", {1, 9, 40}, "m/s", Applies::Live, "that the motor drives towards"),
            real("torque", {0, 8, 200}, "N m", Applies::Live, "of the motor, at each wheel"),
            real("suspension", {1, 4, 20}, "1/s", Applies::Live, "swings of the springs in a second"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Car>(setup); },
        .drags_bodies = true,
        .own_code = "the driver stops at the goal, and starts again when the car is stuck",
    };
}

} // namespace carom::scenes
