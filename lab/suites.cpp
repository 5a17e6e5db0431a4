// The suites, made of the field's scenes.
#include "lab/suites.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace carom::lab
{

namespace
{

constexpr QualityTraits traits_with(bool rests, bool stands, bool keeps_energy, bool keeps_momentum, bool is_closed)
{
    return {.rests = rests, .stands = stands, .keeps_energy = keeps_energy, .keeps_momentum = keeps_momentum, .is_closed = is_closed};
}

constexpr QualityTraits settles = traits_with(true, false, false, false, true);
constexpr QualityTraits stands = traits_with(true, true, false, false, false);
constexpr QualityTraits stirs = traits_with(false, false, false, false, true);
constexpr QualityTraits bounces = traits_with(false, false, true, false, true);
constexpr QualityTraits floats = traits_with(false, false, false, true, false);

/// What should hold in a scene, by its name or by that without the size; nothing in those that are not here.
QualityTraits traits_of_scene(const std::string& name)
{
    static const std::map<std::string, QualityTraits> traits = {
        {"large_pyramid", stands}, {"many_pyramids", stands}, {"stack_20", stands}, {"spinner", stirs}, {"tumbler", stirs},
        {"washer", stirs},         {"mixed", settles},        {"origin", bounces},  {"orbits", floats}, {"compounds", stirs},
    };
    const auto exact = traits.find(name);
    if (exact != traits.end()) return exact->second;
    const auto family = traits.find(name.substr(0, name.find_last_of('_')));
    return family != traits.end() ? family->second : QualityTraits{};
}

SuiteScene in_full(const FieldScene& scene)
{
    return {.name = scene.name, .scene = &scene, .size = scene.size.initial, .steps = scene.steps, .traits = traits_of_scene(scene.name)};
}

Suite suite_of_field(const std::string& name, const std::string& what)
{
    Suite suite{.name = name, .what = what, .scenes = {}};
    for (const FieldScene& scene : field_scenes())
        if (scene.suite == name) suite.scenes.push_back(in_full(scene));
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
    constexpr Small chosen[] = {{"large_pyramid", 30, 200}, {"joint_grid", 30, 200}, {"tumbler", 20, 300},
                                {"spinner", 800, 200},      {"rain", 20, 200},       {"mixed_200", 200, 400},
                                {"origin_500", 500, 200},   {"stack_20", 20, 300},   {"ragdolls_20", 20, 300}};
    Suite suite{.name = "quick", .what = "some scenes of each kind, small and short", .scenes = {}};
    for (const Small& small : chosen)
    {
        const FieldScene* const scene = find_field_scene(small.scene);
        suite.scenes.push_back(
            {.name = scene->name, .scene = scene, .size = small.size, .steps = small.steps, .traits = traits_of_scene(scene->name)});
    }
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

std::span<const Suite> suites()
{
    static const std::vector<Suite> all = {suite_of_field("box2d", "Box2D 3's own ten benchmark scenes"),
                                           suite_of_field("ordinary", "what games do every day"),
                                           suite_of_field("origin", "the collision scene of the engine that Carom began as"),
                                           suite_of_field("nbody", "gravity between bodies"), quick_suite()};
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
