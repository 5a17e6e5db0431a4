// Joints: an exhibit of each of the nine types, all moving by themselves, and a spring that tears. Everything is within reach of the pointer.
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

constexpr Vec2 cell{6.4f, 8.2f}; // of an exhibit [m]
constexpr std::size_t columns = 5;

struct Exhibit
{
    const char* name;
    const char* what;
};
constexpr std::array exhibits = {
    Exhibit{"Revolute", "motor, limits; free pin"}, Exhibit{"Prismatic", "motor; spring on a rail"},
    Exhibit{"Distance", "rod, rope, spring"},       Exhibit{"Weld", "stiff and soft"},
    Exhibit{"Wheel", "suspension and motor"},       Exhibit{"Motor", "led to a pose"},
    Exhibit{"Mouse", "pulled to a point"},          Exhibit{"Gear", "two wheels and a rack"},
    Exhibit{"Pulley", "one rope, two weights"},     Exhibit{"Break", "a spring that tears"},
};

constexpr Color red = rgb(0.86f, 0.38f, 0.34f);
constexpr Color blue = rgb(0.36f, 0.56f, 0.84f);
constexpr Color green = rgb(0.40f, 0.70f, 0.50f);
constexpr Color yellow = rgb(0.88f, 0.72f, 0.36f);
constexpr Color violet = rgb(0.62f, 0.50f, 0.82f);
constexpr Color rubber = rgb(0.35f, 0.37f, 0.42f);

constexpr Range arm_limit{-2.3f, 0.6f};       // of the driven arm [rad]
constexpr float arm_length = 1.5f;            // [m]
constexpr float rail_half = 1.9f;             // [m]
constexpr float rail_tilt = 0.5f;             // of the rail with the spring [rad]
constexpr float small_gear = 0.55f;           // its radius [m]
constexpr float large_gear = 1.05f;           // [m]
constexpr int teeth_of_small = 11;            // the large one has 21: the same pitch
constexpr float pulley_drop = 2.6f;           // from a wheel of the pulley to its weight at the start [m]
constexpr float tear_force = 32;              // of the spring with the bucket [N]
constexpr float ball_radius = 0.17f;          // [m]
constexpr double ball_every = 0.6;            // [s]
constexpr std::size_t most_balls = 30;        // in the bucket
constexpr double seconds_after_tearing = 3.5; // until the bucket hangs again
constexpr float lost_beyond = 40;             // where a thing that was thrown away is put back [m]

/// The middle of an exhibit's stage, in rows of five from the top left.
Vec2 center_of(std::size_t exhibit)
{
    const auto column = static_cast<float>(exhibit % columns);
    const auto row = static_cast<float>(exhibit / columns);
    return {(column - 2) * cell.x, (0.5f - row) * cell.y};
}

class Joints : public PaintedScene
{
public:
    explicit Joints(const SceneSetup& setup);

private:
    void add_revolute(Vec2 c);
    void add_prismatic(Vec2 c);
    void add_distance(Vec2 c);
    void add_weld(Vec2 c);
    void add_track(Vec2 c);
    void add_cart(Vec2 c);
    void add_motor(Vec2 c);
    void add_mouse(Vec2 c);
    void add_gear(Vec2 c);
    void add_pulley(Vec2 c);
    void hang_bucket();
    void remove_bucket();
    void drop_ball();

    void drive_back_and_forth();
    void drive_targets(float t);
    void drive_bucket();

    void before_step() override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    void draw_marks(DrawList& list) const override;
    void draw_cells(DrawList& list) const;
    void draw_teeth(DrawList& list) const;
    void draw_bucket_load(DrawList& list) const;
    std::string status() const override;

    Random random_;
    JointId arm_;
    JointId slider_;
    JointId sprung_slider_;
    BodyId swing_bar_;
    BodyId rocker_;
    std::array<BodyId, 3> cart_; ///< chassis and wheels
    std::array<JointId, 2> wheels_;
    JointId led_;
    JointId pulled_;
    std::array<BodyId, 3> gears_; ///< small, large, rack
    JointId gear_motor_;
    BodyId lift_;
    BodyId bucket_;
    JointId bucket_spring_;
    std::vector<BodyId> balls_;
    double next_ball_ = 0;
    double torn_at_ = 0; ///< when the spring tore, if it has
    int torn_ = 0;       ///< springs so far
    float phase_;        ///< of what moves to and fro [rad]
};

