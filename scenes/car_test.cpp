// The car gets over the whole course on its wheels, starts again, and obeys its keys.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

constexpr float goal = 142; // [m]

BodyView car(const Scene& scene) { return scene.world().body(body_named(scene, "car")); }

/// Steps until the car is past a place. @return how many it took, or `most`
int steps_until_past(Scene& scene, float x, int most)
{
    for (int i = 0; i < most; ++i)
    {
        if (car(scene).position().x > x) return i;
        scene.step();
    }
    return most;
}

} // namespace

TEST(Car, drives_to_the_goal_by_itself_and_stands_there_on_its_wheels)
{
    const auto scene = make_scene("car");
    constexpr int most = 30 * 60;
    EXPECT_LT(steps_until_past(*scene, 45, most), 7 * 60);    // bumps and hills
    EXPECT_LT(steps_until_past(*scene, 83, most), 7 * 60);    // the seesaw and the bridge
    EXPECT_LT(steps_until_past(*scene, goal, most), 18 * 60); // boxes and the jump
    step(*scene, 120);
    EXPECT_LT(std::abs(car(*scene).angle()), 0.1f);
    EXPECT_NEAR(car(*scene).position().y, 0.95f, 0.1f);
    EXPECT_LT(length(car(*scene).linear_velocity()), 0.1f);
    step(*scene, 240);
    EXPECT_LT(car(*scene).position().x, 20) << "it starts again";
    EXPECT_LT(length(scene->camera().center - car(*scene).position()), 6) << "the camera comes along";
}

TEST(Car, its_wheels_stay_where_they_belong)
{
    const auto scene = make_scene("car");
    const World& world = scene->world();
    ASSERT_EQ(world.joints_of(body_named(*scene, "car")).size(), 2u);
    for (int i = 0; i < 1500; ++i)
    {
        scene->step();
        for (const JointId id : world.joints_of(body_named(*scene, "car")))
        {
            const JointView wheel = world.joint(id);
            EXPECT_LT(std::abs(wheel.offset().x), 0.27f) << i; // limited to 0.25 m
            EXPECT_LT(wheel.error(), 0.02f) << i;
        }
    }
}

TEST(Car, the_bridge_and_the_seesaw_hold)
{
    // How hard the car lands on the bridge differs from seed to seed: planks open by 7 to 19 mm for a step or two.
    for (const std::uint64_t seed : {1u, 2u, 3u})
    {
        const auto scene = make_scene("car", {}, seed);
        float largest = 0;
        float sum_of_widest = 0;
        constexpr int steps = 1500;
        for (int i = 0; i < steps; ++i)
        {
            scene->step();
            float widest = 0;
            for (const JointId id : scene->world().joints())
            {
                const JointView joint = scene->world().joint(id);
                if (joint.type() == JointType::Revolute) widest = std::max(widest, joint.error());
            }
            largest = std::max(largest, widest);
            sum_of_widest += widest;
        }
        EXPECT_GT(largest, 0) << "of what bears a load";
        EXPECT_LT(largest, 0.02f) << seed;
        EXPECT_LT(sum_of_widest / steps, 0.0003f) << seed;
    }
}

TEST(Car, keys_drive_and_brake)
{
    const auto scene = make_scene("car");
    step(*scene, 60);
    scene->key("space");
    step(*scene, 120);
    EXPECT_LT(length(car(*scene).linear_velocity()), 0.1f);
    const float there = car(*scene).position().x;
    step(*scene, 300);
    EXPECT_NEAR(car(*scene).position().x, there, 0.01f) << "a person who brakes is not hurried";
    scene->key("left");
    step(*scene, 60);
    EXPECT_LT(car(*scene).linear_velocity().x, -3);
    scene->key("right");
    step(*scene, 120);
    EXPECT_GT(car(*scene).linear_velocity().x, 3);
}

TEST(Car, a_car_on_its_back_starts_again)
{
    const auto scene = make_scene("car");
    const BodyId first = body_named(*scene, "car");
    scene->world().body(first).set_transform({4, 1.3f}, 3.1f); // and its wheels where they belong
    for (const JointId id : scene->world().joints_of(first))
    {
        const JointView joint = scene->world().joint(id);
        scene->world().body(joint.body_b()).set_transform(scene->world().body(first).transform() * joint.frame_a().p, 0);
    }
    step(*scene, 400);
    EXPECT_FALSE(scene->world().find_body(first));
    EXPECT_LT(std::abs(car(*scene).angle()), 0.5f);
}

} // namespace carom::scenes
