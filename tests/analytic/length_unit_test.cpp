// A world of another size goes the same way. Every length, speed and acceleration of a scene is multiplied by L and the world is told so
// (WorldDef::length_unit); then its picture is that of L = 1, magnified.
//
// For L a power of two a product with L is exact in float, so the outcome must be the same to the bit, but for the factor. One tolerance that does not
// follow the length unit breaks that.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace carom
{

namespace
{

/// A world of length unit L, told in lengths of L = 1.
class ScaledWorld
{
public:
    explicit ScaledWorld(float scale, WorldDef def = {}) : scale_(scale), world_(scaled(def, scale)) {}

    World& world() { return world_; }
    float scale() const { return scale_; }

    BodyId add(BodyDef def, const Geometry& geometry, const ShapeDef& shape = {})
    {
        def.position *= scale_;
        def.linear_velocity *= scale_;
        const BodyId body = world_.create_body(def, scaled(geometry), shape);
        if (def.type != BodyType::Static) bodies_.push_back(body);
        return body;
    }
    BodyId add_static(Vec2 position, const Geometry& geometry, const ShapeDef& shape = {})
    {
        return add({.type = BodyType::Static, .position = position}, geometry, shape);
    }
    void add_chain(std::vector<Vec2> points)
    {
        for (Vec2& point : points) point *= scale_;
        world_.create_chain(world_.create_body({.type = BodyType::Static}), {.points = points});
    }

    Vec2 position(BodyId body) const { return (1 / scale_) * world_.body(body).position(); }
    Vec2 velocity(BodyId body) const { return (1 / scale_) * world_.body(body).linear_velocity(); }
    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) world_.step(dt);
    }
    /// Position, velocity, angle and spin of all bodies that can move, as of L = 1.
    std::vector<float> state() const
    {
        std::vector<float> all;
        for (const BodyId body : bodies_)
        {
            const Vec2 p = position(body);
            const Vec2 v = velocity(body);
            const BodyView view = world_.body(body);
            for (const float value : {p.x, p.y, v.x, v.y, view.transform().q.c, view.transform().q.s, view.angular_velocity()})
                all.push_back(value);
            all.push_back(view.is_awake() ? 1.0f : 0.0f);
        }
        return all;
    }

    Geometry scaled(const Geometry& geometry) const
    {
        if (const auto* c = std::get_if<Circle>(&geometry)) return circle(scale_ * c->radius, scale_ * c->center);
        if (const auto* c = std::get_if<Capsule>(&geometry)) return capsule(scale_ * c->p1, scale_ * c->p2, scale_ * c->radius, scale_);
        if (const auto* s = std::get_if<Segment>(&geometry)) return segment(scale_ * s->p1, scale_ * s->p2, scale_);
        Polygon polygon = *std::get_if<Polygon>(&geometry);
        for (Vec2& vertex : polygon.vertices) vertex *= scale_;
        polygon.centroid *= scale_;
        polygon.radius *= scale_;
        return polygon;
    }

private:
    static WorldDef scaled(WorldDef def, float scale)
    {
        def.gravity *= scale;
        def.length_unit = scale;
        return def;
    }

    float scale_;
    World world_;
    std::vector<BodyId> bodies_;
};

const std::array<float, 2> powers_of_two = {1 / 128.0f, 128.0f};
const std::array<float, 3> sizes = {0.01f, 1, 100};

std::string at(float scale) { return "length unit " + std::to_string(scale); }

using Setup = std::function<void(ScaledWorld&)>;

/// Runs a scene at both powers of two against L = 1.
void expect_same_to_the_bit(const Setup& set_up, int steps, const WorldDef& def = {})
{
    ScaledWorld reference(1, def);
    set_up(reference);
    reference.run(steps);
    const std::vector<float> expected = reference.state();
    ASSERT_FALSE(expected.empty());
    for (const float scale : powers_of_two)
    {
        ScaledWorld other(scale, def);
        set_up(other);
        other.run(steps);
        EXPECT_EQ(other.state(), expected) << at(scale);
    }
}

