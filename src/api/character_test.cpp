// What a character can walk on, what stops it, and that it never enters anything.
#include "geometry/distance.hpp"
#include "geometry/random_shapes.hpp"
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace carom
{

namespace
{

constexpr float foot = 0.8f; // from the default capsule's middle to its lowest point [m]

/// A flat ground whose top is at height 0, and a player.
class CharacterTest : public testing::Test
{
protected:
    CharacterTest() { ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2)); }

    BodyId add(Vec2 center, const Geometry& geometry)
    {
        return world.create_body({.type = BodyType::Static, .position = center}, geometry);
    }

    /// Walks with gravity, as a game does.
    void walk(Character& character, float speed, int steps)
    {
        for (int i = 0; i < steps; ++i)
        {
            velocity.x = speed;
            velocity.y -= 9.81f * dt;
            velocity = character.move(world, velocity, dt);
            world.step(dt);
        }
    }

    /// A slope of 20 m that begins at x = 2.
    void add_slope(float angle)
    {
        const SinCos v = sin_cos(angle);
        add({2, 0}, convex_hull(std::array{Vec2{0, 0}, Vec2{20 * v.cos, 20 * v.sin}, Vec2{20 * v.cos, 0}}));
    }

    World world;
    BodyId ground;
    Vec2 velocity;
};

} // namespace

TEST_F(CharacterTest, FallsAndStands)
{
    Character character({.position = {0, 3}});
    walk(character, 0, 20);
    EXPECT_EQ(character.ground().state, GroundState::InAir);
    EXPECT_NEAR(velocity.y, -20 * 9.81f * dt, 1e-4f);
    walk(character, 0, 60);
    EXPECT_EQ(character.ground().state, GroundState::OnGround);
    EXPECT_EQ(character.ground().body, ground);
    EXPECT_EQ(character.ground().normal, (Vec2{0, 1}));
    EXPECT_NEAR(character.position().y, foot + character.def().skin, 1e-3f);
    EXPECT_EQ(velocity, Vec2{});
    const Vec2 rest = character.position();
    walk(character, 0, 60);
    EXPECT_EQ(character.position(), rest) << "and does not move a bit";
}

TEST_F(CharacterTest, WalksAtItsSpeed)
{
    Character character({.position = {0, 0.81f}});
    walk(character, 0, 5);
    const float start = character.position().x;
    walk(character, 5, 60);
    EXPECT_NEAR(character.position().x - start, 5, 1e-3f);
    EXPECT_NEAR(character.position().y, foot + character.def().skin, 1e-3f);
    EXPECT_NEAR(velocity.x, 5, 1e-4f);
}

TEST_F(CharacterTest, WalksUpALowStep)
{
    for (const float speed : {0.5f, 2.0f, 8.0f, 30.0f})
    {
        World own;
        own.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
        own.create_body({.type = BodyType::Static, .position = {12, 0}}, box(20, 0.56f)); // top at 0.28, from x = 2
        Character character({.position = {0, 0.81f}});
        Vec2 v;
        for (int i = 0; i < 600 && character.position().x < 4; ++i) v = character.move(own, {speed, v.y - 9.81f * dt}, dt);
        EXPECT_GE(character.position().x, 4) << speed;
        EXPECT_NEAR(character.position().y, 0.28f + foot + character.def().skin, 2e-3f) << speed;
        EXPECT_EQ(character.ground().state, GroundState::OnGround);
    }
}

TEST_F(CharacterTest, WalksUpAndDownStairs)
{
    for (int i = 0; i < 10; ++i)
        add({3 + static_cast<float>(i), 0.125f * static_cast<float>(i + 1)}, box(1, 0.25f * static_cast<float>(i + 1)));
    Character character({.position = {0, 0.81f}});
    walk(character, 3, 60 * 4);
    EXPECT_NEAR(character.position().x, 12, 0.5f);
    EXPECT_NEAR(character.position().y, 2.5f + foot, 0.02f);
    int in_air = 0;
    for (int i = 0; i < 240; ++i)
    {
        walk(character, -3, 1);
        in_air += character.ground().state != GroundState::OnGround;
    }
    EXPECT_NEAR(character.position().y, foot, 0.02f);
    EXPECT_EQ(in_air, 0) << "it follows the stairs down without a hop";
}

