// The suites, made of the field's scenes.
#include "lab/suites.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace carom::lab
{

namespace
{

constexpr QualityTraits settles = {.rests = true, .is_closed = true};
constexpr QualityTraits stands = {.rests = true, .stands = true};
constexpr QualityTraits stirs = {.is_closed = true};
constexpr QualityTraits bounces = {.keeps_energy = true, .is_closed = true};
constexpr QualityTraits floats = {.keeps_momentum = true};
constexpr QualityTraits shoots = {.has_shots = true};

/// What should hold in a scene, by its name or by that without the size; nothing in those that are not here.
QualityTraits traits_of_scene(const std::string& name)
{
    static const std::map<std::string, QualityTraits> traits = {
        {"large_pyramid", stands}, {"many_pyramids", stands}, {"stack_20", stands}, {"spinner", stirs},
        {"tumbler", stirs},        {"washer", stirs},         {"mixed", settles},   {"origin", bounces},
        {"orbits", floats},        {"compounds", stirs},      {"shots", shoots},    {"sleep_piles", stands},
    };
    const auto exact = traits.find(name);
    if (exact != traits.end()) return exact->second;
    const auto family = traits.find(name.substr(0, name.find_last_of('_')));
    return family != traits.end() ? family->second : QualityTraits{};
}

SuiteScene measured(const FieldScene& scene, int size, int steps)
{
    return {.name = scene.name, .scene = &scene, .size = size, .steps = steps, .traits = traits_of_scene(scene.name)};
}

Suite suite_of_field(const std::string& name, const std::string& what)
{
    Suite suite{.name = name, .what = what, .scenes = {}};
    for (const FieldScene& scene : field_scenes())
        if (scene.suite == name) suite.scenes.push_back(measured(scene, scene.size.initial, scene.steps));
    return suite;
}

Suite joined(const std::string& name, const std::string& what, const std::vector<Suite>& parts)
{
    Suite suite{.name = name, .what = what, .scenes = {}};
    for (const Suite& part : parts) suite.scenes.insert(suite.scenes.end(), part.scenes.begin(), part.scenes.end());
    return suite;
}

/// Some scenes of each kind, small and short: for every day.
Suite quick_suite()
{
    struct Small
    {
        const char* scene;
        int size;
        int steps;
    };
    constexpr Small chosen[] = {{"large_pyramid", 30, 200}, {"joint_grid", 30, 200},  {"tumbler", 20, 300},      {"spinner", 800, 200},
                                {"rain", 20, 200},          {"mixed_200", 200, 400},  {"origin_500", 500, 200},  {"stack_20", 20, 300},
                                {"ragdolls_20", 20, 300},   {"rays_1000", 1000, 100}, {"spawn_destroy", 4, 300}, {"shots", 240, 60}};
    Suite suite{.name = "quick", .what = "some scenes of each kind, small and short", .scenes = {}};
    for (const Small& small : chosen) suite.scenes.push_back(measured(*find_field_scene(small.scene), small.size, small.steps));
    return suite;
}

} // namespace

SceneFile SuiteScene::make() const
{
    SceneFile file = make_field_scene(*scene, {.size = size, .seed = 1});
    file.steps = steps;
    return file;
}

const QualityTraits& Suite::traits_of(const std::string& scene) const
{
    const auto place = std::find_if(scenes.begin(), scenes.end(), [&](const SuiteScene& one) { return one.name == scene; });
    if (place == scenes.end()) throw std::invalid_argument("suite " + name + " has no scene " + scene);
    return place->traits;
}

Suite Suite::with_scenes(const std::vector<std::string>& names) const
{
    Suite some{.name = name, .what = what, .scenes = {}};
    for (const std::string& wanted : names)
    {
        const auto place = std::find_if(scenes.begin(), scenes.end(), [&](const SuiteScene& one) { return one.name == wanted; });
        if (place != scenes.end())
        {
            some.scenes.push_back(*place);
            continue;
        }
        std::string all;
        for (const SuiteScene& one : scenes) all += (all.empty() ? "" : ", ") + one.name;
        throw std::invalid_argument("suite " + name + " has no scene \"" + wanted + "\"; give some of " + all);
    }
    return some;
}

std::span<const Suite> suites()
{
    static const std::vector<Suite> all = []
    {
        std::vector<Suite> parts = {suite_of_field("box2d", "the benchmark scenes of Box2D 3's kind"),
                                    suite_of_field("ordinary", "what games do every day"),
                                    suite_of_field("origin", "the collision scene of the engine that Carom began as"),
                                    suite_of_field("nbody", "gravity between bodies")};
        parts.push_back(joined("full", "all of these", parts));
        parts.push_back(quick_suite());
        return parts;
    }();
    return all;
}

const Suite& find_suite(const std::string& name)
{
    std::string names;
    for (const Suite& suite : suites())
    {
        if (suite.name == name) return suite;
        names += (names.empty() ? "" : ", ") + suite.name;
    }
    throw std::invalid_argument("suite \"" + name + "\" is not known; give one of " + names);
}

int body_count(const SceneFile& file)
{
    std::size_t count = file.bodies.size();
    for (const FileEvent& event : file.events) count += event.create_bodies.size();
    return static_cast<int>(count);
}

} // namespace carom::lab