void add_floor(ScaledWorld& w) { w.add_static({0, -1}, box(200, 2)); }

void add_tower(ScaledWorld& w)
{
    add_floor(w);
    for (int i = 0; i < 5; ++i) w.add({.position = {0, 0.5f + static_cast<float>(i)}}, box(1, 1));
}

void add_pyramid(ScaledWorld& w)
{
    add_floor(w);
    constexpr int rows = 8;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
            w.add({.position = {1.1f * (static_cast<float>(i) - 0.5f * static_cast<float>(rows - row)), 0.5f + static_cast<float>(row)}},
                  box(1, 1));
}

/// Every type of shape, tumbling into a bowl, some bouncing.
void add_rain(ScaledWorld& w)
{
    w.add_chain({{-6, 8}, {-6, 0}, {-2, -1.5f}, {0, -1.75f}, {2, -1.5f}, {6, 0}, {6, 8}});
    const std::array<Vec2, 5> corners = {{{-0.5f, -0.25f}, {0.5f, -0.375f}, {0.625f, 0.25f}, {0, 0.5f}, {-0.5f, 0.25f}}};
    const std::array<Geometry, 5> shapes = {circle(0.5f), capsule({-0.5f, 0}, {0.5f, 0}, 0.25f), box(1, 0.5f), rounded_box(1, 1, 0.125f),
                                            convex_hull(corners)};
    for (int i = 0; i < 40; ++i)
    {
        const float column = static_cast<float>(i % 8) - 3.5f;
        const float row = static_cast<float>(i) / 8;
        w.add({.position = {1.25f * column, 2 + 1.5f * row}, .angle = 0.3f * static_cast<float>(i), .angular_velocity = column},
              shapes[static_cast<std::size_t>(i) % shapes.size()], {.material = {.restitution = i % 3 == 0 ? 0.5f : 0}});
    }
}

/// Tiles of solid boxes and a chain, with things that slide over the seams.
void add_tiles(ScaledWorld& w)
{
    for (int i = 0; i < 20; ++i) w.add_static({static_cast<float>(i), -0.5f}, box(1, 1));
    std::vector<Vec2> points;
    for (int i = 0; i <= 40; ++i) points.push_back({20.5f - 0.5f * static_cast<float>(i), 5});
    w.add_chain(points);
    const ShapeDef smooth = {.material = {.friction = 0.05f}};
    w.add({.position = {0.5f, 0.25f}, .linear_velocity = {8, 0}}, box(0.5f, 0.5f), smooth);
    w.add({.position = {1.5f, 0.25f}, .linear_velocity = {9, 0}}, circle(0.25f), smooth);
    w.add({.position = {2, 5.25f}, .linear_velocity = {8, 0}}, box(0.5f, 0.5f), smooth);
    w.add({.position = {4, 5.25f}, .linear_velocity = {6, 0}}, rounded_box(0.5f, 0.5f, 0.125f), smooth);
}

/// Joints of most types, some of which begin far from closed.
void add_joints(ScaledWorld& w)
{
    add_floor(w);
    World& world = w.world();
    const float scale = w.scale();
    const BodyId post = w.add_static({0, 6}, box(0.5f, 0.5f));
    BodyId last = post;
    for (int i = 0; i < 6; ++i)
    {
        const BodyId link = w.add({.position = {1 + static_cast<float>(i), 6}}, box(1, 0.25f));
        world.create_joint(world.joint_at(last, link, scale * Vec2{0.5f + static_cast<float>(i), 6}), RevoluteJoint{});
        last = link;
    }
    const BodyId open = w.add({.position = {-3, 6}}, box(1, 0.25f));
    world.create_joint({.body_a = post, .body_b = open, .frame_b = {scale * Vec2{1, 0}, rotation(0.5f)}}, WeldJoint{});
    const BodyId ball = w.add({.position = {-6, 4}}, circle(0.5f));
    world.create_joint(world.joint_between(post, ball, scale * Vec2{-3, 6}, scale * Vec2{-6, 4}), DistanceJoint{.length = 3 * scale});
    const BodyId slider = w.add({.position = {8, 2}}, box(1, 0.5f));
    world.create_joint(
        world.joint_at({}, slider, scale * Vec2{8, 2}, 0.25f),
        PrismaticJoint{.limit = Range{-scale, scale}, .motor = Motor{.speed = scale, .max_force = 100 * scale * scale * scale}});
}

