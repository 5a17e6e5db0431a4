// Series against the sums that they stand for.
#include "fields/local_series.hpp"

#include "fields/interaction_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom::detail
{
namespace
{

std::vector<Simd> present_simd()
{
    std::vector<Simd> present;
    for (const Simd simd : all_simd)
        if (is_available(simd)) present.push_back(simd);
    return present;
}

Aabb square(Vec2 center, float half) { return {center - Vec2{half, half}, center + Vec2{half, half}}; }

/// Of one mass at the origin, about a place.
LocalPull series_of(const GroupMass& mass, const Aabb& box, Simd simd)
{
    LocalPull around = series_around(box);
    const std::uint32_t which = 0;
    pull_passes_of(simd).expand(&mass.center.x, &which, 1, pull_limits(0.1f, 1), around);
    return around;
}

Vec2 value_at(const LocalPull& around, Vec2 point, Simd simd)
{
    Vec2 pull;
    pull_passes_of(simd).sum({}, around, &point.x, 1, pull_limits(0.1f, 1), &pull.x);
    return pull;
}

GroupMass point_mass()
{
    return {.center = {},
            .rest = {},
            .pull = 10,
            .spread_xx = 0,
            .spread_xy = 0,
            .spread_yy = 0,
            .skew_xxx = 0,
            .skew_xxy = 0,
            .skew_xyy = 0,
            .skew_yyy = 0};
}

/// The largest error at the corners of a square in units of the pull at its middle.
float corner_error(Vec2 center, float half, Simd simd)
{
    const LocalPull around = series_of(point_mass(), square(center, half), simd);
    const PullLimits limits = pull_limits(0.1f, 1);
    float largest = 0;
    for (const Vec2 corner : {Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}})
    {
        const Vec2 point = center + half * corner;
        largest = std::max(largest, distance(value_at(around, point, simd), pull_of_one({{}, 10}, point, limits)));
    }
    return largest / length(pull_of_one({{}, 10}, center, limits));
}

TEST(LocalSeries, leaves_out_what_is_of_sixth_order_in_the_size_of_the_square)
{
    for (const Simd simd : present_simd())
    {
        for (const Vec2 center : {Vec2{10, 0}, Vec2{-6, 8}, Vec2{0, -10}, Vec2{7, 7}})
        {
            const float whole = corner_error(center, 2.4f, simd);
            EXPECT_LT(whole, 0.02f);
            EXPECT_GT(whole / corner_error(center, 1.2f, simd), 40.0f) << "2^6 for small squares";
        }
    }
}

TEST(LocalSeries, is_the_same_about_the_middle_of_a_child)
{
    const Simd simd = best_simd();
    const LocalPull parent = series_of(point_mass(), square({8, -5}, 2), simd);
    LocalPull child = series_around(square({9, -6}, 1));
    inherit(child, parent);
    for (const Vec2 point : {Vec2{9, -6}, Vec2{10, -7}, Vec2{8, -6.5f}, Vec2{9.7f, -5.1f}})
    {
        const Vec2 expected = value_at(parent, point, simd);
        EXPECT_LT(distance(value_at(child, point, simd), expected), 1e-6f * length(expected));
    }
}

/// Three unequal bodies, whose moments are known, seen as one mass.
TEST(LocalSeries, holds_the_second_and_third_moments_of_a_group)
{
    const PointPull bodies[] = {{{0.3f, 0.1f}, 1}, {{-0.5f, 0.4f}, 2}, {{0.2f, -0.6f}, 3}};
    GroupMass group = point_mass();
    group.pull = 6;
    for (const PointPull& b : bodies) group.center += b.pull / 6 * b.position;
    for (const PointPull& b : bodies)
    {
        const Vec2 e = b.position - group.center;
        const float share = b.pull / 6;
        group.spread_xx += share * e.x * e.x;
        group.spread_xy += share * e.x * e.y;
        group.spread_yy += share * e.y * e.y;
        group.skew_xxx += share * e.x * e.x * e.x;
        group.skew_xxy += share * e.x * e.x * e.y;
        group.skew_xyy += share * e.x * e.y * e.y;
        group.skew_yyy += share * e.y * e.y * e.y;
    }
    const PullLimits limits = pull_limits(0.1f, 3);
    for (const Simd simd : present_simd())
    {
        const LocalPull around = series_of(group, square({3, 4}, 0.2f), simd);
        const Vec2 point{3.1f, 3.9f};
        Vec2 expected;
        for (const PointPull& b : bodies) expected += pull_of_one(b, point, limits);
        EXPECT_LT(distance(value_at(around, point, simd), expected), 4e-4f * length(expected));
    }
}

} // namespace
} // namespace carom::detail
