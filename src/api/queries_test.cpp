// Queries of a world: against closed forms, and what they refuse.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace carom
{

namespace
{

template <class Call>
void expect_refused(const char* function, const char* field, Call&& call)
{
    try
    {
        call();
        ADD_FAILURE() << function << " accepted a bad " << field;
    }
    catch (const UsageError& error)
    {
        EXPECT_EQ(error.function(), function) << error.what();
        EXPECT_EQ(error.field(), field) << error.what();
    }
}

class QueriesTest : public testing::Test
{
protected:
    BodyId add(Vec2 position, const Geometry& geometry, const ShapeDef& def = {})
    {
        return world.create_body({.type = BodyType::Static, .position = position}, geometry, def);
    }
    ShapeId shape_of(BodyId body) const { return world.body(body).shapes().front(); }

    World world{{.gravity = {}}};
};

} // namespace

// ---- rays ----

TEST_F(QueriesTest, ARayMeetsTheNearestShape)
{
    const BodyId near = add({5, 0}, box(2, 2));
    add({10, 0}, box(2, 2));
    const auto hit = world.cast_ray({0, 0.5f}, {20, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, near);
    EXPECT_EQ(hit->shape, shape_of(near));
    EXPECT_FLOAT_EQ(hit->fraction, 0.2f);
    EXPECT_EQ(hit->point, (Vec2{4, 0.5f}));
    EXPECT_EQ(hit->normal, (Vec2{-1, 0}));
    EXPECT_FALSE(hit->starts_inside);
    EXPECT_FALSE(world.cast_ray({0, 0.5f}, {3.99f, 0}));
    EXPECT_FALSE(world.cast_ray({0, 5}, {20, 0}));
    EXPECT_TRUE(world.is_ray_blocked({0, 0.5f}, {20, 0}));
    EXPECT_FALSE(world.is_ray_blocked({0, 5}, {20, 0}));
}

TEST_F(QueriesTest, ARayMeetsTurnedBodies)
{
    world.create_body({.type = BodyType::Static, .position = {5, 0}, .angle = pi / 4}, box(2, 2));
    const auto hit = world.cast_ray({0, 0.5f}, {20, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.x, 5 - std::sqrt(2.0f) + 0.5f, 1e-5f);
    EXPECT_NEAR(hit->normal.x, -std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(hit->normal.y, std::sqrt(0.5f), 1e-6f);
}

TEST_F(QueriesTest, AllHitsComeInTheirOrder)
{
    const BodyId far = add({10, 0}, box(2, 2));
    const BodyId near = add({5, 0}, circle(1));
    const BodyId twin = add({10, 0}, box(2, 2));
    const auto hits = world.cast_ray_all({0, 0}, {20, 0});
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[0].body, near);
    EXPECT_EQ(hits[1].body, far) << "of two at the same fraction, that of the lower index";
    EXPECT_EQ(hits[2].body, twin);
    EXPECT_TRUE(world.cast_ray_all({0, 3}, {20, 0}).empty());
}

TEST_F(QueriesTest, ARayThatStartsInsideSaysSo)
{
    const BodyId around = add({0, 0}, box(4, 4));
    add({1, 0}, circle(0.2f));
    const auto hit = world.cast_ray({-1, 0}, {5, 0});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(hit->starts_inside);
    EXPECT_EQ(hit->body, around);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_EQ(hit->normal, Vec2{});
    EXPECT_EQ(hit->point, (Vec2{-1, 0}));
    const auto all = world.cast_ray_all({-1, 0}, {5, 0});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_FALSE(all[1].starts_inside);
    const auto beyond = world.cast_ray({-1, 0}, {5, 0}, {.ignored_body = around});
    ASSERT_TRUE(beyond);
    EXPECT_FLOAT_EQ(beyond->point.x, 0.8f);
}

TEST_F(QueriesTest, ARayCanStartWhereAnotherEnded)
{
    add({0, -1}, box(100, 2));
    Vec2 at = {0, 5};
    Vec2 sweep = {6, -8};
    for (int i = 0; i < 50; ++i)
    {
        const auto hit = world.cast_ray(at, sweep);
        ASSERT_EQ(hit.has_value(), i % 2 == 0) << i;
        if (!hit)
        {
            at = {0, 5 + 0.05f * static_cast<float>(i)};
            sweep = {6, -8};
            continue;
        }
        at = hit->point;
        sweep = {6, 8};
    }
}

TEST_F(QueriesTest, AFilterDecidesWhatIsSeen)
{
    const BodyId body = add({5, 0}, box(2, 2), {.filter = {.category = 2, .mask = 5, .group = 0}});
    EXPECT_TRUE(world.cast_ray({0, 0}, {9, 0}));
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}, {.filter = {.category = 2}})) << "not in its mask";
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}, {.filter = {.mask = 1}})) << "not in ours";
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}, {.ignored_body = body}));

    struct Only final : QueryPredicate
    {
        ShapeId shape;
        bool accepts(ShapeId asked, BodyId) const override { return asked == shape; }
    } only;
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}, {.predicate = &only}));
    only.shape = shape_of(body);
    EXPECT_TRUE(world.cast_ray({0, 0}, {9, 0}, {.predicate = &only}));
    EXPECT_EQ(world.overlapping(Aabb{{4, 0}, {6, 0}}, {.predicate = &only}).size(), 1u);
}