/// Bullets against thin walls and small bodies, and one through a sensor.
void add_shots(ScaledWorld& w)
{
    w.add_static({10, 0}, segment({0, -5}, {0, 5}));
    w.add_static({5, 0}, box(0.0625f, 10), {.is_sensor = true});
    for (int i = 0; i < 8; ++i)
    {
        const float y = static_cast<float>(i) - 4;
        w.add({.position = {0, y},
               .angle = 0.2f * y,
               .linear_velocity = {300 + 100 * y, 3},
               .angular_velocity = 10 * y,
               .is_bullet = i % 2 == 0},
              i % 3 == 0 ? Geometry(box(0.25f, 0.25f)) : Geometry(circle(0.125f)));
        w.add({.position = {8, y + 0.25f}}, box(0.25f, 0.5f));
    }
}

} // namespace

TEST(LengthUnit, a_tower_of_five_stands_at_every_size)
{
    for (const float scale : sizes)
    {
        ScaledWorld w(scale);
        add_tower(w);
        const std::vector<float> start = w.state();
        w.run(600);
        const std::vector<float> end = w.state();
        for (std::size_t i = 0; i < start.size(); i += 8)
        {
            EXPECT_NEAR(end[i], start[i], 0.002) << at(scale);
            EXPECT_NEAR(end[i + 1], start[i + 1], 0.005) << at(scale);
            EXPECT_EQ(end[i + 7], 0) << at(scale) << ": asleep";
        }
    }
}

TEST(LengthUnit, a_tower_of_five_goes_the_same_way_to_the_bit) { expect_same_to_the_bit(add_tower, 300); }
TEST(LengthUnit, a_pyramid_goes_the_same_way_to_the_bit) { expect_same_to_the_bit(add_pyramid, 300); }
TEST(LengthUnit, rain_into_a_bowl_goes_the_same_way_to_the_bit) { expect_same_to_the_bit(add_rain, 600); }
TEST(LengthUnit, sliding_over_seams_goes_the_same_way_to_the_bit) { expect_same_to_the_bit(add_tiles, 200); }
TEST(LengthUnit, joints_go_the_same_way_to_the_bit) { expect_same_to_the_bit(add_joints, 300); }
TEST(LengthUnit, shots_go_the_same_way_to_the_bit) { expect_same_to_the_bit(add_shots, 60, {.gravity = {}}); }

TEST(LengthUnit, a_pyramid_stands_at_every_size)
{
    for (const float scale : sizes)
    {
        ScaledWorld w(scale);
        add_pyramid(w);
        const std::vector<float> start = w.state();
        w.run(600);
        const std::vector<float> end = w.state();
        for (std::size_t i = 0; i < start.size(); i += 8)
        {
            EXPECT_NEAR(end[i], start[i], 0.02) << at(scale);
            EXPECT_NEAR(end[i + 1], start[i + 1], 0.02) << at(scale);
        }
    }
}

TEST(LengthUnit, a_slide_on_a_chain_has_no_bumps_at_any_size)
{
    for (const float scale : sizes)
    {
        ScaledWorld w(scale);
        std::vector<Vec2> points;
        for (int i = 0; i <= 100; ++i) points.push_back({50 - static_cast<float>(i), 0});
        w.add_chain(points);
        const BodyId slider = w.add({.position = {-40, 0.25f}, .linear_velocity = {10, 0}}, box(0.5f, 0.5f), {.material = {.friction = 0}});
        float highest = 0;
        for (int i = 0; i < 300; ++i)
        {
            w.run(1);
            highest = std::max(highest, w.position(slider).y);
        }
        EXPECT_LT(highest, 0.2505f) << at(scale);
        EXPECT_NEAR(w.velocity(slider).x, 10, 0.001) << at(scale);
    }
}

