// What a probe sees in the middle of a step, and that it disturbs nothing.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

namespace carom
{

namespace
{

/// Everything that a view shows.
struct Shown : DebugDraw
{
    void shape(ShapeId, BodyId of, const Geometry&, const Transform& transform) override { shapes[of] = transform; }
    void bounds(ShapeId id, const Aabb& tight, const Aabb&) override { tight_bounds[id] = tight; }
    void body(const DebugBody& body) override { bodies[body.id] = body; }
    void pair(ShapeId a, ShapeId b, bool is_new) override { pairs[{a, b}] = is_new; }
    void contact(const DebugContact& contact) override { contacts.push_back(contact); }
    void joint(const DebugJoint& joint) override { joints.push_back(joint); }
    void broad_phase_node(const Aabb&, int) override { ++nodes; }

    std::map<BodyId, Transform> shapes;
    std::map<ShapeId, Aabb> tight_bounds;
    std::map<BodyId, DebugBody> bodies;
    std::map<std::pair<ShapeId, ShapeId>, bool> pairs;
    std::vector<DebugContact> contacts;
    std::vector<DebugJoint> joints;
    int nodes = 0;
};

Shown shown_by(const World& world)
{
    Shown shown;
    world.debug_draw(shown);
    return shown;
}

/// A probe that calls a function.
struct Probe : StepProbe
{
    explicit Probe(std::function<void(const StepMoment&, const Shown&)> f) : look(std::move(f)) {}
    void after_stage(const StepMoment& moment, const StepView& view) override
    {
        Shown shown;
        view.debug_draw(shown);
        look(moment, shown);
    }
    std::function<void(const StepMoment&, const Shown&)> look;
};

struct StepProbeTest : testing::Test
{
    World world{{.gravity = {0, -10}}};
    BodyId ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));

    BodyId add(Vec2 position, const Geometry& geometry = box(1, 1), const ShapeDef& def = {})
    {
        return world.create_body({.position = position}, geometry, def);
    }
    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) world.step(dt);
    }
    ShapeId shape_of(BodyId body) { return world.body(body).shapes()[0]; }
    /// Steps once with a look at one stage; of those in substeps, at that of the last.
    Shown after(Stage stage, int substeps = 4)
    {
        Shown seen;
        bool is_seen = false;
        Probe probe([&](const StepMoment& moment, const Shown& shown)
        {
            if (moment.stage != stage) return;
            seen = shown;
            is_seen = true;
        });
        world.step(dt, substeps, &probe);
        EXPECT_TRUE(is_seen);
        return seen;
    }
};

} // namespace

TEST_F(StepProbeTest, is_called_after_each_stage_in_order)
{
    using enum Stage;
    std::vector<std::pair<Stage, int>> expected = {{FindPairs, -1}, {UpdateManifolds, -1}, {BuildRows, -1}, {Restitution, -1}};
    for (int i = 0; i < 3; ++i)
        for (const Stage stage : {IntegrateVelocities, WarmStart, Solve, IntegratePositions, Relax}) expected.emplace_back(stage, i);
    for (const Stage stage : {StoreImpulses, FinalizeBodies, Continuous, EmitEvents, Sleep}) expected.emplace_back(stage, -1);

    std::vector<std::pair<Stage, int>> seen;
    Probe probe([&](const StepMoment& moment, const Shown&)
    {
        EXPECT_EQ(moment.substeps, 3);
        seen.emplace_back(moment.stage, moment.substep);
    });
    add({0, 0.5f});
    world.step(dt, 3, &probe);
    EXPECT_EQ(seen, expected);

    seen.clear();
    world.step(0, 3, &probe);
    EXPECT_EQ(seen, (std::vector<std::pair<Stage, int>>{{FindPairs, -1}, {UpdateManifolds, -1}, {BuildRows, -1}, {EmitEvents, -1}}));
}

