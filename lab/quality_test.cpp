#include "lab/quality.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::lab
{

namespace
{

constexpr QualityTraits energy_is_kept{.rests = false, .stands = false, .keeps_energy = true, .keeps_momentum = false, .is_closed = false};

/// A ground, and boxes of 1 m with their centres at the places given.
SceneFile boxes_at(const std::vector<Vec2>& places)
{
    SceneFile file;
    file.world.gravity = {0, -10};
    FileBody ground;
    ground.def.type = BodyType::Static;
    ground.shapes = {{.geometry = offset_box(40, 2, {0, -1}), .def = {}}};
    file.bodies.push_back(ground);
    for (const Vec2 place : places)
    {
        FileBody body;
        body.def.position = place;
        body.shapes = {{.geometry = box(1, 1), .def = {}}};
        file.bodies.push_back(body);
    }
    return file;
}

Sample sample_at(int step, const std::vector<BodySample>& moving)
{
    Sample sample{.step = step, .bodies = {BodySample{}}};
    for (const BodySample& body : moving) sample.bodies.emplace_back(body);
    return sample;
}

} // namespace

TEST(Quality, measures_overlap)
{
    const SceneFile file = boxes_at({{0, 0.5f}, {5, 0.5f}});
    const auto quality = quality_of(file, {sample_at(10, {{.x = 0, .y = 0.47}, {.x = 5, .y = 0.49}})}, {});
    EXPECT_NEAR(quality.at("deepest_penetration_m"), 0.03, 1e-4);
    EXPECT_NEAR(quality.at("mean_penetration_m"), 0.02, 1e-4);
    EXPECT_EQ(quality.at("lost"), 0);
    EXPECT_EQ(quality.count("joint_separation_m"), 0u);
}

TEST(Quality, counts_what_is_lost_or_outside_and_how_far_it_went)
{
    const SceneFile file = boxes_at({{0, 0.5f}, {38, 0.5f}, {8, 0.5f}}); // the ground is 40 m wide
    QualityTraits traits;
    traits.rests = traits.stands = traits.is_closed = true;
    const auto quality = quality_of(file, {sample_at(10, {{.x = 0, .y = -0.5}, {.x = 42, .y = 0.5, .vx = 2}, {.x = NAN, .y = 0}})}, traits);
    EXPECT_EQ(quality.at("lost"), 1);
    EXPECT_EQ(quality.at("escapes"), 1);
    EXPECT_NEAR(quality.at("drift_m"), 4, 1e-4);
    EXPECT_NEAR(quality.at("rest_energy_j_per_kg"), 1, 1e-5) << "half of what moves at 2 m/s";
}

TEST(Quality, measures_energy_that_should_be_kept)
{
    SceneFile file = boxes_at({{0, 10}});
    const double fallen = 5; // [m]
    const Sample right = sample_at(60, {{.x = 0, .y = 10 - fallen, .vy = -std::sqrt(2 * 10 * fallen)}});
    EXPECT_NEAR(quality_of(file, {right}, energy_is_kept).at("energy_error"), 0, 1e-5);
    const Sample wrong = sample_at(60, {{.x = 0, .y = 10 - fallen, .vy = 0}});
    EXPECT_NEAR(quality_of(file, {wrong}, energy_is_kept).at("energy_error"), fallen, 1e-4);
}

TEST(Quality, measures_momentum_that_should_be_kept)
{
    SceneFile file = boxes_at({{0, 10}, {10, 10}});
    file.bodies[1].def.linear_velocity = {3, 0};
    QualityTraits traits;
    traits.keeps_momentum = true;
    const auto error = [&](double va, double vb)
    { return quality_of(file, {sample_at(60, {{.x = 0, .y = 10, .vx = va}, {.x = 10, .y = 10, .vx = vb}})}, traits).at("momentum_error"); };
    EXPECT_NEAR(error(1, 2), 0, 1e-6);
    EXPECT_NEAR(error(1, 2.3), 0.1, 1e-5);
}

TEST(Quality, measures_joints_that_came_apart)
{
    SceneFile file = boxes_at({{0, 5}, {2, 5}});
    FileJoint joint;
    joint.body_a = 1;
    joint.body_b = 2;
    joint.def.frame_a.p = {1, 0};
    joint.def.frame_b.p = {-1, 0};
    file.joints.push_back(joint);
    const auto quality = quality_of(file, {sample_at(1, {{.x = 0, .y = 5}, {.x = 2.04, .y = 5}})}, {});
    EXPECT_NEAR(quality.at("joint_separation_m"), 0.04, 1e-5);
}

TEST(Quality, follows_events)
{
    SceneFile file = boxes_at({{0, 0.5f}, {0, 0.5f}}); // the second lies in the first until that goes
    FileEvent event;
    event.step = 5;
    event.destroy_bodies = {1};
    file.events.push_back(event);
    Sample sample = sample_at(10, {{}, {.x = 0, .y = 0.5}});
    sample.bodies[1] = std::nullopt;
    EXPECT_LT(quality_of(file, {sample}, {}).at("deepest_penetration_m"), 0.001);
}

} // namespace carom::lab
