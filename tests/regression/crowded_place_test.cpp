// A crowd in one place: n bodies are n (n - 1) / 2 pairs. The world says so before they fill the memory, and goes on when there is room again.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom
{

namespace
{

std::vector<BodyId> add_crowd(World& world, int count, const Geometry& geometry, const ShapeDef& shape = {})
{
    std::vector<BodyId> crowd;
    for (int i = 0; i < count; ++i) crowd.push_back(world.create_body({.position = {30, 5}}, geometry, shape));
    return crowd;
}

void add_floor(World& world) { world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2)); }

/// The message with which a step is refused; empty when it is not.
std::string refusal(World& world)
{
    try
    {
        world.step(dt);
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return {};
}

} // namespace

TEST(CrowdedPlace, five_thousand_boxes_are_refused_before_they_fill_the_memory)
{
    for (const BroadPhaseType broad_phase : all_broad_phases)
    {
        World world({.broad_phase = broad_phase});
        add_floor(world);
        add_crowd(world, 5000, box(1, 1));
        const std::string message = refusal(world);
        EXPECT_NE(message.find("more than 524288"), std::string::npos) << message;
        EXPECT_NE(message.find("near (30, 5)"), std::string::npos) << message;
        EXPECT_NE(message.find("max_pairs"), std::string::npos) << message;
        EXPECT_LT(world.memory().total.peak_bytes, std::size_t{100} << 20) << name_of(broad_phase);
    }
}

TEST(CrowdedPlace, twenty_thousand_circles_are_refused_before_they_fill_the_memory)
{
    World world;
    add_floor(world);
    add_crowd(world, 20000, circle(0.5f));
    EXPECT_NE(refusal(world).find("more than 1280064"), std::string::npos);
    EXPECT_LT(world.memory().total.peak_bytes, std::size_t{200} << 20);
}

/// What may not meet is no crowd: particles of one negative group, in whatever place.
TEST(CrowdedPlace, shapes_that_do_not_meet_do_not_count)
{
    World world({.max_pairs = 3000});
    add_floor(world);
    add_crowd(world, 2500, circle(0.5f), {.filter = {.group = -1}});
    for (int i = 0; i < 120; ++i) ASSERT_EQ(refusal(world), "");
    EXPECT_EQ(world.step(dt).pairs, 2500);
    EXPECT_LT(world.memory().total.peak_bytes, std::size_t{16} << 20);
}

/// 40 bodies in one place are 780 pairs, and 40 with the floor.
TEST(CrowdedPlace, the_limit_is_exact_and_the_same_for_every_broad_phase)
{
    for (const BroadPhaseType broad_phase : all_broad_phases)
    {
        World world({.broad_phase = broad_phase, .max_pairs = 819});
        world.create_body({.type = BodyType::Static, .position = {30, 5}}, box(20, 2));
        add_crowd(world, 40, circle(0.5f));
        EXPECT_NE(refusal(world), "") << name_of(broad_phase);
        world.set_max_pairs(820);
        EXPECT_EQ(refusal(world), "") << name_of(broad_phase);
    }
}

TEST(CrowdedPlace, a_refused_step_changes_nothing_and_the_world_goes_on_once_there_is_room)
{
    World world({.max_pairs = 1000});
    add_floor(world);
    const BodyId first = world.create_body({.position = {0, 10}}, box(1, 1));
    for (int i = 0; i < 30; ++i) world.step(dt);
    World other = world.copy();
    other.set_max_pairs(0);

    const std::vector<BodyId> crowd = add_crowd(world, 100, box(1, 1));
    const std::uint64_t before = world.hash();
    EXPECT_NE(refusal(world), "");
    EXPECT_NE(refusal(world), "");
    EXPECT_EQ(world.hash(), before);
    EXPECT_EQ(world.step_count(), 30u);
    EXPECT_EQ(world.overlapping(Aabb{{29, 4}, {31, 6}}).size(), 100u);

    for (std::size_t i = 40; i < crowd.size(); ++i) world.destroy_body(crowd[i]);
    add_crowd(other, 40, box(1, 1));
    for (int i = 0; i < 60; ++i)
    {
        ASSERT_EQ(refusal(world), "");
        other.step(dt);
    }
    EXPECT_EQ(world.body(first).position(), other.body(other.translated(first)).position());
    EXPECT_EQ(world.step_count(), 90u);
}

TEST(CrowdedPlace, the_limit_is_checked_read_copied_and_hashed)
{
    EXPECT_EQ(World().max_pairs(), 0);
    EXPECT_THROW(World({.max_pairs = -1}), UsageError);
    World world({.max_pairs = 5});
    EXPECT_THROW(world.set_max_pairs((1 << 30) + 1), UsageError);
    EXPECT_EQ(world.max_pairs(), 5);
    EXPECT_EQ(world.copy().max_pairs(), 5);
    EXPECT_NE(world.hash(), World().hash());
    World other;
    other.restore(world);
    EXPECT_EQ(other.max_pairs(), 5);
}

} // namespace carom
