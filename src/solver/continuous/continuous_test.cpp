#include "solver/continuous/continuous.hpp"

#include "dynamics/dynamics_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom::detail::continuous_test
{
namespace
{

constexpr float step_time = 1 / 60.0f;

/// Bodies at the end of their displacements in a step, as finalize_bodies leaves them.
class ContinuousTest : public testing::Test
{
protected:
    std::uint32_t add(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape = {})
    {
        const std::uint32_t body = scene.add(def, geometry, shape);
        broad_phase->insert(body, scene.shapes.bounds[body].fat, ProxyKind::Moving);
        return body;
    }
    std::uint32_t fixed(const Geometry& geometry, Vec2 position, const ShapeDef& shape = {})
    {
        return add({.type = BodyType::Static, .position = position}, geometry, shape);
    }
    /// A body that went from one place to another in the step.
    std::uint32_t flying(const Geometry& geometry, Vec2 from, Vec2 to, BodyDef def = {})
    {
        def.position = to;
        def.linear_velocity = (to - from) / step_time;
        const std::uint32_t body = add(def, geometry);
        ShapeBounds& bounds = scene.shapes.bounds[body];
        bounds.fat = expanded(merge(bounds_of(geometry, {from, {}}), bounds.tight), 0.01f);
        broad_phase->update(body, bounds.fat);
        fast.push_back({body, {{}, from, to, {}, 0}});
        return body;
    }
    void run() { continuous.run(fast, scene.bodies, scene.shapes, joints, scene.contacts, rules, *broad_phase, step_time, 2 * step_time); }
    Vec2 place(std::uint32_t body) const { return scene.bodies.poses[body].center; }

    SmallScene scene;
    BroadPhasePtr broad_phase = make_broad_phase(BroadPhaseType::BruteForce, {}, scene.memory);
    JointStore joints{scene.memory};
    ContactRules rules;
    std::vector<FastBody> fast;
    ContinuousCollision continuous{scene.memory};
};

TEST_F(ContinuousTest, a_fast_body_stands_where_it_first_touches_a_wall_and_keeps_its_velocity)
{
    fixed(box(0.2f, 4), {5, 0});
    fixed(box(0.2f, 4), {8, 0});
    const std::uint32_t ball = flying(circle(0.1f), {0, 0}, {10, 0});
    run();
    EXPECT_NEAR(place(ball).x, 4.8f, 0.005f);
    EXPECT_LT(distance(scene.bodies.velocity(ball), {600, 0}), 0.01f);
    EXPECT_LT(scene.shapes.bounds[ball].tight.max.x, 4.905f) << "its bounds are where it is";
}

TEST_F(ContinuousTest, what_flies_past_is_not_stopped)
{
    fixed(box(0.2f, 4), {5, 2.2f});
    const std::uint32_t ball = flying(circle(0.1f), {0, 0}, {10, 0}); // its top is at 0.1, the wall begins at 0.2
    run();
    EXPECT_EQ(place(ball), (Vec2{10, 0}));
}

TEST_F(ContinuousTest, a_contact_that_is_disabled_or_passing_lets_through)
{
    const std::uint32_t wall = fixed(box(0.2f, 4), {5, 0});
    const std::uint32_t other = fixed(box(0.2f, 4), {7, 0});
    const std::uint32_t ball = flying(circle(0.1f), {0, 0}, {10, 0});
    scene.contacts.contacts[scene.touch(wall, ball)].is_disabled = true;
    scene.contacts.contacts[scene.touch(other, ball)].is_passing = true;
    run();
    EXPECT_EQ(place(ball), (Vec2{10, 0}));
}

TEST_F(ContinuousTest, a_one_sided_segment_stops_only_what_comes_from_its_front)
{
    for (const bool from_front : {false, true})
    {
        const std::uint32_t wall =
            fixed(segment({0, from_front ? 2.0f : -2.0f}, {0, from_front ? -2.0f : 2.0f}), {5, from_front ? 0.0f : 20.0f});
        scene.shapes.records[wall].is_one_sided = true; // solid on the right of the way: downwards, that is the left side
        const float y = from_front ? 0.0f : 20.0f;
        const std::uint32_t ball = flying(circle(0.1f), {0, y}, {10, y});
        fast = {fast.back()};
        ContinuousCollision once{scene.memory};
        once.run(fast, scene.bodies, scene.shapes, joints, scene.contacts, rules, *broad_phase, step_time, 2 * step_time);
        EXPECT_NEAR(place(ball).x, from_front ? 4.9f : 10.0f, 0.005f) << from_front;
    }
}

TEST_F(ContinuousTest, two_that_meet_head_on_stand_where_they_meet)
{
    const std::uint32_t a = flying(circle(0.1f), {0, 0}, {10, 0});
    const std::uint32_t b = flying(circle(0.1f), {10, 0}, {0, 0});
    run();
    EXPECT_NEAR(place(a).x, 4.9f, 0.01f);
    EXPECT_NEAR(place(b).x, 5.1f, 0.01f);
}

TEST_F(ContinuousTest, one_that_catches_up_goes_on_as_far_as_both_do)
{
    const std::uint32_t a = flying(circle(0.1f), {0, 0}, {10, 0});
    const std::uint32_t b = flying(circle(0.1f), {5, 0}, {7, 0}); // at 5 + 2t; a reaches it at t = 0.6
    run();
    EXPECT_NEAR(place(b).x, 7, 0.01f);
    EXPECT_NEAR(place(a).x, 6.8f, 0.02f);
}

TEST_F(ContinuousTest, a_kinematic_body_takes_along_what_it_meets)
{
    const std::uint32_t ram = flying(box(0.4f, 2), {0, 0}, {10, 0}, {.type = BodyType::Kinematic});
    const std::uint32_t ball = add({.position = {5, 0}}, circle(0.1f));
    run();
    EXPECT_EQ(place(ram), (Vec2{10, 0})) << "nothing stops it";
    EXPECT_NEAR(place(ball).x, 10.3f, 0.01f);
}

TEST_F(ContinuousTest, a_sensor_that_is_crossed_within_the_step_is_told_and_stops_nothing)
{
    const std::uint32_t sensor = fixed(box(0.2f, 4), {5, 0}, {.is_sensor = true});
    fixed(box(0.2f, 4), {5, 10}, {.is_sensor = true});
    const std::uint32_t ball = flying(circle(0.1f), {0, 0}, {10, 0});
    run();
    EXPECT_EQ(place(ball), (Vec2{10, 0}));
    ASSERT_EQ(continuous.crossings().size(), 1u);
    EXPECT_EQ(continuous.crossings()[0], (Crossing{sensor, ball}));
}

TEST_F(ContinuousTest, a_sensor_behind_the_wall_that_stops_the_body_is_not_crossed)
{
    fixed(box(0.2f, 4), {3, 0});
    fixed(box(0.2f, 4), {5, 0}, {.is_sensor = true});
    flying(circle(0.1f), {0, 0}, {10, 0});
    run();
    EXPECT_TRUE(continuous.crossings().empty());
}

TEST_F(ContinuousTest, a_bullet_is_stopped_at_what_it_hardly_enters_whichever_of_the_two_is_first)
{
    for (int i = 0; i < 4; ++i)
    {
        const bool is_ball_first = i % 2 == 0;
        const bool is_ball_bullet = i / 2 == 0;
        const float y = 20 * static_cast<float>(i);
        const std::size_t before = fast.size();
        // Seen from the crate, the ball moves by less than half its radius, and would end 1.5 cm deep.
        const auto crate = [&] { return flying(box(1, 1), {0, y}, {1, y}, {.is_bullet = !is_ball_bullet}); };
        const auto ball = [&] { return flying(circle(0.1f), {-0.63f, y}, {-0.63f + 1.045f, y}, {.is_bullet = is_ball_bullet}); };
        const std::uint32_t first = is_ball_first ? ball() : crate();
        const std::uint32_t second = is_ball_first ? crate() : ball();
        const std::vector<FastBody> both(fast.begin() + static_cast<std::ptrdiff_t>(before), fast.end());
        ContinuousCollision once{scene.memory};
        once.run(both, scene.bodies, scene.shapes, joints, scene.contacts, rules, *broad_phase, step_time, 2 * step_time);
        EXPECT_GT(std::abs(place(first).x - place(second).x), 0.599f) << i;
    }
}

} // namespace
} // namespace carom::detail::continuous_test
