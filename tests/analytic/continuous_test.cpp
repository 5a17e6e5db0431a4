// Nothing passes through anything, however fast.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace carom
{

namespace
{

float between(std::mt19937& engine, float low, float high)
{
    return low + (high - low) * static_cast<float>(engine() % 100000) / 100000.0f;
}

} // namespace

TEST(Continuous, a_bullet_of_200_m_per_s_does_not_pass_a_wall_of_10_cm)
{
    for (const Geometry& bullet : {Geometry{circle(0.05f)}, Geometry{box(0.1f, 0.1f)}, Geometry{capsule({-0.1f, 0}, {0.1f, 0}, 0.03f)}})
        for (float angle = 0; angle < 3; angle += 0.37f)
        {
            World world({.gravity = {}});
            world.create_body({.type = BodyType::Static, .position = {5, 0}}, box(0.1f, 10));
            const BodyId id = world.create_body({.angle = angle, .linear_velocity = {200, 0}, .angular_velocity = 5}, bullet);
            float farthest = 0;
            for (int i = 0; i < 30; ++i)
            {
                world.step(dt);
                farthest = std::max(farthest, world.body(id).position().x);
            }
            EXPECT_LT(farthest, 5);
            EXPECT_GT(farthest, 4.7f) << "it came to the wall";
        }
}

TEST(Continuous, a_segment_stops_what_falls_on_it_at_any_speed)
{
    for (float speed = 1; speed < 1e5f; speed *= 3)
    {
        World world;
        world.create_body({.type = BodyType::Static}, segment({-50, 0}, {50, 0}));
        const BodyId id = world.create_body({.position = {0, 20}, .linear_velocity = {0, -speed}}, circle(0.1f));
        for (int i = 0; i < 300; ++i)
        {
            world.step(dt);
            ASSERT_GT(world.body(id).position().y, 0) << speed << " m/s, step " << i;
        }
        EXPECT_NEAR(world.body(id).position().y, 0.1f, 0.01) << speed;
    }
}

/// Two boxes of 10 cm that meet in flight. Where their ways overlap by at least a quarter of a box, the blow must be felt: they never change
/// sides along their line of flight.
TEST(Continuous, boxes_that_meet_at_200_m_per_s_each_do_not_pass_through_each_other)
{
    std::mt19937 engine(1);
    int met = 0;
    for (int trial = 0; trial < 1000; ++trial)
    {
        World world({.gravity = {}});
        const float heading = between(engine, -3, 3);
        const Vec2 along = rotate(rotation(heading), Vec2{1, 0});
        const Vec2 across = left_perp(along);
        const Vec2 middle = {between(engine, -100, 100), between(engine, -100, 100)};
        const float offset = between(engine, -0.07f, 0.07f);
        const float apart = between(engine, 0.5f, 15);
        const BodyId a = world.create_body({.position = middle - apart * along,
                                            .angle = between(engine, -3, 3),
                                            .linear_velocity = 200 * along,
                                            .angular_velocity = between(engine, -20, 20),
                                            .is_bullet = trial % 3 == 0},
                                           box(0.1f, 0.1f), {.material = {.restitution = trial % 2 == 0 ? 0.0f : 0.5f}});
        const BodyId b = world.create_body({.position = middle + between(engine, 0.5f, 15) * along + offset * across,
                                            .angle = between(engine, -3, 3),
                                            .linear_velocity = -200 * along,
                                            .angular_velocity = between(engine, -20, 20)},
                                           box(0.1f, 0.1f));
        bool has_met = false;
        for (int i = 0; i < 20; ++i)
        {
            world.step(dt);
            has_met = has_met || !world.events().contact_begin.empty();
            const Vec2 gap = world.body(b).position() - world.body(a).position();
            ASSERT_TRUE(has_met || dot(gap, along) > -0.03f) << "trial " << trial << " passed through unfelt";
        }
        met += has_met;
        EXPECT_TRUE(has_met) << trial << " offset " << offset;
    }
    EXPECT_EQ(met, 1000);
}

TEST(Continuous, many_fast_bodies_in_a_box_stay_in_it)
{
    World world({.gravity = {}});
    const BodyId frame = world.create_body({.type = BodyType::Static});
    for (const auto& [from, to] : {std::pair<Vec2, Vec2>{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}, {{10, 10}, {0, 10}}, {{0, 10}, {0, 0}}})
        world.create_shape(frame, segment(from, to));
    std::mt19937 engine(4);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 100; ++i)
    {
        const Vec2 at = {0.5f + static_cast<float>(i % 10), 0.5f + static_cast<float>(i / 10)};
        const Vec2 velocity = {between(engine, -300, 300), between(engine, -300, 300)};
        const Geometry shape = i % 2 == 0 ? Geometry{circle(0.1f)} : Geometry{box(0.2f, 0.15f)};
        bodies.push_back(world.create_body({.position = at, .linear_velocity = velocity, .angular_velocity = between(engine, -30, 30)},
                                           shape, {.material = {.restitution = 1}}));
    }
    for (int i = 0; i < 300; ++i)
    {
        world.step(dt);
        for (const BodyId id : bodies)
        {
            const Vec2 p = world.body(id).position();
            ASSERT_TRUE(p.x > 0 && p.x < 10 && p.y > 0 && p.y < 10) << "step " << i << " at " << p.x << ", " << p.y;
        }
    }
}