TEST_F(QueriesTest, SensorsAreSeenOnRequestAndDisabledBodiesNever)
{
    const BodyId sensor = add({5, 0}, box(2, 2), {.is_sensor = true});
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}));
    EXPECT_TRUE(world.cast_ray({0, 0}, {9, 0}, {.sensors = true}));
    EXPECT_TRUE(world.shapes_at({5, 0}).empty());
    EXPECT_EQ(world.shapes_at({5, 0}, {.sensors = true}).size(), 1u);
    world.body(sensor).set_enabled(false);
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}, {.sensors = true}));
    EXPECT_FALSE(world.closest_point({0, 0}, 100, {.sensors = true}));
}

TEST_F(QueriesTest, EditsAreSeenAtOnce)
{
    const BodyId body = add({5, 0}, circle(1));
    EXPECT_TRUE(world.cast_ray({0, 0}, {9, 0}));
    world.body(body).set_transform({5, 50}, 0);
    EXPECT_FALSE(world.cast_ray({0, 0}, {9, 0}));
    EXPECT_TRUE(world.cast_ray({0, 50}, {9, 0}));
    world.shape(shape_of(body)).set_geometry(circle(60));
    EXPECT_TRUE(world.cast_ray({0, -9}, {9, 0}));
    world.destroy_body(body);
    EXPECT_FALSE(world.cast_ray({0, 50}, {9, 0}));
}

TEST_F(QueriesTest, ManyRaysAtOnce)
{
    add({5, 0}, box(2, 2));
    const std::array<Ray, 3> rays = {Ray{{0, 0}, {9, 0}}, Ray{{0, 5}, {9, 0}}, Ray{{9, 0}, {-9, 0}}};
    std::array<std::optional<RayHit>, 3> hits;
    hits[1] = RayHit{};
    world.cast_rays(rays, hits);
    EXPECT_EQ(hits[0]->normal, (Vec2{-1, 0}));
    EXPECT_FALSE(hits[1]);
    EXPECT_EQ(hits[2]->normal, (Vec2{1, 0}));
}

// ---- shapes ----

