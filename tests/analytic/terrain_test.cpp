// Ground that is made of many shapes has to feel like ground that is made of one.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace carom
{

namespace
{

constexpr int tiles = 200;

/// Makes a floor of 200 m from x = 0, its top at y = 0.
using Floor = std::function<void(World&)>;

float at(int i) { return static_cast<float>(i); }

/// A floor for what starts before x = 0 and ends beyond x = 200 goes on for a bit on both sides.
void tile_bodies(World& world, const std::function<Geometry(int)>& tile)
{
    for (int i = -5; i < tiles + 5; ++i) world.create_body({.type = BodyType::Static, .position = {at(i) + 0.5f, -0.5f}}, tile(i));
}

void plain(World& world) { world.create_body({.type = BodyType::Static, .position = {100, -0.5f}}, box(210, 1)); }
void boxes(World& world)
{
    tile_bodies(world, [](int) { return box(1, 1); });
}
void boxes_of_one_body(World& world)
{
    const BodyId body = world.create_body({.type = BodyType::Static});
    for (int i = -5; i < tiles + 5; ++i) world.create_shape(body, offset_box(1, 1, {at(i) + 0.5f, -0.5f}));
}
void kinematic_boxes(World& world)
{
    for (int i = -5; i < tiles + 5; ++i)
        world.create_body({.type = BodyType::Kinematic, .position = {at(i) + 0.5f, -0.5f}, .linear_velocity = {0.5f, 0}}, box(1, 1));
}
void segments(World& world)
{
    tile_bodies(world, [](int) { return segment({-0.5f, 0.5f}, {0.5f, 0.5f}); });
}
void capsules(World& world)
{
    tile_bodies(world, [](int) { return capsule({-0.5f, 0.3f}, {0.5f, 0.3f}, 0.2f); });
}
void rounded_boxes(World& world)
{
    tile_bodies(world, [](int) { return rounded_box(1, 1, 0.004f); });
}
void turned_boxes(World& world)
{
    for (int i = -5; i < tiles + 5; ++i)
        world.create_body({.type = BodyType::Static, .position = {at(i) + 0.5f, -0.5f}, .angle = at(i) * 0.5f * pi}, box(1, 1));
}
void boxes_with_gaps(World& world)
{
    tile_bodies(world, [](int i) { return box(1 - 0.001f * at(1 + (i + 5) % 4), 1); });
}
void uneven_boxes(World& world)
{
    tile_bodies(world, [](int i) { return offset_box(1, 1, {0, -0.0005f * at((i + 5) % 3)}); });
}
void boxes_that_overlap(World& world)
{
    tile_bodies(world, [](int) { return box(1.3f, 1); });
}

void chain_of_200_segments(World& world, ChainSides sides)
{
    std::vector<Vec2> points;
    for (int i = tiles + 5; i >= -5; --i) points.push_back({at(i), 0}); // the front is on the right of the way: above
    world.create_chain(world.create_body({.type = BodyType::Static}), {.points = points, .sides = sides});
}
void two_sided_chain(World& world) { chain_of_200_segments(world, ChainSides::TwoSided); }
void one_sided_chain(World& world) { chain_of_200_segments(world, ChainSides::OneSided); }

enum class Slider
{
    Ball,
    Box,
    SmallBall,
    SmallBox,
    Capsule
};

Geometry geometry_of(Slider slider)
{
    switch (slider)
    {
    case Slider::Ball: return circle(0.5f);
    case Slider::Box: return box(1, 1);
    case Slider::SmallBall: return circle(0.06f);
    case Slider::SmallBox: return box(0.15f, 0.1f);
    default: return capsule({-0.3f, 0}, {0.3f, 0}, 0.2f);
    }
}

float half_height(Slider slider)
{
    constexpr float heights[] = {0.5f, 0.5f, 0.06f, 0.05f, 0.2f};
    return heights[static_cast<int>(slider)];
}

struct Ride
{
    float highest = -1;
    float lowest = 1;
    float slowest = 1e9f; ///< [m/s]
    float last_speed = 0; ///< [m/s]
    float most_turn = 0;  ///< [rad]
    int steps = 0;
};

/// Which of two things a world gets first: the pair of their shapes is ordered by it.
enum class First
{
    Ground,
    Mover
};

/// Slides over the whole floor. A rolling ball has friction and starts with the spin of its speed.
Ride ride(const Floor& floor, Slider slider, float speed, float friction = 0, First first = First::Ground)
{
    World world;
    if (first == First::Ground) floor(world);
    const float height = half_height(slider);
    const bool rolls = friction > 0 && slider == Slider::Ball;
    const BodyId body =
        world.create_body({.position = {0, height}, .linear_velocity = {speed, 0}, .angular_velocity = rolls ? -speed / height : 0},
                          geometry_of(slider), {.material = {.friction = friction}});
    if (first == First::Mover) floor(world);
    Ride result;
    while (world.body(body).position().x < static_cast<float>(tiles) && result.steps < 60 * 400)
    {
        world.step(dt);
        ++result.steps;
        const Body view = world.body(body);
        result.highest = std::max(result.highest, view.position().y - height);
        result.lowest = std::min(result.lowest, view.position().y - height);
        result.slowest = std::min(result.slowest, view.linear_velocity().x);
        result.last_speed = view.linear_velocity().x;
        if (slider != Slider::Ball && slider != Slider::SmallBall) result.most_turn = std::max(result.most_turn, std::abs(view.angle()));
    }
    return result;
}

/// The same bump and speed as on a plain floor, to 1 mm and 1%, and never backwards.
void expect_as_on_plain_floor(const Floor& floor, const char* name, Slider slider, float speed, float friction = 0,
                              First first = First::Ground)
{
    SCOPED_TRACE(std::string(name) + ", slider " + std::to_string(static_cast<int>(slider)) + ", " + std::to_string(speed) + " m/s");
    const Ride reference = ride(plain, slider, speed, friction);
    const Ride result = ride(floor, slider, speed, friction, first);
    EXPECT_LT(result.highest, reference.highest + 0.001f);
    EXPECT_GT(result.lowest, reference.lowest - 0.001f);
    EXPECT_GT(result.slowest, 0.99f * reference.slowest);
    EXPECT_LT(result.most_turn, reference.most_turn + 0.01f);
}

void expect_no_bumps(const Floor& floor, const char* name)
{
    for (const float speed : {1.0f, 10.0f, 50.0f})
    {
        for (const Slider slider : {Slider::Ball, Slider::Box}) expect_as_on_plain_floor(floor, name, slider, speed);
        expect_as_on_plain_floor(floor, name, Slider::Ball, speed, 0.6f);
    }
    for (const float speed : {10.0f, 50.0f})
        for (const Slider slider : {Slider::SmallBall, Slider::SmallBox, Slider::Capsule})
            expect_as_on_plain_floor(floor, name, slider, speed);
}

struct Pit
{
    World world{{.gravity = {0, -10}}};
    BodyId add(const Geometry& geometry, Vec2 position, float angle = 0)
    {
        return world.create_body({.position = position, .angle = angle}, geometry);
    }
    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) world.step(dt);
    }
};

} // namespace

