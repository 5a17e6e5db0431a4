// Thousands of bodies stirred in a ring: nothing squeezes out through a thin wall.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace carom
{

namespace
{

/// A static ring of 360 segments, a paddle on a motor in its middle, and bodies of three shapes in rows around it.
struct Spinner
{
    explicit Spinner(float ring_radius) : radius(ring_radius)
    {
        const BodyId ground = world.create_body({.type = BodyType::Static});
        std::vector<Vec2> ring;
        for (int i = 0; i < 360; ++i) ring.push_back(rotate(rotation(static_cast<float>(i) * pi / 180), {radius, 0}));
        const Material slippery{.friction = 0.1f};
        world.create_chain(ground, {.points = ring, .is_loop = true, .materials = {&slippery, 1}});

        const BodyId paddle =
            world.create_body({.position = {0, -0.5f * radius}}, rounded_box(0.8f, radius, 0.2f), {.material = {.friction = 0}});
        world.create_joint(world.joint_at(ground, paddle, {0, -0.5f * radius}),
                           RevoluteJoint{.motor = Motor{.speed = 5, .max_force = 25 * radius * radius}});
    }

    /// Row by row in the upper part of the ring.
    void fill(int count)
    {
        constexpr float spacing = 0.8f;
        const ShapeDef def{.density = 0.25f, .material = {.friction = 0.1f, .restitution = 0.1f}};
        for (float y = 0.15f * radius; static_cast<int>(bodies.size()) < count && y < radius; y += spacing)
            for (float x = -radius; static_cast<int>(bodies.size()) < count && x < radius; x += spacing)
            {
                if (length(Vec2{x, y}) > radius - 1) continue;
                const Geometry shapes[] = {capsule({-0.25f, 0}, {0.25f, 0}, 0.25f), circle(0.35f), box(0.7f, 0.7f)};
                bodies.push_back(world.create_body({.position = {x, y}}, shapes[bodies.size() % 3], def));
            }
    }

    long escaped() const
    {
        return std::count_if(bodies.begin(), bodies.end(), [&](BodyId id) { return length(world.body(id).position()) > radius; });
    }

    float radius;
    World world;
    std::vector<BodyId> bodies;
};

} // namespace

TEST(Crowd, at_most_two_of_6076_stirred_bodies_escape_from_a_ring)
{
#ifdef NDEBUG
    constexpr int count = 6076;
    Spinner spinner(57);
#else
    constexpr int count = 600; // the checks of each step take their time
    Spinner spinner(22);
#endif
    spinner.fill(count);
    ASSERT_EQ(spinner.bodies.size(), static_cast<std::size_t>(count));
    float fastest = 0;
    for (int i = 0; i < 500; ++i)
    {
        const StepReport report = spinner.world.step(1 / 60.0f);
        ASSERT_TRUE(report.quarantined.empty());
        for (const BodyId id : spinner.bodies) fastest = std::max(fastest, length(spinner.world.body(id).linear_velocity()));
    }
    EXPECT_GT(fastest, 30) << "it was stirred";
    EXPECT_LE(spinner.escaped(), 2);
}

} // namespace carom