TEST(Continuous, a_fast_ball_is_stopped_by_a_light_slow_one)
{
    World world({.gravity = {}});
    const BodyId slow = world.create_body({.position = {5, 0.02f}, .linear_velocity = {0, 0.1f}}, circle(0.1f));
    const BodyId fast = world.create_body({.linear_velocity = {150, 0}}, circle(0.1f), {.material = {.restitution = 1}});
    for (int i = 0; i < 10; ++i) world.step(dt);
    EXPECT_GT(world.body(slow).linear_velocity().x, 100) << "it was hit";
    EXPECT_NEAR(world.body(slow).linear_velocity().x + world.body(fast).linear_velocity().x, 150, 0.1);
}

TEST(Continuous, a_swung_bat_takes_a_ball_along)
{
    for (const float speed : {20.0f, 100.0f, 400.0f})
    {
        World world({.gravity = {}});
        const BodyId bat =
            world.create_body({.type = BodyType::Kinematic, .position = {-10, 0}, .linear_velocity = {speed, 0}}, box(0.1f, 2));
        const BodyId ball = world.create_body({.position = {0, 0.1f}}, circle(0.1f));
        for (int i = 0; i < 60; ++i) world.step(dt);
        EXPECT_GT(world.body(ball).position().x, world.body(bat).position().x) << speed;
        EXPECT_GE(world.body(ball).linear_velocity().x, 0.95f * speed);
    }
}

/// The ball is slow and far from the wall until the bat comes, within one step.
TEST(Continuous, a_bat_does_not_drive_a_ball_through_a_wall)
{
    for (const float speed : {30.0f, 100.0f, 300.0f})
        for (float start = 0; start < 1; start += 0.09f)
        {
            World world({.gravity = {}});
            world.create_body({.type = BodyType::Static}, segment({0, -3}, {0, 3}));
            const BodyId bat = world.create_body(
                {.type = BodyType::Kinematic, .position = {-speed / 20 - start, 0}, .linear_velocity = {speed, 0}}, box(0.1f, 2));
            const BodyId ball = world.create_body({.position = {-1, 0.1f}}, circle(0.1f), {.material = {.restitution = 0.5f}});
            for (int i = 0; i < 60; ++i)
            {
                Body driver = world.body(bat);
                const float room = -0.3f - driver.position().x; // up to where the ball still fits between
                driver.set_linear_velocity({std::min(speed, std::max(0.0f, room / dt)), 0});
                world.step(dt);
                ASSERT_LT(world.body(ball).position().x, 0) << speed << " m/s from " << start << ", step " << i;
                ASSERT_GT(world.body(ball).position().x, world.body(bat).position().x) << speed << " m/s from " << start << ", step " << i;
            }
        }
}

/// Stopping the blade itself would tear it from its hinge.
TEST(Continuous, a_blade_on_a_hinge_takes_a_ball_along_and_stays_on_its_hinge)
{
    for (const float spin : {5.0f, 12.0f, 25.0f})
        for (float turned = 0; turned < 6; turned += 0.37f)
        {
            World world({.gravity = {}});
            const BodyId blade = world.create_body(
                {.angle = turned, .linear_velocity = rotate(rotation(turned), {0, spin}), .angular_velocity = spin}, // of its middle
                offset_box(2, 0.06f, {1, 0}), {.density = 20});
            const JointId hinge = world.create_joint(world.joint_at({}, blade, {0, 0}), RevoluteJoint{});
            const BodyId ball = world.create_body({.position = {1.5f, 0}}, circle(0.1f));
            float error = 0;
            float side_before = 0;
            for (int i = 0; i < 120; ++i)
            {
                world.step(dt);
                error = std::max(error, world.joint(hinge).error());
                const Vec2 seen = inverse_transform(world.body(blade).transform(), world.body(ball).position());
                const bool is_beside = seen.x > 0.1f && seen.x < 1.9f && std::abs(seen.y) < 0.3f;
                ASSERT_FALSE(is_beside && side_before * seen.y < 0) << "passed through: " << spin << " rad/s from " << turned;
                side_before = is_beside ? seen.y : 0;
            }
            EXPECT_LT(error, 0.01f) << spin << " rad/s from " << turned;
            EXPECT_GT(length(world.body(ball).linear_velocity()), spin) << turned;
        }
}

