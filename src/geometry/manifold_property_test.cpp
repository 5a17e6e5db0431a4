// What must hold for the contact of any two shapes at any place.
#include "geometry/distance.hpp"
#include "geometry/manifold.hpp"
#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace carom::detail
{

namespace
{

/// The pair and the place of one trial.
struct Trial
{
    Geometry a;
    Geometry b;
    Transform b_in_a;
};

/// Shapes of random types, at random, then brought together along the line between them until they are `gap` apart.
Trial nearly_touching(RandomShapes& random, int type_a, int type_b, float size, float gap)
{
    Trial trial = {random.geometry_of(type_a, size), random.geometry_of(type_b, size), random.transform(8 * size)};
    for (int i = 0; i < 8; ++i)
    {
        const DistanceResult d = distance(convex_points(trial.a), convex_points(trial.b), trial.b_in_a);
        trial.b_in_a.p -= (d.distance - gap) * d.normal;
    }
    return trial;
}

float least_separation(const LocalManifold& manifold)
{
    float least = manifold.points[0].separation;
    if (manifold.count == 2) least = std::min(least, manifold.points[1].separation);
    return least;
}

bool is_sound(const LocalManifold& manifold)
{
    if (manifold.count == 0) return true;
    bool sound = manifold.count <= 2 && std::abs(length(manifold.normal) - 1) < 1e-4f;
    for (int i = 0; i < manifold.count; ++i)
    {
        const LocalPoint& point = manifold.points[static_cast<std::size_t>(i)];
        sound = sound && is_finite(point.position) && std::isfinite(point.separation);
    }
    return sound && (manifold.count < 2 || manifold.points[0].feature != manifold.points[1].feature);
}

Transform inverse_of(const Transform& t) { return relative(t, Transform{}); }

} // namespace

TEST(ManifoldProperty, SeparationIsTheDistanceOfSeparatedShapes)
{
    RandomShapes random(61);
    int tested = 0;
    for (int i = 0; i < 40000; ++i)
    {
        const float gap = random.uniform(0.0005f, 0.019f);
        const Trial t = nearly_touching(random, i % 4, i / 4 % 4, 1, gap);
        const DistanceResult d = distance(convex_points(t.a), convex_points(t.b), t.b_in_a);
        if (d.distance < 1e-4f || d.distance > 0.0195f) continue;
        ++tested;
        const LocalManifold m = collide(t.a, t.b, t.b_in_a);
        ASSERT_TRUE(is_sound(m)) << i;
        ASSERT_GE(m.count, 1) << i << " types " << t.a.index() << " " << t.b.index() << " distance " << d.distance;
        ASSERT_NEAR(least_separation(m), d.distance, 1e-3f) << i << " types " << t.a.index() << " " << t.b.index();
        for (int k = 0; k < m.count; ++k)
        {
            ASSERT_LE(m.points[static_cast<std::size_t>(k)].separation, Tolerances{}.speculative_distance);
        }
    }
    EXPECT_GT(tested, 30000);
}

TEST(ManifoldProperty, ShapesFartherApartThanTheMarginMakeNoContact)
{
    RandomShapes random(62);
    int tested = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const Trial t = nearly_touching(random, i % 4, i / 4 % 4, 1, random.uniform(0.022f, 0.2f));
        const DistanceResult d = distance(convex_points(t.a), convex_points(t.b), t.b_in_a);
        if (d.distance <= 0.021f) continue;
        ++tested;
        ASSERT_EQ(collide(t.a, t.b, t.b_in_a).count, 0) << i;
    }
    EXPECT_GT(tested, 15000);
}

TEST(ManifoldProperty, TheOtherOrderGivesTheOppositeNormal)
{
    RandomShapes random(63);
    int tested = 0;
    int opposite = 0;
    for (int i = 0; i < 40000; ++i)
    {
        const Trial t = {random.geometry_of(i % 4, 1), random.geometry_of(i / 4 % 4, 1), random.transform(1.5f)};
        const LocalManifold ab = collide(t.a, t.b, t.b_in_a);
        const LocalManifold ba = collide(t.b, t.a, inverse_of(t.b_in_a));
        ASSERT_TRUE(is_sound(ab) && is_sound(ba)) << i;
        if (ab.count == 0 || ba.count == 0) continue;
        // A tie between two ways out may go either way; all else must agree.
        ASSERT_NEAR(least_separation(ab), least_separation(ba), 1e-3f) << i;
        ++tested;
        opposite += distance(rotate(t.b_in_a.q, ba.normal), -ab.normal) < 2e-3f;
    }
    EXPECT_GT(tested, 10000);
    EXPECT_GT(opposite, tested - tested / 200);
}

