// Orbits and the sum of many pulls.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom
{

namespace
{

/// Uniform numbers in [0, 1), the same everywhere.
class Random
{
public:
    double next()
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<double>(state_ >> 11) / 9007199254740992.0;
    }

private:
    std::uint64_t state_ = 42;
};

/// A body on a circular orbit around a sun: its distance from the start after whole turns, and the extremes of its radius.
struct Orbit
{
    double miss = 0;
    double min_radius = 1e30;
    double max_radius = 0;
};

Orbit orbit(double radius, double strength, int turns, bool around_a_body)
{
    World world({.gravity = {0, 0}});
    if (around_a_body)
    {
        // A heavy sun that is pulled by nothing but the planet's tiny mass.
        const BodyId sun = world.create_body({.is_attractor = true}, circle(1));
        world.body(sun).set_mass_data({.mass = 1e6f, .inertia = 1e6f});
        world.add_field(NBodyField{.gravitational_constant = static_cast<float>(strength / 1e6), .sources = NBodySources::Attractors});
    }
    else
        world.add_field(PointField{.strength = static_cast<float>(strength)});

    const double speed = std::sqrt(strength / radius);
    const Vec2 start = {static_cast<float>(radius), 0};
    const BodyId planet = world.create_body({.position = start, .linear_velocity = {0, static_cast<float>(speed)}}, circle(0.1f));
    const double period = 2 * double{pi} * radius / speed;
    // A step of about 1/60 s that divides the time evenly, or the last one would end beside the start.
    const int steps = static_cast<int>(std::lround(turns * period * 60));
    const float whole_dt = static_cast<float>(turns * period / steps);
    Orbit result;
    for (int i = 0; i < steps; ++i)
    {
        world.step(whole_dt);
        const double r = length(world.body(planet).position());
        result.min_radius = std::min(result.min_radius, r);
        result.max_radius = std::max(result.max_radius, r);
    }
    result.miss = distance(world.body(planet).position(), start);
    return result;
}

} // namespace

TEST(Gravity, a_circular_orbit_closes_after_10_turns)
{
    for (const bool around_a_body : {false, true})
    {
        const double radius = 20;
        const Orbit result = orbit(radius, 8000, 10, around_a_body); // a period of 6.28 s
        EXPECT_LT(result.miss, 0.01 * radius) << around_a_body;
        EXPECT_NEAR(result.min_radius, radius, 0.01 * radius);
        EXPECT_NEAR(result.max_radius, radius, 0.01 * radius);
    }
}

/// At four times the radius half the speed keeps a circle; any other speed would not.
TEST(Gravity, orbital_speed_falls_as_one_over_the_root_of_the_radius)
{
    for (const double radius : {10.0, 20.0, 40.0, 80.0})
    {
        const Orbit result = orbit(radius, 8000, 1, false);
        EXPECT_NEAR(result.min_radius, radius, 0.01 * radius);
        EXPECT_NEAR(result.max_radius, radius, 0.01 * radius);
        EXPECT_LT(result.miss, 0.01 * radius);
    }
}

TEST(Gravity, two_free_bodies_circle_their_common_centre)
{
    World world({.gravity = {0, 0}});
    world.add_field(NBodyField{.gravitational_constant = 1, .method = NBodyMethod::Direct});
    // m1 = 300 at 5 m from the centre, m2 = 100 at 15 m: w^2 = G (m1 + m2) / d^3.
    const float w = std::sqrt(400.0f / (20 * 20 * 20));
    const BodyId a = world.create_body({.position = {-5, 0}, .linear_velocity = {0, -5 * w}}, circle(0.5f));
    const BodyId b = world.create_body({.position = {15, 0}, .linear_velocity = {0, 15 * w}}, circle(0.5f));
    world.body(a).set_mass_data({.mass = 300, .inertia = 1});
    world.body(b).set_mass_data({.mass = 100, .inertia = 1});
    for (int i = 0; i < 60 * 60; ++i)
    {
        world.step(dt);
        EXPECT_NEAR(distance(world.body(a).position(), world.body(b).position()), 20, 0.2);
    }
    const Vec2 momentum = 300.0f * world.body(a).linear_velocity() + 100.0f * world.body(b).linear_velocity();
    EXPECT_NEAR(length(momentum), 0, 0.05);
}