TEST(Terrain, nothing_bumps_on_tiles_that_are_bodies) { expect_no_bumps(boxes, "boxes"); }
TEST(Terrain, nothing_bumps_on_tiles_of_one_body) { expect_no_bumps(boxes_of_one_body, "one body"); }
TEST(Terrain, nothing_bumps_on_tiles_that_are_turned) { expect_no_bumps(turned_boxes, "turned"); }
TEST(Terrain, nothing_bumps_on_tiles_that_overlap) { expect_no_bumps(boxes_that_overlap, "overlapping"); }
TEST(Terrain, nothing_bumps_on_segments_end_to_end) { expect_no_bumps(segments, "segments"); }
TEST(Terrain, nothing_bumps_on_capsules_end_to_end) { expect_no_bumps(capsules, "capsules"); }
TEST(Terrain, nothing_bumps_on_slightly_rounded_boxes) { expect_no_bumps(rounded_boxes, "rounded"); }
TEST(Terrain, a_gap_of_4_mm_between_tiles_is_none) { expect_no_bumps(boxes_with_gaps, "gaps"); }

TEST(Terrain, nothing_bumps_on_a_chain) { expect_no_bumps(two_sided_chain, "chain"); }
TEST(Terrain, nothing_bumps_on_a_one_sided_chain) { expect_no_bumps(one_sided_chain, "one-sided chain"); }

TEST(Terrain, nothing_bumps_when_the_slider_was_made_before_the_floor)
{
    const std::pair<Floor, const char*> floors[] = {{boxes, "boxes"},
                                                    {boxes_of_one_body, "one body"},
                                                    {segments, "segments"},
                                                    {two_sided_chain, "chain"},
                                                    {one_sided_chain, "one-sided chain"}};
    for (const auto& [floor, name] : floors)
        for (const Slider slider : {Slider::Ball, Slider::Box, Slider::SmallBox, Slider::Capsule})
            expect_as_on_plain_floor(floor, name, slider, 10, 0, First::Mover);
}

