// Placed shapes are apart, and a search without room ends.
#include "scenes/placement.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

constexpr Aabb field{{-10, -5}, {10, 5}};

} // namespace

TEST(Placement, keeps_circles_apart_and_inside)
{
    Random random(1);
    Placement placement(field);
    std::vector<Vec2> places;
    for (int i = 0; i < 60; ++i)
    {
        const std::optional<Vec2> place = placement.find(circle(0.6f), random);
        ASSERT_TRUE(place);
        EXPECT_TRUE(contains(expanded(field, -0.6f), *place));
        for (const Vec2 other : places) EXPECT_GT(distance(*place, other), 1.2f);
        places.push_back(*place);
    }
}

TEST(Placement, keeps_boxes_apart)
{
    Random random(2);
    Placement placement(field);
    std::vector<Vec2> places;
    for (int i = 0; i < 40; ++i)
    {
        const std::optional<Vec2> place = placement.find(box(2, 1), random);
        ASSERT_TRUE(place);
        for (const Vec2 other : places)
            EXPECT_TRUE(std::abs(place->x - other.x) > 2 || std::abs(place->y - other.y) > 1) << place->x << " " << place->y;
        places.push_back(*place);
    }
}

TEST(Placement, keeps_a_circle_off_a_box_and_uses_the_room_at_its_corner)
{
    Random random(3);
    bool is_near_corner = false;
    for (int i = 0; i < 300; ++i)
    {
        Placement placement({{-2, -2}, {2, 2}});
        const Vec2 box_place = placement.find(box(1, 1), random).value();
        const std::optional<Vec2> place = placement.find(circle(0.5f), random);
        ASSERT_TRUE(place);
        const Vec2 offset = *place - box_place;
        const Vec2 outside{std::max(std::abs(offset.x) - 0.5f, 0.0f), std::max(std::abs(offset.y) - 0.5f, 0.0f)};
        EXPECT_GT(length(outside), 0.5f);
        is_near_corner |= std::abs(offset.x) < 1 && std::abs(offset.y) < 1;
    }
    EXPECT_TRUE(is_near_corner);
}

TEST(Placement, ends_when_there_is_no_room)
{
    Random random(4);
    Placement placement(field);
    int placed = 0;
    while (placement.find(box(1.5f, 1.5f), random)) ASSERT_LT(++placed, 200 / 2); // 2.25 m^2 each on 200 m^2
    EXPECT_GT(placed, 20);
    EXPECT_FALSE(placement.find(circle(6), random)); // larger than the field
}

} // namespace carom::scenes
