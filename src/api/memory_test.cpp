// Where a world's bytes come from, that they all return, and that a warm step asks for none.

#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <memory_resource>
#include <string>
#include <utility>
#include <vector>

namespace carom
{

namespace
{

/// While it lives, whoever asks the default resource for memory gets std::bad_alloc.
class NoDefaultResource
{
public:
    NoDefaultResource() : before_(std::pmr::set_default_resource(std::pmr::null_memory_resource())) {}
    ~NoDefaultResource() { std::pmr::set_default_resource(before_); }
    NoDefaultResource(const NoDefaultResource&) = delete;
    NoDefaultResource& operator=(const NoDefaultResource&) = delete;

private:
    std::pmr::memory_resource* before_;
};

void fill_each_store(World& world)
{
    world.create_body({.type = BodyType::Static, .position = {0, -1}, .name = "a name that is too long for a short string"}, box(60, 2));
    world.create_body({.type = BodyType::Static, .position = {0, 2}}, box(5, 4), {.is_sensor = true, .persist_events = true});
    world.create_body({.type = BodyType::Kinematic, .position = {8, 3}, .angular_velocity = 1}, box(6, 0.4f));
    world.add_field(PointField{.center = {0, 5}, .strength = 1, .softening = 1});
    world.add_field(NBodyField{.gravitational_constant = 1e-3f, .softening = 0.1f});
    for (int i = 0; i < 150; ++i)
    {
        const BodyDef def = {.position = {0.8f * static_cast<float>(i % 15) - 6, 0.5f + 0.8f * static_cast<float>(i / 15)}};
        world.create_body(def, i % 2 == 0 ? Geometry{box(0.7f, 0.7f)} : Geometry{circle(0.35f)}, {.persist_events = i % 3 == 0});
    }
}

class MemoryTest : public testing::TestWithParam<BroadPhaseType>
{
};

/// QuadtreeNaive and QuadtreeWithSet are left out: their sets allocate, by design.
class WarmMemoryTest : public testing::TestWithParam<BroadPhaseType>
{
};

} // namespace

TEST_P(MemoryTest, EveryByteComesFromTheResourceAndReturnsToIt)
{
    HeapResource memory;
    {
        const NoDefaultResource guard;
        World world({.broad_phase = GetParam(), .capacity = {.bodies = 10, .shapes = 10, .contacts = 10}, .memory = &memory});
        fill_each_store(world);
        for (int i = 0; i < 60; ++i)
        {
            const StepReport report = world.step(dt);
            ASSERT_EQ(report.memory.total.bytes, memory.stats().bytes);
            ASSERT_EQ(report.memory.total.blocks, memory.stats().blocks);
            ASSERT_GE(report.memory.total.peak_bytes, report.memory.total.bytes);
            if (i == 30) world.destroy_body(world.bodies()[40]);
            if (i == 40) world.set_broad_phase(BroadPhaseType::Quadtree);
        }
        World moved = std::move(world);
        moved.step(dt);
    }
    EXPECT_EQ(memory.stats().bytes, 0u);
}

TEST_P(WarmMemoryTest, AWarmPileAllocatesNothing)
{
    HeapResource memory;
    World world({.broad_phase = GetParam(), .memory = &memory});
    fill_each_store(world);
    for (int i = 0; i < 400; ++i) world.step(dt);
    const std::size_t before = memory.stats().allocations;
    for (int i = 0; i < 300; ++i) EXPECT_EQ(world.step(dt).allocations, 0u) << i;
    EXPECT_EQ(memory.stats().allocations, before);
}

TEST_P(WarmMemoryTest, AConstantPopulationHardlyEverAllocates)
{
    HeapResource memory;
    World world({.broad_phase = GetParam(), .memory = &memory});
    fill_each_store(world);
    std::size_t late = 0;
    for (int i = 0; i < 1800; ++i)
    {
        const std::vector<BodyId> bodies = world.bodies();
        world.destroy_body(bodies[3 + static_cast<std::size_t>(i * 7 % 150)]);
        world.create_body({.position = {static_cast<float>(i % 11) - 5, 9}}, circle(0.3f));
        const std::size_t before = memory.stats().allocations;
        world.step(dt);
        if (i >= 1200) late += memory.stats().allocations - before;
    }
    // One comes and one goes at every step, so that the number of contacts and the fill of each colour go on setting records now and then.
    EXPECT_LE(late, 4u) << "in 10 s, after 20 s";
}

INSTANTIATE_TEST_SUITE_P(BroadPhases, MemoryTest, testing::ValuesIn(all_broad_phases),
                         [](const auto& type) { return std::string(name_of(type.param)); });

INSTANTIATE_TEST_SUITE_P(BroadPhases, WarmMemoryTest,
                         testing::Values(BroadPhaseType::BruteForce, BroadPhaseType::Quadtree, BroadPhaseType::Tree),
                         [](const auto& type) { return std::string(name_of(type.param)); });

TEST(Memory, CapacityHintsSpareGrowing)
{
    HeapResource memory;
    World world({.capacity = {.bodies = 200, .shapes = 200, .contacts = 2000}, .memory = &memory});
    const std::size_t before = memory.stats().allocations;
    for (int i = 0; i < 200; ++i) world.create_body({.position = {static_cast<float>(2 * i), 0}});
    EXPECT_EQ(memory.stats().allocations, before) << "bodies alone grow nothing";
}

} // namespace carom
