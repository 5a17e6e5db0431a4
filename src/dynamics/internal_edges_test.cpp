#include "dynamics/internal_edges.hpp"

#include "dynamics/dynamics_test.hpp"

#include <gtest/gtest.h>

namespace carom::detail::internal_edges_test
{
namespace
{

/// Fixed tiles, and a slider that has a contact with each.
class InternalEdgesTest : public testing::Test
{
protected:
    std::uint32_t tile(const Geometry& geometry, Vec2 position = {})
    {
        return scene.add({.type = BodyType::Static, .position = position}, geometry);
    }
    void slide(const Geometry& geometry, Vec2 position, float angle = 0)
    {
        const auto tiles = static_cast<std::uint32_t>(scene.shapes.records.size());
        const std::uint32_t slider = scene.add({.position = position, .angle = angle}, geometry);
        for (std::uint32_t i = 0; i < tiles; ++i) scene.touch(i, slider);
    }
    /// The contact of the slider with one tile: alone, and with the whole surface.
    LocalManifold alone(std::uint32_t slot) const
    {
        const Contact& c = scene.contacts.contacts[slot];
        return collide(scene.shapes.geometry[c.shape_a], scene.shapes.geometry[c.shape_b],
                       relative(scene.bodies.poses[c.body_a].transform, scene.bodies.poses[c.body_b].transform));
    }
    LocalManifold judged(std::uint32_t slot) const
    {
        return without_internal_edges(alone(slot), scene.contacts.contacts[slot], scene.bodies, scene.shapes, scene.contacts);
    }

    SmallScene scene;
};

TEST_F(InternalEdgesTest, a_contact_with_one_tile_alone_is_left_as_it_is)
{
    tile(box(1, 1), {0, -0.5f});
    slide(circle(0.2f), {0.55f, 0.15f}); // at the corner
    ASSERT_EQ(alone(0).count, 1);
    EXPECT_EQ(judged(0).count, 1);
    EXPECT_EQ(judged(0).normal, alone(0).normal);
}

TEST_F(InternalEdgesTest, the_side_of_a_tile_that_its_neighbor_hides_pushes_up_and_not_back)
{
    tile(box(1, 1), {0, -0.5f});
    tile(box(1, 1), {1, -0.5f});
    slide(box(0.1f, 0.1f), {0.455f, 0.04f}); // 1 cm deep, and 5 mm over the seam: seen alone, the second tile pushes to the left
    ASSERT_GT(alone(1).count, 0);
    EXPECT_LT(alone(1).normal.x, -0.9f);
    const LocalManifold second = judged(1);
    EXPECT_TRUE(second.count == 0 || second.normal.y > 0.999f);
    ASSERT_GT(judged(0).count, 0);
    EXPECT_GT(judged(0).normal.y, 0.999f);
}

TEST_F(InternalEdgesTest, a_ball_over_a_seam_is_pushed_straight_up)
{
    tile(box(1, 1), {0, -0.5f});
    tile(box(1, 1), {1, -0.5f});
    slide(circle(0.2f), {0.49f, 0.199f});
    ASSERT_EQ(alone(1).count, 1);
    EXPECT_LT(alone(1).normal.x, -0.01f) << "the corner leans against the ball";
    EXPECT_EQ(judged(1).count, 0) << "it is over the first tile";
    EXPECT_GT(judged(0).normal.y, 0.9999f);
}

TEST_F(InternalEdgesTest, a_step_is_a_step)
{
    tile(box(1, 1), {0, -0.5f});
    tile(box(1, 1), {1, -0.492f}); // 8 mm higher
    slide(box(0.2f, 0.2f), {0.401f, 0.1f});
    ASSERT_GT(judged(1).count, 0);
    EXPECT_LT(judged(1).normal.x, -0.999f);
}

TEST_F(InternalEdgesTest, tiles_that_move_apart_are_no_surface)
{
    tile(box(1, 1), {0, -0.5f});
    const std::uint32_t moving = scene.add({.type = BodyType::Kinematic, .position = {1, -0.5f}, .linear_velocity = {0, 0.5f}}, box(1, 1));
    slide(circle(0.2f), {0.49f, 0.199f});
    ASSERT_EQ(moving, 1u);
    EXPECT_EQ(judged(1).count, 1) << "its corner may come up";
}

TEST_F(InternalEdgesTest, the_end_of_a_wall_does_not_push_what_its_ledge_supports)
{
    tile(segment({4, 0}, {4, 2}));
    tile(segment({4, 2}, {0, 2}));
    slide(box(0.5f, 0.5f), {3.77f, 2.2499f}, 0.001f); // tilted, so that the wall's end leans against it
    ASSERT_GT(alone(0).count, 0);
    for (const LocalPoint& point : judged(0).points) EXPECT_GT(point.separation, -0.01f) << "not out by its whole overhang";
    ASSERT_GT(judged(1).count, 0);
    EXPECT_GT(std::abs(judged(1).normal.y), 0.99f);
}

} // namespace
} // namespace carom::detail::internal_edges_test