TEST(Terrain, nothing_bumps_on_tiles_that_move_together)
{
    for (const float speed : {1.0f, 10.0f, 50.0f})
        for (const Slider slider : {Slider::Ball, Slider::Box}) expect_as_on_plain_floor(kinematic_boxes, "kinematic", slider, speed);
}

TEST(Terrain, tiles_that_differ_in_height_by_1_mm_lift_by_no_more)
{
    for (const float speed : {1.0f, 10.0f, 50.0f})
        for (const Slider slider : {Slider::Ball, Slider::Box, Slider::SmallBall, Slider::SmallBox, Slider::Capsule})
        {
            if (speed < 10 && slider > Slider::Box) continue;
            SCOPED_TRACE("slider " + std::to_string(static_cast<int>(slider)) + ", " + std::to_string(speed) + " m/s");
            const Ride result = ride(uneven_boxes, slider, speed);
            EXPECT_LT(result.highest, 0.001f);
            EXPECT_GT(result.lowest, -0.002f);
            // A climb of 1 mm costs what it costs: at 1 m/s, 2% of the energy.
            EXPECT_GT(result.slowest, speed < 10 ? 0.8f * speed : 0.99f * speed);
        }
}

TEST(Terrain, stacks_stand_wherever_the_seams_are)
{
    for (int shift = 0; shift < 20; ++shift)
    {
        World world;
        boxes(world);
        std::vector<BodyId> stack;
        const float x = 10 + 0.05f * at(shift);
        for (int i = 0; i < 5; ++i) stack.push_back(world.create_body({.position = {x, 0.5f + at(i)}}, box(1, 1)));
        for (int step = 0; step < 600; ++step) world.step(dt);
        for (int i = 0; i < 5; ++i)
        {
            const Body body = world.body(stack[static_cast<std::size_t>(i)]);
            EXPECT_LT(distance(body.position(), {x, 0.5f + at(i)}), 0.01f) << "box " << i << " at " << x;
            EXPECT_NEAR(body.angle(), 0, 0.002f) << "box " << i << " at " << x;
            EXPECT_LT(length(body.linear_velocity()), 0.01f);
        }
    }
}

TEST(Terrain, a_small_box_that_falls_onto_a_seam_is_pushed_up)
{
    for (const float x : {9.97f, 9.99f, 9.999f, 10.0f, 10.001f, 10.02f})
        for (const float angle : {0.0f, 0.3f, 0.7f})
            for (const float speed : {0.0f, 5.0f, 10.0f})
            {
                Pit pit;
                boxes(pit.world);
                const BodyId body = pit.add(box(0.1f, 0.1f), {x, 0.2f}, angle);
                pit.world.body(body).set_linear_velocity({0, -speed});
                pit.run(240);
                EXPECT_NEAR(pit.world.body(body).position().y, 0.05f, 0.003f) << x << ", turned by " << angle << ", at " << speed << " m/s";
            }
}

TEST(Terrain, nothing_falls_through_a_gap_of_4_mm)
{
    for (const bool is_ball : {false, true})
        for (const float x : {-0.001f, 0.0f, 0.001f, 0.002f, 0.003f, 0.004f, 0.005f})
        {
            Pit pit;
            pit.world.create_body({.type = BodyType::Static, .position = {-1, -0.5f}}, box(2, 1));
            pit.world.create_body({.type = BodyType::Static, .position = {1.004f, -0.5f}}, box(2, 1));
            const BodyId body = pit.add(is_ball ? Geometry(circle(0.05f)) : box(0.1f, 0.1f), {x, 0.1f}, 0.25f * pi);
            pit.run(240);
            EXPECT_GT(pit.world.body(body).position().y, 0.048f) << x;
        }
}