TEST_F(CharacterTest, SteepStairsDoNotSlowItDown)
{
    for (const float tread : {0.4f, 0.6f, 0.8f})
    {
        World own;
        own.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
        for (int i = 0; i < 12; ++i)
        {
            const float height = 0.25f * static_cast<float>(i + 1);
            own.create_body({.type = BodyType::Static, .position = {10 + tread * static_cast<float>(i), 0.5f * height}}, box(20, height));
        }
        Character character({.geometry = capsule({0, -0.3f}, {0, 0.3f}, 0.25f), .position = {-1.5f, 0.56f}});
        Vec2 v;
        int steps = 0;
        for (; steps < 600 && character.position().x < 12 * tread; ++steps) v = character.move(own, {3, v.y - 9.81f * dt}, dt);
        EXPECT_LT(static_cast<float>(steps) * dt * 3, 2.0f * (1.5f + 12 * tread)) << tread;
    }
}

TEST_F(CharacterTest, IsStoppedByAHighStep)
{
    add({12, 0}, box(20, 0.64f)); // top at 0.32
    Character character({.position = {0, 0.81f}});
    walk(character, 5, 120);
    EXPECT_NEAR(character.position().x, 2 - 0.3f - character.def().skin, 2e-3f);
    EXPECT_NEAR(character.position().y, foot + character.def().skin, 1e-3f);
    EXPECT_EQ(velocity.x, 0);
}

TEST_F(CharacterTest, SlidesDownAWallThatItRunsInto)
{
    add({3, 10}, box(2, 20));
    Character character({.position = {1, 12}});
    walk(character, 5, 60);
    EXPECT_NEAR(character.position().x, 2 - 0.3f - character.def().skin, 2e-3f);
    EXPECT_NEAR(character.position().y, 12 - 0.5f * 9.81f, 0.1f) << "the wall does not hold it";
}

TEST_F(CharacterTest, StopsAtACeiling)
{
    add({0, 3}, box(10, 1));
    Character character({.position = {0, 0.81f}});
    walk(character, 0, 2);
    velocity.y = 8;
    float highest = 0;
    for (int i = 0; i < 45; ++i)
    {
        walk(character, 0, 1);
        highest = std::max(highest, character.position().y);
        EXPECT_LE(velocity.y, 8);
    }
    EXPECT_NEAR(highest, 2.5f - foot - character.def().skin, 2e-3f);
    EXPECT_EQ(character.ground().state, GroundState::OnGround) << "down again: the ceiling took the velocity";
}

TEST_F(CharacterTest, ClimbsASlopeBelowTheLimit)
{
    add_slope(0.8f); // of 0.87
    Character character({.position = {0, 0.81f}});
    walk(character, 4, 180);
    EXPECT_GT(character.position().y, 4);
    EXPECT_EQ(character.ground().state, GroundState::OnGround);
    EXPECT_NEAR(character.ground().normal.x, -std::sin(0.8f), 1e-3f);
    const Vec2 rest = character.position();
    walk(character, 0, 60);
    EXPECT_LT(distance(character.position(), rest), 1e-3f) << "and stays there";
}

TEST_F(CharacterTest, SlopesDoNotChangeItsSpeed)
{
    add_slope(0.6f);
    Character character({.position = {0, 0.81f}});
    walk(character, 4, 120);
    const Vec2 start = character.position();
    walk(character, 4, 30);
    EXPECT_NEAR(distance(start, character.position()), 2, 0.02f);
    const Vec2 top = character.position();
    int in_air = 0;
    for (int i = 0; i < 30; ++i)
    {
        walk(character, -4, 1);
        in_air += character.ground().state != GroundState::OnGround;
    }
    EXPECT_NEAR(distance(top, character.position()), 2, 0.02f);
    EXPECT_EQ(in_air, 0);
}

TEST_F(CharacterTest, DoesNotClimbASlopeAboveTheLimit)
{
    add_slope(0.95f);
    Character character({.position = {0, 0.81f}});
    walk(character, 4, 180);
    EXPECT_LT(character.position().y, foot + 0.15f);
    // Nor by jumping against it.
    for (int i = 0; i < 10; ++i)
    {
        velocity.y = character.ground().state == GroundState::OnGround ? 4.0f : velocity.y;
        walk(character, 4, 30);
    }
    walk(character, 4, 60);
    EXPECT_LT(character.position().y, foot + 0.5f);
}

TEST_F(CharacterTest, SlidesDownASteepSlope)
{
    add_slope(1.1f);
    const SinCos v = sin_cos(1.1f);
    Character character({.position = Vec2{2, 0} + Vec2{10 * v.cos, 10 * v.sin} + Vec2{-0.5f, 1.5f}});
    bool was_too_steep = false;
    for (int i = 0; i < 240; ++i)
    {
        walk(character, velocity.x, 1);
        was_too_steep |= character.ground().state == GroundState::TooSteep;
    }
    EXPECT_TRUE(was_too_steep);
    EXPECT_NEAR(character.position().y, foot, 0.1f);
}

