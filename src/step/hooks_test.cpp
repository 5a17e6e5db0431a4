// Mixing rules, hooks, hits, and the impulses that events tell.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace carom
{

namespace
{

/// Hooks that call functions.
struct Hooks : ContactHooks
{
    std::function<bool(ShapeId, ShapeId)> collide;
    std::function<float(const Material&, const Material&, float)> friction;
    std::function<float(const Material&, const Material&, float)> restitution;
    std::function<void(PreSolve&)> solve;

    bool should_collide(ShapeId a, ShapeId b) override { return !collide || collide(a, b); }
    float mix_friction(const Material& a, const Material& b, float mixed) override { return friction ? friction(a, b, mixed) : mixed; }
    float mix_restitution(const Material& a, const Material& b, float mixed) override
    {
        return restitution ? restitution(a, b, mixed) : mixed;
    }
    void pre_solve(PreSolve& contact) override
    {
        if (solve) solve(contact);
    }
};

struct HooksTest : testing::Test
{
    Hooks hooks;
    World world{{.gravity = {0, -10}, .sleep = {.is_enabled = false}, .hooks = &hooks}};
    BodyId ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));

    BodyId add(Vec2 position, const ShapeDef& def = {}, const Geometry& geometry = box(1, 1))
    {
        return world.create_body({.position = position}, geometry, def);
    }
    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) world.step(dt);
    }
    ShapeId shape_of(BodyId body) { return world.body(body).shapes()[0]; }
};

/// Speed that is left of 5 m/s after a box of friction 0.9 has slid on ground of friction 0.4 for half a second.
float speed_after_sliding(const WorldDef& def)
{
    World world(def);
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.friction = 0.4f}});
    const BodyId body =
        world.create_body({.position = {0, 0.25f}, .linear_velocity = {5, 0}}, box(4, 0.5f), {.material = {.friction = 0.9f}});
    for (int i = 0; i < 30; ++i) world.step(dt);
    return world.body(body).linear_velocity().x;
}

float rebound_after_fall(const WorldDef& def)
{
    World world(def);
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.restitution = 0.2f}});
    const BodyId body =
        world.create_body({.position = {0, 0.6f}, .linear_velocity = {0, -10}}, circle(0.5f), {.material = {.restitution = 0.8f}});
    for (int i = 0; i < 3; ++i) world.step(dt);
    return world.body(body).linear_velocity().y;
}

} // namespace

TEST(Mixing, each_rule_gives_its_friction)
{
    const auto speed = [](Mix rule) { return speed_after_sliding({.gravity = {0, -10}, .mixing = {.friction = rule}}); };
    EXPECT_NEAR(speed(Mix::GeometricMean), 5 - 5 * 0.6f, 0.02);
    EXPECT_NEAR(speed(Mix::Average), 5 - 5 * 0.65f, 0.02);
    EXPECT_NEAR(speed(Mix::Minimum), 5 - 5 * 0.4f, 0.02);
    EXPECT_NEAR(speed(Mix::Maximum), 5 - 5 * 0.9f, 0.02);
    EXPECT_NEAR(speed(Mix::Product), 5 - 5 * 0.36f, 0.02);
}

TEST(Mixing, each_rule_gives_its_restitution)
{
    const auto speed = [](Mix rule) { return rebound_after_fall({.gravity = {}, .mixing = {.restitution = rule}}); };
    EXPECT_NEAR(speed(Mix::GeometricMean), 4, 0.01);
    EXPECT_NEAR(speed(Mix::Average), 5, 0.01);
    EXPECT_NEAR(speed(Mix::Minimum), 2, 0.01);
    EXPECT_NEAR(speed(Mix::Maximum), 8, 0.01);
    EXPECT_NEAR(speed(Mix::Product), 1.6f, 0.01);
}

TEST(Mixing, can_change_while_bodies_slide)
{
    World world({.gravity = {0, -10}, .mixing = {.friction = Mix::Minimum}});
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.friction = 0}});
    const BodyId body =
        world.create_body({.position = {0, 0.25f}, .linear_velocity = {5, 0}}, box(4, 0.5f), {.material = {.friction = 0.5f}});
    for (int i = 0; i < 30; ++i) world.step(dt);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 5, 1e-4);
    world.set_mixing({.friction = Mix::Maximum});
    EXPECT_EQ(world.mixing().friction, Mix::Maximum);
    for (int i = 0; i < 30; ++i) world.step(dt);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 2.5f, 0.02);
    EXPECT_THROW(world.set_mixing({.friction = static_cast<Mix>(9)}), UsageError);
    EXPECT_THROW(World({.mixing = {.restitution = static_cast<Mix>(-1)}}), UsageError);
}

