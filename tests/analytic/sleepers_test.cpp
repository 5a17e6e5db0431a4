// Sleepers cost next to nothing.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace carom
{

namespace
{

double median_step_seconds(World& world, int steps)
{
    std::vector<double> seconds;
    for (int i = 0; i < steps; ++i) seconds.push_back(world.step(dt).seconds);
    std::nth_element(seconds.begin(), seconds.begin() + steps / 2, seconds.end());
    return seconds[static_cast<std::size_t>(steps / 2)];
}

} // namespace

/// A thousand towers of ten boxes, awake and asleep.
TEST(Sleepers, SlowTenThousandOfThemCostLessThanOnePercent)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {1000, -1}}, box(2100, 2));
    for (int tower = 0; tower < 1000; ++tower)
        for (int i = 0; i < 10; ++i)
            world.create_body({.position = {2 * static_cast<float>(tower), 0.5f + static_cast<float>(i)}}, box(1, 1));
    const double awake = median_step_seconds(world, 30);
    EXPECT_EQ(world.awake_body_count(), 10'000);
    for (int i = 0; i < 600 && world.awake_body_count() > 0; ++i) world.step(dt);
    ASSERT_EQ(world.awake_body_count(), 0);
    const double asleep = median_step_seconds(world, 100);
    EXPECT_LT(asleep, 0.01 * awake);
    std::printf("awake %.3f ms, asleep %.5f ms: %.3f %%\n", 1e3 * awake, 1e3 * asleep, 100 * asleep / awake);
    EXPECT_EQ(world.step(dt).pairs, 10'000) << "they are all still there";
}

} // namespace carom
