// A shape that has changed is seen as it is now, by everything that remembers shapes from step to step.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

namespace carom
{

TEST(Regression, a_shape_that_shrank_does_not_pass_through_a_wall)
{
    World world({.gravity = {}});
    world.create_body({.type = BodyType::Static}, segment({5, -5}, {5, 5}));
    const BodyId ball = world.create_body({.position = {0.17f, 0}, .linear_velocity = {20, 0}}, circle(1));
    world.shape(world.body(ball).shapes()[0]).set_geometry(circle(0.05f));
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    EXPECT_LT(world.body(ball).position().x, 5) << "its extent was that of the large circle";
}

} // namespace carom
