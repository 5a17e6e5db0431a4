#include "dynamics/body_store.hpp"

#include <gtest/gtest.h>

#include <memory_resource>
#include <random>

namespace carom::detail
{

namespace
{

class BodyStoreTest : public testing::Test
{
protected:
    BodyStore bodies{*std::pmr::new_delete_resource()};

    /// As edits do when shapes come and go.
    void give_shapes_mass(std::uint32_t slot, const MassData& mass)
    {
        bodies.records[slot].shapes_mass = mass;
        bodies.refresh_mass(slot);
    }
};

TEST_F(BodyStoreTest, StaticBodiesHaveNoMotionIndex)
{
    const std::uint32_t slot = bodies.create({.type = BodyType::Static, .position = {1, 2}});
    EXPECT_FALSE(bodies.is_active(slot));
    EXPECT_EQ(bodies.motions.size(), 1u) << "the entry for all that does not move";
    EXPECT_EQ(bodies.velocity(slot), Vec2{});
}

TEST_F(BodyStoreTest, DenseArraysStayDenseAndLinkedWhateverComesAndGoes)
{
    std::mt19937 engine(3);
    std::vector<std::uint32_t> live;
    for (int i = 0; i < 2000; ++i)
    {
        const auto any = [&] { return live[engine() % live.size()]; };
        switch (live.empty() ? 0 : engine() % 4)
        {
        case 0: live.push_back(bodies.create({.type = static_cast<BodyType>(engine() % 3), .is_enabled = engine() % 2 == 0})); break;
        case 1:
        {
            const std::size_t at = engine() % live.size();
            bodies.destroy(live[at]);
            live.erase(live.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        }
        case 2:
        {
            const std::uint32_t slot = any();
            bodies.records[slot].is_enabled = !bodies.records[slot].is_enabled;
            bodies.refresh(slot);
            break;
        }
        default:
        {
            const std::uint32_t slot = any();
            bodies.records[slot].type = static_cast<BodyType>(engine() % 3);
            bodies.refresh_mass(slot);
        }
        }
        std::size_t active = 0;
        for (const std::uint32_t slot : live)
        {
            const BodyRecord& record = bodies.records[slot];
            ASSERT_EQ(bodies.is_active(slot), record.is_enabled && record.type != BodyType::Static);
            if (!bodies.is_active(slot)) continue;
            ++active;
            ASSERT_EQ(bodies.motions[bodies.motion_index[slot]].slot, slot);
        }
        ASSERT_EQ(bodies.motions.size(), active + 1);
        ASSERT_EQ(bodies.masses.size(), active + 1);
        ASSERT_EQ(bodies.drives.size(), active + 1);
        ASSERT_EQ(bodies.motions[0].v, Vec2{});
        ASSERT_EQ(bodies.masses[0].inv_mass, Vec2{});
    }
}

TEST_F(BodyStoreTest, ADisabledBodyKeepsItsVelocity)
{
    const std::uint32_t slot = bodies.create({.linear_velocity = {3, 4}, .angular_velocity = 5});
    bodies.create({}); // the one that is moved into the gap
    bodies.records[slot].is_enabled = false;
    bodies.refresh(slot);
    EXPECT_EQ(bodies.velocity(slot), (Vec2{3, 4}));
    bodies.set_velocity(slot, {6, 7});
    bodies.records[slot].is_enabled = true;
    bodies.refresh(slot);
    EXPECT_EQ(bodies.velocity(slot), (Vec2{6, 7}));
    EXPECT_EQ(bodies.spin(slot), 5);
}

TEST_F(BodyStoreTest, AStaticBodyForgetsItsVelocity)
{
    const std::uint32_t slot = bodies.create({.linear_velocity = {3, 4}, .angular_velocity = 5});
    bodies.records[slot].type = BodyType::Static;
    bodies.refresh_mass(slot);
    bodies.records[slot].type = BodyType::Dynamic;
    bodies.refresh_mass(slot);
    EXPECT_EQ(bodies.velocity(slot), Vec2{});
    EXPECT_EQ(bodies.spin(slot), 0);
}

TEST_F(BodyStoreTest, AMovedCentreOfMassLeavesTheMaterialsVelocity)
{
    const std::uint32_t slot = bodies.create({.position = {10, 0}, .linear_velocity = {1, 0}, .angular_velocity = 2});
    give_shapes_mass(slot, {.mass = 3, .center = {0.5f, 0}, .inertia = 1});
    EXPECT_EQ(bodies.poses[slot].center, (Vec2{10.5f, 0}));
    EXPECT_EQ(bodies.velocity(slot), (Vec2{1, 1})) << "v + w x (0.5, 0)";
}

TEST_F(BodyStoreTest, AMassOverrideWinsUntilItIsTakenBack)
{
    const std::uint32_t slot = bodies.create({});
    EXPECT_EQ(bodies.records[slot].mass.mass, 1) << "no shape: counts as 1 kg";
    EXPECT_EQ(bodies.masses[bodies.motion_index[slot]].inv_inertia, 0) << "and does not turn";
    give_shapes_mass(slot, {.mass = 4, .center = {}, .inertia = 2});
    EXPECT_EQ(bodies.masses[bodies.motion_index[slot]].inv_mass, (Vec2{0.25f, 0.25f}));

    bodies.records[slot].has_mass_override = true;
    bodies.records[slot].mass_override = {.mass = 8, .center = {1, 0}, .inertia = 4};
    bodies.refresh_mass(slot);
    EXPECT_EQ(bodies.masses[bodies.motion_index[slot]].inv_inertia, 0.25f);
    EXPECT_EQ(bodies.poses[slot].center, (Vec2{1, 0}));
    bodies.records[slot].has_mass_override = false;
    bodies.refresh_mass(slot);
    EXPECT_EQ(bodies.records[slot].mass.mass, 4);
    EXPECT_EQ(bodies.poses[slot].center, Vec2{});
}

TEST_F(BodyStoreTest, LocksHoldADynamicBodyAlone)
{
    const MotionLocks locks = {.x = true, .y = false, .rotation = true};
    const std::uint32_t dynamic = bodies.create({.linear_velocity = {1, 2}, .angular_velocity = 3, .locks = locks});
    EXPECT_EQ(bodies.velocity(dynamic), (Vec2{0, 2}));
    EXPECT_EQ(bodies.spin(dynamic), 0);
    bodies.push(dynamic, {5, 5}, 5);
    EXPECT_EQ(bodies.velocity(dynamic), (Vec2{0, 7}));
    EXPECT_EQ(bodies.spin(dynamic), 0);
    EXPECT_EQ(bodies.drives[bodies.motion_index[dynamic]].gravity_scale, (Vec2{0, 1}));

    const std::uint32_t kinematic =
        bodies.create({.type = BodyType::Kinematic, .linear_velocity = {1, 2}, .angular_velocity = 3, .locks = locks});
    EXPECT_EQ(bodies.velocity(kinematic), (Vec2{1, 2}));
    EXPECT_EQ(bodies.spin(kinematic), 3);
}

TEST_F(BodyStoreTest, WhatEveryTypeWeighsToAnNBodyField)
{
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic})
    {
        const std::uint32_t slot = bodies.create({.type = type});
        give_shapes_mass(slot, {.mass = 4, .center = {}, .inertia = 2});
        EXPECT_EQ(bodies.gravity_mass(slot), 4);
        EXPECT_EQ(bodies.records[slot].mass.mass, type == BodyType::Dynamic ? 4 : 0);
    }
}

TEST(CombinedMass, FollowsSteiner)
{
    const MassData both = combined({.mass = 1, .center = {0, 0}, .inertia = 0.5f}, {.mass = 3, .center = {4, 0}, .inertia = 0.25f});
    EXPECT_FLOAT_EQ(both.mass, 4);
    EXPECT_EQ(both.center, (Vec2{3, 0}));
    EXPECT_FLOAT_EQ(both.inertia, 0.5f + 0.25f + 1 * 9 + 3 * 1);
    EXPECT_EQ(combined({}, {}).mass, 0);
    EXPECT_EQ(combined({}, {.mass = 2, .center = {1, 1}, .inertia = 3}).inertia, 3);
}

} // namespace
} // namespace carom::detail
