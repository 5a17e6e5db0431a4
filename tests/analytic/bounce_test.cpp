// How high things bounce, against e^2 of the height from which they fell, whatever their size and the step.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace carom
{

namespace
{

struct Drop
{
    Geometry geometry;
    float size;        ///< [m]
    float restitution; ///< of both surfaces
    int rate;          ///< steps a second
    int substeps = 4;
};

/// The heights of all tops of 20 s after a fall from 5 m, the first one among them [m].
std::vector<float> tops_of(const Drop& drop)
{
    World world;
    const ShapeDef surface = {.material = {.restitution = drop.restitution}};
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(40, 2), surface);
    const float rest = 0.5f * drop.size;
    const BodyId id = world.create_body({.position = {0, rest + 5}}, drop.geometry, surface);
    std::vector<float> tops = {5};
    float top = 0;
    for (int i = 0; i < 20 * drop.rate; ++i)
    {
        const bool was_rising = world.body(id).linear_velocity().y > 0;
        world.step(1 / static_cast<float>(drop.rate), drop.substeps);
        top = std::max(top, world.body(id).position().y - rest);
        if (world.body(id).linear_velocity().y > 0 || !was_rising)
        {
            if (!was_rising) top = 0;
            continue;
        }
        tops.push_back(top);
    }
    return tops;
}

std::vector<Drop> drops(float restitution, int substeps)
{
    std::vector<Drop> all;
    for (const float size : {0.05f, 0.1f, 0.5f, 2.0f})
        for (const int rate : {30, 60, 120, 240})
        {
            all.push_back({circle(0.5f * size), size, restitution, rate, substeps});
            all.push_back({box(size, size), size, restitution, rate, substeps});
        }
    return all;
}

std::string name_of_drop(const Drop& drop)
{
    return (std::holds_alternative<Circle>(drop.geometry) ? "circle of " : "box of ") + std::to_string(drop.size) + " m at " +
           std::to_string(drop.rate) + " Hz, substeps " + std::to_string(drop.substeps);
}

} // namespace

TEST(Bounce, a_perfect_one_keeps_its_height_for_20_seconds_whatever_size_and_rate)
{
    for (const int substeps : {1, 4})
        for (const Drop& drop : drops(1, substeps))
        {
            const std::vector<float> tops = tops_of(drop);
            EXPECT_GE(tops.size(), 9u) << name_of_drop(drop);
            EXPECT_LE(tops.size(), 11u) << name_of_drop(drop);
            for (const float top : tops)
            {
                EXPECT_GT(top, 0.99f * 5) << name_of_drop(drop);
                EXPECT_LT(top, 1.0003f * 5) << "never more than it had: " << name_of_drop(drop);
            }
        }
}

TEST(Bounce, each_reaches_e_squared_of_the_height_before_whatever_size_and_rate)
{
    for (const float e : {0.5f, 0.8f})
        for (const Drop& drop : drops(e, 4))
        {
            const std::vector<float> tops = tops_of(drop);
            ASSERT_GE(tops.size(), 3u) << name_of_drop(drop);
            float expected = 5;
            for (std::size_t i = 0; i < tops.size() && expected > 0.2f; ++i, expected *= e * e)
                EXPECT_NEAR(tops[i], expected, 0.01f * expected) << "bounce " << i << " of " << e << ", " << name_of_drop(drop);
        }
}

/// Gravity is not all that accelerates.
TEST(Bounce, a_force_and_a_field_count_like_gravity)
{
    for (const bool by_force : {false, true})
    {
        World world({.gravity = {}});
        const ShapeDef surface = {.material = {.restitution = 1}};
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(40, 2), surface);
        const BodyId id = world.create_body({.position = {0, 5.5f}}, circle(0.5f), surface);
        const float weight = 9.81f * world.body(id).mass_data().mass;
        if (!by_force) world.add_field(UniformField{{0, -9.81f}});
        float late_top = 0;
        for (int i = 0; i < 1200; ++i)
        {
            if (by_force) world.body(id).apply_force_to_center({0, -weight});
            world.step(1 / 60.0f);
            if (i > 1050) late_top = std::max(late_top, world.body(id).position().y - 0.5f);
        }
        EXPECT_NEAR(late_top, 5, 0.02f) << by_force;
    }
}

/// Between a floor and a ceiling: what a bounce below adds would show above.
TEST(Bounce, a_ball_between_floor_and_ceiling_keeps_its_energy)
{
    World world;
    const ShapeDef surface = {.material = {.friction = 0, .restitution = 1}};
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(40, 2), surface);
    world.create_body({.type = BodyType::Static, .position = {0, 4}}, box(40, 2), surface);
    const BodyId id = world.create_body({.position = {0, 1}, .linear_velocity = {0, 9}}, circle(0.1f), surface);
    const auto energy = [&]
    {
        const Body body = world.body(id);
        return 0.5f * length_squared(body.linear_velocity()) + 9.81f * body.position().y;
    };
    const float before = energy();
    for (int i = 0; i < 1200; ++i)
    {
        world.step(1 / 60.0f);
        // Within a step of its bounce, a body that was set back has the velocity of the place that it would have come to.
        if (i % 60 == 0)
        {
            EXPECT_NEAR(energy(), before, 0.05f * before) << i;
        }
    }
    EXPECT_NEAR(energy(), before, 0.03f * before);
}

/// Dropped while turning: friction and corners trade height for spin, and never make energy.
TEST(Bounce, boxes_that_tumble_never_gain_energy)
{
    for (float angle = 0.1f; angle < 1.5f; angle += 0.2f)
        for (const float size : {0.1f, 1.0f})
        {
            World world;
            const ShapeDef surface = {.material = {.friction = 0.5f, .restitution = 1}};
            world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(400, 2), surface);
            const BodyId id = world.create_body({.position = {0, 5}, .angle = angle}, box(size, size), surface);
            const float mass = world.body(id).mass_data().mass;
            float most = 0;
            for (int i = 0; i < 1200; ++i)
            {
                world.step(1 / 60.0f);
                most = std::max(most, world.body(id).position().y);
            }
            EXPECT_LT(most, 5.05f) << size << " m, turned by " << angle << ", mass " << mass;
        }
}

} // namespace carom
