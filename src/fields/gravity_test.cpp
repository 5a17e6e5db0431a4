// Gravity against closed forms; Barnes-Hut against a direct sum in double, over many kinds of distributions.
#include "fields/gravity.hpp"
#include "math/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdio>
#include <limits>

namespace carom::detail
{
namespace
{

struct Cloud
{
    std::vector<Vec2> position;
    std::vector<float> mass;

    PointMasses sources() const { return {position, mass}; }
};

Cloud even_cloud(std::size_t count, Vec2 center, float half_side)
{
    Random random(3);
    Cloud cloud;
    for (std::size_t i = 0; i < count; ++i)
    {
        cloud.position.push_back(center + Vec2{random.between(-half_side, half_side), random.between(-half_side, half_side)});
        cloud.mass.push_back(random.between(0.1f, 2));
    }
    return cloud;
}

/// Clusters, denser towards their middles, of sizes that differ a hundredfold.
Cloud clustered_cloud(std::size_t count, float spread)
{
    Random random(4);
    Cloud cloud;
    Vec2 center[7];
    for (Vec2& c : center) c = {random.between(-spread, spread), random.between(-spread, spread)};
    for (std::size_t i = 0; i < count; ++i)
    {
        const float radius = spread * 0.1f / static_cast<float>(1 + 15 * (i % 7)) * random.between(0, 1) * random.between(0, 1);
        const Rot direction = rotation(random.between(-pi, pi));
        cloud.position.push_back(center[i % 7] + radius * Vec2{direction.c, direction.s});
        cloud.mass.push_back(random.between(0.1f, 2));
    }
    return cloud;
}

std::vector<Vec2> accelerations(const NBodyField& field, const Cloud& cloud, Simd simd = best_simd())
{
    NBodySolver solver(*std::pmr::new_delete_resource());
    std::vector<Vec2> result(cloud.position.size());
    solver.add(field, cloud.sources(), cloud.position, result, pull_passes_of(simd));
    return result;
}

/// By a plain loop in double, gravitational constant 1.
std::vector<std::array<double, 2>> reference_accelerations(const Cloud& cloud, double softening)
{
    std::vector<std::array<double, 2>> result;
    for (const Vec2 target : cloud.position)
    {
        double a_x = 0;
        double a_y = 0;
        for (std::size_t j = 0; j < cloud.position.size(); ++j)
        {
            const double x = static_cast<double>(cloud.position[j].x) - static_cast<double>(target.x);
            const double y = static_cast<double>(cloud.position[j].y) - static_cast<double>(target.y);
            if (x == 0 && y == 0) continue;
            const double s = std::sqrt(x * x + y * y + softening * softening);
            const double f = static_cast<double>(cloud.mass[j]) / (s * s * s);
            a_x += f * x;
            a_y += f * y;
        }
        result.push_back({a_x, a_y});
    }
    return result;
}

struct Error
{
    double overall = 0; ///< root of the sum of squared errors over the sum of squares
    double each = 0;    ///< root mean square of each body's relative error: the harder one, since many bodies' pulls nearly cancel
};

Error relative_error(const std::vector<std::array<double, 2>>& expected, const std::vector<Vec2>& got)
{
    double errors = 0;
    double squares = 0;
    double ratios = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        const auto [x, y] = expected[i];
        const double error = std::pow(x - static_cast<double>(got[i].x), 2) + std::pow(y - static_cast<double>(got[i].y), 2);
        errors += error;
        squares += x * x + y * y;
        ratios += error / (x * x + y * y);
    }
    return {std::sqrt(errors / squares), std::sqrt(ratios / static_cast<double>(expected.size()))};
}

NBodyField field_of(NBodyMethod method, float opening_angle = 0.5f, float softening = 0)
{
    return {.gravitational_constant = 1, .softening = softening, .method = method, .opening_angle = opening_angle};
}

void expect_close(const char* name, const Cloud& cloud, float softening)
{
    SCOPED_TRACE(name);
    const std::vector<std::array<double, 2>> expected = reference_accelerations(cloud, static_cast<double>(softening));
    const auto error_of = [&](NBodyMethod method, float opening_angle)
    { return relative_error(expected, accelerations(field_of(method, opening_angle, softening), cloud)); };
    EXPECT_LT(error_of(NBodyMethod::Direct, 0.5f).overall, 1e-5);
    EXPECT_LT(error_of(NBodyMethod::BarnesHut, 0).overall, 1e-5);
    const Error half = error_of(NBodyMethod::BarnesHut, 0.5f);
    EXPECT_LT(half.overall, 0.003);
    EXPECT_LT(half.each, 0.01);
    EXPECT_LT(error_of(NBodyMethod::BarnesHut, 1.5f).overall, 0.15);
    std::printf("    %-22s opening angle 0.5: error overall %.4f %%, of each body %.3f %%\n", name, 100 * half.overall, 100 * half.each);
}

TEST(PointField, PullsByTheInverseSquare)
{
    const Vec2 targets[] = {{3, 4}, {1, 1}, {-9, 1}};
    Vec2 acceleration[] = {{100, 0}, {0, 0}, {0, 0}};
    add_point_field({.center = {1, 1}, .strength = 10}, targets, acceleration);
    const float r = std::sqrt(13.0f);
    EXPECT_NEAR(acceleration[0].x, 100 - 20 / (r * r * r), 1e-5f);
    EXPECT_NEAR(acceleration[0].y, -30 / (r * r * r), 1e-6f);
    EXPECT_EQ(acceleration[1], (Vec2{0, 0}));
    EXPECT_NEAR(acceleration[2].x, 0.1f, 1e-7f);
    EXPECT_EQ(acceleration[2].y, 0);
}

TEST(PointField, SoftensAndPushes)
{
    const Vec2 target{0, 3};
    Vec2 acceleration;
    add_point_field({.strength = -50, .softening = 4}, {&target, 1}, {&acceleration, 1});
    EXPECT_NEAR(acceleration.y, 50.0f * 3 / 125, 1e-6f);
}

TEST(PointField, StaysFiniteAtExtremes)
{
    const float most = std::numeric_limits<float>::max();
    const float least = std::numeric_limits<float>::denorm_min();
    for (const float strength : {1.0f, -1.0f, most, -most, least})
        for (const Vec2 center : {Vec2{}, Vec2{most, -most}, Vec2{1e-22f, 1e-25f}})
            for (const Vec2 target : {Vec2{least, 0}, Vec2{-most, most}, Vec2{1e-20f, 1e-20f}, Vec2{1e19f, 0}})
            {
                Vec2 acceleration;
                add_point_field({.center = center, .strength = strength}, {&target, 1}, {&acceleration, 1});
                EXPECT_TRUE(is_finite(acceleration));
            }
}

TEST(NBody, TwoBodiesPullEachOther)
{
    for (const NBodyMethod method : {NBodyMethod::Direct, NBodyMethod::BarnesHut})
    {
        const Cloud cloud{{{0, 0}, {2, 0}}, {8, 4}};
        const std::vector<Vec2> a = accelerations(field_of(method), cloud);
        EXPECT_NEAR(a[0].x, 1, 1e-6f);
        EXPECT_NEAR(a[1].x, -2, 1e-6f);
        EXPECT_EQ(a[0].y, 0);
    }
}

TEST(NBody, OneBodyNoneAndMassless)
{
    for (const NBodyMethod method : {NBodyMethod::Direct, NBodyMethod::BarnesHut})
    {
        EXPECT_TRUE(accelerations(field_of(method), {}).empty());
        EXPECT_EQ(accelerations(field_of(method), {{{5, 5}}, {3}})[0], Vec2{});
        EXPECT_EQ(accelerations(field_of(method), {{{5, 5}, {6, 6}}, {0, 0}})[1], Vec2{});

        Cloud half = even_cloud(500, {}, 10);
        for (std::size_t i = 0; i < 250; ++i) half.mass[i] = 0;
        EXPECT_LT(relative_error(reference_accelerations(half, 0), accelerations(field_of(method), half)).overall, 0.01);
    }
}

TEST(NBody, AllAtOnePointPullNothing)
{
    for (const NBodyMethod method : {NBodyMethod::Direct, NBodyMethod::BarnesHut})
    {
        Cloud cloud{std::vector<Vec2>(1000, {-3, 7}), std::vector<float>(1000, 2)};
        for (const Vec2 a : accelerations(field_of(method), cloud)) EXPECT_EQ(a, Vec2{});
        cloud.position.push_back({-3, 17}); // seen from here they are one mass
        cloud.mass.push_back(1);
        const Vec2 a = accelerations(field_of(method), cloud).back();
        EXPECT_NEAR(a.y, -20, 1e-3f);
    }
}

TEST(NBody, BarnesHutIsWithinOnePercentAtHalf)
{
    expect_close("even", even_cloud(10000, {}, 100), 0.1f);
    expect_close("even_sharp", even_cloud(3000, {}, 100), 0);
    expect_close("clustered", clustered_cloud(10000, 100), 0.01f);
    expect_close("clustered_sharp", clustered_cloud(3000, 100), 0);
    expect_close("negative", even_cloud(2000, {-500, -900}, 100), 0.1f);
    expect_close("far_from_the_origin", even_cloud(3000, {1e6f, -1e6f}, 50), 0.1f);
    expect_close("spread_1e12", even_cloud(3000, {}, 1e12f), 0);
    expect_close("spread_1e12_clustered", clustered_cloud(3000, 1e12f), 0);
}

/// An outlier makes the first grid's cells larger than the rest of the world.
TEST(NBody, DividesClustersManyMagnitudesBelowTheSpread)
{
    Cloud cloud = even_cloud(3000, {}, 1);
    cloud.position.push_back({1e12f, 1e12f});
    cloud.mass.push_back(1);
    const Cloud tiny = even_cloud(1000, {2e-6f, 2e-6f}, 1e-6f);
    cloud.position.insert(cloud.position.end(), tiny.position.begin(), tiny.position.end());
    cloud.mass.insert(cloud.mass.end(), tiny.mass.begin(), tiny.mass.end());
    expect_close("outlier", cloud, 1e-7f);

    PointTree tree(*std::pmr::new_delete_resource());
    tree.build(cloud.position, 8);
    for (const PointTree::Node& node : tree.nodes())
    {
        EXPECT_TRUE(!node.is_leaf || node.end - node.begin <= 8);
        EXPECT_GT(node.end, node.begin);
    }
    EXPECT_LT(tree.nodes().size(), 2 * cloud.position.size());
}

TEST(NBody, StaysFiniteAtExtremes)
{
    const float most = std::numeric_limits<float>::max();
    const float least = std::numeric_limits<float>::denorm_min();
    const Cloud cloud{{{most, most},
                       {-most, -most},
                       {0, 0},
                       {least, 0},
                       {1e-20f, 0},
                       {-1e-20f, 1e-22f},
                       {1e30f, -1e30f},
                       {1e19f, 1},
                       {least, least},
                       {0, 0},
                       {1, 1}},
                      {most, most, most, 1, least, most, most, 1, 1, most, 1e-30f}};
    for (const NBodyMethod method : {NBodyMethod::Direct, NBodyMethod::BarnesHut})
        for (const float constant : {1.0f, 1e30f, 1e-30f, -1.0f, 0.0f})
            for (const float softening : {0.0f, 1.0f, 1e-30f, 1e30f})
            {
                NBodyField field = field_of(method, 1, softening);
                field.gravitational_constant = constant;
                for (const Vec2 a : accelerations(field, cloud)) EXPECT_TRUE(is_finite(a));
            }
}

std::uint64_t hash_of(const std::vector<Vec2>& values)
{
    std::uint64_t hash = 14695981039346656037u; // FNV-1a
    for (const Vec2 v : values)
        for (const float f : {v.x, v.y}) hash = (hash ^ std::bit_cast<std::uint32_t>(f)) * 1099511628211u;
    return hash;
}

/// Fails when a compiler, an option or a machine changes a single bit.
TEST(NBody, GivesTheSameBitsEverywhere)
{
    const Cloud cloud = clustered_cloud(1000, 300);
    for (const Simd simd : all_simd)
    {
        if (!is_available(simd)) continue;
        SCOPED_TRACE(name_of(simd));
        EXPECT_EQ(hash_of(accelerations(field_of(NBodyMethod::Direct), cloud, simd)), 10845187299477817314u);
        EXPECT_EQ(hash_of(accelerations(field_of(NBodyMethod::BarnesHut), cloud, simd)), 9173700104828621607u);
    }
}

/// Within a step the trees are kept: their nodes need not be those of the places, only the bounds around them.
TEST(NBody, is_as_exact_with_the_trees_of_before)
{
    Cloud cloud = even_cloud(3000, {}, 50);
    NBodySolver solver(*std::pmr::new_delete_resource());
    std::vector<Vec2> before(cloud.position.size());
    const PullPasses& passes = pull_passes_of(best_simd());
    solver.add(field_of(NBodyMethod::BarnesHut, 0.5f, 0.1f), cloud.sources(), cloud.position, before, passes);
    Random random(9);
    for (Vec2& p : cloud.position) p += Vec2{random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f)};
    std::vector<Vec2> after(cloud.position.size());
    solver.add(field_of(NBodyMethod::BarnesHut, 0.5f, 0.1f), cloud.sources(), cloud.position, after, passes, true);
    const auto expected = reference_accelerations(cloud, 0.1f);
    EXPECT_LT(relative_error(expected, after).overall, 0.003);
    EXPECT_LT(relative_error(expected, after).each, 0.01);
    EXPECT_GT(relative_error(expected, before).each, 0.1) << "they have moved";
}

