#include "dynamics/finalize_bodies.hpp"

#include "dynamics/dynamics_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace carom::detail::finalize_bodies_test
{
namespace
{

constexpr float step_time = 1 / 60.0f;

class FinalizeBodiesTest : public testing::Test
{
protected:
    std::uint32_t add(const BodyDef& def, const Geometry& geometry = circle(0.5f))
    {
        const std::uint32_t body = scene.add(def, geometry);
        broad_phase->insert(body, scene.shapes.bounds[body].fat, ProxyKind::Moving);
        return body;
    }
    BodyMotion& motion(std::uint32_t body) { return scene.bodies.motions[scene.bodies.motion_index[body]]; }
    BodyWatch& watch(std::uint32_t body) { return scene.bodies.watches[scene.bodies.motion_index[body]]; }
    void finalize() { finalize_bodies(scene.bodies, scene.shapes, *broad_phase, step_time, 0.05f, lost, &motions); }

    SmallScene scene;
    BroadPhasePtr broad_phase = make_broad_phase(BroadPhaseType::BruteForce, {}, scene.memory);
    std::pmr::vector<LostBody> lost{&scene.memory};
    FastMotion motions{scene.memory};
    std::pmr::vector<FastBody>& fast = motions.bodies;
};

TEST_F(FinalizeBodiesTest, poses_take_over_the_displacement_and_forces_end)
{
    const std::uint32_t body = add({.position = {1, 2}, .angle = 0.5f});
    motion(body).dp = {0.01f, -0.02f};
    motion(body).dq = rotation(0.1f);
    scene.bodies.drives[scene.bodies.motion_index[body]].force = {3, 4};
    scene.bodies.drives[scene.bodies.motion_index[body]].torque = 5;
    finalize();
    EXPECT_LT(distance(scene.bodies.poses[body].center, {1.01f, 1.98f}), 1e-6f);
    EXPECT_LT(distance(scene.bodies.poses[body].transform.p, {1.01f, 1.98f}), 1e-6f);
    EXPECT_NEAR(angle(scene.bodies.poses[body].transform.q), 0.6f, 1e-6f);
    EXPECT_EQ(motion(body).dp, Vec2{});
    EXPECT_EQ(motion(body).dq.s, 0);
    EXPECT_EQ(scene.bodies.drives[scene.bodies.motion_index[body]].force, Vec2{});
    EXPECT_EQ(scene.bodies.drives[scene.bodies.motion_index[body]].torque, 0);
    EXPECT_NEAR(scene.shapes.bounds[body].tight.max.x, 1.51f, 1e-5f);
    EXPECT_TRUE(fast.empty());
}

TEST_F(FinalizeBodiesTest, only_bounds_that_are_left_are_made_anew)
{
    const std::uint32_t near = add({});
    const std::uint32_t far = add({.position = {5, 0}});
    const Aabb fat = scene.shapes.bounds[near].fat;
    scene.shapes.clear_moved();
    motion(near).dp = {0.05f, 0}; // the fat bounds are 0.1 m wider
    motion(far).dp = {0.15f, 0};
    finalize();
    EXPECT_EQ(scene.shapes.bounds[near].fat.max.x, fat.max.x);
    ASSERT_EQ(scene.shapes.moved.size(), 1u);
    EXPECT_EQ(scene.shapes.moved[0], far);
    EXPECT_GT(scene.shapes.bounds[far].fat.max.x, scene.shapes.bounds[far].tight.max.x);
}

TEST_F(FinalizeBodiesTest, a_state_that_is_not_finite_is_not_taken_over)
{
    const std::uint32_t body = add({.position = {1, 2}, .linear_velocity = {3, 0}});
    const std::uint32_t sound = add({.position = {9, 0}});
    motion(body).dp = {std::numeric_limits<float>::quiet_NaN(), 0};
    motion(sound).dp = {0.01f, 0};
    finalize();
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_EQ(lost[0].body, body);
    EXPECT_EQ(scene.bodies.poses[body].center, (Vec2{1, 2}));
    EXPECT_EQ(motion(body).v, Vec2{});
    EXPECT_NEAR(scene.bodies.poses[sound].center.x, 9.01f, 1e-5f) << "the others go on";
}

TEST_F(FinalizeBodiesTest, rest_time_grows_while_all_of_the_body_is_slow)
{
    const std::uint32_t still = add({});
    const std::uint32_t moves = add({.position = {3, 0}, .linear_velocity = {0.06f, 0}});
    const std::uint32_t spins = add({.position = {6, 0}, .angular_velocity = 0.11f}); // its rim moves at 0.055 m/s
    const std::uint32_t pulled = add({.position = {9, 0}});
    const std::uint32_t wakeful = add({.position = {12, 0}, .can_sleep = false});
    motion(pulled).dp = {0.002f, 0}; // without a velocity: 0.12 m/s
    finalize();
    EXPECT_FLOAT_EQ(watch(still).rest_time, step_time);
    EXPECT_EQ(watch(moves).rest_time, 0);
    EXPECT_EQ(watch(spins).rest_time, 0);
    EXPECT_EQ(watch(pulled).rest_time, 0);
    EXPECT_EQ(watch(wakeful).rest_time, 0);
    finalize();
    EXPECT_FLOAT_EQ(watch(still).rest_time, 2 * step_time);
}

TEST_F(FinalizeBodiesTest, bodies_are_fast_from_half_their_inner_radius_and_bullets_at_once)
{
    const std::uint32_t slow = add({});
    const std::uint32_t swift = add({.position = {3, 0}});
    const std::uint32_t bullet = add({.position = {6, 0}, .is_bullet = true});
    const std::uint32_t turning = add({.position = {9, 0}}, box(4, 0.2f));
    motion(slow).dp = {0.24f, 0};
    motion(swift).dp = {0.26f, 0};
    motion(bullet).dp = {0.02f, 0};
    motion(turning).dq = rotation(0.1f); // its ends move by 0.2 m, and it is 0.1 m thick from its middle
    finalize();
    ASSERT_EQ(fast.size(), 3u);
    EXPECT_EQ(fast[0].body, swift);
    EXPECT_EQ(fast[1].body, bullet);
    EXPECT_EQ(fast[2].body, turning);
    EXPECT_LT(distance(fast[0].sweep.center_start, {3, 0}), 1e-6f);
    EXPECT_LT(distance(fast[0].sweep.center_end, {3.26f, 0}), 1e-6f);
    EXPECT_LT(scene.shapes.bounds[swift].fat.min.x, 2.5f) << "its bounds hold the whole way";
    EXPECT_GT(scene.shapes.bounds[swift].fat.max.x, 3.76f);
}

TEST_F(FinalizeBodiesTest, shapes_stray_when_their_displacement_leaves_the_fat_bounds)
{
    const std::uint32_t slow = add({});
    const std::uint32_t slow_out = add({.position = {3, 0}});
    const std::uint32_t swift = add({.position = {6, 0}});
    const std::uint32_t swift_out = add({.position = {9, 0}});
    const std::uint32_t there_and_back = add({.position = {12, 0}}, box(2, 1));
    scene.shapes.bounds[swift].fat = expanded(scene.shapes.bounds[swift].fat, 1);
    scene.shapes.bounds[there_and_back].fat = expanded(scene.shapes.bounds[there_and_back].tight, 0.2f);
    motion(slow).dp = {0.05f, 0}; // the fat bounds are 0.1 m wider
    motion(slow_out).dp = {0.15f, 0};
    motion(swift).dp = {0.3f, 0};
    motion(swift_out).dp = {0.3f, 0};
    motion(there_and_back).dq = rotation(pi); // half a turn: its corners leave the bounds, and come back
    finalize();
    EXPECT_EQ(fast.size(), 3u);
    const std::pmr::vector<std::uint32_t>& strayed = motions.strayed_shapes;
    EXPECT_EQ(std::vector(strayed.begin(), strayed.end()), (std::vector{slow_out, swift_out, there_and_back}));
    EXPECT_LT(scene.shapes.bounds[swift].fat.max.x, 6.9f) << "no more than its way";
}

TEST_F(FinalizeBodiesTest, shapes_that_the_next_step_takes_out_of_their_fat_bounds_get_new_ones_before_they_stray)
{
    const std::uint32_t body = add({.linear_velocity = {0.06f / step_time, 0}}); // 0.06 m a step, and the fat bounds are 0.1 m wider
    scene.shapes.clear_moved();
    const Aabb fat = scene.shapes.bounds[body].fat;
    motion(body).dp = {0.06f, 0};
    finalize();
    EXPECT_EQ(scene.shapes.bounds[body].fat, fat) << "the pairs of this step were found with them";
    EXPECT_TRUE(motions.strayed_shapes.empty());
    ASSERT_EQ(motions.leaving_shapes.size(), 1u);
    renew_bounds(motions.leaving_shapes, scene.bodies, scene.shapes, *broad_phase, step_time);
    EXPECT_EQ(scene.shapes.moved.size(), 1u) << "the next search for pairs knows them";
    motions.leaving_shapes.clear();
    motion(body).dp = {0.06f, 0};
    finalize();
    EXPECT_TRUE(motions.strayed_shapes.empty());
    EXPECT_TRUE(motions.leaving_shapes.empty());
}

TEST_F(FinalizeBodiesTest, a_turn_of_more_than_half_a_circle_is_told_by_the_spin)
{
    const std::uint32_t body = add({.angular_velocity = 400}, box(1, 0.1f)); // 6.67 rad in the step: one turn and 0.38 rad
    motion(body).dq = rotation(400 * step_time);
    finalize();
    ASSERT_EQ(fast.size(), 1u);
    EXPECT_NEAR(fast[0].sweep.turn, 400 * step_time, 1e-3f);
}

} // namespace
} // namespace carom::detail::finalize_bodies_test