TEST_F(StepProbeTest, bodies_are_where_the_substeps_have_brought_them)
{
    const BodyId ball =
        world.create_body({.position = {0, 20}, .linear_velocity = {3, 0}, .angular_velocity = 2}, offset_box(1, 1, {0.5f, 0}));
    const Vec2 center = world.body(ball).center_of_mass();
    const float h = dt / 4;
    Vec2 expected_center = center;
    Vec2 expected_velocity = world.body(ball).linear_velocity();
    Shown last;
    Probe probe([&](const StepMoment& moment, const Shown& shown)
    {
        if (moment.stage == Stage::IntegrateVelocities) expected_velocity.y -= 10 * h;
        if (moment.stage == Stage::IntegratePositions) expected_center += h * expected_velocity;
        const DebugBody& body = shown.bodies.at(ball);
        EXPECT_NEAR(distance(body.center_of_mass, expected_center), 0, 1e-5f) << name_of(moment.stage) << moment.substep;
        EXPECT_NEAR(distance(body.linear_velocity, expected_velocity), 0, 1e-5f) << name_of(moment.stage) << moment.substep;
        EXPECT_NEAR(distance(body.transform * Vec2{0.5f, 0}, body.center_of_mass), 0, 1e-5f);
        EXPECT_EQ(shown.shapes.at(ball), body.transform);
        if (moment.stage == Stage::Relax) last = shown;
    });
    world.step(dt, 4, &probe);
    EXPECT_NE(expected_center, center);
    EXPECT_EQ(last.bodies.at(ball).transform, world.body(ball).transform()) << "finalizing changes nothing that was shown";
    EXPECT_EQ(last.bodies.at(ball).angular_velocity, world.body(ball).angular_velocity());
    EXPECT_NE(last.tight_bounds.at(shape_of(ball)), world.shape(shape_of(ball)).bounds()) << "bounds come later";
}

/// Of everything that has pushed a body since the step began, its velocity tells at every moment: m dv = m g t + sum of impulses.
TEST_F(StepProbeTest, impulses_and_forces_are_what_was_applied_so_far)
{
    std::vector<BodyId> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(add({0.1f * static_cast<float>(i), 0.5f + static_cast<float>(i)}));
    bodies.push_back(add({5, 0.6f}, circle(0.5f), {.material = {.restitution = 0.6f}}));
    world.body(bodies.back()).set_linear_velocity({2, -8});
    bodies.push_back(add({-10, 3}, circle(0.2f)));
    world.create_joint(world.joint_between({}, bodies.back(), {-12, 3}, {-10, 3}), DistanceJoint{.length = 2});
    const BodyId held = bodies.back();
    bodies.push_back(add({-9, 3}, circle(0.2f)));
    world.create_joint(world.joint_at(held, bodies.back(), {-10, 3}), RevoluteJoint{});
    bodies.push_back(add({-20, 5}));
    world.create_joint({.body_b = bodies.back()}, MouseJoint{.target = {-20, 7}, .max_force = 500});

    bool has_bounced = false;
    for (int step = 0; step < 30; ++step)
    {
        std::map<BodyId, Vec2> start;
        for (const BodyId id : bodies) start[id] = world.body(id).linear_velocity();
        float time = 0;
        Probe probe([&](const StepMoment& moment, const Shown& shown)
        {
            if (moment.stage == Stage::FindPairs || moment.stage >= Stage::FinalizeBodies) return;
            if (moment.stage == Stage::IntegrateVelocities) time += dt / 4;
            std::map<BodyId, Vec2> momentum;
            for (const DebugContact& contact : shown.contacts)
            {
                Vec2 impulse;
                for (const ContactPoint& point : contact.manifold.points)
                    impulse += point.normal_impulse * contact.manifold.normal + point.tangent_impulse * right_perp(contact.manifold.normal);
                momentum[world.shape(contact.shape_a).body()] -= impulse;
                momentum[world.shape(contact.shape_b).body()] += impulse;
            }
            if (moment.stage != Stage::UpdateManifolds) // until then forces are those of the last step
                for (const DebugJoint& joint : shown.joints)
                {
                    momentum[joint.body_a] -= dt * joint.force;
                    momentum[joint.body_b] += dt * joint.force;
                }
            for (const BodyId id : bodies)
            {
                const Vec2 expected = start[id] + time * Vec2{0, -10} + (1 / world.body(id).mass_data().mass) * momentum[id];
                EXPECT_NEAR(distance(shown.bodies.at(id).linear_velocity, expected), 0, 5e-3f) // joints turn a little within a substep
                    << "body " << id.index << " in step " << step << " after " << name_of(moment.stage) << " " << moment.substep;
            }
            has_bounced = has_bounced || (moment.stage == Stage::Restitution && length(momentum[bodies[4]]) > 1);
        });
        world.step(dt, 4, &probe);
        if (HasFailure()) return;
    }
    EXPECT_TRUE(has_bounced);
}