TEST(Terrain, a_box_in_a_nook_keeps_both_contacts)
{
    for (const bool is_turned : {false, true})
    {
        Pit pit;
        pit.world.create_body({.type = BodyType::Static, .position = {-1, -0.5f}}, box(2, 1));  // floor up to x = 0
        pit.world.create_body({.type = BodyType::Static, .position = {0.5f, 0.5f}}, box(1, 3)); // wall from below the floor
        const BodyId body = pit.world.create_body({.position = {-0.3f, 0.3f}, .angle = is_turned ? 0.25f * pi : 0}, box(0.4f, 0.4f),
                                                  {.material = {.friction = 0}});
        // It may stand on its tip, leaning on another; it may not get into the wall or the floor.
        const float farthest = is_turned ? 0.29f : 0.203f;
        for (int i = 0; i < 300; ++i)
        {
            pit.world.body(body).apply_force_to_center({1, 0});
            pit.world.step(dt);
            const Aabb bounds = pit.world.body(body).bounds();
            EXPECT_LT(bounds.max.x, 0.006f); // it slams flat onto wall and floor at 5 rad/s
            EXPECT_GT(bounds.min.y, -0.006f);
        }
        EXPECT_GT(pit.world.body(body).position().x, -farthest);
        EXPECT_LT(pit.world.body(body).position().y, farthest);
    }
}

TEST(Terrain, a_ball_in_a_valley_touches_both_slopes)
{
    Pit pit;
    const BodyId ground = pit.world.create_body({.type = BodyType::Static});
    pit.world.create_shape(ground, segment({-5, 2}, {0, 0}));
    pit.world.create_shape(ground, segment({0, 0}, {5, 2}));
    const BodyId ball = pit.add(circle(0.5f), {0, 1});
    pit.run(200);
    EXPECT_NEAR(pit.world.body(ball).position().x, 0, 0.002f);
    EXPECT_NEAR(pit.world.body(ball).position().y, 0.5f * std::sqrt(1.16f), 0.002f); // r / cos of the slope
    EXPECT_EQ(pit.world.shape(pit.world.body(ball).shapes()[0]).touching().size(), 2u);
}

TEST(Terrain, a_step_of_1_cm_is_a_step)
{
    for (const Slider slider : {Slider::Ball, Slider::Box})
    {
        World world;
        world.create_body({.type = BodyType::Static, .position = {-5, -0.5f}}, box(10, 1));
        world.create_body({.type = BodyType::Static, .position = {5, -0.49f}}, box(10, 1));
        const BodyId body = world.create_body({.position = {-2, half_height(slider)}, .linear_velocity = {0.3f, 0}}, geometry_of(slider),
                                              {.material = {.friction = 0}});
        for (int i = 0; i < 600; ++i) world.step(dt);
        EXPECT_LT(world.body(body).position().x, 0) << static_cast<int>(slider);
    }
}

TEST(Terrain, a_body_of_several_boxes_slides_like_one)
{
    World world;
    boxes(world);
    const BodyId sled = world.create_body({.position = {0, 0.25f}, .linear_velocity = {20, 0}});
    for (int i = -3; i <= 3; ++i) world.create_shape(sled, offset_box(0.5f, 0.5f, {0.5f * at(i), 0}), {.material = {.friction = 0}});
    for (int step = 0; step < 500; ++step)
    {
        world.step(dt);
        EXPECT_NEAR(world.body(sled).position().y, 0.25f, 0.001f);
        EXPECT_GT(world.body(sled).linear_velocity().x, 19.8f);
    }
}

TEST(Terrain, a_ball_follows_a_hilly_chain_and_keeps_its_energy)
{
    World world({.gravity = {0, -10}});
    std::vector<Vec2> points;
    for (int i = 1000; i >= 0; --i)
    {
        const float x = 0.1f * at(i);
        points.push_back({x, 2 * sin_cos(0.3f * x).cos}); // hills 21 m long and 4 m high
    }
    const BodyId ground = world.create_body({.type = BodyType::Static});
    world.create_chain(ground, {.points = points, .sides = ChainSides::OneSided});
    const BodyId ball =
        world.create_body({.position = {10.5f, -1.45f}, .linear_velocity = {12, 0}}, circle(0.5f), {.material = {.friction = 0}});
    const auto energy = [&] { return 0.5f * length_squared(world.body(ball).linear_velocity()) + 10 * world.body(ball).position().y; };
    for (int i = 0; i < 10; ++i) world.step(dt); // it starts beside the slope
    const float start = energy();
    while (world.body(ball).position().x < 95)
    {
        world.step(dt);
        ASSERT_GT(world.body(ball).linear_velocity().x, 0);
    }
    // Over 84 m of hills. The valleys take what their bends take as inelastic bumps, less with shorter segments and steps.
    EXPECT_GT(energy(), 0.85f * start);
    EXPECT_LT(energy(), 1.01f * start);
}

