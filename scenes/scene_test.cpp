// What holds for every scene.
#include "scenes/helpers.hpp"
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace carom::scenes
{

namespace
{

std::vector<std::string> scene_names()
{
    std::vector<std::string> names;
    for (const SceneInfo& info : all_scenes()) names.push_back(info.name);
    return names;
}

std::uint64_t hash_after(Scene& scene, int steps)
{
    step(scene, steps);
    return scene.world().hash();
}

std::size_t drawn_things(const Scene& scene)
{
    DrawList list;
    scene.draw(list);
    std::size_t count = 0;
    for (const DrawnLayer& layer : list.layers()) count += layer.shapes.size() + layer.lines.size() + layer.texts.size();
    return count;
}

/// All that a person could notice of a scene.
struct Look
{
    std::uint64_t world_hash = 0;
    ParameterValues parameters;
    std::vector<float> places; ///< of the camera, and of what is drawn
    std::vector<Color> colors;
    std::string words;

    friend bool operator==(const Look&, const Look&) = default;
};

Look looks(const Scene& scene)
{
    const Camera& camera = scene.camera();
    Look look{scene.world().hash(), scene.parameters().values(), {camera.center.x, camera.center.y, camera.height}, {}, {}};
    DrawList list;
    scene.draw(list);
    for (const DrawnLayer& layer : list.layers())
    {
        for (const DrawnShape& shape : layer.shapes)
        {
            look.places.insert(look.places.end(), {shape.transform.p.x, shape.transform.p.y, shape.transform.q.c, shape.transform.q.s});
            look.colors.insert(look.colors.end(), {shape.paint.fill, shape.paint.line});
        }
        for (const DrawnLine& line : layer.lines) look.places.insert(look.places.end(), {line.from.x, line.from.y, line.to.x, line.to.y});
        for (const DrawnText& text : layer.texts) look.words += text.text + "\n";
    }
    return look;
}

/// Whether a key makes a difference within a second: to the world, a parameter, the camera or the picture.
/// @param twin the same scene, in which it is not pressed
/// @param before pressed in both, before they are stepped; may be empty
bool key_differs(Scene& scene, Scene& twin, int steps, const std::string& before, const std::string& key)
{
    for (Scene* each : {&scene, &twin})
    {
        each->key(before);
        step(*each, steps);
    }
    EXPECT_EQ(looks(scene), looks(twin));
    scene.key(key);
    for (int i = 0; i < 60; ++i)
    {
        if (looks(scene) != looks(twin)) return true;
        scene.step();
        twin.step();
    }
    return looks(scene) != looks(twin);
}

class EveryScene : public testing::TestWithParam<std::string>
{
protected:
    std::unique_ptr<Scene> make(std::uint64_t seed = 1) const { return make_scene(GetParam(), {}, seed); }
};

/// A test's name takes no dash.
std::string test_name(const testing::TestParamInfo<std::string>& scene)
{
    std::string name = scene.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryScene, testing::ValuesIn(scene_names()), test_name);

} // namespace

TEST_P(EveryScene, equal_seeds_give_equal_runs)
{
    EXPECT_EQ(hash_after(*make(), 60), hash_after(*make(), 60));
    EXPECT_NE(hash_after(*make(1), 1), hash_after(*make(2), 1));
}

TEST_P(EveryScene, the_broad_phase_does_not_show)
{
    const auto hash_with = [&](BroadPhaseType type)
    { return hash_after(*make_scene(GetParam(), {{"broad_phase", std::string(name_of(type))}}), 60); };
    const std::uint64_t expected = hash_with(BroadPhaseType::BruteForce);
    for (const BroadPhaseType type : all_broad_phases) EXPECT_EQ(hash_with(type), expected) << name_of(type);
}

TEST_P(EveryScene, the_broad_phase_can_change_while_it_runs)
{
    const auto scene = make();
    for (const BroadPhaseType type : all_broad_phases)
    {
        scene->set_parameter("broad_phase", std::string(name_of(type)));
        EXPECT_EQ(scene->world().broad_phase(), type);
        step(*scene, 10);
    }
    EXPECT_EQ(scene->world().hash(), hash_after(*make(), 10 * static_cast<int>(all_broad_phases.size())));
}

TEST_P(EveryScene, drawing_changes_nothing)
{
    const auto drawn = make();
    for (int i = 0; i < 30; ++i)
    {
        drawn->step();
        EXPECT_GT(drawn_things(*drawn), 0u);
    }
    EXPECT_EQ(drawn->world().hash(), hash_after(*make(), 30));
}

TEST_P(EveryScene, is_alive_without_input_unless_it_is_calm)
{
    const auto scene = make();
    std::vector<BodyId> movable = scene->world().bodies();
    std::erase_if(movable, [&](BodyId id) { return scene->world().body(id).type() == BodyType::Static; });
    const std::vector<float> ways = farthest_ways(*scene, movable, 300);
    const auto farther_than = [&](float way) { return std::count_if(ways.begin(), ways.end(), [&](float w) { return w > way; }); };
    if (scene->info().is_calm)
    {
        EXPECT_EQ(farther_than(0.02f), 0);
        return;
    }
    // More than 20 bodies go somewhere within five seconds; or, in a scene of fewer, a third of those that do not sleep: a cradle of five balls
    // swings the first and the last, a bridge only gives way, and what a car will come to waits asleep.
    std::ptrdiff_t active = 0;
    for (std::size_t i = 0; i < movable.size(); ++i)
    {
        const auto body = scene->world().find_body(movable[i]);
        active += ways[i] > 0.5f || (body && body->is_awake());
    }
    EXPECT_GE(farther_than(0.5f), std::clamp<std::ptrdiff_t>((active + 2) / 3, 2, 21)) << "of " << active;
}

TEST_P(EveryScene, restarts_with_the_parameters_that_it_has)
{
    const auto scene = make(7);
    scene->set_parameter("substeps", 2);
    step(*scene, 20);
    const auto again = restarted(*scene);
    EXPECT_EQ(again->seed(), 7u);
    EXPECT_EQ(again->parameters().integer("substeps"), 2);
    EXPECT_EQ(again->world().step_count(), 0u);
    EXPECT_EQ(hash_after(*again, 20), scene->world().hash());
}

/// A key may have no effect on what it has brought about already, as the one that walks to the right while the figure does: so it is tried
/// early and late, and after each other key.
TEST_P(EveryScene, every_key_does_something)
{
    std::vector<std::string> keys;
    for (const Control& control : make()->info().controls)
        if (control.kind == Control::Kind::Key) keys.push_back(control.input);
    for (const std::string& key : keys)
    {
        bool has_effect = key_differs(*make(), *make(), 30, "", key) || key_differs(*make(), *make(), 240, "", key);
        for (std::size_t i = 0; i < keys.size() && !has_effect; ++i) has_effect = key_differs(*make(), *make(), 30, keys[i], key);
        EXPECT_TRUE(has_effect) << key;
    }
}

TEST_P(EveryScene, stands_every_key_again_and_again)
{
    const auto scene = make();
    for (int round = 0; round < 30; ++round)
    {
        for (const Control& control : scene->info().controls)
        {
            if (control.kind == Control::Kind::Key) scene->key(control.input);
            scene->step();
            ASSERT_LE(scene->world().body_count(), max_bodies);
        }
        EXPECT_GT(drawn_things(*scene), 0u);
    }
    for (const BodyId id : scene->world().bodies()) EXPECT_TRUE(is_finite(scene->world().body(id).position()));
}

TEST_P(EveryScene, ignores_keys_that_no_control_names)
{
    const auto scene = make();
    const Look before = looks(*scene);
    scene->key("no such key");
    scene->key("");
    EXPECT_EQ(looks(*scene), before);
    EXPECT_EQ(hash_after(*scene, 10), hash_after(*make(), 10));
}

TEST_P(EveryScene, positions_that_are_not_sound_are_ignored)
{
    const auto scene = make();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const int bodies = scene->world().body_count();
    for (const Vec2 place : {Vec2{nan, 0}, {0, nan}, {infinity, 0}, {0, -infinity}, {1e30f, 1e30f}, {-5e5f, 0}})
    {
        for (const auto action :
             {PointerEvent::Action::Move, PointerEvent::Action::Down, PointerEvent::Action::Up, PointerEvent::Action::Wheel})
            scene->pointer({action, PointerEvent::Button::Left, place, 1});
    }
    scene->pointer({PointerEvent::Action::Wheel, PointerEvent::Button::None, {}, nan});
    EXPECT_EQ(scene->world().body_count(), bodies);
    EXPECT_EQ(hash_after(*scene, 10), hash_after(*make(), 10));
}

TEST_P(EveryScene, thousands_of_clicks_at_one_place_do_not_pile_up)
{
    const auto scene = make();
    const int bodies = scene->world().body_count();
    int one_more = bodies + 1; // body, or doll of several
    for (int i = 0; i < 5000; ++i)
    {
        click(*scene, {2, 7}, i % 2 == 0 ? PointerEvent::Button::Left : PointerEvent::Button::Middle);
        if (i == 0) one_more = std::max(one_more, scene->world().body_count());
    }
    EXPECT_LE(scene->world().body_count(), one_more);
    step(*scene, 5);
}

TEST_P(EveryScene, survives_random_pointer_and_keys)
{
    const auto scene = make();
    Random random(5);
    const std::vector<Control>& controls = scene->info().controls;
    for (int i = 0; i < 3000; ++i)
    {
        const auto action = static_cast<PointerEvent::Action>(random.integer(0, 3));
        const auto button = static_cast<PointerEvent::Button>(random.integer(0, 3));
        const Vec2 place = random.point_in({{-90, -60}, {90, 60}});
        scene->pointer({action, button, place, random.uniform(-20, 20)});
        const Control& control = controls[static_cast<std::size_t>(random.integer(0, static_cast<int>(controls.size()) - 1))];
        if (i % 50 == 0) scene->key(control.input);
        if (i % 10 == 0) scene->step();
    }
    EXPECT_LE(scene->world().body_count(), max_bodies);
    EXPECT_GT(drawn_things(*scene), 0u);
}

TEST_P(EveryScene, live_parameters_take_their_extremes_while_it_runs)
{
    for (const ParameterInfo& info : make()->info().parameters)
    {
        if (info.applies != Applies::Live) continue;
        const auto scene = make();
        std::vector<ParameterValue> values(info.choices.begin(), info.choices.end());
        if (info.kind == ParameterKind::Boolean) values = {true, false};
        if (info.kind == ParameterKind::Integer || info.kind == ParameterKind::Real) values = {info.min, info.max};
        for (const ParameterValue& value : values)
        {
            scene->set_parameter(info.name, value);
            EXPECT_NO_THROW(step(*scene, 3)) << info.name << "=" << to_text(value);
        }
    }
}

TEST_P(EveryScene, starts_at_the_least_value_of_every_parameter)
{
    for (const ParameterInfo& info : make()->info().parameters)
    {
        if (info.kind != ParameterKind::Integer && info.kind != ParameterKind::Real) continue;
        const auto scene = make_scene(GetParam(), {{info.name, info.min}});
        EXPECT_NO_THROW(step(*scene, 3)) << info.name;
    }
}

TEST_P(EveryScene, says_whether_it_drags_bodies)
{
    const auto scene = make();
    step(*scene, 2);
    const int joints = scene->world().joint_count();
    const auto grabs = [&](BodyId id)
    {
        const Vec2 place = scene->world().body(id).center_of_mass();
        if (scene->world().body(id).type() != BodyType::Dynamic || !shape_at(scene->world(), place)) return false;
        scene->pointer({PointerEvent::Action::Down, PointerEvent::Button::Left, place});
        return scene->world().joint_count() > joints;
    };
    const std::vector<BodyId> bodies = scene->world().bodies();
    EXPECT_EQ(std::any_of(bodies.begin(), bodies.end(), grabs), scene->info().drags_bodies);
}

TEST_P(EveryScene, takes_guests)
{
    const auto scene = make();
    const int bodies = scene->world().body_count();
    const Vec2 top = scene->camera().center + Vec2{0, 0.45f * scene->camera().height};
    const std::optional<BodyId> guest = scene->add_guest({.position = top}, circle(0.1f));
    ASSERT_EQ(scene->world().body_count(), bodies + (guest ? 1 : 0));
    step(*scene, 60);
    DrawList list;
    scene->draw(list);
    if (!guest || !scene->world().find_body(*guest)) return;
    const Vec2 place = scene->world().body(*guest).position();
    const auto& shapes = list.layer(Layer::Bodies).shapes;
    EXPECT_TRUE(std::any_of(shapes.begin(), shapes.end(), [&](const DrawnShape& shape) { return shape.transform.p == place; }));
    EXPECT_THROW(scene->add_guest({.position = {NAN, 0}}, circle(0.1f)), UsageError);
}

TEST_P(EveryScene, explains_itself)
{
    const SceneInfo& info = make()->info();
    EXPECT_FALSE(info.title.empty());
    EXPECT_FALSE(info.description.empty());
    EXPECT_FALSE(info.group.empty());
    for (const Control& control : info.controls) EXPECT_FALSE(control.input.empty() || control.action.empty());
    for (const ParameterInfo& parameter : info.parameters)
    {
        EXPECT_FALSE(parameter.description.empty()) << parameter.name;
        EXPECT_EQ(checked(parameter, parameter.initial), parameter.initial) << parameter.name;
    }
}

TEST(Registry, names_the_scene_that_was_meant)
{
    try
    {
        make_scene("colisions");
        FAIL() << "no error";
    }
    catch (const SceneError& error)
    {
        EXPECT_STREQ(error.what(), "scene: \"colisions\" does not exist; did you mean collisions?");
    }
    EXPECT_THROW(make_scene("planets", {{"planet", 3}}), SceneError);
}

TEST(PerShape, starts_afresh_for_a_new_shape_in_an_old_place)
{
    PerShape<int> values;
    const ShapeId first{3, 1, 1};
    const ShapeId second{3, 2, 1};
    values[first] = 5;
    EXPECT_EQ(*values.find(first), 5);
    EXPECT_EQ(values.find(second), nullptr);
    EXPECT_EQ(values[second], 0);
    EXPECT_EQ(values.find(first), nullptr);
}

} // namespace carom::scenes
