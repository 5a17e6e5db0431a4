// Explosions: who is pushed, how hard, and who is woken.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

namespace carom
{

namespace
{

class ExplosionTest : public testing::Test
{
protected:
    World world{{.gravity = {}}};
};

} // namespace

TEST_F(ExplosionTest, AnExplosionPushesByWidthAndDistance)
{
    const auto ball = [&](Vec2 at, float radius) { return world.create_body({.position = at}, circle(radius)); };
    const BodyId small = ball({2, 0}, 0.25f);
    const BodyId large = ball({-2, 0}, 0.5f);
    const BodyId fading = ball({0, 4.25f}, 0.25f);
    const BodyId beyond = ball({0, -6}, 0.25f);
    const BodyId wall = world.create_body({.type = BodyType::Static, .position = {2, 2}}, box(1, 1));
    EXPECT_EQ(world.explode({.center = {0, 0}, .radius = 3, .falloff = 2, .impulse_per_metre = 10}), 3);
    const auto momentum = [&](BodyId id) { return world.body(id).mass_data().mass * world.body(id).linear_velocity(); };
    EXPECT_NEAR(momentum(small).x, 5, 1e-4f);
    EXPECT_NEAR(momentum(large).x, -10, 1e-4f);
    EXPECT_NEAR(momentum(fading).y, 2.5f, 1e-4f) << "halfway through the falloff";
    EXPECT_EQ(momentum(beyond), Vec2{});
    EXPECT_EQ(world.body(wall).linear_velocity(), Vec2{});
    EXPECT_NEAR(world.body(small).angular_velocity(), 0, 1e-5f);
}

TEST_F(ExplosionTest, AnExplosionTurnsWhatItMeetsAtACorner)
{
    const BodyId plank = world.create_body({.position = {2, 1}}, box(0.2f, 4));
    world.explode({.center = {0, -1}, .radius = 5, .impulse_per_metre = 1});
    EXPECT_GT(world.body(plank).linear_velocity().x, 0);
    EXPECT_GT(world.body(plank).angular_velocity(), 0);
}

TEST_F(ExplosionTest, AnExplosionInsideOfABodyPushesItAsAWhole)
{
    const BodyId crate = world.create_body({.position = {0.2f, 0}}, box(2, 2));
    EXPECT_EQ(world.explode({.impulse_per_metre = 1}), 1);
    EXPECT_GT(world.body(crate).linear_velocity().x, 0);
    const BodyId centred = world.create_body({.position = {20, 0}}, box(2, 2));
    EXPECT_EQ(world.explode({.center = {20, 0}, .impulse_per_metre = 1}), 0) << "from all sides alike";
    EXPECT_EQ(world.body(centred).linear_velocity(), Vec2{});
}

TEST_F(ExplosionTest, SleepersAreSeenAndAnExplosionWakesThem)
{
    const BodyId sleeper = world.create_body({.position = {3, 0}}, box(1, 1));
    for (int i = 0; i < 120; ++i) world.step(1 / 60.0f);
    ASSERT_FALSE(world.body(sleeper).is_awake());
    EXPECT_TRUE(world.cast_ray({0, 0}, {5, 0}));
    EXPECT_EQ(world.shapes_at({3, 0}).size(), 1u);
    EXPECT_TRUE(world.closest_point({0, 0}, 5));
    EXPECT_FALSE(world.body(sleeper).is_awake()) << "to be asked about wakes nobody";
    EXPECT_EQ(world.explode({.radius = 1, .impulse_per_metre = 1}), 0);
    EXPECT_FALSE(world.body(sleeper).is_awake()) << "out of reach";
    EXPECT_EQ(world.explode({.radius = 4, .impulse_per_metre = 1}), 1);
    EXPECT_TRUE(world.body(sleeper).is_awake());
    EXPECT_NEAR(world.body(sleeper).linear_velocity().x, 1, 1e-4f);
}

} // namespace carom
