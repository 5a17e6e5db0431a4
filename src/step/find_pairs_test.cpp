// Which pairs of near shapes are contacts, whatever was edited since the last search.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace carom
{
namespace
{

/// Allows all that filters allow. A world with hooks judges every pair in each search.
struct AllMayMeet final : ContactHooks
{
};

/// Discs that fly about in a box, and edits that make and unmake pairs of shapes that stay near each other.
class Crowd
{
public:
    explicit Crowd(ContactHooks* hooks) : world({.gravity = {0, 0}, .sleep = {.is_enabled = false}, .hooks = hooks})
    {
        const BodyId walls = world.create_body({.type = BodyType::Static});
        for (const float side : {-4.0f, 4.0f})
        {
            world.create_shape(walls, offset_box(8, 0.4f, {0, side}));
            world.create_shape(walls, offset_box(0.4f, 8, {side, 0}));
        }
        for (int i = 0; i < 60; ++i) add();
    }

    void edit()
    {
        const BodyId body = bodies[random() % bodies.size()];
        const BodyId other = bodies[random() % bodies.size()];
        const ShapeId shape = world.body(body).shapes().front();
        switch (random() % 9)
        {
        case 0: world.shape(shape).set_filter({.category = 1 + random() % 3, .mask = 1 + random() % 3}); break;
        case 1: world.shape(shape).set_filter({}); break;
        case 2: world.body(body).set_enabled(!world.body(body).is_enabled()); break;
        case 3: world.body(body).set_type(random() % 2 == 0 ? BodyType::Static : BodyType::Dynamic); break;
        case 4: world.body(body).set_type(BodyType::Dynamic); break;
        case 5:
            if (body != other) joints.push_back(world.create_joint({.body_a = body, .body_b = other}, MotorJoint{}));
            break;
        case 6:
            if (!joints.empty()) world.destroy_joint(joints.back()), joints.pop_back();
            break;
        case 7: world.body(body).set_transform(place(), 0); break;
        default:
            world.destroy_body(body);
            std::erase(bodies, body);
            std::erase_if(joints, [&](JointId joint) { return !world.find_joint(joint); });
            add();
        }
    }

    World world;

private:
    float number(float most) { return most * (static_cast<float>(random() % 2001) / 1000 - 1); }
    Vec2 place() { return {number(3.5f), number(3.5f)}; }
    void add() { bodies.push_back(world.create_body({.position = place(), .linear_velocity = {number(4), number(4)}}, circle(0.4f))); }

    std::mt19937 random{3};
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
};

TEST(FindPairs, edits_between_searches_leave_the_contacts_of_a_search_that_judges_every_pair)
{
    AllMayMeet hooks;
    Crowd quick(nullptr);
    Crowd thorough(&hooks);
    for (int i = 0; i < 400; ++i)
    {
        for (int k = 0; k < i % 4; ++k) quick.edit(), thorough.edit();
        const StepReport report = quick.world.step(1 / 60.0f);
        ASSERT_EQ(report.pairs, thorough.world.step(1 / 60.0f).pairs) << i;
        ASSERT_EQ(quick.world.hash(), thorough.world.hash()) << i;
    }
}

TEST(FindPairs, a_world_whose_hooks_go_finds_the_pairs_that_they_refused)
{
    struct NoneMayMeet final : ContactHooks
    {
        bool should_collide(ShapeId, ShapeId) override { return false; }
    } hooks;
    World world({.gravity = {0, 0}, .hooks = &hooks});
    world.create_body({.linear_velocity = {0.01f, 0}}, circle(0.5f));
    world.create_body({.position = {0.9f, 0}, .linear_velocity = {1, 0}}, circle(0.5f));
    EXPECT_EQ(world.step(1 / 60.0f).pairs, 0);
    world.set_hooks(nullptr);
    World copy = world.copy();
    int pairs = 0;
    for (int i = 0; i < 6; ++i) pairs += world.step(1 / 60.0f).pairs;
    EXPECT_GT(pairs, 0) << "asked again when the second has moved";
    EXPECT_GT(copy.step(1 / 20.0f).pairs + copy.step(1 / 20.0f).pairs, 0);
}

} // namespace
} // namespace carom
