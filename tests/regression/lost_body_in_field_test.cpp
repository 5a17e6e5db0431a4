// Bodies that become non-finite within a step while others are pulled by gravity between bodies.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace carom
{

/// The tree of masses divided for ever around a body at infinity.
TEST(Regression, a_body_that_goes_to_infinity_does_not_stop_gravity)
{
    for (const float impulse : {1e38f, 3e38f})
    {
        World world({.gravity = {}});
        world.add_field(NBodyField{.gravitational_constant = 1, .softening = 0.1f, .method = NBodyMethod::BarnesHut});
        for (int i = 0; i < 60; ++i) world.create_body({.position = {static_cast<float>(i), 0}}, circle(0.3f));
        const BodyId lost = world.create_body({.position = {0, 5}}, circle(0.3f), {.density = 0.01f});
        world.body(lost).apply_impulse_to_center({impulse, -impulse});
        world.body(lost).apply_impulse_to_center({impulse, -impulse});
        world.step(1 / 60.0f, 8);
        EXPECT_FALSE(world.body(lost).is_enabled());
        EXPECT_TRUE(is_finite(world.body(world.bodies().front()).position()));
    }
}

} // namespace carom
