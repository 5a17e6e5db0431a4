#include "dynamics/shape_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory_resource>
#include <random>
#include <set>

namespace carom::detail
{
namespace
{

TEST(ShapeStore, TheListOfMovedShapesAgreesWithASet)
{
    ShapeStore shapes(*std::pmr::new_delete_resource());
    std::mt19937 engine(1);
    std::set<std::uint32_t> live;
    std::set<std::uint32_t> moved;
    for (int i = 0; i < 5000; ++i)
    {
        const std::uint32_t slot = static_cast<std::uint32_t>(engine() % 50);
        if (!live.contains(slot))
            live.insert(shapes.create(0, circle(1), {}));
        else if (engine() % 4 == 0)
            shapes.destroy(slot), live.erase(slot), moved.erase(slot);
        else if (engine() % 2 == 0)
            shapes.mark_moved(slot), moved.insert(slot);
        else
            shapes.unmark_moved(slot), moved.erase(slot);
        if (engine() % 200 == 0) shapes.clear_moved(), moved.clear();
        ASSERT_EQ(std::set(shapes.moved.begin(), shapes.moved.end()), moved);
        ASSERT_EQ(shapes.moved.size(), moved.size()) << "none twice";
    }
}

TEST(ShapeStore, ATenantOfAUsedPlaceHasNothingOfTheOneBefore)
{
    ShapeStore shapes(*std::pmr::new_delete_resource());
    const std::uint32_t first =
        shapes.create(7, circle(1), {.density = 5, .filter = {.category = 4, .mask = 8, .group = 3}, .is_sensor = true});
    shapes.mark_moved(first);
    shapes.records[first].next_of_body = 99;
    shapes.destroy(first);
    ASSERT_EQ(shapes.create(8, box(1, 1), {}), first);
    EXPECT_EQ(shapes.records[first].body, 8u);
    EXPECT_EQ(shapes.records[first].next_of_body, null_index);
    EXPECT_EQ(shapes.records[first].density, 1);
    EXPECT_EQ(shapes.records[first].filter, Filter{});
    EXPECT_FALSE(shapes.records[first].is_sensor);
    EXPECT_TRUE(std::holds_alternative<Polygon>(shapes.geometry[first]));
    EXPECT_TRUE(shapes.moved.empty());
}

TEST(FattenedBounds, HoldTheTightOnesAndTheWayAhead)
{
    const Aabb tight = {{-1, -1}, {1, 1}};
    const Aabb fat = fattened(tight, {3, -2}, Tolerances{}.max_bounds_margin);
    EXPECT_TRUE(contains(fat, tight));
    EXPECT_TRUE(contains(fat, Aabb{{2, -3}, {4, -1}})) << "the box at the end of its way";
    EXPECT_NEAR(fat.min.x, -1.05f, 1e-6) << "no more than the margin behind it";
    EXPECT_NEAR(fat.max.y, 1.05f, 1e-6);
    const Aabb small = fattened({{0, 0}, {0.08f, 0.08f}}, {}, Tolerances{}.max_bounds_margin);
    EXPECT_NEAR(small.max.x, 0.09f, 1e-6) << "an eighth of its size";
}

TEST(ShouldCollide, GroupsBeforeMasks)
{
    const Filter all;
    EXPECT_TRUE(should_collide(all, all));
    EXPECT_FALSE(should_collide({.category = 1, .mask = 2}, {.category = 4, .mask = 1})) << "one side is not enough";
    EXPECT_TRUE(should_collide({.category = 1, .mask = 4}, {.category = 4, .mask = 1}));
    EXPECT_TRUE(should_collide({.category = 1, .mask = 0, .group = 2}, {.category = 1, .mask = 0, .group = 2}));
    EXPECT_TRUE(should_collide({.category = 1, .mask = 0, .group = 1}, {.category = 1, .mask = 0, .group = 1}));
    EXPECT_FALSE(should_collide({.group = -1}, {.group = -1}));
    EXPECT_FALSE(should_collide({.group = -2}, {.group = -2}));
    EXPECT_TRUE(should_collide({.group = -2}, {.group = -3}));
    EXPECT_TRUE(should_collide({.group = -2}, {.group = 0}));
    const std::uint64_t last = std::uint64_t{1} << 63;
    EXPECT_TRUE(should_collide({.category = last, .mask = last}, {.category = last, .mask = last}));
}

} // namespace
} // namespace carom::detail
