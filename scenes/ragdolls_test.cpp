// The ragdolls: their joints hold and bend no further than they may, and they come to rest.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

constexpr int limbs = 11; // of a doll

/// By how much the joint that misses its limits most does so [rad].
float limit_miss(const World& world)
{
    float most = 0;
    for (const JointId id : world.joints())
    {
        const JointView joint = world.joint(id);
        const Range limit = *std::get<RevoluteJoint>(joint.spec()).limit;
        most = std::max({most, joint.angle() - limit.upper, limit.lower - joint.angle()});
    }
    return most;
}

} // namespace

TEST(Ragdolls, their_joints_hold_while_they_fall_and_they_fall_asleep)
{
    for (const std::uint64_t seed : {1u, 2u, 3u})
    {
        const auto scene = make_scene("ragdolls", {}, seed);
        float widest = 0;
        float farthest_bent = 0;
        int open = 0; // joints that are open by more than 3 mm, summed over steps
        constexpr int steps = 2400;
        for (int i = 0; i < steps; ++i)
        {
            scene->step();
            for (const JointId id : scene->world().joints())
            {
                const float error = scene->world().joint(id).error();
                widest = std::max(widest, error);
                open += error > 0.003f;
            }
            farthest_bent = std::max(farthest_bent, limit_miss(scene->world()));
        }
        EXPECT_EQ(dynamic_bodies(*scene).size(), 12u * limbs);
        EXPECT_LT(widest, 0.05f) << seed;          // a limb struck at 8 m/s
        EXPECT_LT(open, 24 * (limbs - 1)) << seed; // each joint for two steps of 2400
        EXPECT_LT(farthest_bent, 0.1f) << seed;
        EXPECT_EQ(scene->world().awake_body_count(), 0) << seed;
        EXPECT_LT(largest_joint_error(*scene, 1), 0.001f) << seed;
        EXPECT_LT(limit_miss(scene->world()), 0.02f) << seed;
    }
}

TEST(Ragdolls, stay_in_the_box)
{
    const auto scene = make_scene("ragdolls", {{"dolls", 24}});
    EXPECT_EQ(times_outside(*scene, {{-13, 0}, {13, 40}}, 800), 0);
    EXPECT_EQ(dynamic_bodies(*scene).size(), 24u * limbs);
}

TEST(Ragdolls, a_key_and_clicks_add_dolls_up_to_two_hundred)
{
    const auto scene = make_scene("ragdolls", {{"dolls", 0}, {"size", 0.5}});
    scene->key("space");
    EXPECT_EQ(dynamic_bodies(*scene).size(), 1u * limbs);
    for (int i = 0; i < 250; ++i)
    {
        const Vec2 place{2 * static_cast<float>(i % 10) - 9, 12 + 1.5f * static_cast<float>(i / 10)};
        click(*scene, place);
        EXPECT_EQ(dynamic_bodies(*scene).size(), static_cast<std::size_t>(limbs * std::min(i + 2, 200)));
    }
    scene->key("space");
    EXPECT_EQ(dynamic_bodies(*scene).size(), 200u * limbs);
}

TEST(Ragdolls, a_doll_that_is_dragged_comes_along_whole)
{
    const auto scene = make_scene("ragdolls", {{"dolls", 1}});
    step(*scene, 200);
    const BodyId chest = dynamic_bodies(*scene).front();
    const auto place = [&] { return scene->world().body(chest).center_of_mass(); };
    click(*scene, place());
    const Vec2 target{0, 9};
    for (int i = 1; i <= 60; ++i)
    {
        const float t = static_cast<float>(i) / 60;
        scene->pointer({.action = PointerEvent::Action::Move, .position = place() + t * (target - place())});
        scene->step();
    }
    scene->pointer({.action = PointerEvent::Action::Move, .position = target});
    EXPECT_LT(largest_joint_error(*scene, 120), 0.02f);
    EXPECT_LT(distance(place(), target), 0.5f);
}

} // namespace carom::scenes
