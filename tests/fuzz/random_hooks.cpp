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