/// Moving B by the depth along the normal takes it out, and there is no shorter way.
TEST(ManifoldProperty, NormalAndDepthAreTheLeastTranslation)
{
    RandomShapes random(64);
    int tested = 0;
    for (int i = 0; i < 30000; ++i)
    {
        const Trial t = {random.geometry_of(i % 4, 1), random.geometry_of(i / 4 % 4, 1), random.transform(1.2f)};
        const LocalManifold m = collide(t.a, t.b, t.b_in_a);
        if (m.count == 0 || least_separation(m) > -0.01f) continue;
        ++tested;
        const float depth = -least_separation(m);
        const ConvexPoints a = convex_points(t.a);
        const ConvexPoints b = convex_points(t.b);

        Transform out = t.b_in_a;
        out.p += (depth + 0.002f) * m.normal;
        ASSERT_GT(distance(a, b, out).distance, 0) << i << " types " << t.a.index() << " " << t.b.index() << " depth " << depth;
        for (int k = 0; k < 32; ++k)
        {
            Transform shorter = t.b_in_a;
            shorter.p += (depth - 0.002f) * rotate(rotation(static_cast<float>(k) * pi / 16), m.normal);
            ASSERT_EQ(distance(a, b, shorter).distance, 0) << i << " types " << t.a.index() << " " << t.b.index() << " depth " << depth;
        }
    }
    EXPECT_GT(tested, 10000);
}

TEST(ManifoldProperty, FeaturesPersistUnderTinyMotions)
{
    RandomShapes random(65);
    int kept = 0;
    int all = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const Trial t = nearly_touching(random, i % 4, i / 4 % 4, 1, 0.005f);
        const LocalManifold before = collide(t.a, t.b, t.b_in_a);
        Transform moved = t.b_in_a;
        moved.p += random.point(1e-5f);
        moved.q = moved.q * rotation(random.uniform(-1e-5f, 1e-5f));
        const LocalManifold after = collide(t.a, t.b, moved);
        if (before.count == 0) continue;
        ++all;
        bool same = before.count == after.count;
        for (int k = 0; same && k < before.count; ++k)
        {
            const std::size_t n = static_cast<std::size_t>(k);
            same = before.points[n].feature == after.points[n].feature ||
                   (before.count == 2 && before.points[n].feature == after.points[1 - n].feature);
        }
        kept += same;
    }
    // Only the few pairs that stand right at a change of features or of the margin may change.
    EXPECT_GT(kept, all - all / 200);
    EXPECT_GT(all, 15000);
}

TEST(ManifoldProperty, AnyPlaceGivesFiniteResults)
{
    RandomShapes random(66);
    constexpr std::array<float, 6> sizes = {0.02f, 0.1f, 1, 30, 1000, 9e4f};
    constexpr std::array<float, 6> reaches = {0, 0.01f, 1, 100, 1e4f, 1e6f};
    for (int i = 0; i < 60000; ++i)
    {
        const float size_a = sizes[static_cast<std::size_t>(random.integer(0, 5))];
        const float size_b = sizes[static_cast<std::size_t>(random.integer(0, 5))];
        const float reach = reaches[static_cast<std::size_t>(random.integer(0, 5))];
        const Trial t = {random.geometry_of(i % 4, size_a), random.geometry_of(i / 4 % 4, size_b), random.transform(reach)};
        ASSERT_TRUE(is_sound(collide(t.a, t.b, t.b_in_a, random.uniform(0, 0.1f)))) << i;
    }
}

/// The bits themselves: this number is the same for every compiler, build type and architecture, or worlds would drift apart.
TEST(ManifoldProperty, GivesTheSameBitsEverywhere)
{
    RandomShapes random(67);
    std::uint64_t hash = 0xcbf29ce484222325ull;
    const auto add = [&hash](float value) { hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3ull; };
    for (int i = 0; i < 40000; ++i)
    {
        const Trial t = {random.geometry_of(i % 4, 1), random.geometry_of(i / 4 % 4, 1), random.transform(2)};
        const LocalManifold m = collide(t.a, t.b, t.b_in_a);
        for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k)
        {
            for (float value : {m.normal.x, m.normal.y, m.points[k].position.x, m.points[k].position.y, m.points[k].separation}) add(value);
            hash += m.points[k].feature;
        }
        const DistanceResult d = distance(convex_points(t.a), convex_points(t.b), t.b_in_a);
        for (float value : {d.distance, d.normal.x, d.normal.y, d.point_a.x, d.point_b.y}) add(value);
        const MassData mass = mass_of(t.a, 1);
        for (float value : {mass.mass, mass.inertia, mass.center.x, mass.center.y}) add(value);
    }
    EXPECT_EQ(hash, 3053143589854884504ull);
}

} // namespace carom::detail
