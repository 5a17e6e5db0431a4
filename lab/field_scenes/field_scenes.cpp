// The list of scenes. A new one goes in here.
#include "lab/field_scenes/field_scenes.hpp"

#include "lab/field_scenes/makers.hpp"
#include "scene_file/check.hpp"

#include <algorithm>

namespace carom::lab
{

namespace
{

std::vector<FieldScene> box2d_suite()
{
    return {
        {"compounds", "box2d", "Bodies of several shapes each pile up in a box.", {1, 900, 10000, "bodies"}, 500, compounds},
        {"joint_grid",
         "box2d",
         "A net of circles on revolute joints hangs from its middle.",
         {2, 100, 300, "circles a side"},
         500,
         joint_grid},
        {"junkyard", "box2d", "A pusher goes to and fro through loose polygons.", {1, 5000, 20000, "polygons"}, 800, junkyard},
        {"large_pyramid", "box2d", "One pyramid of boxes, which stands.", {1, 100, 300, "rows"}, 500, large_pyramid},
        {"many_pyramids",
         "box2d",
         "Small pyramids of 55 boxes each, on shelves.",
         {1, 20, 60, "shelves, and pyramids a shelf"},
         200,
         many_pyramids},
        {"rain",
         "box2d",
         "Ragdolls rain on uneven ground; the oldest go and new ones come.",
         {1, 40, 100, "columns of 25 ragdolls"},
         1000,
         rain},
        {"sleep_piles", "box2d", "Pyramids of 55 boxes fall asleep, and some of them are woken.", {1, 100, 400, "pyramids"}, 600, sleep},
        {"smash",
         "box2d",
         "A heavy box flies into a block of sleeping squares.",
         {1, 80, 200, "rows; half as many columns again"},
         300,
         smash},
        {"spinner", "box2d", "A beam stirs circles, boxes and capsules in a ring.", {1, 6076, 6076, "bodies"}, 500, spinner},
        {"tile_world",
         "box2d",
         "Bodies run over a map of static tiles, eight floors high.",
         {10, 500, 2000, "tiles a floor is long; a fourth as many bodies on it"},
         300,
         tile_world},
        {"tumbler",
         "box2d",
         "Small boxes in a square drum that turns.",
         {1, 45, 60, "boxes a side of the block that they start as"},
         750,
         tumbler},
        {"washer", "box2d", "Small squares in a round drum with paddles that turns.", {1, 8000, 9000, "squares"}, 500, washer},
    };
}

std::vector<FieldScene> ordinary_suite()
{
    std::vector<FieldScene> scenes;
    for (const int size : {50, 200, 500, 1000})
    {
        scenes.push_back({"mixed_" + std::to_string(size),
                          "ordinary",
                          "Circles, boxes, capsules and polygons fall into a box.",
                          {1, size, 10000, "bodies"},
                          600,
                          mixed});
    }
    scenes.push_back({"platformer",
                      "ordinary",
                      "A level of tiles with moving platforms, crates, coins, and a player who runs through it.",
                      {40, 300, 2000, "tiles long"},
                      900,
                      platformer});
    scenes.push_back({"ragdolls_20", "ordinary", "Ragdolls fall down stairs.", {1, 20, 500, "ragdolls"}, 600, ragdolls});
    scenes.push_back({"stack_20", "ordinary", "One stack of boxes, which stands.", {1, 20, 200, "boxes"}, 600, stack});
    scenes.push_back({"rays_1000",
                      "ordinary",
                      "Rays cross a field of moving bodies in every step.",
                      {2, 1000, 20000, "rays; half as many bodies"},
                      300,
                      rays});
    scenes.push_back({"spawn_destroy",
                      "ordinary",
                      "Bodies come in every step, and go again after two seconds.",
                      {1, 4, 50, "bodies a step"},
                      600,
                      spawn_and_destroy});
    scenes.push_back({"shots",
                      "ordinary",
                      "Shots of up to 300 m/s at thin walls, plates and balls.",
                      {1, 240, 2000, "shots, each with what it flies at"},
                      60,
                      shots});
    return scenes;
}

std::vector<FieldScene> weightless_suites()
{
    std::vector<FieldScene> scenes;
    for (const int size : {500, 1000, 2000, 8000})
    {
        scenes.push_back({"origin_" + std::to_string(size),
                          "origin",
                          "Circles and boxes bounce between walls without losing energy; they cover 34 %.",
                          {1, size, 20000, "circles, and as many boxes"},
                          300,
                          bouncing});
    }
    const auto add_orbits = [&](int size, int steps)
    {
        scenes.push_back({"orbits_" + std::to_string(size),
                          "nbody",
                          "Planets around a sun; all pull each other.",
                          {1, size, 200000, "planets"},
                          steps,
                          orbits});
    };
    add_orbits(1000, 600);
    add_orbits(10000, 200);
    add_orbits(100000, 60);
    return scenes;
}

} // namespace

const std::vector<FieldScene>& field_scenes()
{
    static const std::vector<FieldScene> scenes = []
    {
        std::vector<FieldScene> all = box2d_suite();
        for (const auto& suite : {ordinary_suite(), weightless_suites()}) all.insert(all.end(), suite.begin(), suite.end());
        return all;
    }();
    return scenes;
}

const FieldScene* find_field_scene(std::string_view name)
{
    const auto& all = field_scenes();
    const auto found = std::find_if(all.begin(), all.end(), [&](const FieldScene& scene) { return scene.name == name; });
    return found == all.end() ? nullptr : &*found;
}

scenes::ParameterInfo size_parameter(const FieldScene& scene)
{
    return scenes::integer("size", {scene.size.min, scene.size.initial, scene.size.max}, "", scenes::Applies::OnRestart, scene.size.what);
}

SceneFile make_field_scene(const FieldScene& scene, const FieldSetup& setup)
{
    scenes::checked(size_parameter(scene), std::int64_t{setup.size});
    SceneFile file = scene.make(setup);
    file.name = scene.name;
    file.description = scene.description;
    file.steps = scene.steps;
    file.notes.clear();
    check(file, scene.name);
    return file;
}

} // namespace carom::lab
