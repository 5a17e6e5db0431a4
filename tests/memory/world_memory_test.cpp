// What a world takes from the heap, counted by the program's own operator new: nothing once it is warm, and nothing that it keeps.
#include "math/values_test.hpp"
#include "scenes/helpers.hpp"
#include "scenes/registry.hpp"
#include "tests/memory/counting_heap.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace carom
{

namespace
{

constexpr int warm_up = 200;
constexpr int measured = 1000;

/// A world and what happens between its steps, which allocates nothing itself.
struct Play
{
    std::function<void(World&)> fill;
    std::function<void(World&, int)> before_step = [](World&, int) {};
};

/// 500 circles and 500 boxes without gravity that cover a third of a field.
void fill_with_collisions(World& world)
{
    scenes::add_walls(world, {{0, 0}, {62, 36}}, {.restitution = 1});
    for (int i = 0; i < 1000; ++i)
    {
        const float x = 1 + 1.5f * static_cast<float>(i % 40);
        const float y = 1 + 1.35f * static_cast<float>(i / 40);
        const SinCos heading = sin_cos(static_cast<float>(i) * 2.4f);
        const Geometry geometry = i % 2 == 0 ? Geometry(circle(0.2f + 0.002f * static_cast<float>(i % 200)))
                                             : box(0.4f + 0.004f * static_cast<float>(i % 200), 0.8f);
        world.create_body({.position = {x, y}, .linear_velocity = {5 * heading.cos, 5 * heading.sin}}, geometry,
                          {.material = {.friction = 0, .restitution = 1}});
    }
}

Play collisions()
{
    return {[](World& world)
    {
        world.set_gravity({});
        fill_with_collisions(world);
    }};
}

Play pyramid()
{
    return {[](World& world)
    {
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
        for (int row = 0; row < 20; ++row)
            for (int i = 0; i < 20 - row; ++i)
                world.create_body({.position = {static_cast<float>(i) + 0.5f * static_cast<float>(row), 0.5f + static_cast<float>(row)}},
                                  box(0.9f, 1));
    }};
}

/// A heap of bodies; in every step the oldest goes and a new one falls in.
Play spawning(int count)
{
    auto bodies = std::make_shared<std::vector<BodyId>>();
    const auto spawn = [](World& world, int i)
    {
        const BodyDef def = {.position = {static_cast<float>(i * 7 % 19) - 9, 12 + static_cast<float>(i % 3)}};
        return world.create_body(def, i % 2 == 0 ? Geometry(circle(0.4f)) : box(0.7f, 0.7f));
    };
    return {[=](World& world)
    {
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(24, 2));
        for (const float x : {-11.0f, 11.0f}) world.create_body({.type = BodyType::Static, .position = {x, 10}}, box(1, 20));
        for (int i = 0; i < count; ++i) bodies->push_back(spawn(world, i));
    }, [=](World& world, int i)
    {
        BodyId& oldest = (*bodies)[static_cast<std::size_t>(i) % bodies->size()];
        world.destroy_body(oldest);
        oldest = spawn(world, i);
    }};
}

struct NamedPlay
{
    const char* name;
    Play (*make)();
};

class WarmWorld : public testing::TestWithParam<NamedPlay>
{
};

INSTANTIATE_TEST_SUITE_P(Plays, WarmWorld,
                         testing::Values(NamedPlay{"collisions", collisions}, NamedPlay{"pyramid", pyramid},
                                         NamedPlay{"spawning", [] { return spawning(300); }}),
                         [](const auto& play) { return play.param.name; });

/// @return allocations in the measured steps and edits, as the heap and as the world itself count them
std::pair<std::size_t, std::size_t> late_allocations(World& world, const Play& play)
{
    play.fill(world);
    int step = 0;
    const auto run = [&](int steps)
    {
        for (int i = 0; i < steps; ++i)
        {
            play.before_step(world, step++);
            world.step(dt);
        }
    };
    run(warm_up);
    const std::size_t heap_before = heap_allocations();
    const std::size_t own_before = world.memory().total.allocations;
    run(measured);
    return {heap_allocations() - heap_before, world.memory().total.allocations - own_before};
}

} // namespace

TEST_P(WarmWorld, TakesNothingFromTheHeap)
{
    World world;
    EXPECT_EQ(late_allocations(world, GetParam().make()), (std::pair<std::size_t, std::size_t>{0, 0}));
    EXPECT_GT(world.awake_body_count() + (std::string_view(GetParam().name) == "pyramid"), 0) << "it was alive";
}

TEST_P(WarmWorld, LivesOnEachResourceAndGivesEveryByteBack)
{
    const auto expect_clean = [&](std::pmr::memory_resource& memory, const auto& stats, const char* name)
    {
        {
            World world({.memory = &memory});
            EXPECT_EQ(late_allocations(world, GetParam().make()).second, 0u) << name;
            EXPECT_EQ(world.memory().total.bytes, stats().bytes) << name;
            EXPECT_EQ(world.memory().total.blocks, stats().blocks) << name;
        }
        EXPECT_EQ(stats().bytes, 0u) << name;
        EXPECT_EQ(stats().blocks, 0u) << name;
    };
    HeapResource heap;
    expect_clean(heap, [&] { return heap.stats(); }, "heap");
    LinearResource linear(1 << 20);
    expect_clean(linear, [&] { return linear.stats(); }, "linear");
    FreeListResource first_fit({.checks = true});
    expect_clean(first_fit, [&] { return first_fit.stats(); }, "first fit");
    FreeListResource best_fit({.fit = FreeListFit::Best, .checks = true});
    expect_clean(best_fit, [&] { return best_fit.stats(); }, "best fit");
    TrackingResource tracking;
    expect_clean(tracking, [&] { return tracking.stats(); }, "tracking");
    LimitResource limit(16 << 20);
    expect_clean(limit, [&] { return limit.stats(); }, "limit");
}