TEST(NBody, TargetsNeedNotBeSources)
{
    const Cloud cloud = even_cloud(2000, {}, 20);
    NBodySolver solver(*std::pmr::new_delete_resource());
    const std::vector<Vec2> targets{{100, 0}, {0.5f, 0.5f}, {-3000, 40}, {0.5f, 0.5f}};
    std::vector<Vec2> direct(4, {1, 1});
    std::vector<Vec2> grouped(4, {1, 1});
    solver.add(field_of(NBodyMethod::Direct), cloud.sources(), targets, direct, pull_passes_of(best_simd()));
    solver.add(field_of(NBodyMethod::BarnesHut, 0.3f), cloud.sources(), targets, grouped, pull_passes_of(best_simd()));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(distance(direct[i], grouped[i]), 0.01f * length(direct[i]));
    EXPECT_EQ(grouped[1], grouped[3]);
    EXPECT_EQ(direct[1], direct[3]);
}

TEST(NBody, AllocatesNothingOnceItHasGrown)
{
    alignas(std::max_align_t) static std::byte buffer[4 << 20];
    std::pmr::monotonic_buffer_resource first(buffer, sizeof buffer);
    NBodySolver solver(first);
    const Cloud cloud = even_cloud(3000, {}, 20);
    std::vector<Vec2> once(3000);
    std::vector<Vec2> again(3000);
    solver.add(field_of(NBodyMethod::BarnesHut), cloud.sources(), cloud.position, once, pull_passes_of(best_simd()));
    std::pmr::memory_resource* const heap = std::pmr::set_default_resource(std::pmr::null_memory_resource());
    solver.add(field_of(NBodyMethod::BarnesHut), cloud.sources(), cloud.position, again, pull_passes_of(best_simd()));
    std::pmr::set_default_resource(heap);
    EXPECT_EQ(once, again);
}

} // namespace
} // namespace carom::detail
