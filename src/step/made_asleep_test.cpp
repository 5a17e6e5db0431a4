// Bodies that the user puts to sleep before they have touched anything: they sleep on until something that is awake touches them, and then
// they wake as an island does that fell asleep by itself.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom
{

namespace
{

class MadeAsleepTest : public testing::Test
{
protected:
    BodyId asleep(World& in, Vec2 place, const ShapeDef& shape = {})
    {
        const BodyId id = in.create_body({.position = place}, box(1, 1), shape);
        in.body(id).set_awake(false);
        return id;
    }

    /// The lowest first.
    std::vector<BodyId> tower(World& in, int height)
    {
        std::vector<BodyId> boxes;
        for (int i = 0; i < height; ++i) boxes.push_back(asleep(in, {0, 0.5f + static_cast<float>(i)}));
        return boxes;
    }

    /// In space, edge to edge, its lowest and leftmost square at the origin.
    std::vector<BodyId> block(World& in, int columns, int rows)
    {
        std::vector<BodyId> squares;
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j) squares.push_back(asleep(in, {static_cast<float>(i), static_cast<float>(j)}));
        return squares;
    }

    BodyId floor(World& in, BodyType type = BodyType::Static) { return in.create_body({.type = type, .position = {0, -1}}, box(100, 2)); }

    static void steps(World& in, int count)
    {
        for (int i = 0; i < count; ++i) in.step(dt);
    }

    World space{{.gravity = {}}};
    World world;
};

} // namespace

TEST_F(MadeAsleepTest, ABlockSleepsOnAndItsTouchesAreToldOnce)
{
    block(space, 8, 6);
    const StepReport first = space.step(dt);
    EXPECT_EQ(first.awake_bodies, 0);
    EXPECT_EQ(first.rows, 0);
    const auto touches = static_cast<int>(space.events().contact_begin.size());
    EXPECT_GE(touches, 7 * 6 + 8 * 5) << "edges at least";
    EXPECT_EQ(first.contacts, touches);
    for (int i = 0; i < 60; ++i)
    {
        const StepReport report = space.step(dt);
        ASSERT_EQ(report.awake_bodies, 0);
        ASSERT_EQ(report.contacts, touches) << "sleepers go on touching";
        ASSERT_TRUE(space.events().woke.empty());
        ASSERT_TRUE(space.events().contact_begin.empty());
        ASSERT_TRUE(space.events().contact_end.empty());
    }
}

TEST_F(MadeAsleepTest, TheyShareAnIslandAndTheDrawingShowsTheirContacts)
{
    block(space, 3, 1);
    asleep(space, {10, 0});
    space.step(dt);
    struct Seen : DebugDraw
    {
        void body(const DebugBody& b) override { islands.push_back(b.island); }
        void contact(const DebugContact& c) override { touching += c.is_touching && c.color == -1 ? 1 : 0; }
        std::vector<int> islands;
        int touching = 0;
    } seen;
    space.debug_draw(seen);
    ASSERT_EQ(seen.islands.size(), 4u);
    EXPECT_EQ(seen.islands[0], seen.islands[1]);
    EXPECT_EQ(seen.islands[0], seen.islands[2]);
    EXPECT_NE(seen.islands[0], seen.islands[3]);
    EXPECT_EQ(seen.touching, 2) << "not solved, but there";
}

TEST_F(MadeAsleepTest, AHitWakesTheWholeBlockAndItsContactsActAtOnce)
{
    const std::vector<BodyId> squares = block(space, 10, 3);
    const BodyId far = asleep(space, {40, 0});
    const BodyId ball = space.create_body({.position = {-3, 1}, .linear_velocity = {30, 0}}, circle(0.5f), {.density = 5});
    int woken_in = 0;
    StepReport report;
    for (int i = 0; i < 30 && woken_in == 0; ++i)
    {
        report = space.step(dt);
        if (report.awake_bodies > 1) woken_in = i + 1;
    }
    EXPECT_GE(woken_in, 3) << "not before it comes";
    EXPECT_EQ(report.awake_bodies, 31) << "all of the block, with the ball";
    EXPECT_EQ(report.islands, 1);
    EXPECT_GE(report.rows, 9 * 3 + 10 * 2 + 1) << "no square flies into its neighbour for want of a row";
    EXPECT_EQ(space.events().woke.size(), 30u);
    EXPECT_FALSE(space.body(far).is_awake());
    EXPECT_GT(space.body(squares.back()).linear_velocity().x + space.body(squares[28]).linear_velocity().x, 0) << "felt at the far end";
    EXPECT_LT(space.body(ball).linear_velocity().x, 30);
}