Joints::Joints(const SceneSetup& setup) : PaintedScene(setup, WorldDef{}), random_(seed(), 1), phase_(random_.uniform(-0.3f, 0.3f))
{
    camera_ = framed(world(), {{-15.5f, -7.2f}, {15.5f, 8.4f}});
    add_revolute(center_of(0));
    add_prismatic(center_of(1));
    add_distance(center_of(2));
    add_weld(center_of(3));
    add_track(center_of(4));
    add_cart(center_of(4));
    add_motor(center_of(5));
    add_mouse(center_of(6));
    add_gear(center_of(7));
    add_pulley(center_of(8));
    add_static(offset_box(5.4f, 0.3f, center_of(9) + Vec2{0, -2.35f}));
    hang_bucket();
}

/// A driven arm, and a bar that hangs free from its end.
void Joints::add_revolute(Vec2 c)
{
    const Vec2 pin = c + Vec2{0, 1.5f};
    const Vec2 elbow = pin + Vec2{arm_length, 0};
    const BodyId arm = add({.position = pin, .name = "arm"}, capsule({0, 0}, {arm_length, 0}, 0.17f), red);
    const BodyId bar = add({.position = elbow}, capsule({0, 0}, {0, -1}, 0.13f), yellow);
    arm_ = world().create_joint(world().joint_at({}, arm, pin), RevoluteJoint{.limit = arm_limit, .motor = Motor{-2, 60}});
    world().create_joint(world().joint_at(arm, bar, elbow), RevoluteJoint{});
}

void Joints::add_prismatic(Vec2 c)
{
    const Vec2 level = c + Vec2{0, 2.3f};
    const BodyId slider = add({.position = level}, rounded_box(1, 0.6f, 0.08f), blue);
    slider_ = world().create_joint(world().joint_at({}, slider, level),
                                   PrismaticJoint{.limit = Range{-rail_half, rail_half}, .motor = Motor{1.8f, 60}});

    const Vec2 middle = c + Vec2{0, -0.2f};
    const Vec2 foot = middle - rotate(rotation(rail_tilt), Vec2{rail_half, 0});
    const BodyId sprung = add({.position = middle, .angle = rail_tilt}, rounded_box(0.9f, 0.6f, 0.08f), green);
    JointDef def = world().joint_at({}, sprung, middle, rail_tilt);
    def.frame_a.p = foot; // so that the spring is seen from the rail's foot
    sprung_slider_ = world().create_joint(
        def, PrismaticJoint{.limit = Range{0.5f, 2 * rail_half}, .spring = Spring{.hertz = 0.9f, .damping_ratio = 0.1f, .target = 2}});
}

/// Three pendulums on a bar that moves to and fro.
void Joints::add_distance(Vec2 c)
{
    const Vec2 top = c + Vec2{0, 3};
    swing_bar_ = add({.type = BodyType::Kinematic, .position = top}, box(4, 0.25f), slate);
    const float aside = random_.uniform(0.45f, 0.55f);
    const auto hang = [&](float x, float length, Color color, const JointSpec& spec)
    {
        const Vec2 hook = top + Vec2{x, 0};
        const Vec2 place = hook + rotate(rotation(aside), Vec2{0, -length});
        const BodyId bob = add({.position = place}, circle(0.3f), color);
        world().create_joint(world().joint_between(swing_bar_, bob, hook, place), spec);
    };
    hang(-1.7f, 2.6f, green, DistanceJoint{.length = 2.6f});
    hang(0, 1.4f, yellow, DistanceJoint{.limit = Range{0, 3.2f}});
    hang(1.7f, 2.4f, violet, DistanceJoint{.length = 2, .spring = Spring{.hertz = 0.9f, .damping_ratio = 0.02f}});
}