TEST(LengthUnit, a_bullet_stops_at_a_thin_wall_at_every_size)
{
    for (const float scale : sizes)
    {
        ScaledWorld w(scale, {.gravity = {}});
        w.add_static({10, 0}, box(0.02f, 4));
        const BodyId bullet = w.add({.linear_velocity = {900, 0}, .is_bullet = true}, circle(0.1f));
        w.run(10);
        EXPECT_NEAR(w.position(bullet).x, 10 - 0.01f - 0.1f, 0.01) << at(scale);
    }
}

/// Twice the threshold bounces with all its speed, half of it does not.
TEST(LengthUnit, the_restitution_threshold_follows_the_unit)
{
    for (const float scale : sizes)
    {
        for (const float speed : {2.0f, 0.5f})
        {
            ScaledWorld w(scale, {.gravity = {}});
            w.add_static({0, -1}, box(20, 2));
            const BodyId ball =
                w.add({.position = {0, 0.51f}, .linear_velocity = {0, -speed}}, circle(0.5f), {.material = {.restitution = 1}});
            w.run(5);
            EXPECT_NEAR(w.velocity(ball).y, speed > 1 ? speed : 0, 0.01) << at(scale) << ", " << speed;
        }
    }
}

TEST(LengthUnit, the_sleep_threshold_follows_the_unit)
{
    for (const float scale : sizes)
    {
        for (const float speed : {0.06f, 0.04f})
        {
            ScaledWorld w(scale, {.gravity = {}});
            const BodyId drifter = w.add({.linear_velocity = {speed, 0}}, circle(0.5f));
            w.run(60);
            EXPECT_EQ(w.world().body(drifter).is_awake(), speed > 0.05f) << at(scale) << ", " << speed;
        }
    }
}

TEST(LengthUnit, the_hit_speed_follows_the_unit)
{
    for (const float scale : sizes)
    {
        for (const float speed : {2.0f, 0.5f})
        {
            ScaledWorld w(scale, {.gravity = {}});
            w.add_static({0, -1}, box(20, 2));
            w.add({.position = {0, 0.51f}, .linear_velocity = {0, -speed}}, circle(0.5f), {.hit_events = true});
            std::size_t hits = 0;
            for (int i = 0; i < 5; ++i)
            {
                w.run(1);
                hits += w.world().events().contact_hit.size();
            }
            EXPECT_EQ(hits, speed > 1 ? 1u : 0u) << at(scale) << ", " << speed;
        }
    }
}

TEST(LengthUnit, queries_see_the_same_to_the_bit)
{
    const auto ask = [](float scale)
    {
        ScaledWorld w(scale);
        add_rain(w);
        w.run(100);
        std::vector<float> answers;
        for (int i = 0; i < 200; ++i)
        {
            const Vec2 start = scale * Vec2{static_cast<float>(i % 20) - 10, static_cast<float>(i % 7) - 2};
            const Vec2 sweep = scale * Vec2{static_cast<float>(i % 11) - 5, static_cast<float>(i % 13) - 6};
            if (const auto hit = w.world().cast_ray(start, sweep))
                answers.insert(answers.end(), {hit->fraction, hit->normal.x, hit->normal.y});
            const Geometry probe = w.scaled(box(0.5f, 0.25f));
            if (const auto hit = w.world().cast_shape(probe, {start, {}}, sweep))
                answers.insert(answers.end(), {hit->fraction, hit->normal.x, hit->normal.y});
            answers.push_back(static_cast<float>(w.world().overlapping(probe, {start, {}}).size()));
            if (const auto near = w.world().closest_point(start, 20 * scale)) answers.push_back(near->distance / scale);
        }
        return answers;
    };
    const std::vector<float> expected = ask(1);
    for (const float scale : powers_of_two) EXPECT_EQ(ask(scale), expected) << at(scale);
}

