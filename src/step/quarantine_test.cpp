// A body whose state is lost is put back, disabled and reported; the others go on.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom
{

namespace
{

class QuarantineTest : public testing::Test
{
protected:
    World world;
    BodyId ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
    BodyId victim = world.create_body({.position = {20, 5}, .linear_velocity = {1, 0}}, box(1, 1));
    BodyId witness = world.create_body({.position = {-20, 0.5f}}, box(1, 1));

    /// Twice the largest force that a call takes is infinite.
    void lose(BodyId id)
    {
        for (int i = 0; i < 2; ++i) world.body(id).apply_force_to_center({3e38f, 0});
    }
};

} // namespace

TEST_F(QuarantineTest, ALostBodyIsPutBackDisabledAndReported)
{
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(world.step(dt).quarantined.empty());
    const Vec2 good = world.body(victim).position();
    lose(victim);
    const StepReport report = world.step(dt);
    ASSERT_EQ(report.quarantined.size(), 1u);
    EXPECT_EQ(report.quarantined[0], victim);
    EXPECT_EQ(world.body(victim).position(), good);
    EXPECT_EQ(world.body(victim).linear_velocity(), Vec2{});
    EXPECT_EQ(world.body(victim).angular_velocity(), 0);
    EXPECT_EQ(world.body(victim).force(), Vec2{});
    EXPECT_FALSE(world.body(victim).is_enabled());
    EXPECT_TRUE(world.step(dt).quarantined.empty()) << "told once";
}

TEST_F(QuarantineTest, OthersGoOnAsIfItHadBeenDisabledByHand)
{
    World plain;
    plain.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
    const BodyId twin = plain.create_body({.position = {-20, 0.5f}}, box(1, 1));
    lose(victim);
    for (int i = 0; i < 60; ++i)
    {
        world.step(dt);
        plain.step(dt);
        ASSERT_EQ(world.body(witness).position(), plain.body(twin).position()) << i;
    }
    EXPECT_TRUE(world.body(witness).is_enabled());
}

TEST_F(QuarantineTest, AnEnabledBodyFallsAgain)
{
    lose(victim);
    world.step(dt);
    world.body(victim).set_enabled(true);
    for (int i = 0; i < 120; ++i) EXPECT_TRUE(world.step(dt).quarantined.empty());
    EXPECT_NEAR(world.body(victim).position().y, 0.5f, 0.01f);
}

TEST_F(QuarantineTest, ItsContactsEndInTheSameStep)
{
    for (int i = 0; i < 120; ++i) world.step(dt);
    ASSERT_EQ(world.shape(world.body(victim).shapes()[0]).touching().size(), 1u);
    lose(victim);
    ASSERT_EQ(world.step(dt).quarantined.size(), 1u);
    ASSERT_EQ(world.events().contact_end.size(), 1u);
    EXPECT_TRUE(std::isfinite(world.events().contact_end[0].total_normal_impulse));
    EXPECT_TRUE(std::isfinite(world.events().contact_end[0].total_tangent_impulse));
    EXPECT_EQ(world.events().contact_end[0].shape_b, world.body(victim).shapes()[0]);
    EXPECT_TRUE(world.body(witness).is_enabled());
    EXPECT_NEAR(world.body(witness).position().y, 0.5f, 0.01f);
}

TEST_F(QuarantineTest, EveryWayToGetLostIsSeen)
{
    world.body(victim).apply_torque(3e38f);
    world.body(victim).apply_torque(3e38f);
    EXPECT_EQ(world.step(dt).quarantined.size(), 1u) << "spin";
    world.body(victim).set_enabled(true);
    world.body(victim).apply_impulse_to_center({3e38f, 0});
    world.body(victim).apply_impulse_to_center({3e38f, 0});
    EXPECT_EQ(world.step(dt).quarantined.size(), 1u) << "velocity";
    world.body(victim).set_enabled(true);
    world.body(victim).apply_impulse_to_center({1e20f, 0});
    EXPECT_EQ(world.step(dt).quarantined.size(), 1u) << "finite, but beyond the end of the world";
    EXPECT_TRUE(std::isfinite(world.body(victim).position().x));
}

TEST_F(QuarantineTest, the_report_says_why)
{
    lose(victim);
    const BodyId runaway = world.create_body({.position = {max_coordinate - 1, 5}, .linear_velocity = {1000, 0}}, circle(1));
    const StepReport report = world.step(dt);
    ASSERT_EQ(report.quarantined.size(), 2u);
    ASSERT_EQ(report.quarantine_reasons.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(report.quarantine_reasons[i],
                  report.quarantined[i] == runaway ? QuarantineReason::LeftWorld : QuarantineReason::NotFinite);
    EXPECT_TRUE(world.step(dt).quarantine_reasons.empty());
    EXPECT_EQ(name_of(QuarantineReason::LeftWorld), "left the world");
}

TEST_F(QuarantineTest, SeveralAtOnceAreAllReported)
{
    std::vector<BodyId> lost;
    for (int i = 0; i < 5; ++i)
    {
        lost.push_back(world.create_body({.position = {static_cast<float>(10 * i), 30}}, circle(1)));
        lose(lost.back());
    }
    const StepReport report = world.step(dt);
    EXPECT_EQ(std::vector(report.quarantined.begin(), report.quarantined.end()), lost);
    for (int i = 0; i < 100; ++i) world.step(dt);
    EXPECT_TRUE(world.body(witness).is_enabled());
}

} // namespace carom
