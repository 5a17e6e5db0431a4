// A copy goes on to the same bits, and a world can be taken back.

#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace carom
{

namespace
{

/// Joints, sleepers, sensors, fields, names, things that come and go.
void fill(World& world)
{
    world.create_body({.type = BodyType::Static, .position = {0, -1}, .name = "a name that is too long to be kept in place"}, box(80, 2));
    world.create_body({.type = BodyType::Static}, box(5, 5), {.is_sensor = true});
    world.create_body({.type = BodyType::Kinematic, .position = {6, 3}, .angular_velocity = 1}, box(6, 0.4f));
    world.add_field(UniformField{{0.1f, 0}});
    BodyId previous;
    for (int i = 0; i < 80; ++i)
    {
        const Vec2 at = {0.8f * static_cast<float>(i % 10) - 4, 0.5f + static_cast<float>(i / 10)};
        const BodyId body = world.create_body({.position = at}, i % 2 == 0 ? Geometry{box(0.7f, 0.7f)} : Geometry{circle(0.35f)});
        if (i % 9 == 1) world.create_joint(world.joint_at(previous, body, at), RevoluteJoint{.limit = Range{-1, 1}});
        previous = body;
    }
    world.create_body({.position = {-30, 0.5f}}, box(1, 1)); // sleeps soon
    world.create_body({.position = {-20, 9}, .linear_velocity = {500, 0}, .is_bullet = true}, circle(0.1f));
}

void disturb(World& world, int step)
{
    if (step % 20 != 7) return;
    const std::vector<BodyId> bodies = world.bodies();
    world.destroy_body(bodies[bodies.size() / 2]);
    world.create_body({.position = {0, 12}}, rounded_box(0.8f, 0.5f, 0.1f));
    world.body(bodies[5]).apply_impulse_to_center({1, 2});
}

} // namespace

TEST(Copy, StepsToTheSameBits)
{
    for (const int steps_before : {0, 1, 40, 200})
    {
        World world;
        fill(world);
        for (int i = 0; i < steps_before; ++i) world.step(dt);
        disturb(world, 7); // something that waits to be told
        World copy = world.copy();
        EXPECT_EQ(copy.hash(), world.hash());
        std::size_t ends = 0;
        for (int i = 0; i < 120; ++i)
        {
            disturb(world, i);
            disturb(copy, i);
            world.step(dt);
            copy.step(dt);
            ASSERT_EQ(copy.hash(), world.hash()) << i << " steps after " << steps_before;
            ASSERT_EQ(copy.events().contact_end.size(), world.events().contact_end.size());
            for (const ContactEnd& end : copy.events().contact_end) ASSERT_EQ(end.shape_a.world, copy.number());
            ends += copy.events().contact_end.size();
        }
        EXPECT_GT(ends, 0u) << steps_before;
    }
}

TEST(Copy, IsAWorldOfItsOwn)
{
    World world;
    fill(world);
    const BodyId id = world.bodies()[10];
    World copy = world.copy();
    EXPECT_THROW(copy.body(id), UsageError) << "an id of the other world";
    const BodyId there = copy.translated(id);
    copy.body(there).set_transform({50, 50}, 0);
    EXPECT_NE(world.body(id).position(), copy.body(there).position());
    EXPECT_EQ(copy.body(copy.bodies()[0]).name(), world.body(world.bodies()[0]).name());
    EXPECT_EQ(world.translated(there), id);
    EXPECT_EQ(copy.translated(BodyId{}), BodyId{});
}

TEST(Copy, OutlivesTheOriginalAndTakesItsMemoryFromWhereItIsTold)
{
    HeapResource memory;
    {
        std::optional<World> world(std::in_place);
        fill(*world);
        for (int i = 0; i < 30; ++i) world->step(dt);
        World copy = world->copy(&memory);
        world.reset();
        EXPECT_GT(memory.stats().bytes, 0u);
        for (int i = 0; i < 100; ++i) copy.step(dt);
        EXPECT_EQ(copy.body(copy.bodies()[0]).name(), "a name that is too long to be kept in place");
    }
    EXPECT_EQ(memory.stats().bytes, 0u);
}

TEST(Copy, RestoreTakesAWorldBackAndItsIdsWithIt)
{
    World world;
    fill(world);
    for (int i = 0; i < 60; ++i) world.step(dt);
    const BodyId id = world.bodies()[20];
    const World saved = world.copy();
    const std::uint64_t then = world.hash();
    std::vector<std::uint64_t> first;
    for (int i = 0; i < 60; ++i)
    {
        disturb(world, i);
        world.step(dt);
        first.push_back(world.hash());
    }
    for (int again = 0; again < 3; ++again)
    {
        world.restore(saved);
        EXPECT_EQ(world.hash(), then);
        EXPECT_TRUE(world.find_body(id)) << "ids from before name the same things";
        for (int i = 0; i < 60; ++i)
        {
            disturb(world, i);
            world.step(dt);
            ASSERT_EQ(world.hash(), first[static_cast<std::size_t>(i)]);
        }
    }
}

TEST(Copy, KeepsTheBroadPhaseAndTheOptions)
{
    World world({.gravity = {0, -3},
                 .broad_phase = BroadPhaseType::Quadtree,
                 .broad_phase_options = {4, 3},
                 .sleep = {.time = 2},
                 .continuous = false});
    const World copy = world.copy();
    EXPECT_EQ(copy.broad_phase(), BroadPhaseType::Quadtree);
    EXPECT_EQ(copy.broad_phase_options(), (BroadPhaseOptions{4, 3}));
    EXPECT_EQ(copy.gravity(), (Vec2{0, -3}));
    EXPECT_EQ(copy.sleep_tuning().time, 2);
    EXPECT_FALSE(copy.is_continuous());
}

} // namespace carom
