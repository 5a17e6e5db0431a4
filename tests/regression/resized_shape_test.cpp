// A shape that has changed is seen as it is now, by everything that remembers shapes from step to step.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

/// A face before a corner: bounds that overlap, and shapes that do not.
TEST(Regression, shapes_that_were_apart_touch_when_one_grows)
{
    World world({.gravity = {}});
    const BodyId block = world.create_body({.type = BodyType::Static}, box(1, 1));
    const float way = 0.5f + 0.55f * std::sqrt(0.5f); // 5 cm between the corner and the face
    const BodyId crate = world.create_body({.position = {way, way}, .angle = 0.25f * pi}, box(1, 1));
    world.step(1 / 60.0f);
    world.step(1 / 60.0f);
    const ShapeId fixed = world.body(block).shapes()[0];
    const ShapeId free = world.body(crate).shapes()[0];
    EXPECT_EQ(world.manifold(fixed, free).point_count, 0) << "farther apart than contacts are made";
    world.shape(free).set_geometry(box(1.11f, 1.11f));
    world.step(1 / 60.0f);
    EXPECT_EQ(world.manifold(fixed, free).point_count, 1);
}

TEST(Regression, a_shape_with_other_faces_rests_on_one_of_them)
{
    for (const float angle : {0.0f, 0.5f * pi, pi, 1.5f * pi})
    {
        World world({.gravity = {}});
        const BodyId floor = world.create_body({.type = BodyType::Static, .position = {0, -0.5f}}, box(10, 1));
        const BodyId crate = world.create_body({.position = {0, 0.5f}, .angle = angle}, box(1, 1));
        world.step(1 / 60.0f);
        world.step(1 / 60.0f);
        const ShapeId below = world.body(floor).shapes()[0];
        const ShapeId above = world.body(crate).shapes()[0];
        ASSERT_EQ(world.manifold(below, above).point_count, 2);
        std::array<Vec2, 6> corners; // of a hexagon as high as the box
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = inverse_rotate(rotation(angle), rotate(rotation(static_cast<float>(i) * pi / 3), {0.5f / std::sqrt(3.0f), -0.5f}));
        world.shape(above).set_geometry(convex_hull(corners));
        world.step(1 / 60.0f);
        const Manifold manifold = world.manifold(below, above);
        ASSERT_EQ(manifold.point_count, 2) << angle;
        EXPECT_NEAR(distance(manifold.points[0].position, manifold.points[1].position), 1 / std::sqrt(3.0f), 0.01f) << angle;
    }
}

/// A second shape covers the first one's face: what touched that face no longer does.
TEST(Regression, a_face_that_a_new_shape_covers_is_none)
{
    World world({.gravity = {}});
    const BodyId plank = world.create_body({.position = {0, -0.5f}}, box(10, 1), {.density = 1000});
    const BodyId ball = world.create_body({.position = {0, 0.5f}}, circle(0.5f));
    world.step(1 / 60.0f);
    world.step(1 / 60.0f);
    const ShapeId first = world.body(plank).shapes()[0];
    const ShapeId round = world.body(ball).shapes()[0];
    ASSERT_EQ(world.manifold(first, round).point_count, 1);
    const ShapeId cover = world.create_shape(plank, offset_box(10, 1, {0, 0.05f}));
    world.step(1 / 60.0f);
    EXPECT_EQ(world.manifold(first, round).point_count, 0);
    EXPECT_EQ(world.manifold(cover, round).point_count, 1);
}

} // namespace carom
