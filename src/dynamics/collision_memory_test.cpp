#include "dynamics/body_store.hpp"
#include "dynamics/collision_memory.hpp"
#include "geometry/isa/touch_passes.hpp"
#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

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

/// A contact of two bodies, and what the passes over known faces are given of it.
struct KnownContact
{
    std::array<BodyPose, 2> poses;
    CollisionMemory memory;
    FacePair<float> face_pair;
    LocalManifold expected;
};

KnownContact moved_contact(RandomShapes& random, const Pair& pair)
{
    KnownContact contact;
    FaceSearch search;
    collide_with(pair.a, pair.b, pair.b_in_a, search);
    contact.memory = remember(search, {pair.a, extent_of(pair.a)}, {pair.b, extent_of(pair.b)}, pair.b_in_a);
    contact.memory.has_face_pair = contact.memory.result == CollisionMemory::Result::Faces && face_each_other(search);
    if (!contact.memory.has_face_pair) return contact;
    contact.face_pair = facing_faces(pair.a, pair.b, search).pair;
    contact.memory.features = facing_faces(pair.a, pair.b, search).features;
    const float reach = std::pow(10.0f, random.uniform(-4, -1));
    const Transform a = {random.point(10), rotation(random.uniform(-pi, pi))};
    const Transform b_in_a = {pair.b_in_a.p + random.point(reach), rotation(random.uniform(-1, 1) * reach) * pair.b_in_a.q};
    const Vec2 middle_a = extent_of(pair.a).middle;
    const Vec2 middle_b = extent_of(pair.b).middle;
    contact.poses = {BodyPose{a, a * middle_a, middle_a}, BodyPose{a * b_in_a, a * b_in_a * middle_b, middle_b}};
    const Transform seen = relative(contact.poses[0].transform, contact.poses[1].transform);
    contact.expected = collide_with(pair.a, pair.b, seen, search = {});
    return contact;
}

/// How often each outcome came up.
struct Outcomes
{
    int one_point = 0;
    int two_points = 0;
    int reference_is_b = 0;
    int unknown = 0;
};

void expect_row(const KnownContact& contact, const TouchResults& results, std::size_t i, Outcomes& outcomes)
{
    const auto is_set = [&](std::uint64_t mask) { return (mask >> i & 1) != 0; };
    if (!is_set(results.are_known))
    {
        ++outcomes.unknown;
        return;
    }
    const bool has_two = is_set(results.have_lower & results.have_upper);
    const bool is_swapped = is_set(results.references_are_b ^ ~results.have_lower);
    ++(has_two ? outcomes.two_points : outcomes.one_point);
    outcomes.reference_is_b += is_set(results.references_are_b) ? 1 : 0;

    const BodyPose& a = contact.poses[0];
    const BodyPose& b = contact.poses[1];
    const TouchRow& row = results.rows[i];
    ASSERT_EQ(contact.expected.count, has_two ? 2 : 1);
    EXPECT_EQ((Vec2{row.normal[0], row.normal[1]}), rotate(a.transform.q, contact.expected.normal));
    for (std::size_t p = 0; p < (has_two ? 2u : 1u); ++p)
    {
        const LocalPoint& point = contact.expected.points[p];
        const Vec2 r_a = rotate(a.transform.q, point.position - a.local_center);
        EXPECT_EQ((Vec2{row.arms[4 * p], row.arms[4 * p + 1]}), r_a);
        EXPECT_EQ((Vec2{row.arms[4 * p + 2], row.arms[4 * p + 3]}), r_a - (b.center - a.center));
        EXPECT_EQ(row.separation[p], point.separation);
        EXPECT_EQ(contact.memory.features[is_swapped ? 1 - p : p], point.feature);
    }
}

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

TEST(KnownFaces, every_instruction_set_gives_the_contact_of_a_new_search_to_the_bit)
{
    RandomShapes random(2);
    std::vector<KnownContact> contacts;
    while (contacts.size() < 20000)
    {
        const KnownContact contact = moved_contact(random, Pair(random, random.integer(1, 3), random.integer(1, 3)));
        if (contact.memory.has_face_pair) contacts.push_back(contact);
    }
    for (const Simd simd : all_simd)
    {
        if (!is_available(simd)) continue;
        Outcomes outcomes;
        for (std::size_t first = 0; first < contacts.size();)
        {
            const std::size_t count = std::min(static_cast<std::size_t>(random.integer(1, touch_batch)), contacts.size() - first);
            std::vector<BodyPose> poses;
            std::vector<CollisionMemory> memories;
            std::vector<FacePair<float>> face_pairs;
            TouchBatch batch;
            batch.count = count;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                const KnownContact& contact = contacts[first + i];
                poses.insert(poses.end(), contact.poses.begin(), contact.poses.end());
                memories.push_back(contact.memory);
                face_pairs.push_back(contact.face_pair);
                batch.contacts[i] = i;
                batch.bodies_a[i] = 2 * i;
                batch.bodies_b[i] = 2 * i + 1;
            }
            batch.poses = &poses[0].transform.p.x;
            batch.searches = &memories[0].made_at.p.x;
            batch.search_stride = sizeof(CollisionMemory) / sizeof(float);
            batch.face_pairs = &face_pairs[0].a_v1.x;
            batch.limits = touch_limits(tolerances.speculative_distance, tolerances);
            TouchResults results;
            touch_passes_of(simd).touch(batch, results);
            for (std::size_t i = 0; i < count; ++i) expect_row(contacts[first + i], results, i, outcomes);
            if (HasFailure()) FAIL() << name_of(simd) << ", contacts from " << first;
            first += count;
        }
        EXPECT_GT(outcomes.one_point, 2000);
        EXPECT_GT(outcomes.two_points, 4000);
        EXPECT_GT(outcomes.reference_is_b, 1000);
        EXPECT_GT(outcomes.unknown, 1000) << "what it can't give is left to collide()";
    }
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
