#include "dynamics/collision_memory.hpp"

#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <array>

namespace carom::detail
{

namespace
{

constexpr Tolerances tolerances;

LocalManifold collide_with(const Geometry& a, const Geometry& b, const Transform& b_in_a, FaceSearch& search)
{
    return collide(a, b, b_in_a, tolerances.speculative_distance, tolerances, search);
}

CollisionMemory remembered(const Geometry& a, const Geometry& b, const Transform& b_in_a)
{
    FaceSearch search;
    collide_with(a, b, b_in_a, search);
    return remember(search, {a, extent_of(a)}, {b, extent_of(b)}, b_in_a);
}

LocalManifold collide_from_memory(const CollisionMemory& memory, const Geometry& a, const Geometry& b, const Transform& b_in_a)
{
    if (memory.result == CollisionMemory::Result::Gap) return {};
    FaceSearch search = known_faces(memory);
    return collide_with(a, b, b_in_a, search);
}

void expect_same_bits(const LocalManifold& manifold, const LocalManifold& expected)
{
    ASSERT_EQ(manifold.count, expected.count);
    if (manifold.count == 0) return;
    EXPECT_EQ(manifold.normal, expected.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
    {
        EXPECT_EQ(manifold.points[i].position, expected.points[i].position);
        EXPECT_EQ(manifold.points[i].separation, expected.points[i].separation);
        EXPECT_EQ(manifold.points[i].feature, expected.points[i].feature);
    }
}

/// Two shapes of a pair of types at random, brought together until their middles are as far apart as they are large, more or less.
struct Pair
{
    Geometry a;
    Geometry b;
    Transform b_in_a;

    Pair(RandomShapes& random, int type_a, int type_b)
    {
        a = random.geometry_of(type_a, random.uniform(0.2f, 2));
        b = random.geometry_of(type_b, random.uniform(0.2f, 2));
        const float together = extent_of(a).outer + extent_of(b).outer;
        const Rot direction = rotation(random.uniform(-pi, pi));
        b_in_a.q = rotation(random.uniform(-pi, pi));
        const Vec2 apart = rotate(direction, {random.uniform(0.2f, 1.2f) * together, 0});
        b_in_a.p = extent_of(a).middle + apart - rotate(b_in_a.q, extent_of(b).middle);
    }
};

} // namespace

TEST(CollisionMemory, what_holds_gives_the_contact_of_a_new_search_to_the_bit)
{
    RandomShapes random(1);
    std::array<int, 3> held = {};
    int broken = 0;
    for (int trial = 0; trial < 40000; ++trial)
    {
        const Pair pair(random, random.integer(0, 3), random.integer(0, 3));
        const CollisionMemory memory = remembered(pair.a, pair.b, pair.b_in_a);
        const float reach = std::pow(10.0f, random.uniform(-4, 0));
        for (int i = 0; i < 8; ++i)
        {
            Transform now = {pair.b_in_a.p + random.point(reach), rotation(random.uniform(-1, 1) * reach) * pair.b_in_a.q};
            if (!holds(memory, now))
            {
                broken += memory.result != CollisionMemory::Result::Nothing ? 1 : 0;
                continue;
            }
            ++held[static_cast<std::size_t>(memory.result)];
            FaceSearch search;
            expect_same_bits(collide_from_memory(memory, pair.a, pair.b, now), collide_with(pair.a, pair.b, now, search));
            if (HasFailure()) FAIL() << "trial " << trial << ", types " << pair.a.index() << " and " << pair.b.index();
        }
    }
    EXPECT_GT(held[static_cast<std::size_t>(CollisionMemory::Result::Gap)], 20000);
    EXPECT_GT(held[static_cast<std::size_t>(CollisionMemory::Result::Faces)], 20000);
    EXPECT_GT(broken, 20000) << "large motions end a memory";
}

TEST(CollisionMemory, a_gap_holds_until_it_is_used_up)
{
    const Geometry a = box(1, 1);
    const Geometry b = box(1, 1);
    const float gap = 0.1f;
    const float start = 1 + tolerances.speculative_distance + gap;
    const CollisionMemory memory = remembered(a, b, {{start, 0}, {}});
    EXPECT_TRUE(holds(memory, {{start - 0.99f * gap, 0}, {}}));
    EXPECT_FALSE(holds(memory, {{start - 1.01f * gap, 0}, {}}));
    const float corner = std::sqrt(0.5f);
    EXPECT_TRUE(holds(memory, {{start, 0}, rotation(0.9f * gap / corner)}));
    EXPECT_FALSE(holds(memory, {{start, 0}, rotation(1.02f * gap / corner)}));
}

TEST(CollisionMemory, a_disc_may_turn_in_its_place)
{
    const CollisionMemory memory = remembered(box(10, 1), circle(0.5f), {{0, 1.1f}, {}});
    EXPECT_TRUE(holds(memory, {{0, 1.1f}, rotation(3)}));
    EXPECT_FALSE(holds(memory, {{0, 1.0f}, {}}));
}

TEST(CollisionMemory, faces_of_boxes_that_lie_on_each_other_hold_for_a_good_part_of_their_size)
{
    const CollisionMemory memory = remembered(box(1, 1), box(1, 1), {{0.1f, 0.999f}, {}});
    EXPECT_TRUE(holds(memory, {{0.2f, 1.01f}, rotation(0.05f)}));
    EXPECT_FALSE(holds(memory, {{1, 0.999f}, {}}));
    EXPECT_FALSE(holds(memory, {{0.1f, 0.999f}, rotation(0.8f)}));
}

TEST(CollisionMemory, circles_that_touch_leave_none)
{
    EXPECT_FALSE(holds(remembered(circle(1), circle(1), {{1.9f, 0}, {}}), {{1.9f, 0}, {}}));
}

} // namespace carom::detail