TEST_F(StepProbeTest, what_is_stored_is_what_the_last_pass_showed)
{
    const BodyId body = add({0, 0.5f});
    add({0, 1.5f});
    world.create_joint(world.joint_at({}, add({10, 5}), {12, 5}), RevoluteJoint{});
    run(20);
    const Shown relaxed = after(Stage::Relax);
    const Manifold stored = world.manifold(shape_of(ground), shape_of(body));
    ASSERT_EQ(stored.point_count, 2);
    EXPECT_GT(stored.total_normal_impulse(), 1.9f * 10 * dt);
    EXPECT_EQ(relaxed.contacts[0].manifold.total_normal_impulse(), stored.total_normal_impulse());
    EXPECT_EQ(relaxed.joints[0].force, world.joint(relaxed.joints[0].id).force());
    EXPECT_EQ(after(Stage::UpdateManifolds).contacts[0].manifold.total_normal_impulse(), 0);
    EXPECT_EQ(after(Stage::BuildRows).contacts[0].manifold.total_normal_impulse(), 0);
    EXPECT_EQ(after(Stage::BuildRows).joints[0].force, Vec2{});
    EXPECT_GT(after(Stage::FindPairs).contacts[0].manifold.total_normal_impulse(), 1.9f * 10 * dt) << "still of the step before";
}

TEST_F(StepProbeTest, contact_points_follow_the_bodies)
{
    const BodyId body = world.create_body({.position = {0, 0.51f}, .linear_velocity = {0, -1.5f}, .locks = {.rotation = true}}, box(1, 1));
    Probe probe([&](const StepMoment& moment, const Shown& shown)
    {
        if (moment.stage != Stage::IntegratePositions) return;
        ASSERT_EQ(shown.contacts.size(), 1u);
        const float bottom = shown.bodies.at(body).center_of_mass.y - 0.5f;
        for (const ContactPoint& point : shown.contacts[0].manifold.points)
        {
            EXPECT_NEAR(point.separation, bottom, 1e-5f);
            EXPECT_NEAR(point.position.y, 0.5f * bottom, 1e-5f);
        }
    });
    for (int i = 0; i < 4; ++i) world.step(dt, 4, &probe);
}

TEST_F(StepProbeTest, anchors_of_joints_follow_the_bodies)
{
    const BodyId body = world.create_body({.position = {0, 5}, .linear_velocity = {6, 0}}, box(1, 1));
    const BodyId other = world.create_body({.position = {0, 6}, .linear_velocity = {6, 0}}, box(1, 1));
    const JointId joint = world.create_joint(world.joint_at(body, other, {0, 5.5f}), WeldJoint{});
    const JointId mouse = world.create_joint({.body_b = body}, MouseJoint{.target = {3, 4}, .max_force = 0});
    const Shown seen = after(Stage::IntegratePositions);
    ASSERT_EQ(seen.joints.size(), 2u);
    EXPECT_EQ(seen.joints[0].id, joint);
    EXPECT_EQ(seen.joints[0].type, JointType::Weld);
    EXPECT_EQ(seen.joints[0].body_a, body);
    EXPECT_NEAR(seen.joints[0].anchor_a.x, 0.1f, 1e-3f);
    EXPECT_NEAR(distance(seen.joints[0].anchor_a, seen.joints[0].anchor_b), 0, 1e-4f);
    EXPECT_EQ(seen.joints[1].id, mouse);
    EXPECT_EQ(seen.joints[1].body_a, BodyId{});
    EXPECT_EQ(seen.joints[1].anchor_a, (Vec2{3, 4}));
}

