// Writes a world down as a scene file.
#include "files/output_file.hpp"
#include "scene_file/snapshot.hpp"
#include "scene_file/writer.hpp"

#include <carom/scene_file.hpp>

#include <cmath>
#include <ostream>
#include <sstream>
#include <utility>

namespace carom
{

using namespace scene_file;

namespace
{

void require(bool holds, const char* field, const std::string& value, const char* remedy)
{
    if (!holds) throw UsageError("save_scene", field, value, remedy);
}

void require_valid(const SceneSaveOptions& options)
{
    const auto fits = [](const std::string& text) { return text.size() <= most_text_bytes; };
    require(options.time_step >= 1e-6f && options.time_step <= 1, "time_step", std::to_string(options.time_step), "give 1e-6 to 1 [s]");
    require(options.substeps >= 1 && options.substeps <= 64, "substeps", std::to_string(options.substeps), "give 1 to 64");
    require(options.steps >= 1 && options.steps <= most_file_steps, "steps", std::to_string(options.steps), "give 1 to 10,000,000");
    require(fits(options.name), "name", std::to_string(options.name.size()) + " bytes long", "give at most 64 KiB");
    require(fits(options.description), "description", std::to_string(options.description.size()) + " bytes long", "give at most 64 KiB");
    if (!options.view) return;
    const SceneView& view = *options.view;
    require(view.height >= 0.001f && view.height <= max_coordinate, "view.height", std::to_string(view.height), "give 0.001 to 1e6 [m]");
    const Vec2 c = view.center;
    require(std::abs(c.x) <= max_coordinate && std::abs(c.y) <= max_coordinate, "view.center",
            "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")", "give a finite point within 1e6 [m]");
}

SceneFile file_of(const World& world, const SceneSaveOptions& options)
{
    require_valid(options);
    SceneFile file = snapshot_of(world, options.names);
    file.name = options.name;
    file.description = options.description;
    file.time_step = options.time_step;
    file.substeps = options.substeps;
    file.steps = options.steps;
    file.view = options.view;
    return file;
}

/// Hands a file to `write`, and turns what it throws into a result.
template <class Write>
SceneSaveResult saved(const World& world, const SceneSaveOptions& options, const Write& write)
{
    try
    {
        SceneFile file = file_of(world, options);
        write(file);
        return {.losses = std::move(file.notes), .problem = {}};
    }
    catch (const SceneFileError& error)
    {
        return {.losses = {}, .problem = error.problem()};
    }
}

} // namespace

SceneSaveResult save_scene(const World& world, const std::filesystem::path& path, const SceneSaveOptions& options)
{
    return saved(world, options, [&](const SceneFile& file) { write_scene_file(path, file); });
}

SceneSaveResult save_scene(const World& world, std::ostream& stream, const SceneSaveOptions& options)
{
    return saved(world, options, [&](const SceneFile& file)
    {
        write_scene_file(stream, file);
        if (!stream.flush()) throw SceneFileError({.source = "stream", .message = "can't be written"});
    });
}

std::string scene_text(const World& world, const SceneSaveOptions& options) { return scene_file_text(file_of(world, options)); }

} // namespace carom