TEST_F(QueriesTest, AShapeIsStoppedByWhatItMeets)
{
    const BodyId wall = add({5, 0}, box(2, 2));
    const auto hit = world.cast_shape(box(1, 1), {{0, 1.2f}, {}}, {10, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, wall);
    EXPECT_FLOAT_EQ(hit->fraction, 0.35f);
    EXPECT_EQ(hit->normal, (Vec2{-1, 0}));
    EXPECT_FLOAT_EQ(hit->point.x, 4);
    EXPECT_FALSE(world.cast_shape(box(1, 1), {{0, 1.6f}, {}}, {10, 0}));
    EXPECT_TRUE(world.cast_shape(box(1, 1), {{0, 1.6f}, rotation(pi / 4)}, {10, 0})) << "turned, it reaches farther down";
    const auto ball = world.cast_circle({0, 0}, 0.5f, {10, 0});
    ASSERT_TRUE(ball);
    EXPECT_FLOAT_EQ(ball->fraction, 0.35f);
    add({7, 0}, circle(1));
    EXPECT_EQ(world.cast_shape_all(box(1, 1), {{0, 0}, {}}, {10, 0}).size(), 2u);
    EXPECT_TRUE(world.cast_circle({5, 0}, 0.1f, {0, 1})->starts_inside);
}

TEST_F(QueriesTest, Overlaps)
{
    const BodyId a = add({0, 0}, circle(1));
    const BodyId b = add({3, 0}, circle(1));
    EXPECT_EQ(world.overlapping(Aabb{{0.9f, 0.9f}, {2.1f, 2}}).size(), 2u) << "by bounds";
    EXPECT_EQ(world.overlapping(Aabb{{1.1f, 0}, {1.9f, 0}}).size(), 0u) << "not by the fat ones";
    EXPECT_TRUE(world.overlapping(box(0.1f, 0.1f), {{0.85f, 0.85f}, {}}).empty()) << "by outline";
    EXPECT_EQ(world.overlapping(capsule({0.5f, 0}, {2.5f, 0}, 0.1f), {}), (std::vector{shape_of(a), shape_of(b)}));
    EXPECT_EQ(world.shapes_at({3.5f, 0.5f}), std::vector{shape_of(b)});
    EXPECT_TRUE(world.shapes_at({3.9f, 0.9f}).empty());
}

TEST_F(QueriesTest, VisitorsEndWhenTheyWant)
{
    for (int i = 0; i < 1000; ++i) add({0, 0}, circle(1));
    int visits = 0;
    world.visit_shapes_at({0, 0}, [&visits](ShapeId id)
    {
        EXPECT_EQ(id.index, static_cast<std::uint32_t>(visits)) << "in order, though more than one batch";
        return ++visits < 700;
    });
    EXPECT_EQ(visits, 700);
    visits = 0;
    world.visit_overlapping(Aabb{{-1, -1}, {1, 1}}, [&visits](ShapeId) { ++visits; });
    world.visit_overlapping(circle(1), {}, [&visits](ShapeId) { ++visits; });
    EXPECT_EQ(visits, 2000);
    EXPECT_EQ(world.shapes_at({0, 0}).size(), 1000u);
}

TEST_F(QueriesTest, shapes_far_apart_in_the_order_of_indices_are_all_found)
{
    for (int i = 0; i < 70'000; ++i) add({i % 1000 == 7 ? 0.0f : 100.0f + static_cast<float>(i), 0}, circle(0.4f));
    std::vector<std::uint32_t> seen;
    world.visit_overlapping(circle(1), {}, [&seen](ShapeId id) { seen.push_back(id.index); });
    ASSERT_EQ(seen.size(), 70u);
    for (std::uint32_t i = 0; i < 70; ++i) EXPECT_EQ(seen[i], 1000 * i + 7);
    int visits = 0;
    world.visit_overlapping(circle(1), {}, [&visits](ShapeId) { return ++visits < 60; });
    EXPECT_EQ(visits, 60) << "a visitor ends the query in any window";
}

TEST_F(QueriesTest, ClosestPoint)
{
    const BodyId a = add({5, 0}, box(2, 2));
    add({0, 30}, circle(1));
    const auto near = world.closest_point({0, 0}, 10);
    ASSERT_TRUE(near);
    EXPECT_EQ(near->body, a);
    EXPECT_FLOAT_EQ(near->distance, 4);
    EXPECT_EQ(near->point, (Vec2{4, 0}));
    EXPECT_EQ(near->normal, (Vec2{-1, 0}));
    EXPECT_FALSE(world.closest_point({0, 0}, 3.9f));
    EXPECT_TRUE(world.closest_point({0, 0}, 4));
    EXPECT_FLOAT_EQ(world.closest_point({0, 0}, 100, {.ignored_body = a})->distance, 29);
    const auto inside = world.closest_point({5, 0.5f}, 0);
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->distance, 0);
    EXPECT_EQ(inside->point, (Vec2{5, 0.5f}));
    EXPECT_EQ(inside->normal, Vec2{});
}

TEST_F(QueriesTest, DistanceAndTimeOfImpactOfTwoShapes)
{
    const ShapeDistance apart = distance(box(2, 2), {{10, 0}, {}}, circle(1), {{15, 0.5f}, {}});
    EXPECT_FLOAT_EQ(apart.distance, 3);
    EXPECT_EQ(apart.normal, (Vec2{1, 0}));
    EXPECT_FLOAT_EQ(apart.point_a.x, 11);
    EXPECT_FLOAT_EQ(apart.point_b.x, 14);
    EXPECT_EQ(distance(box(2, 2), {}, circle(1), {}).distance, 0);

    const auto time = time_of_impact(box(2, 2), {.start = {{10, 0}, {}}}, circle(1), {.start = {{20, 0}, {}}, .sweep = {-20, 0}}, 0.01f);
    ASSERT_TRUE(time);
    EXPECT_NEAR(*time, 7.99f / 20, 1e-4f);
    EXPECT_FALSE(time_of_impact(box(2, 2), {}, circle(1), {.start = {{20, 0}, {}}, .sweep = {-5, 0}}));
    // A plank that turns about its end reaches what it would never reach about its middle.
    const Geometry plank = offset_box(4, 0.1f, {2, 0});
    EXPECT_TRUE(time_of_impact(plank, {.turn = 3}, circle(0.2f), {.start = {{0, 3}, {}}}));
    EXPECT_FALSE(time_of_impact(plank, {.turn = 3, .center = {2, 0}}, circle(0.2f), {.start = {{0, 3}, {}}}));
}

// ---- mistakes ----

TEST_F(QueriesTest, BadArgumentsAreNamed)
{
    expect_refused("cast_ray", "start.x", [&] { world.cast_ray({nan, 0}, {1, 0}); });
    expect_refused("cast_ray", "sweep.y", [&] { world.cast_ray({0, 0}, {1, inf}); });
    expect_refused("is_ray_blocked", "start.x", [&] { world.is_ray_blocked({2e6f, 0}, {1, 0}); });
    expect_refused("cast_ray_all", "sweep.x", [&] { world.cast_ray_all({0, 0}, {3e6f, 0}); });
    std::array<std::optional<RayHit>, 1> one;
    expect_refused("cast_rays", "hits.size()", [&] { world.cast_rays({}, one); });
    expect_refused("cast_rays", "start.x", [&] { world.cast_rays(std::array{Ray{{nan, 0}, {}}}, one); });
    expect_refused("cast_shape", "circle.radius", [&] { world.cast_shape(Circle{{}, -1}, {}, {1, 0}); });
    expect_refused("cast_shape", "start.q", [&] { world.cast_shape(circle(1), {{}, {2, 0}}, {1, 0}); });
    expect_refused("cast_circle", "radius", [&] { world.cast_circle({0, 0}, 0, {1, 0}); });
    expect_refused("overlapping", "box.max", [&] { world.overlapping(Aabb{{1, 0}, {0, 1}}); });
    expect_refused("overlapping", "box.min.x", [&] { world.overlapping(Aabb{{nan, 0}, {0, 1}}); });
    expect_refused("overlapping", "transform.p.x", [&] { world.overlapping(circle(1), {{nan, 0}, {}}); });
    expect_refused("shapes_at", "point.y", [&] { world.shapes_at({0, inf}); });
    expect_refused("closest_point", "max_distance", [&] { world.closest_point({0, 0}, -1); });
    expect_refused("explode", "radius", [&] { world.explode({.radius = -1}); });
    expect_refused("explode", "impulse_per_metre", [&] { world.explode({.impulse_per_metre = nan}); });
    expect_refused("distance", "transform_b.p.x", [&] { distance(circle(1), {}, circle(1), {{nan, 0}, {}}); });
    expect_refused("time_of_impact", "motion_b.turn", [&] { time_of_impact(circle(1), {}, circle(1), {.turn = 1e9f}); });
    expect_refused("time_of_impact", "target_distance", [&] { time_of_impact(circle(1), {}, circle(1), {}, 0); });
}

} // namespace carom
