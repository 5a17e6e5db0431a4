// The list of all scenes, with those of the laboratory at sizes that run fluently.
#include "gallery/scene_source.hpp"

#include "lab/field_scenes/field_scenes.hpp"
#include "lab/scene_file/file_scene.hpp"
#include "scene_file/reader.hpp"
#include "scenes/registry.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace carom::gallery
{

namespace
{

using lab::FieldScene;
using lab::FileScene;
using lab::SceneFile;
using scenes::ParameterInfo;
using scenes::ParameterValues;
using scenes::Scene;
using scenes::SceneInfo;

/// A scene of the laboratory in the gallery. The laboratory measures larger ones than a person can watch fluently. Dolls of the rain live for 8 steps
/// a column: with fewer columns they would be gone before they land.
struct Benchmark
{
    const char* name;
    const char* title;
    int size;
};
constexpr std::array benchmarks = {Benchmark{"large_pyramid", "Large pyramid", 30}, Benchmark{"tumbler", "Tumbler", 20},
                                   Benchmark{"rain", "Rain", 14}, Benchmark{"joint_grid", "Joint grid", 24},
                                   Benchmark{"spinner", "Spinner", 800}};

SceneSource named(const SceneInfo& info)
{
    const auto make = [&info](const ParameterValues& values, std::uint64_t seed) { return scenes::make_scene(info.name, values, seed); };
    return {std::shared_ptr<const SceneInfo>(&info, [](const SceneInfo*) {}), make};
}

SceneFile file_of(const FieldScene& scene, const Benchmark& benchmark, int size, std::uint64_t seed)
{
    SceneFile file = lab::make_field_scene(scene, {.size = size, .seed = seed});
    file.name = benchmark.title;
    return file;
}

SceneSource laboratory(const Benchmark& benchmark)
{
    const FieldScene& scene = *lab::find_field_scene(benchmark.name);
    ParameterInfo size = lab::size_parameter(scene);
    size.initial = std::int64_t{benchmark.size};
    const std::vector<ParameterInfo> own = {size};
    SceneInfo info = FileScene::info_of(file_of(scene, benchmark, scene.size.min, 1), own);
    info.name = scene.name;
    info.group = "Benchmarks";
    const auto make = [&scene, benchmark, own](const ParameterValues& values, std::uint64_t seed) -> std::unique_ptr<Scene>
    {
        const auto given = std::find_if(values.begin(), values.end(), [](const auto& value) { return value.first == "size"; });
        const scenes::ParameterValue wanted = given == values.end() ? own[0].initial : scenes::checked(own[0], given->second);
        SceneFile file = file_of(scene, benchmark, static_cast<int>(std::get<std::int64_t>(wanted)), seed);
        return std::make_unique<FileScene>(std::move(file), scene.name, values, own);
    };
    return {std::make_shared<const SceneInfo>(std::move(info)), make};
}

} // namespace

SceneSource SceneSource::of_file(const std::filesystem::path& path)
{
    const auto file = std::make_shared<const SceneFile>(lab::read_scene_file(path));
    SceneInfo info = FileScene::info_of(*file);
    if (file->name.empty()) info.title = path.stem().string();
    info.name = path.string();
    const auto make = [file, source = path.string()](const ParameterValues& values, std::uint64_t)
    { return std::make_unique<FileScene>(*file, source, values); };
    return {std::make_shared<const SceneInfo>(std::move(info)), make, path};
}

const std::vector<SceneSource>& catalogue()
{
    static const std::vector<SceneSource> all = []
    {
        std::vector<SceneSource> sources;
        for (const SceneInfo& info : scenes::all_scenes()) sources.push_back(named(info));
        for (const Benchmark& benchmark : benchmarks) sources.push_back(laboratory(benchmark));
        return sources;
    }();
    return all;
}

const SceneSource& find_source(std::string_view name)
{
    std::vector<std::string> names;
    for (const SceneSource& source : catalogue())
    {
        if (source.info().name == name) return source;
        names.push_back(source.info().name);
    }
    throw scenes::SceneError("scene", "\"" + std::string(name) + "\" does not exist", scenes::suggestion(name, names));
}

} // namespace carom::gallery