TEST(Terrain, a_one_sided_chain_lets_through_what_comes_from_behind_and_holds_what_comes_back)
{
    for (const bool is_ball : {true, false})
    {
        Pit pit;
        const std::vector<Vec2> points = {{5, 0}, {1, 0}, {-1, 0}, {-5, 0}};
        pit.world.create_chain(pit.world.create_body({.type = BodyType::Static}), {.points = points, .sides = ChainSides::OneSided});
        const BodyId body = pit.add(is_ball ? Geometry(circle(0.5f)) : box(1, 1), {0.9f, -2});
        pit.world.body(body).set_linear_velocity({0, 9});
        float highest = -2;
        for (int i = 0; i < 240; ++i)
        {
            pit.world.step(dt);
            // Never faster than gravity lets it: nothing pulls it through.
            ASSERT_TRUE(i >= 50 || std::abs(pit.world.body(body).linear_velocity().y - (9 - 10 * dt * at(i + 1))) < 0.001f) << i;
            highest = std::max(highest, pit.world.body(body).position().y);
        }
        EXPECT_NEAR(highest, -2 + 81 / 20.0f, 0.2f);
        EXPECT_NEAR(pit.world.body(body).position().y, 0.5f, 0.005f);
    }
}

TEST(Terrain, what_turns_back_half_way_through_a_one_sided_chain_falls_back)
{
    Pit pit;
    const std::vector<Vec2> points = {{5, 0}, {-5, 0}};
    pit.world.create_chain(pit.world.create_body({.type = BodyType::Static}), {.points = points, .sides = ChainSides::OneSided});
    const BodyId body = pit.add(box(1, 1), {0, -2});
    pit.world.body(body).set_linear_velocity({0, std::sqrt(2 * 10 * 2.2f)}); // up to a middle of 0.2 m
    pit.run(120);
    EXPECT_LT(pit.world.body(body).position().y, -2);
}

TEST(Terrain, a_loop_that_runs_counter_clockwise_is_solid_inside)
{
    Pit pit;
    const std::vector<Vec2> square = {{-2, -2}, {2, -2}, {2, 0}, {-2, 0}};
    pit.world.create_chain(pit.world.create_body({.type = BodyType::Static}),
                           {.points = square, .is_loop = true, .sides = ChainSides::OneSided});
    const BodyId above = pit.add(box(0.5f, 0.5f), {0, 1});
    const BodyId inside = pit.add(box(0.5f, 0.5f), {0, -1});
    pit.run(180);
    EXPECT_NEAR(pit.world.body(above).position().y, 0.25f, 0.005f);
    EXPECT_LT(pit.world.body(inside).position().y, -5);
}

TEST(Terrain, a_chain_on_a_moving_body_carries)
{
    World world({.gravity = {0, -10}});
    const BodyId lift = world.create_body({.type = BodyType::Kinematic, .linear_velocity = {0.5f, 1}});
    const std::vector<Vec2> bowl = {{3, 1}, {1, 0}, {0, 0}, {-1, 0}, {-3, 1}};
    world.create_chain(lift, {.points = bowl, .sides = ChainSides::OneSided});
    const BodyId ball = world.create_body({.position = {0, 0.5f}, .linear_velocity = {0.5f, 1}}, box(1, 1));
    for (int i = 0; i < 240; ++i) world.step(dt);
    const Vec2 way = world.body(ball).position() - world.body(lift).position();
    EXPECT_NEAR(way.x, 0, 0.01f);
    EXPECT_NEAR(way.y, 0.5f, 0.005f);
}

TEST(Terrain, fast_bodies_pass_a_one_sided_chain_from_behind_and_are_stopped_in_front)
{
    for (const bool is_from_behind : {true, false})
        for (const float speed : {20.0f, 60.0f, 200.0f})
        {
            World world({.gravity = {}});
            const std::vector<Vec2> wall = {{0, 5}, {0, 0}, {0, -5}}; // downwards: the front is on the left
            world.create_chain(world.create_body({.type = BodyType::Static}), {.points = wall, .sides = ChainSides::OneSided});
            const float side = is_from_behind ? 1.0f : -1.0f;
            const BodyId ball = world.create_body({.position = {side * 7.3f, 0.4f}, .linear_velocity = {-side * speed, 0}}, circle(0.2f));
            for (int i = 0; i < 60; ++i) world.step(dt);
            if (is_from_behind)
            {
                EXPECT_NEAR(world.body(ball).position().x, 7.3f - speed, 0.01f) << speed; // as if nothing were there
                EXPECT_NEAR(world.body(ball).linear_velocity().x, -speed, 0.001f * speed);
            }
            else
                EXPECT_NEAR(world.body(ball).position().x, -0.2f, 0.01f) << speed;
        }
}

} // namespace carom