TEST(WorldMemory, GivesTheHeapAllBack)
{
    const std::size_t before = heap_bytes();
    {
        World world;
        const Play play = spawning(300);
        play.fill(world);
        for (int i = 0; i < 60; ++i) world.step(dt);
        EXPECT_GT(heap_bytes(), before + 100'000);
    }
    EXPECT_EQ(heap_bytes(), before);
}

TEST(WorldMemory, ReportsItsCategoriesAndTheirSum)
{
    World world;
    collisions().fill(world);
    for (int i = 0; i < 60; ++i) world.step(dt);
    const MemoryReport report = world.step(dt).memory;
    MemoryStats sum;
    for (int i = 0; i < memory_category_count; ++i)
    {
        const MemoryStats& part = report.categories[static_cast<std::size_t>(i)];
        sum.bytes += part.bytes;
        sum.blocks += part.blocks;
        sum.allocations += part.allocations;
        sum.total_bytes += part.total_bytes;
    }
    EXPECT_EQ(sum.bytes, report.total.bytes);
    EXPECT_EQ(sum.blocks, report.total.blocks);
    EXPECT_EQ(sum.allocations, report.total.allocations);
    EXPECT_EQ(sum.total_bytes, report.total.total_bytes);
    for (const auto category : {MemoryCategory::World, MemoryCategory::Bodies, MemoryCategory::Shapes, MemoryCategory::BroadPhase,
                                MemoryCategory::Contacts, MemoryCategory::Islands, MemoryCategory::Events, MemoryCategory::Scratch})
        EXPECT_GT(report.of(category).bytes, 0u) << name_of(category);
}

/// What the engine used that this one grew from.
TEST(WorldMemory, TheCollisionSceneNeedsLessThan2MB)
{
    const auto scene = scenes::make_scene("collisions", {{"circles", 500}, {"boxes", 500}});
    for (int i = 0; i < 1000; ++i) scene->step();
    const MemoryReport report = scene->world().memory();
    EXPECT_LT(report.total.peak_bytes, 2'000'000u);
    RecordProperty("peak_bytes", std::to_string(report.total.peak_bytes));
    for (int i = 0; i < memory_category_count; ++i)
        std::printf("%-12s %8zu bytes, peak %8zu\n", name_of(static_cast<MemoryCategory>(i)).data(),
                    report.categories[static_cast<std::size_t>(i)].bytes, report.categories[static_cast<std::size_t>(i)].peak_bytes);
    std::printf("%-12s %8zu bytes, peak %8zu\n", "total", report.total.bytes, report.total.peak_bytes);
}

/// With hints even the first step finds all the room that it needs.
TEST(WorldMemory, CapacityHintsSpareTheWarmUp)
{
    World world({.gravity = {}, .capacity = {.bodies = 1004, .shapes = 1004, .contacts = 3000}});
    const std::size_t before = heap_allocations();
    fill_with_collisions(world);
    for (int i = 0; i < 300; ++i) world.step(dt);
    EXPECT_EQ(heap_allocations(), before);
}

TEST(WorldMemory, ABudgetIsNamedInTheErrorAndTheWorldGoesOn)
{
    LimitResource limit(200'000);
    World world({.memory = &limit});
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(10000, 2));
    int made = 0;
    try
    {
        for (;; ++made) world.create_body({.position = {static_cast<float>(made), 1}}, box(0.9f, 0.9f));
    }
    catch (const MemoryLimitError& error)
    {
        EXPECT_NE(std::string(error.what()).find("budget of 200000 bytes"), std::string::npos) << error.what();
    }
    EXPECT_GT(made, 50);
    EXPECT_EQ(world.body_count(), made + 1);
    limit.set_budget(10'000'000);
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.body(world.bodies().back()).position().y, 0.45f, 0.01f);
    EXPECT_NO_THROW(world.create_body({.position = {0, 5}}, box(0.9f, 0.9f)));
}

/// An hour of coming and going: what is free in the world's memory stays in large pieces.
TEST(WorldMemory, AnHourOfSpawningDoesNotFragmentAFreeList)
{
#ifdef NDEBUG
    constexpr int minutes = 60;
#else
    constexpr int minutes = 2;
#endif
    for (const FreeListFit fit : {FreeListFit::First, FreeListFit::Best})
    {
        std::vector<std::byte> buffer(2'000'000);
        FreeListResource list(buffer, {.fit = fit});
        World world({.memory = &list});
        const Play play = spawning(60);
        play.fill(world);
        const auto largest_share = [&] { return static_cast<double>(list.largest_free_block()) / static_cast<double>(list.free_bytes()); };
        double early = 0;
        for (int i = 0; i < minutes * 900; ++i)
        {
            play.before_step(world, i);
            world.step(4 * dt); // steps that a test can afford
            if (i == 900) early = largest_share();
        }
        std::printf("%s fit: the largest free block is %.3f of the free bytes after a minute, %.3f at the end\n",
                    fit == FreeListFit::Best ? "best" : "first", early, largest_share());
        EXPECT_GT(largest_share(), 0.5);
        EXPECT_GT(largest_share(), 0.9 * early);
    }
}

} // namespace carom