/// From the surface on which a ray ended, another can start; 3 um off, in units, is on the surface, 8 um is not.
TEST(LengthUnit, the_touch_distance_of_queries_follows_the_unit)
{
    for (const float scale : sizes)
    {
        ScaledWorld w(scale);
        w.add_static({0, 0}, box(0.25f, 0.25f));
        const auto is_met = [&](float gap)
        { return !w.world().overlapping(w.scaled(box(0.25f, 0.25f)), {scale * Vec2{0.25f + gap, 0}, {}}).empty(); };
        EXPECT_TRUE(is_met(3e-6f)) << at(scale);
        EXPECT_FALSE(is_met(8e-6f)) << at(scale);
    }
}

TEST(LengthUnit, a_character_walks_the_same_way_to_the_bit)
{
    const auto walk = [](float scale)
    {
        ScaledWorld w(scale);
        add_floor(w);
        w.add_static({3, 0.125f}, box(1, 0.25f));
        w.add_static({6, 0}, box(2, 2));
        CharacterDef def = {
            .geometry = w.scaled(capsule({0, -0.5f}, {0, 0.5f}, 0.3125f)), .position = scale * Vec2{0, 1}, .length_unit = scale};
        def.step_height *= scale;
        def.snap_distance *= scale;
        Character character(def);
        std::vector<float> path;
        Vec2 velocity;
        for (int i = 0; i < 200; ++i)
        {
            velocity = {scale * 3, velocity.y - dt * 9.81f * scale};
            if (i == 150) velocity.y = scale * 5;
            velocity = character.move(w.world(), velocity, dt);
            path.insert(path.end(),
                        {character.position().x / scale, character.position().y / scale, static_cast<float>(character.ground().state)});
        }
        return path;
    };
    const std::vector<float> expected = walk(1);
    for (const float scale : powers_of_two) EXPECT_EQ(walk(scale), expected) << at(scale);
}

TEST(LengthUnit, a_character_in_a_world_of_another_unit_is_refused)
{
    World world({.length_unit = 0.01f});
    Character character({});
    EXPECT_THROW(character.move(world, {}, dt), UsageError);
}

TEST(LengthUnit, least_sizes_of_shapes_follow_the_unit)
{
    EXPECT_THROW(box(0.0005f, 1), UsageError);
    EXPECT_NO_THROW(box(0.0005f, 1, 0.01f));
    EXPECT_THROW(box(0.0005f, 1, 100), UsageError);
    World small({.length_unit = 0.01f});
    const BodyId body = small.create_body({});
    EXPECT_NO_THROW(small.create_shape(body, box(2e-5f, 2e-5f, 0.01f)));
    EXPECT_NO_THROW(small.create_chain(body, {.points = std::array{Vec2{0, 0}, Vec2{2e-5f, 0}}}));
    World large({.length_unit = 100});
    EXPECT_THROW(large.create_body({}, box(0.05f, 0.05f)), UsageError);
    EXPECT_THROW(World().create_body({}, box(2e-5f, 2e-5f, 0.01f)), UsageError);
}

TEST(LengthUnit, is_checked_and_read_and_copied)
{
    EXPECT_EQ(World().length_unit(), 1);
    for (const float bad : {0.0f, 0.0009f, 1001.0f, -1.0f, std::nanf("")}) EXPECT_THROW(World({.length_unit = bad}), UsageError) << bad;
    World small({.length_unit = 0.01f});
    EXPECT_EQ(small.length_unit(), 0.01f);
    EXPECT_NE(small.hash(), World().hash());
    EXPECT_EQ(small.copy().length_unit(), 0.01f);
    World other;
    other.restore(small);
    EXPECT_EQ(other.length_unit(), 0.01f);
    EXPECT_EQ(other.hash(), small.hash());
}

} // namespace carom