TEST_F(HooksTest, should_collide_has_the_last_word_and_is_asked_in_order)
{
    std::vector<std::pair<ShapeId, ShapeId>> asked;
    const BodyId ghost = add({0, 0.5f});
    const BodyId solid = add({3, 0.5f});
    const ShapeId ghost_shape = shape_of(ghost);
    hooks.collide = [&](ShapeId a, ShapeId b)
    {
        asked.emplace_back(a, b);
        return a != ghost_shape && b != ghost_shape;
    };
    run(60);
    EXPECT_LT(world.body(ghost).position().y, -2);
    EXPECT_NEAR(world.body(solid).position().y, 0.5f, 0.01);
    ASSERT_GE(asked.size(), 2u);
    EXPECT_EQ(asked[0], std::pair(shape_of(ground), ghost_shape));
    EXPECT_EQ(asked[1], std::pair(shape_of(ground), shape_of(solid)));
}

TEST_F(HooksTest, mixing_hooks_decide_and_nonsense_is_ignored)
{
    world.body(ground).set_transform({0, -1}, 0);
    hooks.friction = [](const Material& a, const Material& b, float) { return a.id + b.id == 7 ? 0.0f : nan; };
    hooks.restitution = [](const Material&, const Material&, float) { return -3.0f; };
    const BodyId slippery =
        world.create_body({.position = {0, 0.5f}, .linear_velocity = {5, 0}}, box(1, 1), {.material = {.friction = 0.6f, .id = 7}});
    const BodyId rough =
        world.create_body({.position = {-20, 0.5f}, .linear_velocity = {5, 0}}, box(4, 1), {.material = {.friction = 0.6f, .id = 8}});
    run(30);
    EXPECT_NEAR(world.body(slippery).linear_velocity().x, 5, 1e-4);
    EXPECT_NEAR(world.body(rough).linear_velocity().x, 5 - 5 * 0.6f, 0.05);
}

TEST_F(HooksTest, pre_solve_is_called_in_every_step_while_there_are_points)
{
    int calls = 0;
    const BodyId body = add({0, 0.5f}, {.pre_solve = true});
    add({5, 0.5f}); // does not ask
    hooks.solve = [&](PreSolve& contact)
    {
        ++calls;
        EXPECT_EQ(contact.shape_a, shape_of(ground));
        EXPECT_EQ(contact.shape_b, shape_of(body));
        EXPECT_NEAR(contact.manifold.normal.y, 1, 1e-5);
        EXPECT_EQ(contact.manifold.point_count, 2);
        EXPECT_EQ(contact.was_touching, calls > 1);
        EXPECT_NEAR(contact.friction, 0.6f, 1e-6);
    };
    run(50);
    EXPECT_EQ(calls, 50);
    world.shape(shape_of(body)).set_pre_solve(false);
    run(10);
    EXPECT_EQ(calls, 50);
    EXPECT_FALSE(world.shape(shape_of(body)).pre_solve());
}

TEST_F(HooksTest, a_disabled_contact_carries_nothing_and_is_not_told)
{
    const BodyId body = add({0, 0.5f}, {.pre_solve = true});
    run(20);
    EXPECT_EQ(world.shape(shape_of(body)).touching().size(), 1u);
    hooks.solve = [](PreSolve& contact) { contact.is_enabled = false; };
    world.step(dt);
    ASSERT_EQ(world.events().contact_end.size(), 1u);
    EXPECT_TRUE(world.shape(shape_of(body)).touching().empty());
    EXPECT_EQ(world.manifold(shape_of(ground), shape_of(body)).point_count, 0);
    run(20);
    EXPECT_NEAR(world.body(body).linear_velocity().y, -10 * 21 * dt, 0.02f);
    EXPECT_TRUE(world.events().contact_begin.empty());

    // From now on it carries again, also from inside the ground.
    hooks.solve = {};
    run(120);
    EXPECT_NEAR(world.body(body).position().y, 0.5f, 0.01);
}

TEST_F(HooksTest, one_way_platform_by_pre_solve)
{
    const BodyId platform = world.create_body({.type = BodyType::Static, .position = {0, 3}}, box(4, 0.2f), {.pre_solve = true});
    const BodyId jumper = world.create_body({.position = {0, 0.5f}, .linear_velocity = {0, 9}}, box(0.5f, 0.5f));
    hooks.solve = [&](PreSolve& contact)
    {
        const bool is_a = contact.shape_a == shape_of(platform);
        const Vec2 up = is_a ? contact.manifold.normal : -contact.manifold.normal;
        contact.is_enabled = contact.was_touching || (up.y > 0.9f && world.body(jumper).linear_velocity().y <= 0);
    };
    float highest = 0;
    for (int i = 0; i < 180; ++i)
    {
        world.step(dt);
        highest = std::max(highest, world.body(jumper).position().y);
    }
    EXPECT_NEAR(highest, 0.5f + 81 / 20.0f, 0.15f);
    EXPECT_NEAR(world.body(jumper).position().y, 3.1f + 0.25f, 0.01f);
}