TEST_F(MadeAsleepTest, AHitInTheVeryFirstStepWakesTheWholeBlock)
{
    block(space, 6, 1);
    space.create_body({.position = {-1, 0}, .linear_velocity = {5, 0}}, box(1, 1));
    const StepReport report = space.step(dt);
    EXPECT_EQ(report.awake_bodies, 7);
    EXPECT_EQ(report.rows, 6);
    EXPECT_EQ(report.islands, 1);
}

/// The order in which the pairs are found does not matter.
TEST_F(MadeAsleepTest, AHitAtTheOtherEndInTheVeryFirstStepDoesToo)
{
    space.create_body({.position = {6, 0}, .linear_velocity = {-5, 0}}, box(1, 1));
    block(space, 6, 1);
    const StepReport report = space.step(dt);
    EXPECT_EQ(report.awake_bodies, 7);
    EXPECT_EQ(report.rows, 6);
    EXPECT_EQ(report.islands, 1);
}

TEST_F(MadeAsleepTest, ATowerStandsAsleepAndWakesWithItsLowestBox)
{
    for (const bool before_a_step : {false, true})
    {
        World own;
        floor(own);
        const std::vector<BodyId> boxes = tower(own, 5);
        if (!before_a_step) steps(own, 30);
        ASSERT_EQ(own.awake_body_count(), 0);
        own.body(boxes[0]).set_awake(true);
        own.step(dt);
        EXPECT_EQ(own.awake_body_count(), 5) << before_a_step;
        steps(own, 20);
        EXPECT_NEAR(own.body(boxes[4]).position().y, 4.5f, 0.02f);
    }
}

TEST_F(MadeAsleepTest, NothingHangsInTheAirWhenItsSupportGoes)
{
    for (const int way : {0, 1, 2})
    {
        World own;
        const BodyId ground = floor(own);
        const std::vector<BodyId> boxes = tower(own, 3);
        steps(own, 10);
        ASSERT_EQ(own.awake_body_count(), 0);
        if (way == 0) own.destroy_body(boxes[0]);
        if (way == 1) own.destroy_body(ground);
        if (way == 2) own.body(boxes[0]).set_linear_velocity({60, 0}); // out at a stroke
        steps(own, 20);
        EXPECT_LT(own.body(boxes[2]).position().y, 2.4f) << way;
    }
}

TEST_F(MadeAsleepTest, AFloorPutUnderSleepersWakesThem)
{
    for (const int way : {0, 1, 2, 3})
    {
        World own;
        const BodyId ground =
            own.create_body({.type = BodyType::Static, .position = {0, way == 1 ? -50.0f : -1.0f}, .is_enabled = way != 2}, box(100, 2),
                            {.filter = {.mask = way == 3 ? 0u : 1u}});
        const BodyId box_id = asleep(own, {0, 0.4f}); // 0.1 m deep, once the ground is there
        if (way == 0) own.destroy_body(ground);
        steps(own, 3);
        ASSERT_FALSE(own.body(box_id).is_awake());
        if (way == 0) floor(own);
        if (way == 1) own.body(ground).set_transform({0, -1}, 0);
        if (way == 2) own.body(ground).set_enabled(true);
        if (way == 3) own.shape(own.body(ground).shapes()[0]).set_filter({});
        own.step(dt);
        EXPECT_TRUE(own.body(box_id).is_awake()) << way;
        steps(own, 60);
        EXPECT_NEAR(own.body(box_id).position().y, 0.5f, 0.02f) << way;
    }
}

