// The list of scenes. A new scene goes in here.
#include "scenes/registry.hpp"

#include "scenes/builtin_scenes.hpp"
#include "scenes/text.hpp"

namespace carom::scenes
{

const std::vector<SceneInfo>& all_scenes()
{
    static const std::vector<SceneInfo> scenes = {planets_scene(),    triggers_scene(),      collisions_scene(),    gravity_scene(),
                                                  queries_scene(),    character_scene(),     chain_terrain_scene(), tiles_scene(),
                                                  one_way_scene(),    bullets_scene(),       sleep_scene(),         bridge_scene(),
                                                  domino_scene(),     newton_cradle_scene(), card_house_scene(),    arch_scene(),
                                                  mass_ratio_scene(), joints_scene(),        ragdolls_scene(),      car_scene()};
    return scenes;
}

const SceneInfo& find_scene(std::string_view name)
{
    std::vector<std::string> names;
    for (const SceneInfo& info : all_scenes())
    {
        if (info.name == name) return info;
        names.push_back(info.name);
    }
    throw SceneError("scene", "\"" + std::string(name) + "\" does not exist", suggestion(name, names));
}

std::unique_ptr<Scene> make_scene(std::string_view name, const ParameterValues& values, std::uint64_t seed)
{
    const SceneInfo& info = find_scene(name);
    Parameters parameters(info.parameters);
    for (const auto& [parameter, value] : values) parameters.set(parameter, value);
    return info.make({info, parameters, seed});
}

std::unique_ptr<Scene> restarted(const Scene& scene) { return scene.info().make({scene.info(), scene.parameters(), scene.seed()}); }

} // namespace carom::scenes