/// Two beams on a base that moves up and down: one of stiff welds, one of soft ones.
void Joints::add_weld(Vec2 c)
{
    const Vec2 middle = c + Vec2{0, 0.6f};
    const Filter apart{.group = -3}; // a beam that whips about passes the base
    rocker_ = add({.type = BodyType::Kinematic, .position = middle}, box(0.7f, 1.8f), slate, {.filter = apart});
    constexpr float plank = 0.6f;
    for (const float side : {-1.0f, 1.0f})
    {
        const bool is_soft = side > 0;
        BodyId before = rocker_;
        for (int i = 0; i < 4; ++i)
        {
            const float x = 0.35f + plank * static_cast<float>(i);
            const BodyId next = add({.position = middle + Vec2{side * (x + 0.5f * plank), 0.3f}}, box(plank - 0.03f, 0.24f),
                                    is_soft ? green : blue, {.density = 0.5f, .filter = apart});
            const JointDef def = world().joint_at(before, next, middle + Vec2{side * x, 0.3f});
            world().create_joint(def, is_soft ? WeldJoint{.angular = Spring{.hertz = 11, .damping_ratio = 0.06f}} : WeldJoint{});
            before = next;
        }
    }
}

/// Bumps between two ramps.
void Joints::add_track(Vec2 c)
{
    const float floor = c.y - 1.9f;
    std::vector<Vec2> points = {{c.x - 3, floor + 1.1f}, {c.x - 2.7f, floor + 0.35f}};
    for (int i = 0; i <= 8; ++i)
    {
        const float x = -2.2f + 0.55f * static_cast<float>(i);
        points.push_back({c.x + x, floor + (i % 2 == 0 ? 0.0f : 0.17f)});
    }
    points.insert(points.end(), {{c.x + 2.7f, floor + 0.35f}, {c.x + 3, floor + 1.1f}});
    add_ground(points, {.friction = 0.9f});
}

void Joints::add_cart(Vec2 c)
{
    const Vec2 middle = c + Vec2{0, -0.6f};
    const ShapeDef body{.filter = {.group = -1}};
    const ShapeDef tyre{.density = 2, .material = {.friction = 1.1f}, .filter = {.group = -1}};
    cart_[0] = add({.position = middle, .name = "cart"}, rounded_box(2.2f, 0.45f, 0.1f), red, body);
    add_shape(cart_[0], offset_box(1, 0.5f, {-0.1f, 0.45f}), darker(red, 0.15f), {.density = 0.3f, .filter = {.group = -1}});
    for (std::size_t i = 0; i < wheels_.size(); ++i)
    {
        const Vec2 hub = middle + Vec2{i == 0 ? -0.75f : 0.75f, -0.5f};
        cart_[1 + i] = add({.position = hub}, circle(0.38f), rubber, tyre);
        wheels_[i] = world().create_joint(world().joint_at(cart_[0], cart_[1 + i], hub, pi / 2),
                                          WheelJoint{.suspension = Spring{4, 0.4f}, .limit = Range{-0.2f, 0.2f}, .motor = Motor{-4, 6}});
    }
}

void Joints::add_motor(Vec2 c)
{
    const BodyId body = add({.position = c}, rounded_box(1.3f, 0.8f, 0.1f), violet);
    led_ = world().create_joint(world().joint_at({}, body, c), MotorJoint{});
}

void Joints::add_mouse(Vec2 c)
{
    const Vec2 grip = c + Vec2{0, 0.6f};
    const BodyId body = add({.position = c}, capsule({0, -0.6f}, {0, 0.6f}, 0.28f), green);
    pulled_ = world().create_joint(world().joint_at({}, body, grip), MouseJoint{.target = grip, .max_force = 0});
}

void Joints::add_gear(Vec2 c)
{
    const ShapeDef apart{.filter = {.group = -2}};
    const Vec2 left = c + Vec2{-0.5f - small_gear, 1.2f};
    const Vec2 right = left + Vec2{small_gear + large_gear, 0};
    const Vec2 rail = right - Vec2{0.5f, large_gear + 0.2f};
    gears_[0] = add({.position = left, .name = "small gear"}, circle(small_gear), yellow, apart);
    gears_[1] = add({.position = right, .name = "large gear"}, circle(large_gear), blue, apart);
    gears_[2] = add({.position = rail, .name = "rack"}, box(3.4f, 0.4f), red, apart);
    gear_motor_ = world().create_joint(world().joint_at({}, gears_[0], left), RevoluteJoint{.motor = Motor{0, 200}});
    world().create_joint(world().joint_at({}, gears_[1], right), RevoluteJoint{});
    world().create_joint(world().joint_at({}, gears_[2], rail), PrismaticJoint{});
    world().create_joint({.body_a = gears_[0], .body_b = gears_[1]}, GearJoint{.ratio = large_gear / small_gear});
    // A wheel that turns to the left pushes a rack below it to the right.
    world().create_joint({.body_a = gears_[1], .body_b = gears_[2]}, GearJoint{.ratio = -1 / large_gear, .motion_b = GearMotion::Slide});
}

