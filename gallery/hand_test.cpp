#include "gallery/hand.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace carom::gallery
{

namespace
{

/// A scene in a window of 1280 by 720, and a hand over it.
struct Desk
{
    explicit Desk(const char* scene) : session(scene, {}, 1), hand(session, view)
    {
        view.set_layout({1280, 720}, {{0, 0}, {1280, 720}});
        view.set_base(session.scene().camera());
    }

    int bodies() const { return session.scene().world().body_count(); }
    Vec2 at(BodyId body) { return view.to_points(session.scene().world().body(body).position()); }
    /// Some dynamic body in sight.
    BodyId any_body()
    {
        for (const BodyId id : session.scene().world().bodies())
            if (session.scene().world().body(id).type() == BodyType::Dynamic) return id;
        return {};
    }
    void step(int count)
    {
        for (int i = 0; i < count; ++i) session.advance(1 / 60.0);
    }

    Session session;
    View view;
    Hand hand;
};

} // namespace

TEST(Hand, clicks_go_to_the_scene)
{
    Desk desk("planets");
    const int bodies = desk.bodies();
    desk.hand.press(Button::Left, {100, 100}, {});
    desk.hand.release(Button::Left, {100, 100});
    EXPECT_EQ(desk.bodies(), bodies + 1);
    desk.hand.press(Button::Right, {200, 600}, {});
    EXPECT_EQ(desk.bodies(), bodies + 1) << "it may still become a move of the picture";
    desk.hand.release(Button::Right, {201, 600});
    EXPECT_EQ(desk.bodies(), bodies + 2);
}

TEST(Hand, drags_a_body_and_adds_none)
{
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    const int bodies = desk.bodies();
    const Vec2 from = desk.at(body);
    const Vec2 to = {640, 360};
    desk.hand.press(Button::Left, from, {});
    for (int i = 1; i <= 20; ++i)
    {
        desk.hand.move(from + (to - from) * (static_cast<float>(i) / 20));
        desk.step(6);
    }
    desk.step(30);
    EXPECT_EQ(desk.session.scene().world().joint_count(), 1);
    EXPECT_LT(distance(desk.at(body), to), 60);
    desk.hand.release(Button::Left, to);
    EXPECT_EQ(desk.session.scene().world().joint_count(), 0);
    EXPECT_EQ(desk.bodies(), bodies);
}

TEST(Hand, drags_a_body_that_moved_on_before_the_press_became_a_drag)
{
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    const Vec2 from = desk.at(body);
    desk.hand.press(Button::Left, from, {});
    desk.session.scene().world().body(body).set_transform(desk.session.scene().world().body(body).position() + Vec2{0, 300}, 0);
    desk.hand.move(from + Vec2{50, 0});
    EXPECT_EQ(desk.session.scene().world().joint_count(), 1);
    desk.hand.release(Button::Left, {NAN, 0});
    EXPECT_EQ(desk.session.scene().world().joint_count(), 0) << "it lets go wherever that is";
}

TEST(Hand, bears_a_world_that_an_error_stopped)
{
    struct Thrower : StepProbe
    {
        void after_stage(const StepMoment&, const StepView&) override { throw std::runtime_error("no memory"); }
    };
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    const Vec2 at = desk.at(body);
    Thrower thrower;
    EXPECT_THROW(desk.session.scene().step(nullptr, &thrower), std::runtime_error);
    desk.hand.move(at);
    desk.hand.look();
    desk.hand.press(Button::Left, at, {});
    desk.hand.move(at + Vec2{50, 0});
    desk.hand.release(Button::Left, at + Vec2{50, 0});
    desk.step(1);
    EXPECT_NE(desk.session.message().find("Press R"), std::string::npos) << desk.session.message();
    desk.session.picture({}, 20);
    desk.session.restart();
    desk.session.clock().set_paused(false);
    desk.step(1);
    EXPECT_EQ(desk.session.scene().world().step_count(), 1u);
}

TEST(Hand, drops_what_it_holds_when_a_step_is_looked_into)
{
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    desk.hand.press(Button::Left, desk.at(body), {});
    desk.hand.move(desk.at(body) + Vec2{50, 0});
    desk.session.look_inside();
    desk.hand.look();
    EXPECT_EQ(desk.session.scene().world().joint_count(), 0);
    EXPECT_FALSE(desk.hand.is_busy());

    desk.session.leave_inside();
    const int bodies = desk.bodies();
    desk.hand.press(Button::Left, {400, 300}, {.shift = true});
    desk.session.look_inside();
    desk.hand.release(Button::Left, {500, 300});
    EXPECT_EQ(desk.bodies(), bodies) << "nothing is thrown into a step";
}

TEST(Hand, leaves_dragging_to_the_scene_that_does_it_itself)
{
    Desk desk("joints");
    const BodyId body = desk.any_body();
    const int joints = desk.session.scene().world().joint_count();
    desk.hand.press(Button::Left, desk.at(body), {});
    EXPECT_EQ(desk.session.scene().world().joint_count(), joints + 1);
    desk.hand.release(Button::Left, desk.at(body));
    EXPECT_EQ(desk.session.scene().world().joint_count(), joints);
}

TEST(Hand, a_restart_while_a_body_is_held_lets_it_go)
{
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    const Vec2 from = desk.at(body);
    desk.hand.press(Button::Left, from, {});
    desk.hand.move(from + Vec2{50, 0});
    desk.session.restart();
    desk.hand.move(from + Vec2{90, 0});
    desk.hand.release(Button::Left, from + Vec2{90, 0});
    desk.step(5);
    EXPECT_EQ(desk.session.scene().world().joint_count(), 0);
    EXPECT_FALSE(desk.hand.is_busy());
}

TEST(Hand, throws_a_new_body_the_other_way_than_it_was_pulled)
{
    Desk desk("planets");
    const int bodies = desk.bodies();
    desk.hand.press(Button::Left, {640, 90}, {.shift = true});
    desk.hand.move({700, 90});
    desk.hand.release(Button::Left, {700, 90});
    ASSERT_EQ(desk.bodies(), bodies + 1);
    const World& world = desk.session.scene().world();
    EXPECT_LT(world.body(world.bodies().back()).linear_velocity().x, -1);
}

TEST(Hand, picks_a_body_with_ctrl)
{
    Desk desk("collisions");
    const BodyId body = desk.any_body();
    desk.hand.press(Button::Left, desk.at(body), {.ctrl = true});
    EXPECT_EQ(desk.hand.selected(), body);
    desk.hand.release(Button::Left, desk.at(body));
    EXPECT_EQ(desk.hand.selected(), body);
}

TEST(Hand, moves_and_scales_the_picture)
{
    Desk desk("planets");
    const int bodies = desk.bodies();
    const Vec2 grabbed = desk.view.to_world({300, 300});
    desk.hand.press(Button::Right, {300, 300}, {});
    desk.hand.move({340, 310});
    desk.hand.move({400, 250});
    desk.hand.release(Button::Right, {400, 250});
    EXPECT_NEAR(desk.view.to_points(grabbed).x, 400, 0.1f);
    EXPECT_NEAR(desk.view.to_points(grabbed).y, 250, 0.1f);
    EXPECT_EQ(desk.bodies(), bodies) << "no sun is added by a drag";
    desk.hand.wheel(3, {400, 250}, {});
    EXPECT_NEAR(desk.view.to_points(grabbed).x, 400, 0.1f);
    EXPECT_GT(desk.view.zoom(), 1.4f);
}

TEST(Hand, gives_the_wheel_to_the_scene_with_shift)
{
    Desk desk("gravity");
    const float size = desk.session.scene().parameters().real("size");
    desk.hand.wheel(2, {600, 300}, {.shift = true});
    EXPECT_GT(desk.session.scene().parameters().real("size"), size);
    EXPECT_EQ(desk.view.zoom(), 1);
}

TEST(Hand, acts_not_in_a_scene_that_is_looked_into)
{
    Desk desk("planets");
    desk.session.look_inside();
    const int bodies = desk.bodies();
    for (const Button button : {Button::Left, Button::Right})
    {
        desk.hand.press(button, {100, 100}, {});
        desk.hand.release(button, {100, 100});
    }
    EXPECT_EQ(desk.bodies(), bodies);
}

TEST(Hand, takes_places_that_are_no_numbers_or_far_away)
{
    Desk desk("planets");
    const int bodies = desk.bodies();
    for (int i = 0; i < 60; ++i) desk.hand.wheel(-5, {5, 5}, {});
    desk.hand.press(Button::Left, {1e6f, -1e6f}, {});
    desk.hand.move({NAN, 0});
    desk.hand.release(Button::Left, {NAN, 0});
    desk.hand.press(Button::Left, {1e6f, -1e6f}, {.shift = true});
    desk.hand.release(Button::Left, {1e6f, -1e6f});
    desk.step(2);
    EXPECT_LE(desk.bodies(), bodies + 2);
}

} // namespace carom::gallery