TEST_F(HooksTest, what_pre_solve_changes_holds_for_one_step_and_nonsense_is_ignored)
{
    const BodyId body = world.create_body({.position = {0, 0.25f}, .linear_velocity = {5, 0}}, box(4, 0.5f), {.pre_solve = true});
    hooks.solve = [](PreSolve& contact)
    {
        EXPECT_NEAR(contact.friction, 0.6f, 1e-6); // afresh in each step
        contact.friction = 0;
    };
    run(20);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 5, 1e-4);
    hooks.solve = [](PreSolve& contact)
    {
        contact.friction = nan;
        contact.restitution = 5;
        contact.rolling_resistance = -1;
        contact.tangent_speed = std::numeric_limits<float>::infinity();
    };
    run(30);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 5 - 5 * 0.6f, 0.05);
    hooks.solve = [](PreSolve& contact) { contact.tangent_speed = 2; }; // of B past A, to the right of the normal
    run(120);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 2, 0.01);
}

TEST_F(HooksTest, hooks_must_not_edit_and_the_world_can_go_on_if_they_catch_the_error)
{
    int refused = 0;
    const auto try_to_edit = [&]
    {
        EXPECT_THROW(world.destroy_body(ground), UsageError);
        EXPECT_THROW(world.set_gravity({}), UsageError);
        EXPECT_THROW(world.step(dt), UsageError);
        ++refused;
    };
    const BodyId body = add({0, 0.5f}, {.pre_solve = true});
    hooks.collide = [&](ShapeId, ShapeId) { return try_to_edit(), true; };
    hooks.friction = [&](const Material&, const Material&, float mixed) { return try_to_edit(), mixed; };
    hooks.solve = [&](PreSolve&) { try_to_edit(); };
    run(2);
    EXPECT_GE(refused, 4);
    refused = 0;
    world.shape(shape_of(body)).set_material({.friction = 0.1f}); // asks mix_friction, between steps
    EXPECT_EQ(refused, 1);
    run(10);
    EXPECT_NEAR(world.body(body).position().y, 0.5f, 0.01);
}

TEST_F(HooksTest, an_exception_from_a_hook_leaves_a_world_that_can_be_read)
{
    const BodyId body = add({0, 0.5f}, {.pre_solve = true});
    hooks.solve = [](PreSolve&) { throw std::runtime_error("enough"); };
    EXPECT_THROW(world.step(dt), std::runtime_error);
    EXPECT_NEAR(world.body(body).position().y, 0.5f, 0.01);
    EXPECT_THROW(world.step(dt), UsageError);
}

TEST_F(HooksTest, hooks_can_be_taken_away)
{
    hooks.friction = [](const Material&, const Material&, float) { return 0.0f; };
    const BodyId body = world.create_body({.position = {0, 0.25f}, .linear_velocity = {5, 0}}, box(4, 0.5f));
    run(10);
    EXPECT_NEAR(world.body(body).linear_velocity().x, 5, 1e-4);
    EXPECT_EQ(world.hooks(), &hooks);
    world.set_hooks(nullptr);
    run(10);
    EXPECT_LT(world.body(body).linear_velocity().x, 4.1f);
}

TEST_F(HooksTest, a_fast_collision_makes_one_hit)
{
    const BodyId ball = world.create_body({.position = {0, 2}, .linear_velocity = {0, -5}}, circle(0.5f),
                                          {.material = {.restitution = 0}, .hit_events = true});
    std::vector<ContactHit> hits;
    for (int i = 0; i < 120; ++i)
    {
        world.step(dt, i % 2 == 0 ? 1 : 4);
        for (const ContactHit& hit : world.events().contact_hit) hits.push_back(hit);
    }
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].shape_a, shape_of(ground));
    EXPECT_EQ(hits[0].shape_b, shape_of(ball));
    EXPECT_NEAR(hits[0].approach_speed, std::sqrt(25 + 2 * 10 * 1.5f), 0.2f);
    EXPECT_NEAR(hits[0].normal.y, 1, 1e-5);
    EXPECT_NEAR(hits[0].point.y, 0, 0.1f);
}

