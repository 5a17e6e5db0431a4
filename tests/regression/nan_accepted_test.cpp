// Calls that only read took NaN and answered as if nothing were wrong: with NaN, with false, or with half a box.
#include "math/expect_refused_test.hpp"
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace carom
{

TEST(NanAccepted, by_views)
{
    World world;
    const BodyView body = world.body(world.create_body({.angular_velocity = 1}, circle(1)));
    const ShapeView shape = world.shape(body.shapes()[0]);
    expect_refused("velocity_at", "world_point.x", [&] { body.velocity_at({nan, 0}); });
    expect_refused("velocity_at", "world_point.y", [&] { body.velocity_at({0, inf}); });
    expect_refused("contains", "world_point.y", [&] { shape.contains({0, nan}); });
    EXPECT_EQ(body.velocity_at({2e6f, 0}), (Vec2{0, 2e6f})) << "a body may lie beyond max_coordinate, and be asked about there";
    EXPECT_FALSE(shape.contains({2e6f, 0}));
}

TEST(NanAccepted, by_what_is_asked_of_a_shape_alone)
{
    expect_refused("aabb_of", "transform.p.x", [] { aabb_of(circle(1), {{nan, 0}, {}}); });
    expect_refused("aabb_of", "transform.q", [] { aabb_of(box(1, 1), {{}, {nan, 0}}); });
    expect_refused("contains", "local_point.x", [] { contains(circle(1), {nan, 0}); });
    expect_refused("contains", "local_point.y", [] { contains(segment({0, 0}, {1, 0}), {0, inf}); });
    EXPECT_EQ(aabb_of(circle(1), {{2e6f, 0}, {}}).max.x, 2e6f + 1);
}

TEST(NanAccepted, in_shapes_filled_in_by_hand)
{
    Polygon polygon = box(1, 1);
    polygon.vertices[1].x = nan;
    expect_refused("aabb_of", "polygon.vertices[1].x", [&] { aabb_of(polygon, {}); });
    expect_refused("contains", "polygon.vertices[1].x", [&] { contains(polygon, {}); });
    expect_refused("aabb_of", "capsule.p1.x", [] { aabb_of(Capsule{{nan, 0}, {1, 0}, 1}, {}); });
    expect_refused("contains", "circle.radius", [] { contains(Circle{{}, nan}, {}); });
}

} // namespace carom
