#include "dynamics/walks.hpp"

#include "dynamics/dynamics_test.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace carom::detail
{
namespace
{

TEST(Walks, SeeTheShapesOfABodyAndNoOthers)
{
    SmallScene scene;
    const std::uint32_t body = scene.add({}, box(1, 1));
    scene.add({}, box(2, 2));
    const std::uint32_t second = scene.add_shape(body, circle(1));
    std::set<std::uint32_t> seen;
    for (const std::uint32_t shape : shapes_of(scene.bodies, scene.shapes, body)) seen.insert(shape);
    EXPECT_EQ(seen, (std::set<std::uint32_t>{body, second}));
}

TEST(Walks, ALoopMayEndTheContactsThatItSees)
{
    SmallScene scene;
    std::vector<std::uint32_t> discs;
    for (int i = 0; i < 5; ++i) discs.push_back(scene.add({}, circle(1)));
    for (const std::uint32_t a : discs)
        for (const std::uint32_t b : discs)
            if (a < b) scene.touch(a, b);

    std::set<std::uint32_t> others;
    for (const Tie contact : contacts_of(scene.bodies, scene.contacts, discs[2]))
    {
        others.insert(contact.other);
        scene.contacts.destroy(contact.slot, scene.bodies);
    }
    EXPECT_EQ(others, (std::set<std::uint32_t>{discs[0], discs[1], discs[3], discs[4]}));
    EXPECT_EQ(scene.bodies.records[discs[2]].first_contact, null_index);
    EXPECT_EQ(scene.contacts.slots.live_count(), 6);
    for (const Tie contact : contacts_of(scene.bodies, scene.contacts, discs[0])) EXPECT_NE(contact.other, discs[2]);
}

TEST(Walks, AJointTiesToTheOtherBodyOrToTheWorld)
{
    SmallScene scene;
    JointStore joints(scene.memory);
    const std::uint32_t a = scene.add({}, circle(1));
    const std::uint32_t b = scene.add({}, circle(1));
    Joint joint;
    joint.body_a = a;
    joint.body_b = b;
    const std::uint32_t between = joints.create(joint, scene.bodies);
    joint.body_a = null_index;
    const std::uint32_t to_world = joints.create(joint, scene.bodies);
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (const Tie tie : joints_of(scene.bodies, joints, b)) seen.insert({tie.slot, tie.other});
    EXPECT_EQ(seen, (std::set<std::pair<std::uint32_t, std::uint32_t>>{{between, a}, {to_world, null_index}}));
}

} // namespace
} // namespace carom::detail
