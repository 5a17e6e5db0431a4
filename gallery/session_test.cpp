#include "gallery/session.hpp"

#include "gallery/moment_words.hpp"
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace carom::gallery
{

namespace
{

using scenes::Layer;

constexpr double frame = 1 / 60.0;

Vec2 first_disc(const scenes::DrawList& list)
{
    for (const scenes::DrawnShape& shape : list.layer(Layer::Bodies).shapes)
        if (std::holds_alternative<Circle>(shape.geometry)) return shape.transform.p;
    ADD_FAILURE() << "no disc";
    return {};
}

} // namespace

TEST(Session, steps_like_a_scene_that_nobody_watches)
{
    Session session("collisions", {}, 3);
    const auto alone = scenes::make_scene("collisions", {}, 3);
    for (int i = 0; i < 60; ++i)
    {
        session.advance(frame);
        session.picture({}, 20);
        alone->step();
    }
    EXPECT_EQ(session.scene().world().hash(), alone->world().hash());
    EXPECT_EQ(session.meter().latest().bodies, alone->world().body_count());
}

TEST(Session, a_look_inside_changes_no_bit_and_ends_where_the_step_ends)
{
    Session session("ragdolls", {}, 1);
    const auto alone = scenes::make_scene("ragdolls", {}, 1);
    for (int i = 0; i < 30; ++i)
    {
        session.advance(frame);
        alone->step();
    }
    session.look_inside();
    alone->step();
    ASSERT_TRUE(session.is_inside());
    EXPECT_EQ(session.scene().world().hash(), alone->world().hash());
    EXPECT_EQ(session.film().step(), alone->world().step_count());
    const Moment& end = session.film().moments().back();
    for (const DebugBody& body : end.bodies)
    {
        const BodyView view = std::as_const(session.scene()).world().body(body.id);
        EXPECT_EQ(body.transform.p, view.position());
        EXPECT_EQ(body.linear_velocity, view.linear_velocity());
    }
    session.advance(10);
    EXPECT_EQ(session.scene().world().hash(), alone->world().hash()) << "it stands still";
}

TEST(Session, walks_through_steps_forwards_and_back)
{
    Session session("card-house", {}, 1);
    session.look_inside();
    const std::uint64_t first = session.film().step();
    const std::size_t last = session.film().moments().size() - 1;
    EXPECT_TRUE(session.film().moments().front().is_start);
    EXPECT_EQ(session.film().moments().size(), 1u + 4 + 5u * 4 + 5);
    session.previous_moment();
    EXPECT_EQ(session.moment(), 0u);
    for (std::size_t i = 0; i < last; ++i) session.next_moment();
    EXPECT_EQ(session.moment(), last);
    session.next_moment();
    EXPECT_EQ(session.film().step(), first + 1);
    EXPECT_EQ(session.moment(), 0u);
    session.previous_moment();
    EXPECT_EQ(session.film().step(), first);
    EXPECT_EQ(session.moment(), last);
    session.next_moment();
    EXPECT_EQ(session.film().step(), first + 1) << "the film is there already: no step is made anew";
    EXPECT_EQ(session.scene().world().step_count(), first + 1);
    EXPECT_EQ(session.film().moments()[7].when.stage, Stage::Solve);
    EXPECT_EQ(session.film().moments()[7].when.substep, 0);
    session.leave_inside();
    EXPECT_FALSE(session.is_inside());
}

TEST(Session, goes_on_from_the_last_step_that_was_looked_into)
{
    Session session("collisions", {}, 1);
    session.advance(frame);
    for (int i = 0; i < 9; ++i) session.look_inside();
    EXPECT_EQ(session.scene().world().step_count(), 10u);
    session.leave_inside();
    session.clock().set_paused(false);
    DrawOptions sharp;
    sharp.is_blended = false;
    const Vec2 end = first_disc(session.picture(sharp, 20));
    session.advance(0.1 * frame);
    const Vec2 shown = first_disc(session.picture({}, 20));
    session.advance(frame);
    const float step = distance(first_disc(session.picture(sharp, 20)), end);
    EXPECT_LT(distance(shown, end), 1.5f * step) << "a step behind at most";
}

TEST(Session, says_something_about_every_moment)
{
    Session session("gravity", {}, 1);
    for (int i = 0; i < 60; ++i) session.advance(frame);
    session.look_inside();
    std::set<std::string> titles;
    for (const Moment& moment : session.film().moments())
    {
        EXPECT_FALSE(explanation_of(moment).empty());
        EXPECT_FALSE(counts_of(moment).empty());
        EXPECT_TRUE(titles.insert(title_of(moment)).second) << title_of(moment);
    }
    EXPECT_EQ(titles.count("solve, substep 4 of 4"), 1u);
}

TEST(Session, shows_motion_between_steps)
{
    Session session("collisions", {}, 1);
    session.advance(frame);
    session.clock().set_speed(0.5);
    const Vec2 at_step = first_disc(session.picture({}, 20));
    session.advance(frame); // half a step is due: the picture goes back to between the last two
    const Vec2 halfway = first_disc(session.picture({}, 20));
    session.advance(frame);
    const Vec2 start = first_disc(session.picture({}, 20));
    EXPECT_NE(start, at_step);
    EXPECT_NE(halfway, at_step);
    DrawOptions sharp;
    sharp.is_blended = false;
    EXPECT_NE(first_disc(session.picture(sharp, 20)), start) << "not blended: as of the last step";
}

TEST(Session, goes_to_neighbours_around_the_list)
{
    const auto& all = catalogue();
    Session session(all.front(), {}, 1);
    session.open_neighbor(-1);
    EXPECT_EQ(session.source().info().name, all.back().info().name);
    session.open_neighbor(1);
    EXPECT_EQ(session.source().info().name, all.front().info().name);
}

TEST(Session, restarts_when_a_parameter_needs_it_and_keeps_it)
{
    Session session("collisions", {}, 5);
    session.set_parameter("circles", std::int64_t{20});
    EXPECT_EQ(session.scene().parameters().integer("circles"), 20);
    EXPECT_EQ(session.seed(), 5u);
    const int bodies = session.scene().world().body_count();
    session.restart();
    EXPECT_EQ(session.scene().world().body_count(), bodies);
    session.restart_with(6);
    EXPECT_EQ(session.seed(), 6u);
    EXPECT_EQ(session.scene().parameters().integer("circles"), 20);
}

TEST(Session, keeps_the_scene_when_a_value_can_not_be_had)
{
    Session session("collisions", {}, 1);
    const int generation = session.generation();
    session.set_parameter("circles", std::int64_t{-4});
    EXPECT_NE(session.message().find("-4"), std::string::npos) << session.message();
    session.open("no-such-scene");
    EXPECT_NE(session.message().find("no-such-scene"), std::string::npos) << session.message();
    EXPECT_EQ(session.generation(), generation);
}

TEST(Session, follows_a_body_between_steps)
{
    Session session("collisions", {}, 1);
    const BodyId body = session.scene().world().bodies().back();
    session.watch(body);
    const Vec2 start = session.scene().world().body(body).position();
    session.advance(frame);
    const Vec2 end = session.scene().world().body(body).position();
    EXPECT_LT(distance(session.watched_place().value(), start), 1e-4f) << "a step is made, and its picture begins where the last one was";
    session.clock().set_speed(0.5);
    session.advance(frame);
    EXPECT_LT(distance(session.watched_place().value(), lerp(start, end, 0.5f)), 1e-4f);
    session.clock().set_paused(true);
    session.advance(frame);
    EXPECT_EQ(session.watched_place().value(), end) << "what stands still is shown as it is";
    session.restart();
    EXPECT_FALSE(session.watched_place());
}

class EverySceneInTheGallery : public testing::TestWithParam<std::string>
{
};

TEST_P(EverySceneInTheGallery, takes_guests_overlays_and_a_look_inside)
{
    Session session(GetParam(), {}, 1);
    for (int i = 0; i < 20; ++i) session.advance(frame);
    scenes::Scene& scene = session.scene();
    const Vec2 top = scene.camera().center + Vec2{0, 0.45f * scene.camera().height};
    const int before = scene.world().body_count();
    const std::optional<BodyId> guest = scene.add_guest({.position = top}, box(0.5f, 0.5f));
    EXPECT_EQ(scene.world().body_count(), before + (guest ? 1 : 0));
    DrawOptions all;
    all.mass_centers = all.contacts = all.impulses = all.joints = all.islands = all.sleep = all.colors = all.velocities = all.names = true;
    for (int i = 0; i < 60; ++i)
    {
        session.advance(frame);
        session.picture(all, scene.camera().height);
    }
    EXPECT_TRUE(session.message().empty()) << session.message();
    session.look_inside();
    ASSERT_TRUE(session.is_inside()) << session.message();
    for (std::size_t i = 0; i < session.film().moments().size(); ++i)
    {
        session.show_moment(i);
        EXPECT_FALSE(session.picture(all, scene.camera().height).layer(Layer::Bodies).shapes.empty());
    }
}

std::vector<std::string> names_of_scenes()
{
    std::vector<std::string> names;
    for (const scenes::SceneInfo& info : scenes::all_scenes()) names.push_back(info.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Gallery, EverySceneInTheGallery, testing::ValuesIn(names_of_scenes()), [](const auto& test)
{
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace carom::gallery