TEST_F(CharacterTest, RidesAPlatform)
{
    const BodyId platform = world.create_body({.type = BodyType::Kinematic, .position = {0, 1}, .linear_velocity = {2, 0}}, box(4, 0.5f));
    Character character({.position = {0.5f, 2.07f}});
    walk(character, 0, 5);
    const float ahead = character.position().x - world.body(platform).position().x;
    walk(character, 0, 120);
    EXPECT_NEAR(character.position().x - world.body(platform).position().x, ahead, 0.04f);
    EXPECT_EQ(character.ground().body, platform);
    EXPECT_EQ(character.ground().velocity, (Vec2{2, 0}));
    EXPECT_EQ(velocity, Vec2{}) << "relative to the platform";

    for (const float speed : {3.0f, -3.0f, 0.0f})
    {
        world.body(platform).set_linear_velocity({0, speed});
        for (int i = 0; i < 60; ++i)
        {
            walk(character, 0, 1);
            EXPECT_EQ(character.ground().state, GroundState::OnGround) << speed << " at " << i;
            const float gap = character.position().y - foot - (world.body(platform).position().y + 0.25f);
            EXPECT_NEAR(gap, 0.01f, 0.06f) << speed << " at " << i;
        }
    }
}

TEST_F(CharacterTest, TakesThePlatformsSpeedAlongWhenItJumps)
{
    world.create_body({.type = BodyType::Kinematic, .position = {0, 1}, .linear_velocity = {6, 0}}, box(4, 0.5f));
    Character character({.position = {0.5f, 2.07f}});
    walk(character, 0, 5);
    velocity = character.move(world, {0, 4}, dt);
    EXPECT_NEAR(velocity.x, 6, 1e-4f);
    EXPECT_NEAR(velocity.y, 4, 1e-4f);
    EXPECT_EQ(character.ground().state, GroundState::InAir);
}

TEST_F(CharacterTest, IsNotTakenAlongByATeleport)
{
    const BodyId platform = world.create_body({.type = BodyType::Kinematic, .position = {0, 1}}, box(4, 0.5f));
    Character character({.position = {0, 2.07f}});
    walk(character, 0, 5);
    world.body(platform).set_transform({50, 50}, 0);
    walk(character, 0, 60);
    EXPECT_NEAR(character.position().x, 0, 0.01f);
    EXPECT_NEAR(character.position().y, foot, 0.02f);
}

TEST_F(CharacterTest, IsPushedByAMovingWall)
{
    world.create_body({.type = BodyType::Kinematic, .position = {3, 2}, .linear_velocity = {-2, 0}}, box(1, 4));
    Character character({.position = {0, 0.81f}});
    walk(character, 0, 120);
    EXPECT_NEAR(character.position().x, 3 - 4 - 0.5f - 0.3f, 0.06f);
}

TEST_F(CharacterTest, PushesCratesOnlyWithForce)
{
    for (const float force : {0.0f, 400.0f})
    {
        World own;
        own.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
        const BodyId crate = own.create_body({.position = {2, 0.5f}}, box(1, 1), {.density = 20});
        Character character({.position = {0, 0.81f}, .push_force = force});
        Vec2 v;
        for (int i = 0; i < 180; ++i)
        {
            v = character.move(own, {2, v.y - 9.81f * dt}, dt);
            own.step(dt);
        }
        if (force > 0)
            EXPECT_GT(own.body(crate).position().x, 3);
        else
            EXPECT_NEAR(own.body(crate).position().x, 2, 0.01f);
        EXPECT_LT(character.position().x, own.body(crate).position().x - 0.5f - 0.3f);
    }
}

TEST_F(CharacterTest, DoesNotTrembleInACorner)
{
    add({3, 5}, box(2, 10));
    add({0, 6}, offset_box(8, 0.5f, {0, 0}, -0.3f)); // a ceiling that comes down to the wall
    Character character({.position = {1, 0.81f}});
    walk(character, 5, 120);
    const Vec2 rest = character.position();
    for (int i = 0; i < 120; ++i)
    {
        walk(character, 5, 1);
        ASSERT_EQ(character.position(), rest) << i;
    }
}

TEST_F(CharacterTest, WalksAcrossTheSeamsOfTiles)
{
    for (int i = 0; i < 60; ++i) add({static_cast<float>(i), 0.5f}, box(1, 1));
    for (const Geometry& geometry : {Geometry(capsule({0, -0.5f}, {0, 0.5f}, 0.3f)), Geometry(box(0.6f, 1.6f))})
    {
        Character character({.geometry = geometry, .position = {1, 1.85f}});
        velocity = {};
        walk(character, 0, 10);
        const Vec2 start = character.position();
        for (int i = 0; i < 300; ++i)
        {
            walk(character, 6, 1);
            ASSERT_NEAR(character.position().y, start.y, 1e-3f) << i;
        }
        EXPECT_NEAR(character.position().x - start.x, 30, 0.01f);
    }
}

