#include "solver/continuous/continuous.hpp"

#include "broadphase/pair_set.hpp"
#include "dynamics/dynamics_test.hpp"
#include "dynamics/find_pairs.hpp"
#include "dynamics/narrow_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
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
        fast.bodies.push_back({body, {{}, from, to, {}, 0}});
        fast.strayed_shapes.push_back(body);
        displace(body, {to - from, 0});
        return body;
    }
    void displace(std::uint32_t body, const Displacement& displacement)
    {
        fast.displacements.resize(scene.bodies.motions.size());
        fast.displacements[scene.bodies.motion_index[body]] = displacement;
    }
    /// Runs what was made to fly last.
    /// @param first how many were made before
    std::vector<Crossing> run(std::size_t first = 0)
    {
        fast.bodies.erase(fast.bodies.begin(), fast.bodies.begin() + static_cast<std::ptrdiff_t>(first));
        fast.displacements.resize(scene.bodies.motions.size());
        ContinuousCollision continuous{scene.memory};
        continuous.run(fast, scene.bodies, scene.shapes, joints, scene.contacts, rules, *broad_phase, step_time);
        return {continuous.crossings().begin(), continuous.crossings().end()};
    }
    Vec2 place(std::uint32_t body) const { return scene.bodies.poses[body].center; }

    SmallScene scene;
    BroadPhasePtr broad_phase = make_broad_phase(BroadPhaseType::BruteForce, {}, scene.memory);
    JointStore joints{scene.memory};
    ContactRules rules;
    FastMotion fast{scene.memory};
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
        run(fast.bodies.size() - 1);
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

TEST_F(ContinuousTest, what_moves_along_with_a_slow_body_is_left_to_their_contact)
{
    for (const float way_of_crate : {0.0f, 0.2f})
    {
        const float y = 10 * way_of_crate;
        const std::uint32_t crate = add({.position = {0.95f, y}}, box(1, 1));
        displace(crate, {{way_of_crate, 0}, 0});
        const std::uint32_t ball = flying(circle(0.5f), {0, y}, {0.4f, y});
        run(fast.bodies.size() - 1);
        EXPECT_EQ(place(ball).x == 0.4f, way_of_crate > 0) << "0.4 m is more than half its radius, 0.2 m is not";
    }
}

TEST_F(ContinuousTest, what_rides_on_a_slow_body_that_turns_is_left_to_their_contact)
{
    constexpr float turn = 0.05f;
    for (const float turn_of_wheel : {0.0f, turn})
    {
        const float y = 1000 * turn_of_wheel;
        const std::uint32_t wheel = add({.type = BodyType::Kinematic, .position = {0, y}, .angle = turn}, box(20, 1));
        displace(wheel, {{}, turn_of_wheel});
        const auto on_wheel = [&](float angle) { return Vec2{0, y} + rotate(rotation(angle), {-8, 0.8f}); };
        const std::uint32_t ball = flying(circle(0.5f), on_wheel(0), on_wheel(turn)); // by 0.4 m, downwards
        run(fast.bodies.size() - 1);
        EXPECT_EQ(place(ball) == on_wheel(turn), turn_of_wheel > 0);
    }
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
    const std::vector<Crossing> crossings = run();
    EXPECT_EQ(place(ball), (Vec2{10, 0}));
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_EQ(crossings[0], (Crossing{sensor, ball}));
}

TEST_F(ContinuousTest, a_sensor_behind_the_wall_that_stops_the_body_is_not_crossed)
{
    fixed(box(0.2f, 4), {3, 0});
    fixed(box(0.2f, 4), {5, 0}, {.is_sensor = true});
    flying(circle(0.1f), {0, 0}, {10, 0});
    EXPECT_TRUE(run().empty());
}

TEST_F(ContinuousTest, a_bullet_is_stopped_at_what_it_hardly_enters_whichever_of_the_two_is_first)
{
    for (int i = 0; i < 4; ++i)
    {
        const bool is_ball_first = i % 2 == 0;
        const bool is_ball_bullet = i / 2 == 0;
        const float y = 20 * static_cast<float>(i);
        const std::size_t before = fast.bodies.size();
        // Seen from the crate, the ball moves by less than half its radius, and would end 1.5 cm deep.
        const auto crate = [&] { return flying(box(1, 1), {0, y}, {1, y}, {.is_bullet = !is_ball_bullet}); };
        const auto ball = [&] { return flying(circle(0.1f), {-0.63f, y}, {-0.63f + 1.045f, y}, {.is_bullet = is_ball_bullet}); };
        const std::uint32_t first = is_ball_first ? ball() : crate();
        const std::uint32_t second = is_ball_first ? crate() : ball();
        run(before);
        EXPECT_GT(std::abs(place(first).x - place(second).x), 0.599f) << i;
    }
}

