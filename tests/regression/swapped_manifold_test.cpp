// World::manifold must tell the same story from both sides.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

namespace carom
{

TEST(Regression, a_manifold_asked_for_the_other_way_round_turns_its_rolling_impulse)
{
    World world;
    const Material felt = {.friction = 1, .rolling_resistance = 0.1f};
    const BodyId ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = felt});
    const BodyId ball =
        world.create_body({.position = {0, 0.5f}, .linear_velocity = {5, 0}, .angular_velocity = -10}, circle(0.5f), {.material = felt});
    for (int i = 0; i < 5; ++i) world.step(1 / 60.0f);

    const ShapeId a = world.body(ground).shapes()[0];
    const ShapeId b = world.body(ball).shapes()[0];
    const Manifold there = world.manifold(a, b);
    const Manifold back = world.manifold(b, a);
    ASSERT_EQ(there.point_count, 1);
    EXPECT_GT(there.rolling_impulse, 0) << "brakes a ball that turns clockwise";
    EXPECT_EQ(back.rolling_impulse, -there.rolling_impulse);
    EXPECT_EQ(back.normal, -there.normal);
    EXPECT_EQ(back.points[0].normal_impulse, there.points[0].normal_impulse);
    // t = right_perp(n) turns with the normal, and so does the body that the impulse acts on: the sign stays.
    EXPECT_EQ(back.points[0].tangent_impulse, there.points[0].tangent_impulse);
}

} // namespace carom
