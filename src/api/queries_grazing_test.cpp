// Casts that only graze a shape meet it, for every kind of shape and every query that casts.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace carom::queries_grazing_test
{

namespace
{

/// A shape whose top is at y = 1; where a ray to the right along that line meets it first.
struct Grazed
{
    const char* name;
    Geometry shape;
    float first_x;
};

std::vector<Grazed> grazed_shapes()
{
    const std::vector<Vec2> triangle = {{-1, 0}, {1, 0}, {0.5f, 1}};
    return {{"box along its face", box(2, 2), -1},
            {"rounded box along its face", rounded_box(2, 2, 0.25f), -0.75f},
            {"capsule along its side", capsule({-1, 0.5f}, {1, 0.5f}, 0.5f), -1},
            {"circle at its top", circle(1), 0},
            {"corner of a triangle", convex_hull(triangle), 0.5f},
            {"segment lengthwise", segment({-1, 1}, {1, 1}), -1},
            {"end of a segment", segment({0.5f, 0}, {0.5f, 1}), 0.5f}};
}

/// All that a world says of a ray to the right at a height.
void expect_met(const Grazed& grazed, float height, bool is_met)
{
    SCOPED_TRACE(std::string(grazed.name) + " at a height of " + std::to_string(height));
    World world;
    world.create_body({.type = BodyType::Static, .position = {10, 0}}, grazed.shape);
    const Vec2 start = {5, height};
    const Vec2 sweep = {10, 0};
    EXPECT_EQ(world.is_ray_blocked(start, sweep), is_met);
    EXPECT_EQ(world.cast_ray_all(start, sweep).size(), is_met ? 1u : 0u);
    const std::vector<Ray> rays = {{start, sweep}};
    std::vector<std::optional<RayHit>> hits(1);
    world.cast_rays(rays, hits);
    EXPECT_EQ(hits[0].has_value(), is_met);
    const std::optional<RayHit> hit = world.cast_ray(start, sweep);
    ASSERT_EQ(hit.has_value(), is_met);
    if (!hit || height != 1) return;
    EXPECT_NEAR(hit->point.x, 10 + grazed.first_x, 0.001f);
    EXPECT_NEAR(hit->point.y, 1, 1e-5f);
    EXPECT_FALSE(hit->starts_inside);
    EXPECT_EQ(world.cast_ray_all(start, sweep)[0].fraction, hit->fraction);
    EXPECT_EQ(hits[0]->fraction, hit->fraction);
}

} // namespace

TEST(GrazingCast, rays_along_a_surface_meet_it_from_either_side)
{
    for (const Grazed& grazed : grazed_shapes())
    {
        expect_met(grazed, 1, true);
        expect_met(grazed, 0.9999f, grazed.shape.index() != 2 || grazed.first_x > 0);
        expect_met(grazed, 1.0001f, false);
    }
}

TEST(GrazingCast, shapes_that_slide_along_a_surface_from_outside_meet_it)
{
    for (const Grazed& grazed : grazed_shapes())
        for (const Geometry& moving : {Geometry(circle(0.5f)), Geometry(box(1, 1)), Geometry(capsule({-0.25f, 0}, {0.25f, 0}, 0.5f))})
        {
            SCOPED_TRACE(std::string(grazed.name) + " grazed by shape " + std::to_string(moving.index()));
            World world;
            world.create_body({.type = BodyType::Static, .position = {10, 0}}, grazed.shape);
            EXPECT_TRUE(world.cast_shape(moving, {{5, 1.5f}, {}}, {10, 0}));
            EXPECT_FALSE(world.cast_shape(moving, {{5, 1.5001f}, {}}, {10, 0}));
        }
}

TEST(GrazingCast, what_starts_on_the_surface_and_goes_along_it_is_free)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {10, 0}}, box(2, 2));
    EXPECT_FALSE(world.is_ray_blocked({9.5f, 1}, {10, 0}));
    EXPECT_FALSE(world.cast_shape(Geometry(box(1, 1)), {{9.5f, 1.5f}, {}}, {10, 0}));
}

} // namespace carom::queries_grazing_test