/// Discs that fly about in a box at speeds at which all of them are fast: without a solver, so that only continuous collision stops them.
class Swarm
{
public:
    explicit Swarm(bool searches_everything) : searches_everything_(searches_everything)
    {
        for (const float side : {-2.0f, 2.0f})
        {
            add({.type = BodyType::Static, .position = {side, 0}}, box(0.2f, 5));
            add({.type = BodyType::Static, .position = {0, side}}, box(5, 0.2f));
        }
        const std::uint32_t stirrer = add({.type = BodyType::Kinematic, .angular_velocity = 3}, box(3, 0.1f));
        EXPECT_TRUE(scene.bodies.is_active(stirrer));
        for (int i = 0; i < 150; ++i)
            add({.position = place(), .linear_velocity = velocity()}, i % 3 == 0 ? Geometry{box(0.2f, 0.2f)} : circle(0.1f));
    }

    void step()
    {
        find_pairs(*broad_phase, scene.shapes, scene.bodies, joints, scene.contacts, known, {}, scene.memory);
        ContactChanges changes(scene.memory);
        update_manifolds(touch_passes_of(best_simd()), scene.bodies, scene.shapes, scene.contacts, 0, changes);
        for (const std::uint32_t slot : changes.separated)
        {
            known.erase({scene.contacts.contacts[slot].shape_a, scene.contacts.contacts[slot].shape_b});
            scene.contacts.destroy(slot, scene.bodies);
        }
        for (std::size_t i = 1; i < scene.bodies.motions.size(); ++i)
        {
            BodyMotion& motion = scene.bodies.motions[i];
            if (scene.bodies.is_dynamic(motion.slot) && random() % 8 == 0) motion.v = velocity();
            motion.dp = step_time * motion.v;
            motion.dq = rotation(step_time * motion.w);
        }
        FastMotion fast(scene.memory);
        std::pmr::vector<LostBody> lost(&scene.memory);
        finalize_bodies(scene.bodies, scene.shapes, *broad_phase, step_time, 0.05f, lost, &fast);
        strayed += fast.strayed_shapes.size();
        moved += fast.bodies.size();
        if (searches_everything_)
            for (std::uint32_t shape = 0; shape < scene.shapes.records.size(); ++shape)
                if (std::find(fast.strayed_shapes.begin(), fast.strayed_shapes.end(), shape) == fast.strayed_shapes.end())
                    fast.strayed_shapes.push_back(shape);
        ContinuousCollision continuous{scene.memory};
        continuous.run(fast, scene.bodies, scene.shapes, joints, scene.contacts, {}, *broad_phase, step_time);
        renew_bounds(fast.leaving_shapes, scene.bodies, scene.shapes, *broad_phase, step_time);
        for (const BodyWatch& watch : scene.bodies.watches) set_back += watch.set_back != Vec2{};
    }

    SmallScene scene;
    std::size_t moved = 0;
    std::size_t strayed = 0;
    std::size_t set_back = 0;

private:
    float number(float most) { return most * (static_cast<float>(random() % 2001) / 1000 - 1); }
    Vec2 place() { return {number(1.7f), number(1.7f)}; }
    Vec2 velocity() { return {number(6), number(6)}; }
    std::uint32_t add(const BodyDef& def, const Geometry& geometry)
    {
        const std::uint32_t body = scene.add(def, geometry);
        broad_phase->insert(body, scene.shapes.bounds[body].fat, def.type == BodyType::Static ? ProxyKind::Static : ProxyKind::Moving);
        scene.shapes.mark_moved(body);
        return body;
    }

    bool searches_everything_;
    std::mt19937 random{5};
    BroadPhasePtr broad_phase = make_broad_phase(BroadPhaseType::Tree, {}, scene.memory);
    JointStore joints{scene.memory};
    PairSet known{scene.memory};
};

TEST(ContinuousCandidates, contacts_and_what_strayed_lead_to_the_impacts_of_a_search_for_everything)
{
    Swarm quick(false);
    Swarm thorough(true);
    for (int i = 0; i < 100; ++i)
    {
        quick.step();
        thorough.step();
        ASSERT_EQ(quick.set_back, thorough.set_back) << i;
        for (std::size_t body = 0; body < quick.scene.bodies.poses.size(); ++body)
        {
            ASSERT_EQ(quick.scene.bodies.poses[body].transform, thorough.scene.bodies.poses[body].transform) << i << ", body " << body;
            ASSERT_EQ(quick.scene.shapes.bounds[body].fat, thorough.scene.shapes.bounds[body].fat) << i << ", body " << body;
        }
    }
    EXPECT_GT(quick.set_back, 500u);
    EXPECT_GT(quick.strayed, 500u);
    EXPECT_LT(2 * quick.strayed, quick.moved) << "or contacts would not be looked at";
}

} // namespace
} // namespace carom::detail::continuous_test
