// Queries against a plain loop over all shapes, the same whatever the broad phase, and from several threads.
#include "geometry/cast.hpp"
#include "geometry/random_shapes.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <thread>
#include <vector>

namespace carom
{

namespace
{

/// The same world with each broad phase, edited and stepped alike.
class Worlds
{
public:
    explicit Worlds(std::uint32_t seed) : random(seed)
    {
        for (const BroadPhaseType type : all_broad_phases) worlds.emplace_back(WorldDef{.gravity = {0, -3}, .broad_phase = type});
    }

    void edit()
    {
        const int kind = random.integer(0, 9);
        const Vec2 place = random.point(30);
        const float angle = random.uniform(-pi, pi);
        const Geometry geometry = random.geometry_of(random.integer(0, 3), random.integer(0, 9) == 0 ? 8.0f : 1.0f);
        const BodyType type = random.integer(0, 2) == 0 ? BodyType::Static : BodyType::Dynamic;
        const bool is_sensor = random.integer(0, 5) == 0;
        const std::size_t victim = bodies.empty() ? 0 : static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1));
        if (bodies.size() < 60 || kind < 4)
        {
            bodies.emplace_back();
            for (std::size_t i = 0; i < worlds.size(); ++i)
                bodies.back()[i] =
                    worlds[i].create_body({.type = type, .position = place, .angle = angle}, geometry, {.is_sensor = is_sensor});
        }
        else if (kind < 7)
        {
            for (std::size_t i = 0; i < worlds.size(); ++i) worlds[i].body(bodies[victim][i]).set_transform(place, angle);
        }
        else if (kind < 8)
        {
            for (std::size_t i = 0; i < worlds.size(); ++i) worlds[i].body(bodies[victim][i]).set_enabled(angle > 0);
        }
        else if (kind < 9)
        {
            for (std::size_t i = 0; i < worlds.size(); ++i) worlds[i].destroy_body(bodies[victim][i]);
            bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(victim));
        }
        else
        {
            for (World& world : worlds) world.step(1 / 60.0f);
        }
    }

    detail::RandomShapes random;
    std::vector<World> worlds;
    std::vector<std::array<BodyId, all_broad_phases.size()>> bodies;
};

/// Calls action(shape, its geometry, its transform) for all that a query without sensors may see.
template <class Action>
void for_each_shape(const World& world, Action action)
{
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (!body.is_enabled()) continue;
        for (const ShapeId shape : body.shapes())
            if (!world.shape(shape).is_sensor()) action(shape, world.shape(shape).geometry(), body.transform());
    }
}

std::vector<CastHit> reference_rays(const World& world, Vec2 start, Vec2 sweep)
{
    std::vector<CastHit> hits;
    for_each_shape(world, [&](ShapeId id, const Geometry& geometry, const Transform& at)
    {
        const auto hit = detail::cast_ray(geometry, inverse_transform(at, start), inverse_rotate(at.q, sweep));
        if (hit)
            hits.push_back({id, world.shape(id).body(), hit->fraction, at * hit->point, rotate(at.q, hit->normal), hit->starts_inside});
    });
    std::sort(hits.begin(), hits.end(), [](const CastHit& a, const CastHit& b)
    { return a.fraction != b.fraction ? a.fraction < b.fraction : a.shape.index < b.shape.index; });
    return hits;
}

void expect_equal(const CastHit& a, const CastHit& b)
{
    EXPECT_EQ(a.shape.index, b.shape.index);
    EXPECT_EQ(a.body.index, b.body.index);
    EXPECT_EQ(a.fraction, b.fraction);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.starts_inside, b.starts_inside);
}

} // namespace