TEST_F(MadeAsleepTest, ARestingPlatformLeavesThemAloneUntilItMoves)
{
    const BodyId platform = floor(world, BodyType::Kinematic);
    const std::vector<BodyId> boxes = tower(world, 3);
    steps(world, 10);
    EXPECT_EQ(world.awake_body_count(), 0);
    world.body(platform).set_linear_velocity({0, 1});
    steps(world, 60);
    EXPECT_NEAR(world.body(boxes[2]).position().y, 3.5f, 0.05f);
}

TEST_F(MadeAsleepTest, AMovingPlatformWakesThemInTheFirstStep)
{
    world.create_body({.type = BodyType::Kinematic, .position = {0, -1}, .linear_velocity = {0, 1}}, box(100, 2));
    tower(world, 3);
    world.step(dt);
    EXPECT_EQ(world.awake_body_count(), 4);
}

TEST_F(MadeAsleepTest, TriggersSeeThem)
{
    const BodyId box_id = asleep(world, {0, 5});
    world.create_body({.type = BodyType::Static, .position = {0, 5}}, circle(2), {.is_sensor = true});
    world.step(dt);
    EXPECT_EQ(world.events().sensor_begin.size(), 1u);
    EXPECT_FALSE(world.body(box_id).is_awake());
    world.body(box_id).set_transform({20, 5}, 0);
    world.step(dt);
    EXPECT_EQ(world.events().sensor_end.size(), 1u);
}

TEST_F(MadeAsleepTest, CopiesAndRestoredWorldsDoTheSame)
{
    floor(world);
    const std::vector<BodyId> boxes = tower(world, 4);
    world.create_body({.position = {-4, 1.5f}, .linear_velocity = {12, 2}}, circle(0.4f), {.density = 3});
    World before = world.copy();
    EXPECT_EQ(before.hash(), world.hash());
    steps(world, 5);
    World asleep_still = world.copy();
    EXPECT_FALSE(world.body(boxes[3]).is_awake());
    steps(world, 60);
    EXPECT_TRUE(world.body(boxes[3]).is_awake());
    const std::uint64_t hash = world.hash();

    steps(asleep_still, 60);
    EXPECT_EQ(asleep_still.hash(), hash);
    steps(before, 65);
    EXPECT_EQ(before.hash(), hash);
    world.restore(asleep_still);
    EXPECT_EQ(world.hash(), hash);
}

/// What a hook disables holds nobody together.
TEST_F(MadeAsleepTest, ADisabledContactDoesNotLinkThem)
{
    struct Ghosts : ContactHooks
    {
        void pre_solve(PreSolve& contact) override { contact.is_enabled = false; }
    } ghosts;
    space.set_hooks(&ghosts);
    const BodyId left = asleep(space, {0, 0}, {.pre_solve = true});
    const BodyId right = asleep(space, {0.9f, 0}, {.pre_solve = true});
    steps(space, 2);
    EXPECT_EQ(space.awake_body_count(), 0);
    space.body(left).set_linear_velocity({1, 0});
    steps(space, 10);
    EXPECT_FALSE(space.body(right).is_awake());
    space.set_hooks(nullptr);
}

TEST_F(MadeAsleepTest, StepsOfSleepersAskForNoMemoryNorDoesTheHit)
{
    block(space, 12, 12);
    const BodyId ball = space.create_body({.position = {-40, 0}, .linear_velocity = {30, 0}}, circle(0.5f));
    steps(space, 2);
    std::size_t allocations = 0;
    for (int i = 0; i < 60; ++i) allocations += space.step(dt).awake_bodies < 2 ? space.step(dt).allocations : 0;
    EXPECT_EQ(allocations, 0u) << "while they sleep";
    EXPECT_LT(space.body(ball).position().x, 40);
}

} // namespace carom
