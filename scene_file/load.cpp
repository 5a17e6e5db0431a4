// Loads and validates scene files: reads, checks, builds in a world on the side, and only then in the caller's.
#include "scene_file/check.hpp"
#include "scene_file/player.hpp"
#include "scene_file/reader.hpp"
#include "scene_file/reading.hpp"
#include "scene_file/snapshot.hpp"

#include <carom/scene_file.hpp>

#include <utility>

namespace carom
{

using namespace scene_file;

/// What play_events() needs: the file with its events, and how far they are done.
struct LoadedScene::Events
{
    Events(SceneFile scene, std::string name, std::uint32_t number)
        : file(std::move(scene)),
          source(std::move(name)),
          playback(file, source),
          world_number(number)
    {
    }

    SceneFile file;
    std::string source;
    FilePlayback playback;
    std::uint32_t world_number;
};

namespace
{

/// Throws UsageError when the world can't be changed now. Setting what is set already changes nothing.
void require_idle(World& world, const char* function)
{
    try
    {
        world.set_hit_speed(world.hit_speed());
    }
    catch (const UsageError& error)
    {
        throw UsageError(function, error.field(), error.value(), error.remedy());
    }
}

/// Builds the scene in a world of its own and lets all its events happen, so that what the engine refuses is found without harm.
/// @throws SceneFileError
void rehearse(const SceneFile& file, const std::string& name, float length_unit)
{
    WorldDef def = FilePlayback::world_def(file);
    def.length_unit = length_unit;
    World world(def);
    FilePlayback playback(file, name);
    playback.begin(world);
    playback.before_step(world, most_file_steps);
}

/// All but the length unit, which no world changes, and the fields. What stays the same is not set, since some of these calls wake bodies.
void set_settings(World& world, const FileWorld& to)
{
    if (world.gravity() != to.gravity) world.set_gravity(to.gravity);
    if (world.is_continuous() != to.continuous) world.set_continuous(to.continuous);
    if (world.sleep_tuning() != to.sleep) world.set_sleep_tuning(to.sleep);
    if (world.solver_tuning() != to.solver) world.set_solver_tuning(to.solver);
    if (world.mixing() != to.mixing) world.set_mixing(to.mixing);
    if (world.hit_speed() != to.hit_speed) world.set_hit_speed(to.hit_speed);
    if (world.max_pairs() != to.max_pairs) world.set_max_pairs(to.max_pairs);
}

void remove_parts(World& world, const FilePlayback& playback)
{
    for (const BodyId id : playback.bodies())
        if (world.find_body(id)) world.destroy_body(id);
    for (const FieldId id : playback.fields()) world.remove_field(id);
}

/// Builds what has been rehearsed. Should memory run out, it is taken away again.
void build(World& world, FilePlayback& playback, const FileWorld& settings, bool with_settings)
{
    const FileWorld before = settings_of(world);
    try
    {
        if (with_settings)
        {
            set_settings(world, settings);
            playback.add_fields(world);
        }
        playback.create_parts(world);
    }
    catch (...)
    {
        remove_parts(world, playback);
        set_settings(world, before);
        throw;
    }
}

std::vector<SceneProblem> validate(BlockSource source, std::string_view name, int most)
{
    if (most < 1) throw UsageError("validate_scene", "most", std::to_string(most), "give a number >= 1");
    TextInput input(std::move(source), std::string(name));
    ReadResult result = read(input, most);
    if (result.problems.empty()) result.problems = problems_of(result.file, input.name(), most);
    if (result.problems.empty()) rehearse(result.file, input.name(), result.file.world.length_unit);
    return std::move(result.problems);
}

/// What an action returns, or the one problem that it throws.
template <class Action>
std::vector<SceneProblem> problems_from(const Action& action)
{
    try
    {
        return action();
    }
    catch (const SceneFileError& error)
    {
        return {error.problem()};
    }
}

} // namespace

/// Makes loaded scenes.
class SceneLoader
{
public:
    SceneLoader(World& world, const SceneLoadOptions& options) : world_(world), options_(options) { require_idle(world, "load_scene"); }

