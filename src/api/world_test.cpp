// Worlds as a whole: looking things up, several of them, moving them.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace carom
{

namespace
{

void drop_boxes(World& world, int count)
{
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(50, 2));
    for (int i = 0; i < count; ++i)
        world.create_body({.position = {0.1f * static_cast<float>(i % 3), 1 + 1.1f * static_cast<float>(i)}}, box(1, 1));
    for (int i = 0; i < 100; ++i) world.step(1 / 60.0f);
}

} // namespace

/// With gcc, World({}) is ambiguous unless a constructor is a better match than moving from an empty world.
TEST(World, can_be_made_in_every_way_of_writing_no_definition)
{
    World plain;
    World braces{};
    World empty_definition({});
    World given({.gravity = {}});
    World nested({.gravity = {0, -1}, .sleep = {.is_enabled = false}});
    World from_definition(WorldDef{});
    World assigned = World({});
    assigned = World({.continuous = false});
    for (const World* world : {&plain, &braces, &empty_definition, &from_definition}) EXPECT_EQ(world->gravity(), WorldDef{}.gravity);
    EXPECT_EQ(given.gravity(), Vec2{});
    EXPECT_EQ(nested.gravity(), (Vec2{0, -1}));
    EXPECT_FALSE(nested.sleep_tuning().is_enabled);
    EXPECT_FALSE(assigned.is_continuous());
}

TEST(World, FindsWhatLivesAndNothingElse)
{
    World world;
    const BodyId body = world.create_body({.user_data = 4}, circle(1), {.user_data = 5});
    const ShapeId shape = world.body(body).shapes()[0];
    ASSERT_TRUE(world.find_body(body));
    EXPECT_EQ(world.find_body(body)->user_data(), 4u);
    ASSERT_TRUE(std::as_const(world).find_shape(shape));
    EXPECT_EQ(std::as_const(world).find_shape(shape)->user_data(), 5u);

    EXPECT_FALSE(world.find_body({}));
    EXPECT_FALSE(world.find_shape({}));
    EXPECT_FALSE(world.find_body({.index = 1000, .generation = 1, .world = body.world}));
    EXPECT_FALSE(world.find_body({.index = body.index, .generation = 0, .world = body.world}));
    EXPECT_FALSE(world.find_body({.index = body.index, .generation = body.generation + 1, .world = body.world}));

    world.destroy_body(body);
    EXPECT_FALSE(world.find_body(body));
    EXPECT_FALSE(world.find_shape(shape)) << "its shapes go with it";
    EXPECT_FALSE(std::as_const(world).find_body(body));
    const BodyId next = world.create_body({});
    EXPECT_EQ(next.index, body.index);
    EXPECT_FALSE(world.find_body(body));
    EXPECT_THROW(world.body(body), UsageError);
    EXPECT_THROW(world.destroy_body(body), UsageError);
    EXPECT_THROW(world.destroy_shape(shape), UsageError);
}

TEST(World, ListsBodiesByIndexAndShapesInTheOrderOfAdding)
{
    World world;
    std::vector<BodyId> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(world.create_body({}));
    world.destroy_body(bodies[1]);
    bodies.erase(bodies.begin() + 1);
    EXPECT_EQ(world.bodies(), bodies);
    EXPECT_EQ(world.body_count(), 3);

    std::vector<ShapeId> shapes;
    for (int i = 0; i < 4; ++i) shapes.push_back(world.create_shape(bodies[0], circle(1)));
    world.destroy_shape(shapes[1]);
    shapes.erase(shapes.begin() + 1);
    shapes.push_back(world.create_shape(bodies[0], circle(1))); // takes the place of the second, and comes last
    EXPECT_EQ(world.body(bodies[0]).shapes(), shapes);
    EXPECT_EQ(world.shape_count(), 4);
    EXPECT_EQ(world.body(bodies[0]).shape_count(), 4u);
}