TEST(Gravity, barnes_hut_is_within_1_percent_of_the_direct_sum)
{
    // The same 10,000 bodies in two worlds; after one step at rest their velocities show the pull.
    const auto velocities = [](NBodyMethod method)
    {
        World world({.gravity = {0, 0}});
        world.add_field(NBodyField{.gravitational_constant = 1, .softening = 0.5f, .method = method, .opening_angle = 0.5f});
        Random random;
        std::vector<BodyId> ids;
        for (int i = 0; i < 10000; ++i)
        {
            const Vec2 position = {static_cast<float>(1000 * random.next() - 500), static_cast<float>(1000 * random.next() - 500)};
            ids.push_back(world.create_body({.position = position}, circle(0.5f),
                                            {.density = static_cast<float>(0.5 + random.next()), .filter = {.mask = 0}}));
        }
        world.step(dt, 1);
        std::vector<Vec2> result;
        for (const BodyId id : ids) result.push_back(world.body(id).linear_velocity());
        return result;
    };
    const std::vector<Vec2> exact = velocities(NBodyMethod::Direct);
    const std::vector<Vec2> fast = velocities(NBodyMethod::BarnesHut);
    double error = 0;
    double size = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        error += length_squared(fast[i] - exact[i]);
        size += length_squared(exact[i]);
    }
    EXPECT_GT(size, 0);
    EXPECT_GT(error, 0); // it is an approximation, and not the direct sum by another name
    EXPECT_LT(std::sqrt(error / size), 0.01);
}

TEST(Gravity, fields_add_up_and_can_be_changed_and_removed)
{
    World world({.gravity = {0, -10}});
    const FieldId wind = world.add_field(UniformField{{3, 0}});
    const FieldId center = world.add_field(PointField{.center = {0, 0}, .strength = 100});
    EXPECT_NEAR(world.gravity_at({0, 10}).x, 3, 1e-5);
    EXPECT_NEAR(world.gravity_at({0, 10}).y, -11, 1e-5);
    world.set_field(wind, UniformField{{-1, 0}});
    world.remove_field(center);
    EXPECT_NEAR(world.gravity_at({0, 10}).x, -1, 1e-5);
    EXPECT_NEAR(world.gravity_at({0, 10}).y, -10, 1e-5);
    EXPECT_THROW(world.remove_field(center), UsageError);

    const BodyId id = world.create_body({.gravity_scale = 2}, circle(1));
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.body(id).linear_velocity().x, -2, 1e-3);
    EXPECT_NEAR(world.body(id).linear_velocity().y, -20, 1e-3);
}

TEST(Gravity, only_enabled_bodies_pull_and_where_asked_only_attractors)
{
    for (const NBodyMethod method : {NBodyMethod::Direct, NBodyMethod::BarnesHut})
    {
        World world({.gravity = {0, 0}});
        const FieldId field = world.add_field(NBodyField{.gravitational_constant = 1, .method = method});
        const BodyId sun = world.create_body({}, box(10, 10), {.density = 5});
        const auto pull = [&] { return world.gravity_at({50, 0}).x; };
        EXPECT_NEAR(pull(), -500 / 2500.0, 1e-4);
        world.body(sun).set_enabled(false);
        EXPECT_EQ(pull(), 0);
        world.body(sun).set_enabled(true);
        world.set_field(field, NBodyField{.gravitational_constant = 1, .method = method, .sources = NBodySources::Attractors});
        world.body(sun).set_is_attractor(false);
        EXPECT_EQ(pull(), 0);
        world.body(sun).set_is_attractor(true);
        EXPECT_NEAR(pull(), -500 / 2500.0, 1e-4);
        world.destroy_body(sun);
        EXPECT_EQ(pull(), 0);
    }
}

TEST(Gravity, a_static_body_pulls_by_the_mass_of_its_shapes)
{
    World world({.gravity = {0, 0}});
    world.add_field(NBodyField{.gravitational_constant = 1});
    world.create_body({.type = BodyType::Static}, box(10, 10), {.density = 5});
    EXPECT_NEAR(world.gravity_at({50, 0}).x, -500 / 2500.0, 1e-4);
}

} // namespace carom