TEST_F(StepProbeTest, new_pairs_colours_and_islands_come_with_their_stages)
{
    const BodyId left = world.create_body({.position = {0, 10}, .linear_velocity = {2, 0}, .gravity_scale = 0}, circle(0.5f));
    const BodyId right = world.create_body({.position = {1.5f, 10}, .gravity_scale = 0}, circle(0.5f));
    const std::pair pair(shape_of(left), shape_of(right));
    int steps = 0;
    while (!shown_by(world).pairs.contains(pair))
    {
        std::map<Stage, Shown> seen;
        Probe probe([&](const StepMoment& moment, const Shown& shown) { seen[moment.stage] = shown; });
        world.step(dt, 4, &probe);
        ASSERT_LT(++steps, 60);
        EXPECT_EQ(seen[Stage::FindPairs].pairs.contains(pair), shown_by(world).pairs.contains(pair));
        for (const auto& [shapes, is_new] : seen[Stage::FindPairs].pairs) EXPECT_EQ(is_new, shapes == pair);
    }
    EXPECT_TRUE(shown_by(world).pairs[pair]) << "found in the last step";
    world.step(dt);
    EXPECT_FALSE(shown_by(world).pairs[pair]);

    for (;;)
    {
        std::map<Stage, Shown> seen;
        Probe probe([&](const StepMoment& moment, const Shown& shown) { seen[moment.stage] = shown; });
        world.step(dt, 4, &probe);
        ASSERT_LT(++steps, 60);
        if (seen[Stage::UpdateManifolds].contacts.empty()) continue;
        Shown& before = seen[Stage::FindPairs];
        EXPECT_TRUE(before.contacts.empty());
        EXPECT_NE(before.bodies[left].island, before.bodies[right].island);
        Shown& then = seen[Stage::UpdateManifolds];
        EXPECT_EQ(then.contacts[0].color, 0) << "the lowest, between dynamic bodies";
        EXPECT_EQ(then.bodies[left].island, then.bodies[right].island);
        EXPECT_EQ(then.bodies[ground].island, -1);
        return;
    }
}

TEST_F(StepProbeTest, continuous_collision_is_seen_to_set_a_body_back)
{
    world.create_body({.type = BodyType::Static, .position = {2, 10}}, box(0.1f, 4));
    const BodyId bullet = world.create_body({.position = {0, 10}, .linear_velocity = {300, 0}, .gravity_scale = 0}, circle(0.1f));
    std::map<Stage, Vec2> seen;
    Probe probe([&](const StepMoment& moment, const Shown& shown) { seen[moment.stage] = shown.bodies.at(bullet).transform.p; });
    world.step(dt, 4, &probe);
    EXPECT_NEAR(seen[Stage::Relax].x, 5, 0.01f);
    EXPECT_NEAR(seen[Stage::FinalizeBodies].x, 5, 0.01f);
    EXPECT_NEAR(seen[Stage::Continuous].x, 1.85f, 0.05f);
    EXPECT_EQ(seen[Stage::Sleep], seen[Stage::Continuous]);
}

TEST_F(StepProbeTest, sleep_is_seen_in_its_stage)
{
    const BodyId body = add({0, 0.5f});
    while (world.body(body).is_awake())
    {
        std::map<Stage, Shown> seen;
        Probe probe([&](const StepMoment& moment, const Shown& shown) { seen[moment.stage] = shown; });
        world.step(dt, 4, &probe);
        ASSERT_LT(world.step_count(), 200u);
        EXPECT_TRUE(seen[Stage::EmitEvents].bodies[body].is_awake);
        EXPECT_EQ(seen[Stage::Sleep].bodies[body].is_awake, world.body(body).is_awake());
    }
}

