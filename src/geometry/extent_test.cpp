#include "geometry/extent.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::detail
{

TEST(Extent, InnerRadiusFitsInside)
{
    EXPECT_FLOAT_EQ(inner_radius(circle(2, {5, 0})), 2);
    EXPECT_FLOAT_EQ(inner_radius(capsule({-1, 0}, {4, 0}, 0.5f)), 0.5f);
    EXPECT_FLOAT_EQ(inner_radius(box(4, 1)), 0.5f);
    EXPECT_FLOAT_EQ(inner_radius(rounded_box(4, 1, 0.2f)), 0.5f);
    EXPECT_EQ(inner_radius(segment({0, 0}, {9, 0})), 0);
}

TEST(Extent, OuterRadiusReachesTheFarthestPoint)
{
    EXPECT_FLOAT_EQ(outer_radius(circle(2, {5, 0}), {1, 0}), 6);
    EXPECT_FLOAT_EQ(outer_radius(capsule({-1, 0}, {4, 0}, 0.5f), {0, 0}), 4.5f);
    EXPECT_FLOAT_EQ(outer_radius(box(6, 8), {}), 5);
    EXPECT_FLOAT_EQ(outer_radius(segment({0, 0}, {3, 4}), {}), 5);
    EXPECT_NEAR(outer_radius(rounded_box(2, 2, 0.25f), {}), std::sqrt(2.0f) * 0.75f + 0.25f, 1e-6);
}

} // namespace carom::detail