/// What stops one part stops all that joints hold to it.
TEST(Continuous, a_chain_thrown_at_a_wall_does_not_pass_and_stays_together)
{
    // A blow opens joints by no more than its speed makes of the substep in which it comes.
    for (const auto& [speed, bound] : {std::pair{10.0f, 0.04f}, {30.0f, 0.1f}, {100.0f, 0.15f}})
        for (float turned = 0; turned < 3; turned += 0.31f)
        {
            World world({.gravity = {}});
            world.create_body({.type = BodyType::Static}, segment({0, -10}, {0, 10}));
            std::vector<BodyId> links;
            std::vector<JointId> pins;
            const Rot q = rotation(turned);
            for (int i = 0; i < 6; ++i)
            {
                const Vec2 middle = Vec2{-3, 0} + rotate(q, {0.4f * static_cast<float>(i) - 1, 0});
                links.push_back(world.create_body({.position = middle, .angle = turned, .linear_velocity = {speed, 0}}, box(0.4f, 0.1f)));
                if (i == 0) continue;
                const Vec2 pin = middle - rotate(q, {0.2f, 0});
                pins.push_back(world.create_joint(world.joint_at(links[links.size() - 2], links.back(), pin), RevoluteJoint{}));
            }
            float error = 0;
            for (int i = 0; i < 60; ++i)
            {
                world.step(dt);
                for (const BodyId link : links)
                    ASSERT_LT(world.body(link).position().x, 0) << speed << " m/s, turned by " << turned << ", step " << i;
                for (const JointId pin : pins) error = std::max(error, world.joint(pin).error());
            }
            EXPECT_LT(error, bound) << speed << " m/s, turned by " << turned;
        }
}

TEST(Continuous, a_sensor_crossed_at_speed_tells_one_begin_and_one_end)
{
    for (float start = 0; start < 4; start += 0.21f)
        for (const float speed : {5.0f, 40.0f, 200.0f, 900.0f})
        {
            World world({.gravity = {}});
            world.create_body({.type = BodyType::Static, .position = {10, 0}}, box(0.2f, 5), {.is_sensor = true});
            world.create_body({.position = {-start, 0}, .linear_velocity = {speed, 0}}, circle(0.1f));
            std::size_t begins = 0;
            std::size_t ends = 0;
            for (int i = 0; i < 400; ++i)
            {
                world.step(dt);
                begins += world.events().sensor_begin.size();
                ends += world.events().sensor_end.size();
                ASSERT_GE(begins, ends);
            }
            EXPECT_EQ(begins, 1u) << speed << " from " << start;
            EXPECT_EQ(ends, 1u) << speed << " from " << start;
        }
}

TEST(Continuous, it_can_be_switched_off)
{
    World world({.gravity = {}, .continuous = false});
    world.create_body({.type = BodyType::Static, .position = {5, 0}}, box(0.1f, 10));
    const BodyId id = world.create_body({.linear_velocity = {200, 0}}, circle(0.05f));
    for (int i = 0; i < 10; ++i) world.step(dt);
    EXPECT_GT(world.body(id).position().x, 10);
}

TEST(Continuous, sliding_over_seams_is_not_stopped)
{
    World world;
    for (int i = 0; i < 400; ++i)
        world.create_body({.type = BodyType::Static, .position = {static_cast<float>(i), -0.5f}}, box(1, 1), {.material = {.friction = 0}});
    const BodyId id =
        world.create_body({.position = {0, 0.25f}, .linear_velocity = {50, 0}}, box(0.5f, 0.5f), {.material = {.friction = 0}});
    for (int i = 0; i < 240; ++i) world.step(dt);
    EXPECT_GT(world.body(id).position().x, 0.99f * 200);
}

} // namespace carom
