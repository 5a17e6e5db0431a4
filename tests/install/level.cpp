// A user's program that loads a level, plays it, and saves it.
#include <carom/carom.hpp>
#include <carom/scene_file.hpp>

#include <cmath>
#include <cstdio>

int main()
{
    constexpr const char* level = R"({"carom_scene": 1, "bodies": [
        {"type": "static", "shapes": [{"polygon": {"vertices": [[-25, -0.5], [25, -0.5], [25, 0.5], [-25, 0.5]]}}]},
        {"name": "ball", "position": [0, 4], "shapes": [{"name": "disc", "circle": {"radius": 0.5}}]}]})";
    carom::World world;
    const carom::SceneLoadResult level_loaded = carom::load_scene_text(world, level);
    if (!level_loaded) return std::printf("%s\n", level_loaded.problem.text().c_str()), 1;
    for (int i = 0; i < 180; ++i) world.step(level_loaded.scene->time_step, level_loaded.scene->substeps);
    const float height = world.body(level_loaded.scene->names.bodies.find("ball")).position().y;
    std::printf("the ball rests at %.3f m\n", static_cast<double>(height));
    if (std::abs(height - 1.0f) > 0.01f) return 1;

    const carom::SceneSaveResult saved = carom::save_scene(world, "saved.json");
    if (!saved) return std::printf("%s\n", saved.problem->text().c_str()), 1;
    carom::World again;
    const carom::SceneLoadResult saved_loaded = carom::load_scene(again, "saved.json");
    if (!saved_loaded || again.body_count() != 2) return std::puts("what was saved does not come back"), 1;

    const carom::SceneLoadResult missing = carom::load_scene(again, "no such level.json");
    return missing || again.body_count() != 2 ? 1 : 0;
}