/// The heavy weight stands on a lift; where it sinks, it pulls the light one up.
void Joints::add_pulley(Vec2 c)
{
    const Vec2 left = c + Vec2{-1.3f, 3};
    const Vec2 right = c + Vec2{1.3f, 3};
    const Vec2 down{0, pulley_drop};
    const Vec2 grip{0, 0.45f};
    const BodyId heavy = add({.position = left - down - grip, .name = "heavy weight"}, box(0.9f, 0.9f), red, {.density = 2});
    const BodyId light = add({.position = right - down - grip, .name = "light weight"}, box(0.8f, 0.9f), yellow);
    lift_ = add({.type = BodyType::Kinematic, .position = left - down - Vec2{0, 1.05f}}, box(1.6f, 0.3f), slate);
    world().create_joint(world().joint_between(heavy, light, left - down, right - down),
                         PulleyJoint{.ground_a = left, .ground_b = right, .length = 2 * pulley_drop});
}

void Joints::hang_bucket()
{
    const Vec2 hook = center_of(9) + Vec2{0, 3.3f};
    const Vec2 grip = hook - Vec2{0, 2};
    bucket_ = add({.position = grip, .name = "bucket"}, offset_box(1.3f, 0.12f, {0, -1.5f}), blue, {.density = 2});
    for (const float side : {-1.0f, 1.0f})
        add_shape(bucket_, offset_box(0.12f, 1, {side * 0.7f, -1.06f}, -0.15f * side), blue, {.density = 2});
    JointDef def = world().joint_between({}, bucket_, hook, grip);
    def.break_force = tear_force;
    bucket_spring_ = world().create_joint(def, DistanceJoint{.length = 2, .spring = Spring{.hertz = 2, .damping_ratio = 0.5f}});
    next_ball_ = time() + ball_every;
}

void Joints::remove_bucket()
{
    for (const BodyId ball : balls_) world().destroy_body(ball);
    balls_.clear();
    world().destroy_body(bucket_);
}

void Joints::drop_ball()
{
    next_ball_ = time() + ball_every;
    const float side = balls_.size() % 2 == 0 ? 1.0f : -1.0f;
    const Vec2 place = center_of(9) + Vec2{side * random_.uniform(0.25f, 0.35f), 2.4f};
    const float hue = random_.uniform(0.05f, 0.16f);
    balls_.push_back(add({.position = place}, circle(ball_radius), from_hue(hue, 0.65f, 0.6f), {.density = 3}));
}

/// What is at the end of its way turns back.
void Joints::drive_back_and_forth()
{
    RevoluteJoint arm = std::get<RevoluteJoint>(world().joint(arm_).spec());
    const float angle = world().joint(arm_).angle();
    const bool arm_turns_back = arm.motor->speed > 0 ? angle > arm_limit.upper - 0.02f : angle < arm_limit.lower + 0.02f;
    if (arm_turns_back)
    {
        arm.motor->speed = -arm.motor->speed;
        world().joint(arm_).set_spec(arm);
    }
    PrismaticJoint slider = std::get<PrismaticJoint>(world().joint(slider_).spec());
    const float way = world().joint(slider_).offset().x;
    if (slider.motor->speed > 0 ? way > rail_half - 0.02f : way < 0.02f - rail_half)
    {
        slider.motor->speed = -slider.motor->speed;
        world().joint(slider_).set_spec(slider);
    }
    const float x = world().body(cart_[0]).position().x - center_of(4).x;
    WheelJoint wheel = std::get<WheelJoint>(world().joint(wheels_[0]).spec());
    const bool goes_right = wheel.motor->speed < 0;
    if (goes_right ? x < 0.9f : x > -0.9f) return;
    wheel.motor->speed = -wheel.motor->speed;
    for (const JointId id : wheels_) world().joint(id).set_spec(wheel);
}