/// Through random rubble, at random speeds, with any outline: what it was not in at the start it is never in.
TEST(Character, NeverOverlapsInRandomWorlds)
{
    detail::RandomShapes random(91);
    int stands = 0;
    float travelled = 0;
    for (int round = 0; round < 60; ++round)
    {
        World world;
        for (int i = 0; i < 60; ++i)
        {
            const Vec2 at = random.point(12);
            const float angle = random.uniform(-pi, pi);
            const Geometry geometry = random.geometry_of(random.integer(0, 3), 1.2f);
            world.create_body({.type = BodyType::Static, .position = at, .angle = angle}, geometry);
        }
        world.create_body({.type = BodyType::Static, .position = {0, -14}}, box(60, 2));
        CharacterDef def;
        if (round % 3 == 1) def.geometry = box(0.5f, 1.2f);
        if (round % 3 == 2) def.geometry = circle(0.4f);
        do def.position = random.point(12);
        while (!world.overlapping(def.geometry, {def.position, {}}).empty());

        Character character(def);
        Vec2 velocity;
        float speed = 0;
        for (int i = 0; i < 360; ++i)
        {
            if (i % 20 == 0) speed = random.uniform(-1, 1) * (round % 5 == 0 ? 60.0f : 5.0f);
            if (i % 120 == 119) velocity.y = random.uniform(0, 6);
            velocity.x = speed;
            velocity.y -= 9.81f * dt;
            const Vec2 before = character.position();
            velocity = character.move(world, velocity, dt);
            travelled += distance(before, character.position());
            ASSERT_TRUE(world.overlapping(def.geometry, character.transform()).empty()) << "round " << round << " step " << i;
            ASSERT_TRUE(is_finite(velocity));
            ASSERT_LT(length(character.position() - before), 2.0f + 70 * dt);
            stands += character.ground().state == GroundState::OnGround;
        }
    }
    EXPECT_GT(stands, 3000);
    EXPECT_GT(travelled, 200);
}

TEST(Character, MovesToTheSameBitsWhateverTheBroadPhase)
{
    Vec2 expected;
    for (const BroadPhaseType type : all_broad_phases)
    {
        World world({.broad_phase = type});
        detail::RandomShapes random(92);
        for (int i = 0; i < 200; ++i)
        {
            const Vec2 at = random.point(15);
            const Geometry geometry = random.geometry_of(random.integer(0, 3), 1);
            world.create_body({.type = i % 5 == 0 ? BodyType::Dynamic : BodyType::Static, .position = at}, geometry);
        }
        Character character({.position = {0, 18}, .push_force = 200});
        Vec2 velocity;
        for (int i = 0; i < 200; ++i)
        {
            velocity = character.move(world, {i % 100 < 50 ? 4.0f : -4.0f, velocity.y - 9.81f * dt}, dt);
            world.step(dt);
        }
        if (type == BroadPhaseType::BruteForce) expected = character.position();
        EXPECT_EQ(character.position(), expected) << name_of(type);
    }
}

TEST(Character, RefusesBadValues)
{
    const auto refused_field = [](auto&& call) -> std::string
    {
        try
        {
            call();
        }
        catch (const UsageError& error)
        {
            return error.field();
        }
        return "nothing";
    };
    EXPECT_EQ(refused_field([] { Character({.position = {nan, 0}}); }), "position.x");
    EXPECT_EQ(refused_field([] { Character({.up = {0, 2}}); }), "up");
    EXPECT_EQ(refused_field([] { Character({.max_slope = 2}); }), "max_slope");
    EXPECT_EQ(refused_field([] { Character({.step_height = -1}); }), "step_height");
    EXPECT_EQ(refused_field([] { Character({.skin = 0}); }), "skin");
    EXPECT_EQ(refused_field([] { Character({.geometry = Circle{{}, -1}}); }), "circle.radius");
    World world;
    Character character({});
    EXPECT_EQ(refused_field([&] { character.move(world, {nan, 0}, dt); }), "velocity.x");
    EXPECT_EQ(refused_field([&] { character.move(world, {}, 0); }), "dt");
    EXPECT_EQ(refused_field([&] { character.set_position({0, nan}); }), "position.y");
    EXPECT_EQ(character.position(), Vec2{});
}

} // namespace carom
