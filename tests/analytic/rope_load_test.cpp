// What a rope of pins carries, however many substeps a step has: 100,000 times the mass of a link at rest, 21,000 times when it swings.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace carom
{

namespace
{

constexpr int link_count = 30;
constexpr float link_length = 0.5f; // [m]

enum class Load
{
    Ball, ///< a circle that hangs by its centre
    Link  ///< the last link, of the same shape as the others
};

struct Rope
{
    /// @param load  in masses of a link
    /// @param angle from where the rope starts: 0 is level, -pi/2 hangs [rad]
    Rope(Load kind, float load, float angle) : world({.sleep = {.is_enabled = false}})
    {
        const Rot q = rotation(angle);
        const auto at = [&](float along) { return rotate(q, {along, 0}); };
        BodyId previous = {};
        float along = 0;
        for (int i = 0; i < link_count; ++i, along += link_length)
        {
            const float mass = kind == Load::Link && i + 1 == link_count ? load : 1;
            const ShapeDef shape = {.density = 10 * mass, .filter = {.mask = 0}};
            const BodyId link = world.create_body({.position = at(along + link_length / 2), .angle = angle}, box(link_length, 0.1f), shape);
            world.create_joint(world.joint_at(previous, link, at(along)), RevoluteJoint{});
            previous = link;
        }
        if (kind == Load::Link) return;
        const float radius = 0.5f;
        const float mass = load * world.body(previous).mass_data().mass;
        const BodyId ball =
            world.create_body({.position = at(along)}, circle(radius), {.density = mass / (pi * radius * radius), .filter = {.mask = 0}});
        world.create_joint(world.joint_at(previous, ball, at(along)), RevoluteJoint{});
    }

    /// @return the largest error of a joint in the given time [m]
    float widest_gap(float seconds, int substeps)
    {
        float widest = 0;
        for (float t = 0; t < seconds; t += dt)
        {
            world.step(dt, substeps);
            for (const JointId id : world.joints()) widest = std::max(widest, world.joint(id).error());
        }
        return widest;
    }

    World world;
};

class RopeLoad : public testing::TestWithParam<float>
{
};

class SwingingRopeLoad : public testing::TestWithParam<float>
{
};

std::string load_name(const testing::TestParamInfo<float>& load) { return std::to_string(static_cast<int>(load.param)); }

} // namespace

TEST_P(RopeLoad, hangs_without_stretching)
{
    for (const Load kind : {Load::Ball, Load::Link})
        for (const int substeps : {2, 4, 8, 16})
            EXPECT_LT(Rope(kind, GetParam(), -pi / 2).widest_gap(10, substeps), 0.0002f) << substeps << " substeps";
}

/// Let go from any side, the rope swings, folds and cracks like a whip. A joint opens for a moment by a fraction of its link, and by less with more
/// substeps.
TEST_P(SwingingRopeLoad, opens_a_little_and_holds_together)
{
    float widest_before = 0.15f;
    for (const int substeps : {4, 8, 16})
    {
        float widest = 0;
        for (const Load kind : {Load::Ball, Load::Link})
            for (const float start : {0.0f, 0.7f, -0.6f, -1.4f})
                widest = std::max(widest, Rope(kind, GetParam(), start).widest_gap(10, substeps));
        EXPECT_LT(widest, widest_before) << substeps << " substeps";
        widest_before = widest;
    }
    EXPECT_LT(widest_before, 0.06f);
}

INSTANTIATE_TEST_SUITE_P(LinkMasses, RopeLoad, testing::Values(200.0f, 1000.0f, 5000.0f, 21'000.0f, 100'000.0f), load_name);
INSTANTIATE_TEST_SUITE_P(LinkMasses, SwingingRopeLoad, testing::Values(200.0f, 1000.0f, 5000.0f, 21'000.0f), load_name);

} // namespace carom