TEST_F(StepProbeTest, a_probe_may_read_but_neither_change_nor_query)
{
    const BodyId body = add({0, 0.5f});
    int refused = 0;
    Probe probe([&](const StepMoment&, const Shown&)
    {
        EXPECT_EQ(world.body(body).type(), BodyType::Dynamic);
        EXPECT_THROW(world.destroy_body(body), UsageError);
        EXPECT_THROW(world.body(body).set_linear_velocity({}), UsageError);
        EXPECT_THROW(world.step(dt), UsageError);
        EXPECT_THROW(world.copy(), UsageError);
        EXPECT_THROW(world.cast_ray({}, {1, 0}), UsageError);
        ++refused;
    });
    world.step(dt, 1, &probe);
    EXPECT_EQ(refused, 14);
    world.step(dt);
    EXPECT_NEAR(world.body(body).position().y, 0.5f, 0.01f);
}

TEST_F(StepProbeTest, an_exception_from_a_probe_leaves_a_world_that_can_be_read)
{
    const BodyId body = add({0, 0.5f});
    for (const Stage stage : {Stage::FindPairs, Stage::Solve, Stage::FinalizeBodies, Stage::Sleep})
    {
        World copy = world.copy();
        Probe probe([&](const StepMoment& moment, const Shown&)
        {
            if (moment.stage == stage) throw std::runtime_error("enough");
        });
        EXPECT_THROW(copy.step(dt, 4, &probe), std::runtime_error);
        EXPECT_NEAR(copy.body(copy.translated(body)).position().y, 0.5f, 0.01f);
        EXPECT_THROW(copy.step(dt), UsageError);
    }
}

TEST_F(StepProbeTest, bad_parts_are_refused_and_an_empty_walk_is_none)
{
    add({0, 0.5f});
    world.step(dt);
    Shown shown;
    EXPECT_THROW(world.debug_draw(shown, static_cast<DrawPart>(128)), UsageError);
    world.debug_draw(shown, DrawPart{});
    EXPECT_TRUE(shown.bodies.empty() && shown.shapes.empty() && shown.nodes == 0);
}

TEST_F(StepProbeTest, a_walk_shows_the_parts_that_it_was_asked_for)
{
    add({0, 0.5f});
    world.create_joint(world.joint_at({}, add({10, 5}), {12, 5}), RevoluteJoint{});
    run(2);
    const auto seen = [&](DrawPart parts)
    {
        Shown shown;
        world.debug_draw(shown, parts);
        return std::vector<bool>{!shown.shapes.empty(),   !shown.tight_bounds.empty(), !shown.bodies.empty(), !shown.pairs.empty(),
                                 !shown.contacts.empty(), !shown.joints.empty(),       shown.nodes > 0};
    };
    std::vector<bool> expected(7);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        expected.assign(7, false);
        expected[i] = true;
        EXPECT_EQ(seen(static_cast<DrawPart>(1u << i)), expected) << i;
    }
    EXPECT_EQ(seen(DrawPart::All), std::vector<bool>(7, true));
    EXPECT_EQ(seen(DrawPart::Shapes | DrawPart::Contacts), (std::vector<bool>{true, false, false, false, true, false, false}));
}

TEST_F(StepProbeTest, overflow_and_sleep_show_in_the_colours)
{
    World crowd({.gravity = {}});
    crowd.create_body({}, circle(10));
    for (int i = 0; i < 60; ++i)
        crowd.create_body({.position = 10.3f * rotate(rotation(2 * pi * static_cast<float>(i) / 60), Vec2{1, 0})}, circle(0.3f));
    const StepReport report = crowd.step(dt);
    std::map<int, int> by_color;
    for (const DebugContact& contact : shown_by(crowd).contacts) ++by_color[contact.color];
    EXPECT_EQ(by_color.size(), 32u);
    EXPECT_EQ(by_color.begin()->first, 0);
    EXPECT_EQ(by_color[DebugContact::overflow], report.overflow_rows);
    EXPECT_GT(report.overflow_rows, 1);

    for (int i = 0; i < 60; ++i) crowd.step(dt);
    ASSERT_EQ(crowd.awake_body_count(), 0);
    for (const DebugContact& contact : shown_by(crowd).contacts) EXPECT_EQ(contact.color, -1);
}

} // namespace carom
