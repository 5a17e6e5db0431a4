// The answers of hooks, and what they try.
#include "tests/fuzz/random_hooks.hpp"

#include "tests/fuzz/random_arguments.hpp"

#include <gtest/gtest.h>

#include <string>

namespace carom::fuzz
{

void expect_complete(const UsageError& error, const char* function)
{
    EXPECT_EQ(error.function(), function);
    EXPECT_FALSE(error.field().empty()) << error.what();
    EXPECT_FALSE(error.value().empty()) << error.what();
    EXPECT_FALSE(error.remedy().empty()) << error.what();
    EXPECT_EQ(std::string(error.what()), error.function() + ": " + error.field() + " is " + error.value() + "; " + error.remedy());
}

void CuriousVisitor::shape(ShapeId id, BodyId body, const Geometry& geometry, const Transform&)
{
    EXPECT_EQ(world_.shape(id).body(), body);
    EXPECT_EQ(&world_.shape(id).geometry(), &geometry);
}

void CuriousVisitor::bounds(ShapeId id, const Aabb& tight, const Aabb& fat)
{
    EXPECT_TRUE(world_.body(world_.shape(id).body()).is_enabled());
    EXPECT_TRUE(tight.min.x <= tight.max.x && tight.min.y <= tight.max.y);
    EXPECT_TRUE(fat.min.x <= tight.min.x && fat.min.y <= tight.min.y && fat.max.x >= tight.max.x && fat.max.y >= tight.max.y);
}

void CuriousVisitor::body(const DebugBody& body)
{
    const BodyView view = world_.body(body.id);
    EXPECT_EQ(body.type, view.type());
    EXPECT_EQ(body.is_awake, view.is_awake());
    EXPECT_EQ(body.is_enabled, view.is_enabled());
    EXPECT_EQ(body.island >= 0, body.type == BodyType::Dynamic && body.is_enabled);
}

void CuriousVisitor::pair(ShapeId a, ShapeId b, bool)
{
    EXPECT_LT(a.index, b.index);
    EXPECT_NE(world_.shape(a).body(), world_.shape(b).body());
}

void CuriousVisitor::contact(const DebugContact& contact)
{
    EXPECT_TRUE(world_.find_shape(contact.shape_a) && world_.find_shape(contact.shape_b));
    EXPECT_TRUE(contact.manifold.point_count == 1 || contact.manifold.point_count == 2);
    EXPECT_NEAR(length(contact.manifold.normal), 1, 1e-3);
    EXPECT_TRUE(contact.color >= -1 && contact.color <= DebugContact::overflow);
}

void CuriousVisitor::joint(const DebugJoint& joint)
{
    const JointView view = world_.joint(joint.id);
    EXPECT_EQ(joint.type, view.type());
    EXPECT_EQ(joint.body_a, view.body_a());
    EXPECT_EQ(joint.body_b, view.body_b());
}

void CuriousVisitor::broad_phase_node(const Aabb& bounds, int depth)
{
    EXPECT_TRUE(bounds.min.x <= bounds.max.x && bounds.min.y <= bounds.max.y);
    EXPECT_GE(depth, 0);
}

void RandomProbe::after_stage(const StepMoment& moment, const StepView& view)
{
    EXPECT_TRUE(moment.substep >= -1 && moment.substep < moment.substeps);
    if (random_.one_in(3))
    {
        CuriousVisitor visitor(world_);
        view.debug_draw(visitor);
    }
    if (!random_.one_in(10)) return;
    try
    {
        world_.set_gravity({});
        ADD_FAILURE() << "a probe was allowed to edit the world";
    }
    catch (const UsageError& error)
    {
        ++refused;
        expect_complete(error, "set_gravity");
    }
}

float RandomHooks::nonsense(float sense)
{
    return random_.one_in(8) ? nasty[static_cast<std::size_t>(random_.below(static_cast<int>(nasty.size())))] : sense;
}

void RandomHooks::try_to_edit()
{
    ++calls;
    if (!random_.one_in(20)) return;
    try
    {
        world->set_gravity({});
        ADD_FAILURE() << "a hook was allowed to edit the world";
    }
    catch (const UsageError& error)
    {
        ++refused;
        expect_complete(error, "set_gravity");
    }
}

bool RandomHooks::should_collide(ShapeId a, ShapeId b)
{
    try_to_edit();
    EXPECT_TRUE(world->find_shape(a) && world->find_shape(b));
    return !random_.one_in(10);
}

float RandomHooks::mix_friction(const Material&, const Material&, float mixed)
{
    try_to_edit();
    return nonsense(mixed);
}

float RandomHooks::mix_restitution(const Material&, const Material&, float mixed)
{
    try_to_edit();
    return nonsense(mixed);
}

void RandomHooks::pre_solve(PreSolve& contact)
{
    try_to_edit();
    EXPECT_GT(contact.manifold.point_count, 0);
    EXPECT_NEAR(length(contact.manifold.normal), 1, 1e-3);
    contact.is_enabled = !random_.one_in(5);
    contact.friction = nonsense(contact.friction);
    contact.restitution = nonsense(contact.restitution);
    contact.rolling_resistance = nonsense(contact.rolling_resistance);
    contact.tangent_speed = nonsense(contact.tangent_speed);
}

} // namespace carom::fuzz