TEST(World, AnIdOfOneWorldIsNotTakenForAnothers)
{
    World first;
    World second;
    const BodyId body = first.create_body({}, circle(1));
    second.create_body({}, circle(1));
    EXPECT_FALSE(second.find_body(body));
    EXPECT_FALSE(second.find_shape(first.body(body).shapes()[0]));
    EXPECT_THROW(second.body(body), UsageError);
    EXPECT_THROW(second.destroy_body(body), UsageError);
    EXPECT_THROW(second.manifold(first.body(body).shapes()[0], first.body(body).shapes()[0]), UsageError);
    const FieldId field = first.add_field(UniformField{{1, 0}});
    second.add_field(UniformField{{1, 0}});
    EXPECT_THROW(second.remove_field(field), UsageError);
    EXPECT_THROW(second.field(field), UsageError);
}

TEST(World, FieldsReadBack)
{
    World world;
    const FieldId first = world.add_field(UniformField{{1, 2}});
    const FieldId second = world.add_field(PointField{.center = {3, 4}, .strength = 5});
    EXPECT_EQ(world.fields(), (std::vector{first, second}));
    EXPECT_EQ(world.field(second), Field(PointField{.center = {3, 4}, .strength = 5}));
    world.remove_field(first);
    EXPECT_EQ(world.fields(), std::vector{second});
    EXPECT_THROW(world.field(first), UsageError);
}

TEST(World, OneWorldDoesNotShowInAnother)
{
    World alone;
    drop_boxes(alone, 10);
    World crowd;
    drop_boxes(crowd, 30);
    World again;
    drop_boxes(again, 10);
    EXPECT_EQ(again.hash(), alone.hash());
}

TEST(World, AMovedWorldGoesOnAndItsViewsWithIt)
{
    World expected;
    drop_boxes(expected, 5);
    for (int i = 0; i < 20; ++i) expected.step(1 / 60.0f);

    World first;
    drop_boxes(first, 5);
    const BodyId id = first.bodies()[2];
    const Body body = first.body(id);
    World second = std::move(first);
    second.step(1 / 60.0f);
    World third;
    third.create_body({}); // given back by the assignment
    third = std::move(second);
    for (int i = 0; i < 19; ++i) third.step(1 / 60.0f);
    EXPECT_EQ(third.hash(), expected.hash());
    EXPECT_EQ(body.position(), third.body(id).position());
}

TEST(World, AMovedFromWorldRefusesAndMayBeGivenAnother)
{
    World first;
    const BodyId id = first.create_body({});
    World second = std::move(first);
    // NOLINTBEGIN(bugprone-use-after-move): this is what the test is about
    EXPECT_THROW(first.step(1 / 60.0f), UsageError);
    EXPECT_THROW(first.create_body({}), UsageError);
    EXPECT_THROW(first.find_body(id), UsageError);
    EXPECT_THROW(first.events(), UsageError);
    EXPECT_THROW(first.hash(), UsageError);
    EXPECT_THROW(first.gravity(), UsageError);
    const auto function_of = [](auto&& call) -> std::string
    {
        try
        {
            call();
            return "it was taken";
        }
        catch (const UsageError& error)
        {
            return error.function();
        }
    };
    EXPECT_EQ(function_of([&] { first.step(1 / 60.0f); }), "step");
    EXPECT_EQ(function_of([&] { first.body(id); }), "body");
    EXPECT_EQ(function_of([&] { first.cast_ray({}, {1, 0}); }), "cast_ray");
    EXPECT_EQ(function_of([&] { first.create_joint({}, RevoluteJoint{}); }), "create_joint");
    EXPECT_EQ(function_of([&] { first.explode({}); }), "explode");
    EXPECT_EQ(function_of([&] { second.restore(first); }), "restore");
    // NOLINTEND(bugprone-use-after-move)
    first = std::move(second);
    EXPECT_TRUE(first.find_body(id));
}

TEST(World, SurvivesBeingMovedToItself)
{
    World world;
    const BodyId id = world.create_body({});
    World& same = world;
    world = std::move(same);
    EXPECT_TRUE(world.find_body(id));
}

