// Which events a world tells, when, in which order, and with which ids.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

namespace carom
{

namespace
{

/// A world without gravity: what touches, touches because it was put there.
class EventsTest : public testing::Test
{
protected:
    World world{{.gravity = {}}};

    ShapeId put(BodyType type, Vec2 position, const ShapeDef& def = {}, float radius = 0.5f)
    {
        return world.body(world.create_body({.type = type, .position = position}, circle(radius), def)).shapes()[0];
    }
    Body body_of(ShapeId shape) { return world.body(world.shape(shape).body()); }
    Events step()
    {
        world.step(dt);
        return world.events();
    }
    /// Two discs that overlap slightly and have begun to touch.
    std::pair<ShapeId, ShapeId> touching_pair(const ShapeDef& def = {.persist_events = true})
    {
        const ShapeId a = put(BodyType::Static, {0, 0}, def);
        const ShapeId b = put(BodyType::Dynamic, {0.99f, 0}, def);
        EXPECT_EQ(step().contact_begin.size(), 1u);
        return {a, b};
    }
    void expect_quiet(const Events& events)
    {
        EXPECT_TRUE(events.contact_begin.empty());
        EXPECT_TRUE(events.contact_persist.empty());
        EXPECT_TRUE(events.contact_end.empty());
        EXPECT_TRUE(events.sensor_begin.empty());
        EXPECT_TRUE(events.sensor_persist.empty());
        EXPECT_TRUE(events.sensor_end.empty());
    }
    void expect_one_contact_end(const Events& events, ShapeId a, ShapeId b)
    {
        ASSERT_EQ(events.contact_end.size(), 1u);
        EXPECT_EQ(events.contact_end[0].shape_a, a);
        EXPECT_EQ(events.contact_end[0].shape_b, b);
        EXPECT_TRUE(events.contact_persist.empty());
    }
};

/// A sensor and a visitor in it, told as begun.
class SensorTest : public EventsTest
{
protected:
    ShapeId sensor = put(BodyType::Static, {0, 0}, {.is_sensor = true, .persist_events = true});
    ShapeId visitor = put(BodyType::Dynamic, {0.5f, 0});