/// It is driven into the ground at 5 m/s in each of ten steps: that is one collision, and the next one after a rest is another.
TEST_F(HooksTest, a_collision_of_several_steps_makes_one_hit)
{
    const BodyId ram = world.create_body({.position = {0, 0.5f}, .locks = {.rotation = true}}, box(1, 1), {.hit_events = true});
    for (int round = 0; round < 2; ++round)
    {
        for (int i = 0; i < 30; ++i)
        {
            world.step(dt);
            ASSERT_TRUE(world.events().contact_hit.empty()) << "at rest, step " << i;
        }
        std::size_t hits = 0;
        for (int i = 0; i < 10; ++i)
        {
            world.body(ram).set_linear_velocity({0, -5});
            world.step(dt);
            hits += world.events().contact_hit.size();
            ASSERT_EQ(world.shape(shape_of(ram)).touching().size(), 1u);
        }
        EXPECT_EQ(hits, 1u) << round;
    }
}

TEST_F(HooksTest, a_bouncing_ball_makes_a_hit_at_each_bounce_until_it_is_slow)
{
    world.create_body({.position = {0, 2.5f}}, circle(0.5f), {.material = {.restitution = 0.5f}, .hit_events = true});
    std::vector<float> speeds;
    for (int i = 0; i < 300; ++i)
    {
        world.step(dt);
        for (const ContactHit& hit : world.events().contact_hit) speeds.push_back(hit.approach_speed);
    }
    // sqrt(2 g h) = 6.3 m/s, and half as much each time: 3.2, 1.6, then below 1 m/s.
    ASSERT_EQ(speeds.size(), 3u);
    EXPECT_NEAR(speeds[0], 6.3f, 0.2f);
    EXPECT_NEAR(speeds[1], 3.2f, 0.2f);
    EXPECT_NEAR(speeds[2], 1.6f, 0.2f);
}

TEST_F(HooksTest, hits_need_a_shape_that_asks_and_a_speed_above_the_limit)
{
    const BodyId quiet = world.create_body({.position = {0, 2}, .linear_velocity = {0, -5}}, circle(0.5f));
    world.create_body({.position = {5, 2}, .linear_velocity = {0, -5}}, circle(0.5f), {.hit_events = true});
    world.set_hit_speed(20);
    EXPECT_EQ(world.hit_speed(), 20);
    EXPECT_FALSE(world.shape(shape_of(quiet)).hit_events());
    for (int i = 0; i < 60; ++i)
    {
        world.step(dt);
        EXPECT_TRUE(world.events().contact_hit.empty());
    }
    EXPECT_THROW(world.set_hit_speed(-1), UsageError);
    EXPECT_THROW(World({.hit_speed = nan}), UsageError);
}

TEST_F(HooksTest, a_contact_tells_its_total_impulse_while_it_lasts_and_when_it_ends)
{
    const BodyId body = add({0, 0.5f}, {.persist_events = true});
    run(60);
    const float weight = 10 * dt; // 1 kg for a step [N s]
    ASSERT_EQ(world.events().contact_persist.size(), 1u);
    const Manifold& manifold = world.events().contact_persist[0].manifold;
    EXPECT_NEAR(manifold.total_normal_impulse(), weight, 0.001f * weight);
    EXPECT_NEAR(manifold.total_tangent_impulse(), 0, 0.001f * weight);
    EXPECT_EQ(manifold.total_normal_impulse(), manifold.points[0].normal_impulse + manifold.points[1].normal_impulse);

    world.body(body).set_transform({0, 5}, 0);
    world.step(dt);
    ASSERT_EQ(world.events().contact_end.size(), 1u);
    EXPECT_NEAR(world.events().contact_end[0].total_normal_impulse, weight, 0.001f * weight);

    const BodyId other = add({8, 0.5f});
    run(60);
    world.destroy_body(other);
    world.step(dt);
    ASSERT_EQ(world.events().contact_end.size(), 1u);
    EXPECT_NEAR(world.events().contact_end[0].total_normal_impulse, weight, 0.01f * weight);
}

TEST_F(HooksTest, what_a_hook_lets_pass_is_not_stopped_by_continuous_collision)
{
    for (const bool by_filter : {true, false})
    {
        hooks.collide = [=](ShapeId, ShapeId) { return !by_filter; };
        hooks.solve = [](PreSolve& contact) { contact.is_enabled = false; };
        const float y = by_filter ? 20.0f : 40.0f;
        world.create_body({.type = BodyType::Static, .position = {10, y}}, box(0.3f, 4), {.pre_solve = true});
        const BodyId bullet = world.create_body({.position = {0, y}, .linear_velocity = {120, 0}, .gravity_scale = 0}, circle(0.1f));
        run(30);
        EXPECT_NEAR(world.body(bullet).linear_velocity().x, 120, 0.1f);
        // One that is only seen by pre_solve may lose part of a step where it first touches.
        EXPECT_NEAR(world.body(bullet).position().x, 60, by_filter ? 0.1f : 2.1f);
    }
}

} // namespace carom
