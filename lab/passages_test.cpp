#include "lab/passages.hpp"

#include <gtest/gtest.h>

namespace carom::lab
{

namespace
{

/// A ball at the left of a wall that is 10 cm thick, and where they are put.
class PassagesTest : public testing::Test
{
protected:
    void put_ball(Vec2 place, float angle = 0) { world_.body(ball_).set_transform(place, angle); }
    void look()
    {
        world_.step(0);
        passages_.look(world_, step_++);
    }

    World world_{WorldDef{.gravity = {}}};
    BodyId wall_ = world_.create_body({.type = BodyType::Kinematic});
    BodyId ball_ = world_.create_body({.position = {-1, 0}});
    ShapeId wall_shape_ = world_.create_shape(wall_, box(0.1f, 4));
    ShapeId ball_shape_ = world_.create_shape(ball_, circle(0.2f));
    Passages passages_;
    int step_ = 1;
};

} // namespace

TEST_F(PassagesTest, a_ball_that_jumps_over_a_wall_went_through_it_once)
{
    look();
    EXPECT_FALSE(passages_.count()) << "nothing is known of one moment";
    put_ball({1, 0});
    look();
    EXPECT_EQ(passages_.count(), 1);
    put_ball({-1, 0});
    look();
    EXPECT_EQ(passages_.count(), 1) << "two bodies count once";
}

TEST_F(PassagesTest, a_ball_that_stops_at_the_wall_or_goes_around_it_did_not)
{
    look();
    put_ball({-0.1f, 0}); // deep in it, but its centre is outside
    look();
    put_ball({-1, 3});
    look();
    put_ball({1, 3});
    look();
    EXPECT_EQ(passages_.count(), 0);
}

TEST_F(PassagesTest, a_wall_that_moves_over_a_ball_is_gone_through_too)
{
    look();
    world_.body(wall_).set_transform({-2, 0}, 0);
    look();
    EXPECT_EQ(passages_.count(), 1);
}

TEST_F(PassagesTest, a_ball_that_moves_with_the_wall_did_not)
{
    look();
    world_.body(wall_).set_transform({-2, 0}, 0);
    put_ball({-3, 0});
    look();
    EXPECT_EQ(passages_.count(), 0);
}

TEST_F(PassagesTest, a_wall_that_is_flung_round_beside_a_ball_was_not_gone_through)
{
    look();
    world_.body(wall_).set_transform({0, 0}, pi); // by half a turn, which the ball beside it does not see
    look();
    EXPECT_EQ(passages_.count(), 0);
}

TEST_F(PassagesTest, what_can_not_collide_and_what_is_not_known_step_by_step_does_not_count)
{
    world_.shape(wall_shape_).set_filter({.category = 2, .mask = 0});
    look();
    put_ball({1, 0});
    look();
    EXPECT_EQ(passages_.count(), 0);

    world_.shape(wall_shape_).set_filter({});
    Passages far_apart;
    far_apart.look(world_, 10);
    put_ball({-1, 0});
    world_.step(0);
    far_apart.look(world_, 20);
    EXPECT_FALSE(far_apart.count());
}

} // namespace carom::lab