/// What follows the time: platforms, and the targets of springs, motors and the mouse joint.
void Joints::drive_targets(float t)
{
    world().body(swing_bar_).set_linear_velocity({0.9f * sin_cos(2.6f * t).cos, 0});
    world().body(rocker_).set_linear_velocity({0, 2 * sin_cos(4 * t).cos});
    world().body(lift_).set_linear_velocity({0, -0.9f * sin_cos(1.1f * t).sin});

    const bool is_up = sin_cos(1.4f * t).sin > 0;
    PrismaticJoint sprung = std::get<PrismaticJoint>(world().joint(sprung_slider_).spec());
    sprung.spring->target = is_up ? 2.9f : 2.1f;
    world().joint(sprung_slider_).set_spec(sprung);

    world().joint(gear_motor_).set_spec(RevoluteJoint{.motor = Motor{1.6f * sin_cos(0.9f * t).cos, 200}});

    const SinCos slow = sin_cos(1.3f * t);
    world().joint(led_).set_spec(MotorJoint{.offset = Vec2{1.8f * slow.cos, 0.5f + 1.4f * slow.sin},
                                            .angle = 0.6f * slow.sin,
                                            .spring = {4, 1},
                                            .max_force = 200,
                                            .max_torque = 100});
    const Vec2 target = center_of(6) + Vec2{1.9f * sin_cos(1.1f * t).sin, 0.9f + 1.2f * sin_cos(2.2f * t).sin};
    world().joint(pulled_).set_spec(MouseJoint{.target = target, .spring = {3, 1}, .max_force = 500});
}

void Joints::drive_bucket()
{
    const bool hangs = world().find_joint(bucket_spring_).has_value();
    if (hangs && time() >= next_ball_ && balls_.size() < most_balls) return drop_ball();
    if (hangs || time() < torn_at_ + seconds_after_tearing) return;
    remove_bucket();
    hang_bucket();
}

void Joints::before_step()
{
    drive_back_and_forth();
    drive_targets(static_cast<float>(time()) + phase_);
    drive_bucket();
}

void Joints::after_step(const StepReport&)
{
    for (const JointBreak& broken : world().events().joint_break)
    {
        if (broken.joint != bucket_spring_) continue;
        torn_at_ = time();
        ++torn_;
    }
    // Only the cart and the balls can be thrown away; all else hangs on something.
    const auto is_lost = [&](BodyId id)
    {
        const Vec2 place = world().body(id).position();
        return std::abs(place.x) > lost_beyond || std::abs(place.y) > lost_beyond;
    };
    std::erase_if(balls_, [&](BodyId ball)
    {
        const bool gone = is_lost(ball);
        if (gone) world().destroy_body(ball);
        return gone;
    });
    if (std::none_of(cart_.begin(), cart_.end(), is_lost)) return;
    for (const BodyId part : cart_) world().destroy_body(part);
    add_cart(center_of(4));
}

void Joints::draw_cells(DrawList& list) const
{
    for (std::size_t i = 0; i < exhibits.size(); ++i)
    {
        const Vec2 c = center_of(i);
        const Vec2 half = 0.5f * cell - Vec2{0.1f, 0.1f};
        list.box(Layer::Background, {c - half, c + half},
                 {.fill = lighter(night, 0.035f), .line = with_alpha(slate, 0.7f), .line_width = 1});
        label(list, c - Vec2{0, 3.0f}, exhibits[i].name, 18);
        label(list, c - Vec2{0, 3.6f}, exhibits[i].what, 14);
    }
}

/// Teeth of equal pitch on both wheels and the rack, so that one sees them mesh.
void Joints::draw_teeth(DrawList& list) const
{
    constexpr float pitch = 2 * pi * small_gear / teeth_of_small;
    const auto tooth = [&](Vec2 from, Vec2 to) { list.line(Layer::Marks, from, to, with_alpha(night, 0.7f), 2); };
    for (std::size_t i = 0; i < 2; ++i)
    {
        const float radius = i == 0 ? small_gear : large_gear;
        const Transform place = world().body(gears_[i]).transform();
        const int teeth = static_cast<int>(std::round(2 * pi * radius / pitch));
        for (int k = 0; k < teeth; ++k)
        {
            // Teeth of one wheel meet the gaps of the other.
            const SinCos v = sin_cos((static_cast<float>(k) + (i == 0 ? 0.5f : 0.0f)) * 2 * pi / static_cast<float>(teeth));
            tooth(place * ((radius - 0.16f) * Vec2{v.cos, v.sin}), place * (radius * Vec2{v.cos, v.sin}));
        }
    }
    const Transform rack = world().body(gears_[2]).transform();
    for (int k = -5; k <= 5; ++k)
        tooth(rack * Vec2{pitch * static_cast<float>(k), 0.05f}, rack * Vec2{pitch * static_cast<float>(k), 0.2f});
}