TEST(Queries, RaysAreThoseOfALoopOverAllShapesWithEachBroadPhase)
{
    Worlds all(81);
    std::size_t most = 0;
    for (int round = 0; round < 3000; ++round)
    {
        all.edit();
        const Vec2 start = all.random.point(40);
        const Vec2 sweep = all.random.integer(0, 3) == 0 ? Vec2{all.random.uniform(-80, 80), 0} : all.random.point(80);
        const std::vector<CastHit> expected = reference_rays(all.worlds[0], start, sweep);
        most = std::max(most, expected.size());
        for (const World& world : all.worlds)
        {
            const auto first = world.cast_ray(start, sweep);
            ASSERT_EQ(first.has_value(), !expected.empty()) << round << " " << name_of(world.broad_phase());
            ASSERT_EQ(world.is_ray_blocked(start, sweep), !expected.empty());
            if (first) expect_equal(*first, expected.front());
            const auto hits = world.cast_ray_all(start, sweep);
            ASSERT_EQ(hits.size(), expected.size());
            for (std::size_t i = 0; i < hits.size(); ++i) expect_equal(hits[i], expected[i]);
            if (testing::Test::HasFailure()) return;
        }
    }
    EXPECT_GT(most, 5u);
}

TEST(Queries, TheOthersAreThoseOfALoopToo)
{
    Worlds all(82);
    int overlaps_found = 0;
    for (int round = 0; round < 2000; ++round)
    {
        all.edit();
        const Geometry geometry = all.random.geometry_of(all.random.integer(0, 3), 2);
        const Transform at = all.random.transform(30);
        const Vec2 sweep = all.random.point(40);
        const float reach = all.random.uniform(0, 20);

        std::vector<std::uint32_t> overlapping;
        std::vector<std::uint32_t> holding;
        std::optional<float> fraction;
        float nearest = std::numeric_limits<float>::infinity();
        detail::ConvexPoints point;
        point.count = 1;
        for_each_shape(all.worlds[0], [&](ShapeId id, const Geometry& other, const Transform& where)
        {
            const Transform local = relative(where, at);
            if (detail::overlap(other, geometry, local)) overlapping.push_back(id.index);
            if (contains(other, inverse_transform(where, at.p))) holding.push_back(id.index);
            const auto hit =
                detail::cast_shape(detail::convex_points(other), detail::convex_points(geometry), local, inverse_rotate(where.q, sweep));
            if (hit) fraction = std::min(hit->fraction, fraction.value_or(1));
            point.points[0] = inverse_transform(where, at.p);
            nearest = std::min(nearest, detail::distance(detail::convex_points(other), point, {}).distance);
        });
        std::sort(overlapping.begin(), overlapping.end());
        std::sort(holding.begin(), holding.end());
        overlaps_found += static_cast<int>(overlapping.size());

        const auto indices = [](const std::vector<ShapeId>& ids)
        {
            std::vector<std::uint32_t> result;
            for (const ShapeId id : ids) result.push_back(id.index);
            return result;
        };
        for (const World& world : all.worlds)
        {
            ASSERT_EQ(indices(world.overlapping(geometry, at)), overlapping) << round << " " << name_of(world.broad_phase());
            ASSERT_EQ(indices(world.shapes_at(at.p)), holding);
            const auto hit = world.cast_shape(geometry, at, sweep);
            ASSERT_EQ(hit ? hit->fraction : -1, fraction.value_or(-1)) << round << " " << name_of(world.broad_phase());
            const auto closest = world.closest_point(at.p, reach);
            ASSERT_EQ(closest ? closest->distance : -1, nearest <= reach ? nearest : -1);
        }
    }
    EXPECT_GT(overlaps_found, 500);
}

// ---- threads ----

TEST(Queries, SeveralThreadsMayAskAtOnce)
{
    World world;
    detail::RandomShapes random(84);
    for (int i = 0; i < 1000; ++i) world.create_body({.position = random.point(40)}, circle(0.5f));
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i)
    {
        const Vec2 start = random.point(50);
        rays.push_back({start, random.point(50)});
    }
    std::array<std::vector<std::optional<RayHit>>, 4> hits;
    std::vector<std::thread> threads;
    for (auto& own : hits)
    {
        own.resize(rays.size());
        threads.emplace_back([&] { world.cast_rays(rays, own); });
    }
    for (std::thread& thread : threads) thread.join();
    int met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
        const auto expected = world.cast_ray(rays[i].start, rays[i].sweep);
        met += expected.has_value();
        for (const auto& own : hits)
        {
            ASSERT_EQ(own[i].has_value(), expected.has_value());
            if (expected) expect_equal(*own[i], *expected);
        }
    }
    EXPECT_GT(met, 500);
}

} // namespace carom