    void SetUp() override
    {
        const Events events = step();
        ASSERT_EQ(events.sensor_begin.size(), 1u);
        EXPECT_EQ(events.sensor_begin[0].sensor, sensor);
        EXPECT_EQ(events.sensor_begin[0].visitor, visitor);
        EXPECT_TRUE(events.contact_begin.empty());
    }
    void expect_one_end(const Events& events)
    {
        ASSERT_EQ(events.sensor_end.size(), 1u);
        EXPECT_EQ(events.sensor_end[0].sensor, sensor);
        EXPECT_EQ(events.sensor_end[0].visitor, visitor);
        EXPECT_TRUE(events.sensor_persist.empty());
    }
};

} // namespace

TEST_F(EventsTest, AContactBeginsPersistsAndEndsOnce)
{
    const auto [a, b] = touching_pair();
    EXPECT_EQ(world.events().contact_begin[0].shape_a, a);
    EXPECT_EQ(world.events().contact_begin[0].shape_b, b);
    EXPECT_EQ(world.events().contact_begin[0].manifold.point_count, 1);
    EXPECT_GT(world.events().contact_begin[0].manifold.normal.x, 0.9f) << "from A to B";
    EXPECT_EQ(step().contact_persist.size(), 1u);
    EXPECT_TRUE(world.events().contact_begin.empty());

    body_of(b).set_linear_velocity({30, 0});
    int ends = 0;
    for (int i = 0; i < 10; ++i) ends += static_cast<int>(step().contact_end.size());
    EXPECT_EQ(ends, 1);
    expect_quiet(step());
}

TEST_F(EventsTest, NearIsNotTouching)
{
    put(BodyType::Static, {0, 0});
    const ShapeId b = put(BodyType::Dynamic, {1.004f, 0});
    expect_quiet(step());
    EXPECT_TRUE(world.shape(b).touching().empty());
}

TEST_F(EventsTest, ADestroyedShapeEndsItsContactInTheNextStepUnderItsOldId)
{
    const auto [a, b] = touching_pair();
    world.destroy_shape(b);
    const ShapeId next = put(BodyType::Dynamic, {50, 0}); // takes the place
    EXPECT_EQ(next.index, b.index);
    expect_one_contact_end(step(), a, b);
    EXPECT_FALSE(world.find_shape(world.events().contact_end[0].shape_b));
    expect_quiet(step());
}

TEST_F(EventsTest, DestroyingBothEndsTheContactOnce)
{
    for (const bool a_first : {false, true})
    {
        const auto [a, b] = touching_pair();
        const BodyId body_a = world.shape(a).body();
        const BodyId body_b = world.shape(b).body();
        world.destroy_body(a_first ? body_a : body_b);
        world.destroy_body(a_first ? body_b : body_a);
        expect_one_contact_end(step(), a, b);
        expect_quiet(step());
    }
}

TEST_F(EventsTest, DisablingEndsAndEnablingBegins)
{
    const auto [a, b] = touching_pair();
    body_of(a).set_enabled(false);
    EXPECT_TRUE(world.shape(b).touching().empty());
    expect_one_contact_end(step(), a, b);
    expect_quiet(step());
    body_of(a).set_enabled(true);
    EXPECT_EQ(step().contact_begin.size(), 1u);
}

TEST_F(EventsTest, AnEditThatIsTakenBackEndsAndBeginsInOneStep)
{
    const auto [a, b] = touching_pair();
    body_of(a).set_enabled(false);
    body_of(a).set_enabled(true);
    expect_one_contact_end(step(), a, b);
    EXPECT_EQ(world.events().contact_begin.size(), 1u);
    EXPECT_EQ(step().contact_persist.size(), 1u);
}

TEST_F(EventsTest, TeleportingAwayEndsAndBackBegins)
{
    const auto [a, b] = touching_pair();
    body_of(b).set_transform({100, 0}, 0);
    expect_one_contact_end(step(), a, b);
    body_of(b).set_transform({0.99f, 0}, 0);
    EXPECT_EQ(step().contact_begin.size(), 1u);
    EXPECT_TRUE(world.events().contact_end.empty());
}

TEST_F(EventsTest, ATeleportedStaticBodyTouchesWhatItLandsOn)
{
    const ShapeId wall = put(BodyType::Static, {100, 0});
    const ShapeId ball = put(BodyType::Dynamic, {0, 0});
    expect_quiet(step());
    body_of(wall).set_transform({0.99f, 0}, 0);
    EXPECT_EQ(step().contact_begin.size(), 1u);
    EXPECT_EQ(world.shape(ball).touching(), std::vector{wall});
}

TEST_F(EventsTest, AFilterThatForbidsEndsAndOneThatAllowsBegins)
{
    const auto [a, b] = touching_pair();
    world.shape(b).set_filter({.mask = 0});
    expect_one_contact_end(step(), a, b);
    expect_quiet(step());
    world.shape(b).set_filter({});
    EXPECT_EQ(step().contact_begin.size(), 1u);
}

TEST_F(EventsTest, AFilterThatStillAllowsIsNoNews)
{
    const auto [a, b] = touching_pair();
    world.shape(b).set_filter({.category = 2});
    EXPECT_EQ(step().contact_persist.size(), 1u);
    EXPECT_TRUE(world.events().contact_end.empty());
}

TEST_F(EventsTest, AGeometryThatNoLongerReachesEnds)
{
    const auto [a, b] = touching_pair();
    world.shape(b).set_geometry(circle(0.1f));
    expect_one_contact_end(step(), a, b);
    world.shape(b).set_geometry(circle(0.5f));
    EXPECT_EQ(step().contact_begin.size(), 1u);
}

TEST_F(EventsTest, ATypeThatDoesNotMeetEnds)
{
    const auto [a, b] = touching_pair();
    body_of(b).set_type(BodyType::Kinematic);
    expect_one_contact_end(step(), a, b);
    expect_quiet(step());
    body_of(b).set_type(BodyType::Dynamic);
    EXPECT_EQ(step().contact_begin.size(), 1u);
}

TEST_F(EventsTest, EventsComeWhenEitherShapeAsks)
{
    for (const bool first : {false, true})
        for (const bool second : {false, true})
        {
            World own({.gravity = {}});
            own.create_body({.type = BodyType::Static}, circle(0.5f), {.contact_events = first, .persist_events = second});
            own.create_body({.position = {0.99f, 0}}, circle(0.5f), {.contact_events = second, .persist_events = first});
            own.step(dt);
            EXPECT_EQ(own.events().contact_begin.empty(), !(first || second));
            own.step(dt);
            EXPECT_EQ(own.events().contact_persist.empty(), !(first || second));
            own.destroy_body(own.bodies()[0]);
            own.step(dt);
            EXPECT_EQ(own.events().contact_end.empty(), !(first || second));
        }
}

TEST_F(EventsTest, AStepOfNoTimeTellsEventsToo)
{
    const ShapeId a = put(BodyType::Static, {0, 0});
    const ShapeId b = put(BodyType::Dynamic, {0.9f, 0});
    EXPECT_EQ(world.step(0).contacts, 1);
    EXPECT_EQ(world.events().contact_begin.size(), 1u);
    EXPECT_FLOAT_EQ(world.shape(b).bounds().min.x, 0.4f);
    world.destroy_shape(a);
    world.step(0);
    EXPECT_EQ(world.events().contact_end.size(), 1u);
}

TEST_F(EventsTest, ListsAreOrderedAndAPileTellsEachPairOnce)
{
    World pile;
    pile.create_body({.type = BodyType::Static, .position = {0, -1}}, box(40, 2), {.persist_events = true});
    pile.create_body({.type = BodyType::Static}, box(5, 5), {.is_sensor = true, .persist_events = true});
    std::set<std::pair<ShapeId, ShapeId>> told;
    std::set<std::pair<ShapeId, ShapeId>> inside;
    std::size_t most = 0;
    std::size_t slept = 0;
    std::size_t woke = 0;
    for (int i = 0; i < 900; ++i)
    {
        if (i < 60) pile.create_body({.position = {static_cast<float>(i % 5) - 2, 5}}, box(0.7f, 0.7f), {.persist_events = i % 2 == 0});
        const bool is_calm = i > 150 && i < 800; // long enough for all to fall asleep
        if (i > 60 && i % 5 == 0 && !is_calm && pile.body_count() > 20)
            pile.destroy_body(pile.bodies()[static_cast<std::size_t>(2 + i % 7)]);
        pile.step(dt);
        const Events events = pile.events();
        const auto contact_order = [](const auto& l, const auto& r)
        { return std::tie(l.shape_a, l.shape_b) < std::tie(r.shape_a, r.shape_b); };
        EXPECT_TRUE(std::is_sorted(events.contact_begin.begin(), events.contact_begin.end(), contact_order));
        EXPECT_TRUE(std::is_sorted(events.contact_persist.begin(), events.contact_persist.end(), contact_order));
        EXPECT_TRUE(std::is_sorted(events.contact_end.begin(), events.contact_end.end(), contact_order));
        for (const ContactEnd& end : events.contact_end)
            ASSERT_EQ(told.erase({end.shape_a, end.shape_b}), 1u) << "ended without a beginning";
        for (const ContactPersist& event : events.contact_persist) ASSERT_TRUE(told.contains({event.shape_a, event.shape_b}));
        for (const ContactBegin& event : events.contact_begin)
        {
            ASSERT_LT(event.shape_a.index, event.shape_b.index);
            ASSERT_TRUE(told.emplace(event.shape_a, event.shape_b).second) << "began twice";
        }
        most = std::max(most, told.size());
        for (const SensorEvent& end : events.sensor_end) ASSERT_EQ(inside.erase({end.sensor, end.visitor}), 1u);
        for (const SensorEvent& event : events.sensor_begin) ASSERT_TRUE(inside.emplace(event.sensor, event.visitor).second);
        slept += events.fell_asleep.size();
        woke += events.woke.size();
        // Sleepers do not persist; who fell asleep in this step was still awake when it was told.
        const std::set<BodyId> to_sleep(events.fell_asleep.begin(), events.fell_asleep.end());
        const auto was_awake = [&](const auto& pair)
        {
            const BodyId body = pile.shape(pair.second).body();
            return pile.body(body).is_awake() || to_sleep.contains(body);
        };
        ASSERT_EQ(events.sensor_persist.size() + events.sensor_begin.size(),
                  static_cast<std::size_t>(std::ranges::count_if(inside, was_awake)));
        for (const auto& [a, b] : told) ASSERT_TRUE(std::ranges::count(pile.shape(a).touching(), b) == 1);
    }
    EXPECT_GT(most, 40u) << "a pile";
    EXPECT_GT(slept, 30u) << "nearly all that are left";
    EXPECT_GT(woke, 0u);
}

TEST_F(SensorTest, AnOverlapPersistsAndEnds)
{
    EXPECT_EQ(step().sensor_persist.size(), 1u);
    body_of(visitor).set_transform({50, 0}, 0);
    expect_one_end(step());
    expect_quiet(step());
}

TEST_F(SensorTest, PushesNothing)
{
    for (int i = 0; i < 10; ++i) step();
    EXPECT_EQ(body_of(visitor).position(), (Vec2{0.5f, 0}));
    EXPECT_EQ(world.manifold(sensor, visitor).point_count, 0);
    EXPECT_EQ(world.shape(sensor).touching(), std::vector{visitor});
}

TEST_F(SensorTest, AnOverlapEndsByDestroyingEitherSide)
{
    world.destroy_shape(visitor);
    expect_one_end(step());
    visitor = put(BodyType::Dynamic, {0.5f, 0});
    EXPECT_EQ(step().sensor_begin.size(), 1u);
    world.destroy_body(world.shape(sensor).body());
    expect_one_end(step());
    expect_quiet(step());
}

TEST_F(SensorTest, AnOverlapEndsByDisablingAndByAFilter)
{
    body_of(sensor).set_enabled(false);
    expect_one_end(step());
    body_of(sensor).set_enabled(true);
    EXPECT_EQ(step().sensor_begin.size(), 1u);
    world.shape(visitor).set_filter({.mask = 0});
    expect_one_end(step());
}

TEST_F(SensorTest, SeesKinematicBodiesAndNoStaticOnes)
{
    const ShapeId kinematic = put(BodyType::Kinematic, {-0.5f, 0.3f});
    put(BodyType::Static, {-0.6f, -0.3f});
    const Events events = step();
    ASSERT_EQ(events.sensor_begin.size(), 1u);
    EXPECT_EQ(events.sensor_begin[0].visitor, kinematic);
    EXPECT_TRUE(events.contact_begin.empty());
}

TEST_F(SensorTest, DoesNotSeeShapesThatDoNotWantToBeSeen)
{
    put(BodyType::Dynamic, {-5, 0}, {.sensor_events = false});
    const ShapeId shy = put(BodyType::Dynamic, {0, 0.6f}, {.sensor_events = false});
    EXPECT_TRUE(step().sensor_begin.empty());
    EXPECT_TRUE(std::ranges::count(world.shape(sensor).touching(), shy) == 0);
}

TEST_F(SensorTest, TwoSensorsMakeTwoEventsEachWay)
{
    const ShapeId other = put(BodyType::Kinematic, {-0.9f, 0}, {.is_sensor = true});
    const Events begin = step();
    ASSERT_EQ(begin.sensor_begin.size(), 2u);
    EXPECT_EQ(begin.sensor_begin[0].sensor, sensor) << "ordered by sensor";
    EXPECT_EQ(begin.sensor_begin[0].visitor, other);
    EXPECT_EQ(begin.sensor_begin[1].sensor, other);
    EXPECT_EQ(begin.sensor_begin[1].visitor, sensor);
    world.destroy_shape(other);
    EXPECT_EQ(step().sensor_end.size(), 2u);
}

TEST_F(EventsTest, hits_are_told_of_a_contact_that_was_there_when_they_were_asked_for)
{
    const auto [a, b] = touching_pair();
    const auto strike = [&]
    {
        step(); // a contact that was hitting goes on doing so
        body_of(b).set_linear_velocity({-5, 0});
        return step().contact_hit.size();
    };
    EXPECT_EQ(strike(), 0u);
    world.shape(a).set_hit_events(true);
    EXPECT_EQ(strike(), 1u);
    world.shape(b).set_hit_events(true);
    world.shape(a).set_hit_events(false);
    EXPECT_EQ(strike(), 1u) << "the other shape asks";
    world.shape(b).set_hit_events(false);
    EXPECT_EQ(strike(), 0u);
}

} // namespace carom