void Joints::draw_bucket_load(DrawList& list) const
{
    const Vec2 c = center_of(9);
    if (const auto spring = world().find_joint(bucket_spring_))
    {
        const float load = length(spring->force()) / tear_force;
        const Color color = mix(paper, gone, std::clamp(load, 0.0f, 1.0f));
        list.text({.text = std::to_string(static_cast<int>(std::round(100 * load))) + " %",
                   .color = color,
                   .size = 15,
                   .place = Place::World,
                   .position = c + Vec2{-1.2f, 2.6f}});
        return;
    }
    const auto since = static_cast<float>(time() - torn_at_);
    list.disc(Layer::Marks, c + Vec2{0, 3.3f}, 0.15f + 0.8f * std::min(since, 1.0f),
              {.line = with_alpha(gone, std::max(1 - since, 0.0f)), .line_width = 3});
    list.text({.text = "torn", .color = gone, .size = 18, .place = Place::World, .position = c + Vec2{0, 2.5f}});
}

void Joints::on_draw(DrawList& list) const
{
    draw_cells(list);
    const auto mount = [&](Vec2 place) { list.disc(Layer::Background, place, 0.3f, {.fill = slate}); };
    mount(center_of(0) + Vec2{0, 1.5f});
    mount(center_of(9) + Vec2{0, 3.3f});
    // The two rails, as far as their limits let the sliders go.
    const auto rail = [&](Vec2 middle, float angle)
    {
        const Vec2 along = rotate(rotation(angle), Vec2{rail_half + 0.5f, 0});
        list.line(Layer::Background, middle - along, middle + along, slate, 5);
    };
    rail(center_of(1) + Vec2{0, 2.3f}, 0);
    rail(center_of(1) + Vec2{0, -0.2f}, rail_tilt);
    PaintedScene::on_draw(list);
}

void Joints::draw_marks(DrawList& list) const
{
    // The bucket's handle.
    const Transform bucket = world().body(bucket_).transform();
    for (const float side : {-1.0f, 1.0f}) list.line(Layer::Marks, bucket.p, bucket * Vec2{side * 0.76f, -0.57f}, lighter(blue, 0.3f), 2);
    // The arm's limits.
    const Vec2 pin = center_of(0) + Vec2{0, 1.5f};
    for (const float angle : {arm_limit.lower, arm_limit.upper})
        list.line(Layer::Background, pin, pin + rotate(rotation(angle), Vec2{arm_length + 0.4f, 0}), with_alpha(red, 0.5f), 1.5f);
    draw_teeth(list);

    const JointView pulled = world().joint(pulled_);
    const Vec2 target = std::get<MouseJoint>(pulled.spec()).target;
    list.line(Layer::Marks, target, world().body(pulled.body_b()).transform() * pulled.frame_b().p, yellow, 1.5f);
    list.disc(Layer::Marks, target, 0.12f, {.line = yellow, .line_width = 2});

    const JointView led = world().joint(led_);
    const MotorJoint& motor = std::get<MotorJoint>(led.spec());
    list.shape(Layer::Marks, box(1.3f, 0.8f), led.frame_a() * Transform{motor.offset, rotation(motor.angle)},
               {.line = with_alpha(lighter(violet, 0.4f), 0.8f), .line_width = 1.5f});
    draw_bucket_load(list);
}

std::string Joints::status() const
{
    float largest = 0;
    for (const JointId id : world().joints()) largest = std::max(largest, world().joint(id).error());
    return std::to_string(world().joint_count()) + " joints, none open by more than " +
           to_text(std::round(100'000 * static_cast<double>(largest)) / 100) + " mm; " + "the spring has torn " + std::to_string(torn_) +
           (torn_ == 1 ? " time" : " times");
}

} // namespace

SceneInfo joints_scene()
{
    return {
        .name = "joints",
        .title = "Joints",
        .description =
            "One exhibit of each of the nine joints, all moving by themselves, and a spring that tears. Every body can be dragged.",
        .group = "Joints",
        .controls = with_common_controls({drag_control()}),
        .parameters = with_common_parameters({}),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Joints>(setup); },
        .drags_bodies = true,
        .own_code = "motors and targets are driven, and parts that are thrown out come back",
    };
}

} // namespace carom::scenes
