// The joints scene: every type is there and moves, holds what it has to, and the spring tears; bodies can be dragged.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace carom::scenes
{

TEST(JointsScene, shows_every_type)
{
    const auto scene = make_scene("joints");
    std::set<JointType> types;
    for (const JointId id : scene->world().joints()) types.insert(scene->world().joint(id).type());
    EXPECT_EQ(types.size(), std::variant_size_v<JointSpec>);
}

TEST(JointsScene, joints_hold_for_half_a_minute)
{
    for (const std::uint64_t seed : {1u, 2u, 3u})
    {
        const auto scene = make_scene("joints", {}, seed);
        // The whip at the end of the driven arm cracks now and then: over ten minutes its pin opens by 3.3 mm at most, and by 1 mm in one step of 120. All
        // others stay below 1.3 mm.
        float widest = 0;
        int wide_open = 0;
        for (int i = 0; i < 1800; ++i)
        {
            const float widest_now = largest_joint_error(*scene, 1);
            widest = std::max(widest, widest_now);
            wide_open += widest_now > 0.001f;
        }
        EXPECT_LT(widest, 0.004f) << seed;
        EXPECT_LT(wide_open, 60) << seed;
    }
}

TEST(JointsScene, the_gears_turn_in_the_ratio_of_their_radii)
{
    const auto scene = make_scene("joints");
    const World& world = scene->world();
    const BodyId small = body_named(*scene, "small gear");
    const BodyId large = body_named(*scene, "large gear");
    const BodyId rack = body_named(*scene, "rack");
    const float start = world.body(rack).position().x;
    float most = 0;
    for (int i = 0; i < 1200; ++i)
    {
        scene->step();
        const float turn = world.body(large).angle();
        most = std::max(most, std::abs(turn));
        EXPECT_NEAR(0.55f * world.body(small).angle(), -1.05f * turn, 0.001f) << i;
        EXPECT_NEAR(world.body(rack).position().x - start, 1.05f * turn, 0.001f) << i;
    }
    EXPECT_GT(most, 0.8f);
}

TEST(JointsScene, the_rope_keeps_its_length)
{
    const auto scene = make_scene("joints");
    const World& world = scene->world();
    const JointId id = world.joints_of(body_named(*scene, "heavy weight")).front();
    const PulleyJoint pulley = std::get<PulleyJoint>(world.joint(id).spec());
    float lowest = 100;
    float highest = -100;
    for (int i = 0; i < 1200; ++i)
    {
        scene->step();
        const JointView joint = world.joint(id);
        const Vec2 a = world.body(joint.body_a()).transform() * joint.frame_a().p;
        const Vec2 b = world.body(joint.body_b()).transform() * joint.frame_b().p;
        EXPECT_NEAR(distance(a, pulley.ground_a) + distance(b, pulley.ground_b), pulley.length, 0.001f) << i;
        lowest = std::min(lowest, b.y);
        highest = std::max(highest, b.y);
    }
    EXPECT_GT(highest - lowest, 1); // the light weight goes up and down
}

TEST(JointsScene, the_arm_turns_back_at_its_limits)
{
    const auto scene = make_scene("joints");
    const JointId arm = scene->world().joints_of(body_named(*scene, "arm")).front();
    float lowest = 0;
    float highest = 0;
    for (int i = 0; i < 600; ++i)
    {
        scene->step();
        lowest = std::min(lowest, scene->world().joint(arm).angle());
        highest = std::max(highest, scene->world().joint(arm).angle());
    }
    EXPECT_NEAR(lowest, -2.3f, 0.03f);
    EXPECT_NEAR(highest, 0.6f, 0.03f);
}

TEST(JointsScene, the_spring_tears_under_its_load_and_hangs_again)
{
    const auto scene = make_scene("joints");
    int torn = 0;
    int hanging = 0;
    for (int i = 0; i < 1800; ++i)
    {
        scene->step();
        torn += static_cast<int>(scene->world().events().joint_break.size());
        hanging += !scene->world().joints_of(body_named(*scene, "bucket")).empty();
    }
    EXPECT_GE(torn, 2);
    EXPECT_GT(hanging, 900);
    EXPECT_LT(hanging, 1700);
}

TEST(JointsScene, a_body_follows_the_pointer_until_it_is_let_go)
{
    const auto scene = make_scene("joints");
    step(*scene, 30);
    const BodyId cart = body_named(*scene, "cart");
    const auto place = [&] { return scene->world().body(cart).position(); };
    const int joints = scene->world().joint_count();
    click(*scene, place());
    EXPECT_EQ(scene->world().joint_count(), joints + 1);
    const Vec2 target = place() + Vec2{0, 3};
    scene->pointer({.action = PointerEvent::Action::Move, .position = target});
    step(*scene, 90);
    EXPECT_LT(distance(place(), target), 0.3f);
    scene->pointer({.action = PointerEvent::Action::Up, .button = PointerEvent::Button::Left, .position = target});
    EXPECT_EQ(scene->world().joint_count(), joints);
    step(*scene, 60);
    EXPECT_LT(place().y, target.y - 2);
}

TEST(JointsScene, the_cart_comes_back_when_it_is_thrown_away)
{
    const auto scene = make_scene("joints");
    const BodyId cart = body_named(*scene, "cart");
    const Vec2 before = scene->world().body(cart).position();
    scene->world().body(cart).set_transform({60, 0}, 0);
    step(*scene, 2);
    EXPECT_FALSE(scene->world().find_body(cart));
    EXPECT_LT(distance(scene->world().body(body_named(*scene, "cart")).position(), before), 0.1f);
}

} // namespace carom::scenes
