// A simulation as plain data: what a scene file holds. The definitions of the public API with places in lists instead of ids.
//
// Bodies and joints are numbered from 0 by their order of appearance: first the lists of the scene, then those of its events. A number stays with
// its body or joint, also after others have gone.
#pragma once

#include <carom/carom.hpp>
#include <carom/scene_file.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace carom::scene_file
{

/// A scene file that can't be read or played. what() is the text of the problem.
class SceneFileError : public std::runtime_error
{
public:
    explicit SceneFileError(SceneProblem problem) : std::runtime_error(problem.text()), problem_(std::move(problem)) {}

    const SceneProblem& problem() const { return problem_; }

private:
    SceneProblem problem_;
};

/// Where in its file a part of a scene begins, counted from 1; 0 when it was not read from a file.
struct Place
{
    int line = 0;
    int column = 0;
};

inline constexpr int scene_file_version = 1;
inline constexpr std::size_t most_file_bytes = 256 << 20;
inline constexpr int most_file_bodies = 1'000'000; ///< in the whole file, those of events included
inline constexpr int most_file_joints = 1'000'000; ///< in the whole file
inline constexpr int most_file_shapes = 4'000'000; ///< in the whole file; a segment of a chain is a shape
inline constexpr int most_file_steps = 10'000'000;
inline constexpr int most_file_events = 1'000'000;
inline constexpr int most_file_rays = 100'000;
inline constexpr int most_file_changes = 4'000'000;       ///< of bodies and joints by events, in the whole file
inline constexpr std::size_t most_text_bytes = 64 * 1024; ///< of a name or a description

struct FileShape
{
    Geometry geometry = Circle{};
    ShapeDef def = {};
    std::string name = {};
    Place place = {};
};

struct FileChain
{
    std::vector<Vec2> points; ///< in the body's frame [m]
    ChainDef def = {};        ///< its spans stay empty
    std::vector<Material> materials = {};
    std::string name = {};
    Place place = {};
};

struct FileBody
{
    BodyDef def = {}; ///< its name stays empty
    std::string name = {};
    bool is_awake = true;                   ///< false: it sleeps from the start
    std::optional<MassData> mass_data = {}; ///< instead of what the shapes give
    std::vector<FileShape> shapes = {};     ///< made in this order, before the next body
    std::vector<FileChain> chains = {};     ///< after the shapes
    Place place = {};
};

struct FileJoint
{
    std::optional<int> body_a = {}; ///< number of the body; empty: the world itself
    int body_b = -1;                ///< number of the body
    JointDef def = {};              ///< its ids stay null
    JointSpec spec = RevoluteJoint{};
    std::string name = {};
    Place place = {};
};

/// Changes what is given, in this order, and nothing else.
struct SetBody
{
    int body = -1;
    std::optional<BodyType> type = {};
    std::optional<Vec2> position = {}; ///< teleports, as does angle [m]
    std::optional<float> angle = {};   ///< [rad]
    std::optional<Vec2> linear_velocity = {};
    std::optional<float> angular_velocity = {};
    std::optional<float> linear_damping = {};
    std::optional<float> angular_damping = {};
    std::optional<float> gravity_scale = {};
    std::optional<MotionLocks> locks = {};
    std::optional<bool> can_sleep = {};
    std::optional<bool> is_bullet = {};
    std::optional<bool> is_attractor = {};
    std::optional<bool> is_enabled = {};
    std::optional<bool> is_awake = {};
    Place place = {};
};

/// One of the two.
struct SetJoint
{
    int joint = -1;
    std::optional<float> motor_speed = {}; ///< of a joint that has a motor [rad/s] or [m/s]
    std::optional<JointSpec> spec = {};    ///< of the joint's own type
    Place place = {};
};

struct SetWorld
{
    std::optional<Vec2> gravity = {}; ///< [m/s^2]
};

/// What happens right before a step, in the order of the members.
struct FileEvent
{
    int step = 0; ///< counted from 0
    std::vector<int> destroy_joints = {};
    std::vector<int> destroy_bodies = {}; ///< and the joints that they have
    std::vector<FileBody> create_bodies = {};
    std::vector<FileJoint> create_joints = {};
    std::optional<SetWorld> set_world = {};
    std::vector<SetBody> set_bodies = {};
    std::vector<SetJoint> set_joints = {};
    Place place = {};
};

struct FileWorld
{
    Vec2 gravity = {0, -9.81f}; ///< [m/s^2]
    bool continuous = true;
    SleepTuning sleep = {};
    SolverTuning solver = {};
    MaterialMixing mixing = {};
    float hit_speed = 1;   ///< [length units/s]
    float length_unit = 1; ///< [m]
    int max_pairs = 0;     ///< 0 lets the world choose
    std::vector<Field> fields = {};
    Place place = {};
};

using FileView = SceneView;

struct SceneFile
{
    int version = scene_file_version;
    std::string name = {};
    std::string description = {};
    std::vector<std::string> notes = {}; ///< what the file could not hold of what it was made from
    std::vector<std::string> needs = {}; ///< what an engine must have to run it; see needs_of()
    float time_step = 1 / 60.0f;         ///< [s]
    int substeps = 4;
    int steps = 600;
    std::optional<FileView> view = {};
    FileWorld world = {};
    std::vector<FileBody> bodies = {};
    std::vector<FileJoint> joints = {};
    std::vector<FileEvent> events = {}; ///< by step
    std::vector<Ray> rays = {};         ///< cast after every step, each for the nearest hit
    Place place = {};
};

} // namespace carom::scene_file