    template <class MakeSource>
    SceneLoadResult load(std::string name, const MakeSource& make_source) const
    {
        try
        {
            TextInput input(make_source(), std::move(name));
            SceneFile file = read_checked(input);
            if (options_.settings) require_length_unit(file, input.name());
            rehearse(file, input.name(), world_.length_unit());
            return {.scene = loaded(std::move(file), input.name()), .problem = {}};
        }
        catch (const SceneFileError& error)
        {
            return {.scene = {}, .problem = error.problem()};
        }
    }

private:
    void require_length_unit(const SceneFile& file, const std::string& name) const
    {
        if (file.world.length_unit == world_.length_unit()) return;
        const Place place = file.world.place.line > 0 ? file.world.place : file.place;
        throw SceneFileError({.source = name,
                              .line = place.line,
                              .column = place.column,
                              .field = "world.length_unit",
                              .message = "is " + number_text(double{file.world.length_unit}) + ", and the world was made with " +
                                         number_text(double{world_.length_unit()}) +
                                         "; make the world with the file's, or load without the settings"});
    }

    LoadedScene loaded(SceneFile file, const std::string& name) const
    {
        LoadedScene scene;
        scene.name = file.name;
        scene.description = file.description;
        scene.view = file.view;
        scene.time_step = file.time_step;
        scene.substeps = file.substeps;
        scene.steps = file.steps;
        scene.events_ = std::make_unique<LoadedScene::Events>(std::move(file), name, world_.number());
        build(world_, scene.events_->playback, scene.events_->file.world, options_.settings);
        scene.take_what_was_made();
        return scene;
    }

    World& world_;
    const SceneLoadOptions& options_;
};

LoadedScene::LoadedScene() = default;
LoadedScene::~LoadedScene() = default;
LoadedScene::LoadedScene(LoadedScene&&) noexcept = default;
LoadedScene& LoadedScene::operator=(LoadedScene&&) noexcept = default;

/// Lists what the playback has made, and lets the file go when nothing is left to play.
void LoadedScene::take_what_was_made()
{
    const FilePlayback& playback = events_->playback;
    if (bodies.size() < playback.bodies().size() || joints.size() < playback.joints().size())
    {
        names = playback.names();
        bodies = playback.bodies();
        joints = playback.joints();
    }
    if (!playback.has_events_left()) events_.reset();
}

bool LoadedScene::has_events() const { return events_ != nullptr; }

std::optional<SceneProblem> LoadedScene::play_events(World& world, int step)
{
    if (!events_) return {};
    require_idle(world, "play_events");
    if (world.number() != events_->world_number)
        throw UsageError("play_events", "world", "another world", "give the world that the scene was loaded into");
    if (!events_->playback.is_due(step)) return {};
    std::optional<SceneProblem> problem;
    try
    {
        events_->playback.before_step(world, step);
    }
    catch (const SceneFileError& error)
    {
        problem = error.problem();
    }
    take_what_was_made();
    return problem;
}

SceneLoadResult load_scene(World& world, const std::filesystem::path& path, const SceneLoadOptions& options)
{
    return SceneLoader(world, options).load(path.string(), [&] { return file_source(path); });
}

SceneLoadResult load_scene(World& world, std::istream& stream, const SceneLoadOptions& options)
{
    const std::string name(options.name);
    return SceneLoader(world, options).load(name, [&] { return stream_source(stream, name); });
}

SceneLoadResult load_scene_text(World& world, std::string_view text, const SceneLoadOptions& options)
{
    return SceneLoader(world, options).load(std::string(options.name), [&] { return text_source(text); });
}

std::vector<SceneProblem> validate_scene(const std::filesystem::path& path, int most)
{
    return problems_from([&] { return validate(file_source(path), path.string(), most); });
}

std::vector<SceneProblem> validate_scene(std::istream& stream, int most, std::string_view name)
{
    return problems_from([&] { return validate(stream_source(stream, std::string(name)), name, most); });
}

std::vector<SceneProblem> validate_scene_text(std::string_view text, int most, std::string_view name)
{
    return problems_from([&] { return validate(text_source(text), name, most); });
}

} // namespace carom