TEST(World, WorldsMadeOnSeveralThreadsHaveNumbersOfTheirOwn)
{
    std::vector<std::vector<std::uint32_t>> numbers(4);
    std::vector<std::uint64_t> hashes(4);
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < 4; ++t)
            threads.emplace_back([&, t]
            {
                for (int i = 0; i < 50; ++i) numbers[t].push_back(World().create_body({}).world);
                World world;
                drop_boxes(world, 8);
                hashes[t] = world.hash();
            });
    }
    std::set<std::uint32_t> all;
    for (const auto& list : numbers) all.insert(list.begin(), list.end());
    EXPECT_EQ(all.size(), 200u);
    EXPECT_FALSE(all.contains(0));
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(World, TellsAnIdThatIsGoneFromOneThatNeverWas)
{
    World world;
    const BodyId gone = world.create_body({});
    world.destroy_body(gone);
    const auto remedy_for = [&](BodyId id)
    {
        try
        {
            world.body(id);
            return std::string("it was taken");
        }
        catch (const UsageError& error)
        {
            return error.remedy();
        }
    };
    const std::string destroyed = "it was destroyed; ask with find before using an old id";
    const std::string unknown = "it does not exist yet in this world; give an id that create returned";
    EXPECT_EQ(remedy_for(gone), destroyed);
    EXPECT_EQ(remedy_for({gone.index, gone.generation + 1, gone.world}), unknown);
    EXPECT_EQ(remedy_for({gone.index + 1, 1, gone.world}), unknown) << "just past the last";
    EXPECT_EQ(remedy_for({1000, 1, gone.world}), unknown);
    EXPECT_EQ(remedy_for({}), "give an id that create returned");
    EXPECT_EQ(remedy_for(World().create_body({})), "give an id of this world");
    world.create_body({});
    EXPECT_EQ(remedy_for(gone), destroyed) << "its place has another tenant";
}

TEST(World, solves_contacts_in_a_step_of_the_longest_length)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(20, 2));
    const BodyId crate = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    const StepReport report = world.step(1, 64);
    EXPECT_EQ(report.rows, 1);
    EXPECT_NEAR(world.body(crate).position().y, 0.5f, 0.02f);
}

TEST(World, RefusesAStepThatIsTooShortTooLongOrNoNumber)
{
    World world;
    for (const float dt : {-1.0f, 1e-7f, 1.5f, std::numeric_limits<float>::quiet_NaN()}) EXPECT_THROW(world.step(dt), UsageError) << dt;
    for (const int substeps : {-1, 0, 65}) EXPECT_THROW(world.step(0.01f, substeps), UsageError) << substeps;
    EXPECT_EQ(world.step_count(), 0u);
    try
    {
        world.step(std::numeric_limits<float>::quiet_NaN());
    }
    catch (const UsageError& error)
    {
        EXPECT_STREQ(error.what(), "step: dt is nan; give 0, or a value from 1e-06 to 1");
    }
    world.step(1e-6f, 64);
    world.step(1, 1);
    EXPECT_EQ(world.step_count(), 2u);
}

TEST(World, WarmStartSurvivesAChangeOfTheStepsLength)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(50, 2));
    std::vector<BodyId> tower;
    for (int i = 0; i < 6; ++i) tower.push_back(world.create_body({.position = {0, 0.5f + static_cast<float>(i)}}, box(1, 1)));
    for (int i = 0; i < 120; ++i) world.step(1 / 60.0f);
    const float top = world.body(tower.back()).position().y;
    for (int i = 0; i < 200; ++i)
    {
        world.step(i % 2 == 0 ? 1 / 30.0f : 1 / 120.0f, i % 3 == 0 ? 2 : 8);
        ASSERT_NEAR(world.body(tower.back()).position().y, top, 0.01f) << i;
        ASSERT_LT(length(world.body(tower.back()).linear_velocity()), 0.2f) << i;
    }
}

TEST(World, a_switch_of_warm_starting_shows_in_the_hash_and_in_a_copy)
{
    World world;
    const std::uint64_t before = world.hash();
    world.set_solver_tuning({.warm_starting = false});
    EXPECT_NE(world.hash(), before);
    EXPECT_FALSE(world.copy().solver_tuning().warm_starting);
    world.set_solver_tuning({});
    EXPECT_EQ(world.hash(), before);
}

} // namespace carom
