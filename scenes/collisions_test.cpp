// The collision scene: its cover, energy, colours, freezing.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace carom::scenes
{

namespace
{

double kinetic_energy(const World& world)
{
    double energy = 0;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        const MassData mass = body.mass_data();
        const float spin = body.angular_velocity();
        energy += 0.5 * static_cast<double>(mass.mass * length_squared(body.linear_velocity()) + mass.inertia * spin * spin);
    }
    return energy;
}

double covered_area(const World& world)
{
    double area = 0;
    for (const BodyId id : world.bodies()) area += static_cast<double>(world.body(id).mass_data().mass); // density 1 kg/m^2
    return area;
}

} // namespace

TEST(Collisions, covers_the_field_as_asked)
{
    const auto scene = make_scene("collisions", {{"cover", 20}});
    const double height = static_cast<double>(scene->camera().height) / 1.04; // 2% of the field stand on each side
    EXPECT_NEAR(covered_area(scene->world()) / (height * height * 31 / 18), 0.20, 0.001);
    EXPECT_EQ(scene->world().body_count(), 1001);
    EXPECT_EQ(scene->world().shape_count(), 1004);
}

TEST(Collisions, no_bodies_touch_at_the_start)
{
    const auto scene = make_scene("collisions", {{"speed", 0}});
    const StepReport report = scene->step();
    EXPECT_EQ(report.contacts, 0);
    EXPECT_EQ(report.rows, 0);
}

// In a field so sparse that a body rarely meets two others in one step, which is where the solver loses or gains some.
TEST(Collisions, keeps_its_energy)
{
    const auto scene = make_scene("collisions", {{"circles", 100}, {"boxes", 100}, {"cover", 2}});
    const double before = kinetic_energy(scene->world());
    std::size_t contacts = 0;
    for (int i = 0; i < 1000; ++i)
    {
        scene->step();
        contacts += scene->world().events().contact_begin.size();
    }
    EXPECT_GT(contacts, 300u);
    EXPECT_NEAR(kinetic_energy(scene->world()) / before, 1, 0.05);
}

TEST(Collisions, finds_room_at_the_highest_cover)
{
    for (const auto& [circles, boxes] : {std::pair(100, 100), std::pair(500, 500), std::pair(800, 0), std::pair(0, 800)})
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
        {
            const auto scene = make_scene("collisions", {{"circles", circles}, {"boxes", boxes}, {"cover", 60}}, seed);
            EXPECT_EQ(scene->world().body_count(), circles + boxes + 1);
        }
    EXPECT_THROW(make_scene("collisions", {{"cover", 61}}), SceneError);
}

TEST(Collisions, says_when_there_is_no_room)
{
    try
    {
        make_scene("collisions", {{"circles", 20}, {"boxes", 20}, {"cover", 60}}, 1);
        FAIL() << "no error";
    }
    catch (const SceneError& error)
    {
        EXPECT_STREQ(error.what(), "cover: 60 % leaves no room to place 40 shapes apart; give less, or another seed");
    }
}

TEST(Collisions, goes_on_after_freezing_as_if_nothing_had_happened)
{
    const auto frozen = make_scene("collisions");
    const auto free = make_scene("collisions");
    for (int i = 0; i < 100; ++i)
    {
        frozen->step();
        free->step();
    }
    const Vec2 place = frozen->world().body(frozen->world().bodies().back()).position();
    frozen->key("f");
    for (int i = 0; i < 20; ++i) frozen->step();
    EXPECT_EQ(frozen->world().body(frozen->world().bodies().back()).position(), place);
    frozen->key("F");
    for (int i = 0; i < 100; ++i)
    {
        frozen->step();
        free->step();
    }
    const BodyId last = frozen->world().bodies().back();
    EXPECT_NEAR(distance(frozen->world().body(last).position(), free->world().body(free->world().bodies().back()).position()), 0, 0.5);
}

TEST(Collisions, two_that_meet_take_one_colour)
{
    const auto scene = make_scene("collisions", {{"circles", 300}, {"boxes", 0}});
    while (scene->world().events().contact_begin.empty()) scene->step();
    const ContactBegin contact = scene->world().events().contact_begin.back();
    DrawList list;
    scene->draw(list);
    const auto color_at = [&](ShapeId shape)
    {
        const Vec2 place = scene->world().body(scene->world().shape(shape).body()).position();
        for (const DrawnShape& drawn : list.layer(Layer::Bodies).shapes)
        {
            if (drawn.transform.p == place) return drawn.paint.fill;
        }
        return Color{};
    };
    EXPECT_NE(color_at(contact.shape_a), Color{});
    EXPECT_EQ(color_at(contact.shape_a), color_at(contact.shape_b));
    EXPECT_FALSE(list.layer(Layer::Marks).shapes.empty());
}

TEST(Collisions, adds_bodies_only_between_the_walls)
{
    const auto scene = make_scene("collisions", {{"circles", 0}, {"boxes", 0}});
    click(*scene, {1000, 0});
    EXPECT_EQ(scene->world().body_count(), 1);
    click(*scene, {1, 0});
    EXPECT_EQ(scene->world().body_count(), 2);
}

} // namespace carom::scenes
