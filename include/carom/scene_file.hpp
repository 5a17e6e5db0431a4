// Scene files: loads a level into a world, writes a world down, and says what is wrong with a file. The library carom::scene_file; docs/scene-files.md
// describes the format.
#pragma once

#include <carom/world.hpp>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace carom
{

/// What is wrong with a scene file, and where.
struct SceneProblem
{
    std::string source = {};  ///< path of the file, or the name that was given for a stream or a text
    int line = 0;             ///< counted from 1; 0 when the problem has no place, as that of a missing file
    int column = 0;           ///< counted from 1, in characters
    std::string field = {};   ///< "bodies[3].shapes[0].circle.radius"; empty when the text is no JSON
    std::string message = {}; ///< what was found and what is expected: "is -1; give a number > 0 [m]"

    /// "level.json:12:40: bodies[3].shapes[0].circle.radius is -1; give a number > 0 [m]". Valid UTF-8 without control characters.
    std::string text() const;
};

/// The ids of what has a name, in the order of the file. Names may repeat.
template <class Id>
class NamedIds
{
public:
    void add(std::string name, Id id) { ids_.emplace(std::move(name), id); }
    /// The first of that name; a null id when there is none.
    Id find(std::string_view name) const
    {
        const auto found = ids_.lower_bound(name);
        return found != ids_.end() && found->first == name ? found->second : Id{};
    }
    /// All of that name.
    std::vector<Id> all(std::string_view name) const
    {
        std::vector<Id> ids;
        for (auto i = ids_.lower_bound(name); i != ids_.end() && i->first == name; ++i) ids.push_back(i->second);
        return ids;
    }
    bool empty() const { return ids_.empty(); }
    std::size_t size() const { return ids_.size(); }
    auto begin() const { return ids_.begin(); } ///< of pairs of name and id, ordered by name
    auto end() const { return ids_.end(); }

private:
    std::multimap<std::string, Id, std::less<>> ids_;
};

struct SceneNames
{
    NamedIds<BodyId> bodies;
    NamedIds<ShapeId> shapes;
    NamedIds<ChainId> chains;
    NamedIds<JointId> joints;
};

/// The part of the world that a picture of the scene should show.
struct SceneView
{
    Vec2 center = {};  ///< [m]
    float height = 20; ///< [m]
};

/// What load_scene() made, and what the file says about how to go on. Ids of what has been destroyed since are stale.
class LoadedScene
{
public:
    LoadedScene();
    ~LoadedScene();
    LoadedScene(LoadedScene&&) noexcept;
    LoadedScene& operator=(LoadedScene&&) noexcept;

    SceneNames names;            ///< grows when events create something
    std::vector<BodyId> bodies;  ///< in the order of the file; grows likewise
    std::vector<JointId> joints; ///< in the order of the file; grows likewise
    std::string name;            ///< of the scene
    std::string description;
    std::optional<SceneView> view;
    float time_step = 1 / 60.0f; ///< that the scene was made for [s]
    int substeps = 4;            ///< that the scene was made for
    int steps = 600;             ///< how long the scene runs

    /// Whether events are left that play_events() would do.
    bool has_events() const;
    /// Does what the file lets happen before a step: bodies and joints that come, go, or change. Call it before every World::step, with 0, 1, 2, ...
    /// Changes of what was destroyed in the meantime are left out.
    /// @param world the one that the scene was loaded into
    /// @param step  counted from the load
    /// @return what the world refused, as a joint between bodies that the program has changed since; what comes before it in the file is done
    /// @throws UsageError during a step, and on another world
    std::optional<SceneProblem> play_events(World& world, int step);

private:
    friend class SceneLoader;
    struct Events;
    void take_what_was_made();

    std::unique_ptr<Events> events_;
};

struct SceneLoadOptions
{
    /// Whether the world takes the settings of the file: gravity, gravity fields (added to those it has), sleep, solver, mixing, continuous,
    /// hit_speed, max_pairs. A world can't change its length_unit: a file with another one is refused. Without settings, only bodies and joints
    /// are added, as for a part that is placed into a level.
    bool settings = true;
    std::string_view name = "scene"; ///< stands for the path in messages about a stream or a text
};

struct SceneLoadResult
{
    std::optional<LoadedScene> scene;
    SceneProblem problem; ///< set when there is no scene

    explicit operator bool() const { return scene.has_value(); }
};

// Adds a scene to what is in the world. A file that is missing, broken, or holds what the world refuses is an expected failure: the result says
// what and where, and the world is as it was, to its hash. A file is read in small blocks and refused at the first character that no scene
// can have; its bodies are built once in a world on the side before they are built in this one.
// @throws UsageError during a step of this world, or when it can't be changed
// @throws std::bad_alloc when memory runs out; then no body, joint or field of the file is in the world

SceneLoadResult load_scene(World& world, const std::filesystem::path& path, const SceneLoadOptions& options = {});
SceneLoadResult load_scene(World& world, std::istream& stream, const SceneLoadOptions& options = {}); ///< reads to the end
SceneLoadResult load_scene_text(World& world, std::string_view text, const SceneLoadOptions& options = {});

struct SceneSaveOptions
{
    std::string name = {};
    std::string description = {};
    float time_step = 1 / 60.0f; ///< [s], 1e-6 to 1
    int substeps = 4;            ///< 1 to 64
    int steps = 600;             ///< 1 to 10,000,000
    std::optional<SceneView> view = {};
    const SceneNames* names = nullptr; ///< names of shapes, chains and joints, as LoadedScene::names; null for none. A body has its own.
};

struct SceneSaveResult
{
    std::vector<std::string> losses;     ///< what of the world no file can hold, one sentence each; the file has them as its notes
    std::optional<SceneProblem> problem; ///< set when nothing was written

    explicit operator bool() const { return !problem; }
};

// Writes the world down as it stands, without events. A disk that is full and a path that can't be written are expected failures: the result has the
// reason, and what was in the file before is still there.
// @throws UsageError on an option that is out of range

SceneSaveResult save_scene(const World& world, const std::filesystem::path& path, const SceneSaveOptions& options = {});
SceneSaveResult save_scene(const World& world, std::ostream& stream, const SceneSaveOptions& options = {});
/// What save_scene() would write.
/// @throws std::runtime_error with the text of the problem where save_scene() would return one
std::string scene_text(const World& world, const SceneSaveOptions& options = {});

// All that is wrong with a file, in its order, and empty when load_scene() would load it. After a syntax error the rest can't be read.
// @param most after so many problems the rest is not looked at, >= 1
// @throws UsageError when `most` is less than 1

std::vector<SceneProblem> validate_scene(const std::filesystem::path& path, int most = 20);
std::vector<SceneProblem> validate_scene(std::istream& stream, int most = 20, std::string_view name = "scene");
std::vector<SceneProblem> validate_scene_text(std::string_view text, int most = 20, std::string_view name = "scene");

} // namespace carom
