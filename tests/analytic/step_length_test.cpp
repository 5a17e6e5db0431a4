// How long a step may be for piles: what the documents of World::step promise, and that a step which is too long says so.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace carom
{

namespace
{

/// Whether a tower of boxes of 1 m still stands after 20 s.
bool tower_stands(int height, float dt, int substeps)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
    BodyId top;
    for (int i = 0; i < height; ++i) top = world.create_body({.position = {0, 0.5f + static_cast<float>(i)}}, box(1, 1));
    for (int i = 0; i < static_cast<int>(20 / dt); ++i) world.step(dt, substeps);
    const Vec2 place = world.body(top).position();
    return place.y > static_cast<float>(height) - 0.75f && std::abs(place.x) < 0.2f;
}

} // namespace

TEST(StepLength, towers_stand_in_the_documented_range)
{
    struct Case
    {
        int height;
        float dt;
        int substeps;
    };
    for (const Case& c : {Case{5, 1 / 60.0f, 1},
                          {5, 1 / 30.0f, 2},
                          {5, 0.1f, 8},
                          {10, 0.1f, 16},
                          {10, 0.05f, 8},
                          {10, 1 / 30.0f, 6},
                          {20, 1 / 60.0f, 4},
                          {20, 1 / 30.0f, 8},
                          {20, 0.05f, 16}})
        EXPECT_TRUE(tower_stands(c.height, c.dt, c.substeps)) << c.height << " boxes, " << c.dt << " s in " << c.substeps;
}

/// The step that the warning is about.
TEST(StepLength, a_tower_of_ten_falls_where_the_report_warns)
{
    EXPECT_FALSE(tower_stands(10, 0.1f, 4));
    World world;
    EXPECT_TRUE(world.step(0.1f, 4).is_too_long);
}

TEST(StepLength, the_report_tells_the_stiffness_and_warns_below_half_of_it)
{
    World world;
    const StepReport usual = world.step(1 / 60.0f, 4);
    EXPECT_NEAR(usual.contact_hertz, 30, 1e-3f);
    EXPECT_FALSE(usual.is_too_long);
    const StepReport half = world.step(1 / 60.0f, 2);
    EXPECT_NEAR(half.contact_hertz, 15, 1e-3f);
    EXPECT_FALSE(half.is_too_long);
    const StepReport long_step = world.step(0.1f, 4);
    EXPECT_NEAR(long_step.contact_hertz, 5, 1e-3f);
    EXPECT_TRUE(long_step.is_too_long);
    EXPECT_FALSE(world.step(0.1f, 16).is_too_long);
    const StepReport none = world.step(0);
    EXPECT_EQ(none.contact_hertz, 0);
    EXPECT_FALSE(none.is_too_long);
    world.set_solver_tuning({.contact_hertz = 5});
    EXPECT_FALSE(world.step(0.1f, 4).is_too_long) << "as soft as it was asked to be";
}

} // namespace carom
