#include "dynamics/narrow_phase.hpp"

#include "dynamics/dynamics_test.hpp"
#include "dynamics/neighborhood.hpp"
#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::detail::narrow_phase_test
{
namespace
{

/// A box of 1 m on a fixed floor whose top is at y = 0, 1 mm deep.
class NarrowPhaseTest : public testing::Test
{
protected:
    void update() { update_manifolds(touch_passes_of(best_simd()), scene.bodies, scene.shapes, scene.contacts, 0, changes); }
    ContactManifold& manifold() { return scene.contacts.manifolds[slot]; }
    ContactResult result() { return result_of(manifold(), scene.contacts.results[slot]); }

    SmallScene scene;
    std::uint32_t ground = scene.add({.type = BodyType::Static, .position = {0, -0.5f}}, box(10, 1));
    std::uint32_t crate = scene.add({.position = {2, 0.499f}}, box(1, 1));
    std::uint32_t slot = scene.touch(ground, crate);
    ContactChanges changes{scene.memory};
};

TEST_F(NarrowPhaseTest, points_lie_halfway_between_the_surfaces_with_arms_from_both_centers)
{
    update();
    ASSERT_EQ(manifold().count, 2);
    EXPECT_NEAR(manifold().normal.y, 1, 1e-6f) << "from the floor, which is shape A";
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Vec2 position = position_of(manifold(), i);
        EXPECT_NEAR(manifold().separation[i], -0.001f, 1e-5f);
        EXPECT_NEAR(position.y, -0.0005f, 1e-5f);
        EXPECT_NEAR(std::abs(position.x - 2), 0.5f, 1e-5f);
        EXPECT_LT(distance(manifold().arms[i].r_a, position - Vec2{0, -0.5f}), 1e-5f);
        EXPECT_LT(distance(manifold().arms[i].r_b, position - Vec2{2, 0.499f}), 1e-5f);
    }
}

TEST_F(NarrowPhaseTest, impulses_stay_with_the_features_that_made_them)
{
    update();
    manifold().impulses = {ContactImpulse{3, 0}, ContactImpulse{5, 7}};
    manifold().rolling_impulse = 11;
    manifold().carried_impulse = 13;
    const ContactManifold before = manifold();
    scene.place(crate, {{2.01f, 0.4991f}, {}});
    update();
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            if (manifold().features[i] == before.features[j])
            {
                EXPECT_EQ(manifold().impulses[i].normal, before.impulses[j].normal);
                EXPECT_EQ(manifold().impulses[i].tangent, before.impulses[j].tangent);
            }
    EXPECT_EQ(manifold().impulses[0].normal + manifold().impulses[1].normal, 8) << "both features are still there";
    EXPECT_EQ(manifold().rolling_impulse, 11);
    EXPECT_EQ(manifold().carried_impulse, 13);

    // It stands on another face now: other features, and no impulse.
    scene.place(crate, {{2, 0.499f}, rotation(0.5f * pi)});
    update();
    ASSERT_EQ(manifold().count, 2);
    for (const ContactImpulse& impulse : manifold().impulses) EXPECT_EQ(impulse.normal, 0);
}

TEST_F(NarrowPhaseTest, what_loses_its_points_keeps_no_rolling_impulse)
{
    update();
    manifold().rolling_impulse = 11;
    scene.place(crate, {{2, 0.55f}, {}});
    update();
    EXPECT_EQ(manifold().count, 0);
    scene.place(crate, {{2, 0.499f}, {}});
    manifold().rolling_impulse = 0;
    update();
    EXPECT_EQ(manifold().rolling_impulse, 0);
}

TEST_F(NarrowPhaseTest, changes_tell_who_gained_and_lost_points_and_who_parted)
{
    update();
    EXPECT_EQ(changes.gained_points.size(), 1u);
    EXPECT_TRUE(changes.lost_points.empty());
    scene.contacts.contacts[slot].color = 4; // the solver has taken it in
    update();
    EXPECT_TRUE(changes.gained_points.empty()) << "no news";
    scene.place(crate, {{2, 0.55f}, {}});
    update();
    EXPECT_EQ(changes.lost_points.size(), 1u);
    EXPECT_TRUE(changes.separated.empty());
    scene.shapes.bounds[crate].fat = expanded(scene.shapes.bounds[crate].tight, -0.5f);
    scene.shapes.bounds[crate].fat.min.y = 5;
    scene.shapes.bounds[crate].fat.max.y = 6;
    update();
    EXPECT_EQ(changes.separated.size(), 1u);
    EXPECT_TRUE(changes.lost_points.empty()) << "its points are not looked at any more";
}

TEST_F(NarrowPhaseTest, sensors_count_an_overlap_and_never_go_to_the_solver)
{
    const std::uint32_t sensor = scene.add({.type = BodyType::Static, .position = {2, 0.5f}}, circle(0.2f), {.is_sensor = true});
    const std::uint32_t seen = scene.touch(sensor, crate, true);
    update();
    EXPECT_EQ(scene.contacts.manifolds[seen].count, 1);
    EXPECT_EQ(changes.gained_points.size(), 1u) << "the floor's contact alone";
    scene.place(crate, {{2, 1.3f}, {}});
    update();
    EXPECT_EQ(scene.contacts.manifolds[seen].count, 0);
}

TEST_F(NarrowPhaseTest, only_contacts_from_the_first_on_are_looked_at)
{
    update_manifolds(touch_passes_of(best_simd()), scene.bodies, scene.shapes, scene.contacts, 1, changes);
    EXPECT_EQ(manifold().count, 0);
}

TEST_F(NarrowPhaseTest, what_is_remembered_of_shapes_does_not_show)
{
    RandomShapes random(3);
    const std::uint32_t other = scene.add({.position = {3, 0.5f}}, box(0.8f, 1));
    const std::uint32_t beside = scene.touch(crate, other);
    int touching = 0;
    for (int i = 0; i < 400; ++i)
    {
        scene.place(crate,
                    {{2 + random.uniform(-0.05f, 0.05f), 0.5f + random.uniform(-0.01f, 0.05f)}, rotation(random.uniform(-0.1f, 0.1f))});
        scene.place(other, {{2.95f + random.uniform(-0.05f, 0.1f), 0.5f}, rotation(random.uniform(-0.1f, 0.1f))});
        update();
        const std::vector<ContactManifold> now(scene.contacts.manifolds.begin(), scene.contacts.manifolds.end());
        for (CollisionMemory& memory : scene.contacts.memories) memory = {};
        update();
        for (const std::uint32_t contact : {slot, beside})
        {
            const ContactManifold& expected = scene.contacts.manifolds[contact];
            ASSERT_EQ(now[contact].count, expected.count);
            if (expected.count == 0) continue;
            ++touching;
            EXPECT_EQ(now[contact].normal, expected.normal);
            for (std::size_t p = 0; p < static_cast<std::size_t>(expected.count); ++p)
            {
                EXPECT_EQ(now[contact].arms[p].r_a, expected.arms[p].r_a);
                EXPECT_EQ(now[contact].separation[p], expected.separation[p]);
                EXPECT_EQ(now[contact].features[p], expected.features[p]);
            }
        }
    }
    EXPECT_GT(touching, 300);
}

/// Whether the shapes still touch or not.
TEST_F(NarrowPhaseTest, the_result_of_the_last_step_is_gone)
{
    for (const float y : {0.499f, 0.55f})
    {
        scene.place(crate, {{2, 0.499f}, {}});
        update();
        manifold().has_result = true;
        scene.contacts.results[slot] = {
            .totals = {ContactImpulse{3, 3}, ContactImpulse{3, 3}}, .normal_velocity = {3, 3}, .total_rolling = 4};
        ASSERT_EQ(result().total_rolling, 4);
        scene.place(crate, {{2, y}, {}});
        update();
        EXPECT_EQ(manifold().count, y < 0.5f ? 2 : 0);
        for (std::size_t i = 0; i < 2; ++i)
        {
            EXPECT_EQ(result().totals[i].normal + result().totals[i].tangent, 0) << y;
            EXPECT_EQ(result().normal_velocity[i], 0) << y;
        }
        EXPECT_EQ(result().total_rolling, 0) << y;
    }
}

TEST_F(NarrowPhaseTest, two_that_are_near_and_do_not_touch_are_idle_until_they_meet)
{
    const std::uint32_t other = scene.add({.position = {3.1f, 0.499f}}, box(1, 1));
    const std::uint32_t beside = scene.touch(crate, other);
    const auto is_idle = [&](std::uint32_t contact)
    { return scene.contacts.awake_pairs[scene.contacts.contacts[contact].place_in_awake].is_idle; };
    update();
    EXPECT_TRUE(is_idle(beside));
    EXPECT_FALSE(is_idle(slot)) << "it has points";

    scene.place(other, {{2.99f, 0.499f}, {}});
    update();
    EXPECT_EQ(scene.contacts.manifolds[beside].count, 2);
    EXPECT_FALSE(is_idle(beside));
    scene.contacts.contacts[beside].color = 4;
    scene.contacts.contacts[beside].is_touching = true;
    scene.place(other, {{3.1f, 0.499f}, {}});
    update();
    EXPECT_EQ(changes.lost_points.size(), 1u);
    EXPECT_FALSE(is_idle(beside)) << "the solver and the events have yet to be told";
    scene.contacts.contacts[beside].color = no_color;
    scene.contacts.contacts[beside].is_touching = false;
    update();
    EXPECT_TRUE(is_idle(beside));

    scene.shapes.bounds[other].fat = {{5, 5}, {6, 6}};
    update();
    EXPECT_EQ(changes.separated.size(), 1u) << "idle or not, it goes when the fat bounds part";
}

TEST_F(NarrowPhaseTest, what_lies_on_one_piece_of_ground_meets_no_inner_edge)
{
    update();
    EXPECT_FALSE(may_be_filtered(scene.contacts.contacts[slot], scene.bodies));
    const std::uint32_t next_tile = scene.add({.type = BodyType::Static, .position = {2.6f, -0.5f}}, box(1, 1));
    const std::uint32_t other = scene.touch(next_tile, crate);
    update();
    EXPECT_TRUE(may_be_filtered(scene.contacts.contacts[slot], scene.bodies));
    EXPECT_TRUE(may_be_filtered(scene.contacts.contacts[other], scene.bodies));
    scene.contacts.destroy(other, scene.bodies);
    EXPECT_FALSE(may_be_filtered(scene.contacts.contacts[slot], scene.bodies));
}

TEST_F(NarrowPhaseTest, events_are_quiet_while_surfaces_that_touch_stay_together)
{
    Contact& contact = scene.contacts.contacts[slot];
    const auto is_quiet = [&]
    {
        update();
        return scene.contacts.awake_states[contact.place_in_awake].is_quiet;
    };
    EXPECT_FALSE(is_quiet()) << "the contact begins";
    contact.is_touching = true;
    EXPECT_TRUE(is_quiet());
    contact.is_watched = true;
    EXPECT_FALSE(is_quiet()) << "each step is told";
    contact.is_watched = false;
    scene.place(crate, {{2, 0.51f}, {}});
    EXPECT_FALSE(is_quiet()) << "the solver decides whether it ends";
    scene.place(crate, {{2, 0.55f}, {}});
    EXPECT_FALSE(is_quiet()) << "the contact ends";
    contact.is_touching = false;
    EXPECT_TRUE(is_quiet());
}

TEST_F(NarrowPhaseTest, the_impulses_of_the_last_step_are_kept_for_the_end)
{
    scene.contacts.contacts[slot].is_touching = true;
    update();
    manifold().has_result = true;
    scene.contacts.results[slot] = {.totals = {ContactImpulse{3, 1}, ContactImpulse{5, -2}}};
    scene.place(crate, {{2, 0.55f}, {}});
    update();
    EXPECT_EQ(manifold().last.normal, 8);
    EXPECT_EQ(manifold().last.tangent, -1);
    update();
    EXPECT_EQ(manifold().last.normal, 0) << "what the store holds is old";
}

TEST_F(NarrowPhaseTest, contacts_beyond_one_block_are_updated_in_their_order)
{
    std::vector<std::uint32_t> expected = {slot};
    for (int i = 0; i < 100; ++i)
    {
        const std::uint32_t body = scene.add({.position = {-4.5f + 0.05f * static_cast<float>(i), i % 3 == 0 ? 0.7f : 0.499f}}, box(1, 1));
        const std::uint32_t contact = scene.touch(ground, body);
        if (i % 3 != 0) expected.push_back(contact);
    }
    update();
    EXPECT_EQ(std::vector<std::uint32_t>(changes.gained_points.begin(), changes.gained_points.end()), expected);
}

/// A box of 10 cm that is 1 cm deep in a tile and 4 mm over the seam to the next one, whose hidden side pushes back.
TEST_F(NarrowPhaseTest, what_is_known_of_faces_minds_a_tile_beside_them)
{
    for (const bool are_two_tiles : {true, false})
    {
        const std::uint32_t tile = scene.add({.type = BodyType::Static, .position = {20, -0.5f}}, box(1, 1));
        const std::uint32_t next = scene.add({.type = BodyType::Static, .position = {21, -0.5f}}, box(1, 1));
        const std::uint32_t slider = scene.add({.position = {20.454f, 0.04f}}, box(0.1f, 0.1f));
        const std::uint32_t seam = scene.touch(next, slider);
        const std::uint32_t top = are_two_tiles ? scene.touch(tile, slider) : scene.touch(ground, crate);
        update();
        ASSERT_TRUE(scene.contacts.memories[seam].has_face_pair && scene.contacts.memories[top].has_face_pair);
        const ContactManifold before = scene.contacts.manifolds[seam];
        const bool is_pushed_back = before.count > 0 && before.normal.x < -0.9f;
        EXPECT_EQ(is_pushed_back, !are_two_tiles) << "alone, the tile has no hidden side";
        for (const std::uint32_t contact : {seam, top}) scene.contacts.contacts[contact].color = 0; // as the solver would have
        update();
        EXPECT_EQ(scene.contacts.manifolds[seam].count, before.count);
        EXPECT_EQ(scene.contacts.manifolds[seam].normal, before.normal);
    }
}

TEST_F(NarrowPhaseTest, forgetting_leaves_the_points_without_impulses)
{
    update();
    manifold().impulses = {ContactImpulse{3, 0}, ContactImpulse{0, 3}};
    manifold().carried_impulse = manifold().rolling_impulse = 4;
    forget_impulses(manifold());
    EXPECT_EQ(manifold().count, 2);
    EXPECT_EQ(manifold().impulses[0].normal + manifold().impulses[1].tangent, 0);
    EXPECT_EQ(manifold().carried_impulse + manifold().rolling_impulse, 0);
}

} // namespace
} // namespace carom::detail::narrow_phase_test
