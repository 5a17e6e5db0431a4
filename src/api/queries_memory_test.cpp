// Queries ask the heap for nothing but the lists that they return.
#include "geometry/random_shapes.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace
{

thread_local std::size_t allocations = 0;

} // namespace

// Counts the requests of a thread to the heap.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    ++allocations;
    void* const memory = std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace carom
{

TEST(Queries, NothingIsAllocatedButLists)
{
    for (const BroadPhaseType type : all_broad_phases)
    {
        World world({.broad_phase = type});
        detail::RandomShapes random(83);
        for (int i = 0; i < 2000; ++i) world.create_body({.position = random.point(40)}, circle(0.5f));
        world.step(1 / 60.0f);
        world.cast_ray({0, 0}, {1, 0}); // brings the broad phase up to date
        const std::size_t before = allocations;
        int visits = 0;
        for (int i = 0; i < 100; ++i)
        {
            world.cast_ray(random.point(40), random.point(40));
            world.cast_circle(random.point(40), 1, random.point(40));
            world.closest_point(random.point(40), 10);
            world.visit_overlapping(Aabb{{-20, -20}, {20, 20}}, [&visits](ShapeId) { ++visits; });
            world.visit_overlapping(circle(20), {}, [&visits](ShapeId) { ++visits; });
            world.visit_shapes_at(random.point(40), [&visits](ShapeId) { ++visits; });
        }
        EXPECT_EQ(allocations, before) << name_of(type);
        EXPECT_GT(visits, 50000);
    }
}

} // namespace carom
