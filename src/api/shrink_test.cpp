// What World::shrink gives back, and that nothing else changes.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom
{

namespace
{

std::vector<BodyId> fill_with_boxes(World& world, int count, Vec2 corner = {})
{
    std::vector<BodyId> bodies;
    for (int i = 0; i < count; ++i)
    {
        const Vec2 at = corner + 0.9f * Vec2{static_cast<float>(i % 1000), static_cast<float>(i / 1000)};
        bodies.push_back(world.create_body({.position = at, .name = "a name that is too long for a short string"}, box(1, 1)));
    }
    return bodies;
}

/// A world of many kinds of things, of which the oldest stay.
struct Level
{
    Level()
    {
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
        for (int i = 0; i < 20; ++i)
            stays.push_back(
                world.create_body({.position = {static_cast<float>(i % 5) - 2, 1.5f + static_cast<float>(i / 5)}}, box(0.9f, 0.9f)));
        world.create_joint(world.joint_between(stays[0], stays[1], {-2, 1.5f}, {-1, 1.5f}), DistanceJoint{.length = 1});
        for (int i = 0; i < 300; ++i)
            goes.push_back(
                world.create_body({.position = {static_cast<float>(i % 30) - 15, 8 + static_cast<float>(i / 30)}}, circle(0.4f)));
        for (std::size_t i = 0; i < 50; ++i)
            world.create_joint(
                world.joint_between(goes[i], goes[i + 100], world.body(goes[i]).position(), world.body(goes[i + 100]).position()),
                DistanceJoint{.length = 4});
        const std::vector<Vec2> points = {{20, 0}, {25, 1}, {30, 0}};
        world.create_chain(world.create_body({.type = BodyType::Static}), {.points = points});
    }

    void unload()
    {
        for (const BodyId id : goes) world.destroy_body(id);
    }

    World world;
    std::vector<BodyId> stays;
    std::vector<BodyId> goes;
};

/// Makes bodies, destroys them, and expects that nothing of them is left after World::shrink.
void expect_empty_again(BroadPhaseType type, int count)
{
    HeapResource memory;
    World world({.broad_phase = type, .memory = &memory});
    const std::size_t empty = memory.stats().bytes;
    const std::vector<BodyId> bodies = fill_with_boxes(world, count);
    for (const BodyId id : bodies) world.destroy_body(id);
    world.step(dt);
    ASSERT_GT(memory.stats().bytes, 100 * empty);
    world.shrink();
    EXPECT_LE(memory.stats().bytes, 2 * empty);
    EXPECT_EQ(world.memory().total.bytes, memory.stats().bytes);
    const StepReport report = world.step(dt);
    EXPECT_EQ(report.memory.total.bytes, memory.stats().bytes);
    EXPECT_LE(memory.stats().bytes, 3 * empty) << "the scratch of a step comes again";
    for (std::size_t i = 0; i < bodies.size(); i += 97) ASSERT_FALSE(world.find_body(bodies[i])) << i;
    const BodyId next = world.create_body({});
    EXPECT_FALSE(world.find_body(bodies[next.index])) << "an old id does not name the new body";
}

class ShrinkTest : public testing::TestWithParam<BroadPhaseType>
{
};

} // namespace

TEST_P(ShrinkTest, an_emptied_world_is_as_small_as_a_new_one) { expect_empty_again(GetParam(), 3000); }

TEST_P(ShrinkTest, with_survivors_a_world_takes_what_they_need)
{
    HeapResource memory;
    HeapResource small_memory;
    World world({.broad_phase = GetParam(), .memory = &memory});
    World small({.broad_phase = GetParam(), .memory = &small_memory});
    const std::vector<BodyId> survivors = fill_with_boxes(world, 100, {-500, 0});
    fill_with_boxes(small, 100, {-500, 0});
    const std::vector<BodyId> others = fill_with_boxes(world, 3000);
    for (int i = 0; i < 3; ++i) world.step(dt), small.step(dt);
    for (const BodyId id : others) world.destroy_body(id);
    world.step(dt);
    small.step(dt);
    world.shrink();
    small.shrink();
    EXPECT_LE(memory.stats().bytes, small_memory.stats().bytes + small_memory.stats().bytes / 4);
    for (const BodyId id : survivors) ASSERT_TRUE(world.find_body(id));
    for (int i = 0; i < 120; ++i)
    {
        world.step(dt);
        small.step(dt);
    }
    for (std::size_t i = 0; i < survivors.size(); ++i)
        EXPECT_EQ(world.body(survivors[i]).position(), small.body(small.bodies()[i]).position()) << i;
}

TEST_P(ShrinkTest, a_world_goes_on_to_the_same_bits_with_and_without)
{
    Level shrinks;
    Level stays;
    for (Level* level : {&shrinks, &stays})
    {
        level->world.set_broad_phase(GetParam());
        for (int i = 0; i < 30; ++i) level->world.step(dt);
        level->unload();
    }
    shrinks.world.shrink();
    for (int i = 0; i < 200; ++i)
    {
        shrinks.world.step(dt);
        stays.world.step(dt);
        if (i % 50 == 0) shrinks.world.shrink();
        for (std::size_t k = 0; k < stays.stays.size(); ++k)
        {
            const Body a = shrinks.world.body(shrinks.stays[k]);
            const Body b = stays.world.body(stays.stays[k]);
            ASSERT_EQ(a.position(), b.position()) << "step " << i << ", body " << k;
            ASSERT_EQ(a.is_awake(), b.is_awake()) << "step " << i << ", body " << k;
        }
    }
    EXPECT_EQ(shrinks.world.joint_count(), stays.world.joint_count());
}

INSTANTIATE_TEST_SUITE_P(BroadPhases, ShrinkTest, testing::ValuesIn(all_broad_phases),
                         [](const auto& type) { return std::string(name_of(type.param)); });

TEST(Shrink, Slow_after_a_million_bodies_an_empty_world_is_as_small_as_a_new_one) { expect_empty_again(BroadPhaseType::Tree, 1'000'000); }

TEST(Shrink, spare_room_alone_does_not_change_the_hash)
{
    World world({.capacity = {.bodies = 1000, .shapes = 1000, .contacts = 1000}});
    fill_with_boxes(world, 10);
    const std::uint64_t hash = world.hash();
    const std::size_t bytes = world.memory().total.bytes;
    world.shrink();
    EXPECT_EQ(world.hash(), hash);
    EXPECT_LT(world.memory().total.bytes, bytes / 4);
}

TEST(Shrink, worlds_that_shrink_at_the_same_step_stay_equal)
{
    Level a;
    Level b;
    for (Level* level : {&a, &b})
    {
        for (int i = 0; i < 20; ++i) level->world.step(dt);
        level->unload();
        level->world.shrink();
    }
    World copy = a.world.copy();
    for (int i = 0; i < 60; ++i)
    {
        for (World* world : {&a.world, &b.world, &copy})
        {
            world->create_body({.position = {static_cast<float>(i % 7) - 3, 9}}, circle(0.3f));
            world->step(dt);
        }
        ASSERT_EQ(a.world.hash(), b.world.hash()) << i;
        ASSERT_EQ(a.world.hash(), copy.hash()) << i;
    }
}

TEST(Shrink, ids_keep_their_meaning_and_a_stale_one_is_called_destroyed)
{
    Level level;
    for (int i = 0; i < 20; ++i) level.world.step(dt);
    level.unload();
    const std::vector<BodyId> before = level.world.bodies();
    level.world.shrink();
    EXPECT_EQ(level.world.bodies(), before);
    EXPECT_EQ(level.world.joint_count(), 1);
    try
    {
        level.world.body(level.goes.back());
        FAIL() << "a stale id";
    }
    catch (const UsageError& error)
    {
        EXPECT_NE(std::string(error.what()).find("was destroyed"), std::string::npos) << error.what();
    }
}

TEST(Shrink, a_world_that_was_restored_from_before_knows_its_ids)
{
    Level level;
    const World saved = level.world.copy();
    level.unload();
    level.world.shrink();
    level.world.restore(saved);
    for (const BodyId id : level.goes) EXPECT_TRUE(level.world.find_body(id));
    level.world.step(dt);
}

TEST(Shrink, it_does_not_wake_sleepers)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
    world.create_body({.position = {0, 0.5f}}, box(1, 1));
    for (int i = 0; i < 120; ++i) world.step(dt);
    ASSERT_EQ(world.awake_body_count(), 0);
    world.shrink();
    world.step(dt);
    EXPECT_EQ(world.awake_body_count(), 0);
}

} // namespace carom
