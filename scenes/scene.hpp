// What every scene is: a world with a story, written once and used by tests, the laboratory, the gallery and the command line.
#pragma once

#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"
#include "scenes/parameters.hpp"

#include <carom/carom.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::scenes
{

class Scene;
struct SceneInfo;

/// Something that a person can do in a scene.
struct Control
{
    enum class Kind
    {
        Key,
        Pointer
    };
    Kind kind = Kind::Key;
    std::string input;  ///< a key's name ("b", "1", "up", "space"), or a pointer action ("left", "right", "move", "wheel")
    std::string action; ///< what it does
};

/// What a scene is made from.
struct SceneSetup
{
    const SceneInfo& info;
    Parameters parameters;
    std::uint64_t seed = 1;
};

struct SceneInfo
{
    std::string name;
    std::string title;
    std::string description;
    std::string group;
    std::vector<Control> controls;
    std::vector<ParameterInfo> parameters;
    std::unique_ptr<Scene> (*make)(const SceneSetup&) = nullptr;
    /// Whether the scene stands still with its defaults until someone touches it, as a house of cards does. Of all others a test asks that
    /// they move by themselves, so that a person who opens one sees at once what it is about.
    bool is_calm = false;
    /// Whether the left button takes hold of bodies in the scene itself; a front end that offers it for every scene then leaves it to this one.
    bool drags_bodies = false;
    /// What the scene's own code does to the world during a run, without anybody's input; empty when the world as it is made is the whole scene.
    std::string own_code = {};
};

struct PointerEvent
{
    enum class Action
    {
        Move,
        Down,
        Up,
        Wheel
    };
    enum class Button
    {
        None,
        Left,
        Middle,
        Right
    };
    Action action = Action::Move;
    Button button = Button::None;
    Vec2 position = {}; ///< in the world [m]
    float wheel = 0;    ///< notches, positive away from the person
};

/// Pointer events beyond are ignored: a body there would stretch the broad phase [m].
inline constexpr float farthest_pointer = 10000;

/// Learns when the world's own step begins and ends, so that a measurement leaves out the scene's code.
class StepObserver
{
public:
    virtual ~StepObserver() = default;
    virtual void world_step_begins() {}
    virtual void world_step_ended() {}
};

/// A world and what happens in it. Derived scenes fill in the `on_...` calls; each is empty by default.
class Scene
{
public:
    virtual ~Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const SceneInfo& info() const { return info_; }
    std::uint64_t seed() const { return seed_; }
    const Parameters& parameters() const { return parameters_; }
    /// A live parameter acts at once; the others act on the next scene made from parameters().
    /// @throws SceneError on an unknown name or a value that does not fit
    void set_parameter(std::string_view name, const ParameterValue& value);

    /// Positions that are not finite or beyond `farthest_pointer` are ignored.
    void pointer(const PointerEvent& event);
    /// A key was pressed. Keys that no control names are ignored.
    void key(std::string_view name);

    /// A body that a person adds to a scene, whatever that is about. The scene draws it; a restart takes it away.
    /// @return none when the scene is full or another body is in the way, and the picture says so
    std::optional<BodyId> add_guest(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape = {});

    /// Advances the scene by one step of its own fixed length.
    /// @param probe sees the inside of the world's step
    StepReport step(StepObserver* observer = nullptr, StepProbe* probe = nullptr);
    float time_step() const { return 1 / parameters_.real("step_rate"); } ///< [s]
    double time() const { return time_; }                                 ///< simulated so far [s]

    World& world() { return world_; }
    const World& world() const { return world_; }

    const Camera& camera() const { return camera_; }
    /// Adds what the scene looks like now.
    void draw(DrawList& list) const;

protected:
    /// @param world its broad phase is set from the parameters
    Scene(const SceneSetup& setup, WorldDef world);

    virtual void on_parameter(std::string_view /*name*/) {}   ///< a live parameter has changed
    virtual void on_pointer(const PointerEvent& /*event*/) {} ///< its position is sound
    virtual void on_key(std::string_view /*name*/) {}         ///< one that the scene's controls name
    virtual void before_step() {}                             ///< the world is about to step
    virtual void after_step(const StepReport& /*report*/) {}  ///< the world has stepped, and its events can be read
    virtual void on_draw(DrawList& /*list*/) const {}
    virtual std::string status() const { return {}; }         ///< a few words for the caption
    virtual float step_length() const { return time_step(); } ///< of the coming step [s]; 0 holds the world still

    float real(std::string_view name) const { return parameters_.real(name); }
    int integer(std::string_view name) const { return parameters_.integer(name); }
    bool boolean(std::string_view name) const { return parameters_.boolean(name); }
    const std::string& choice(std::string_view name) const { return parameters_.choice(name); }
    void toggle(std::string_view name) { set_parameter(name, !boolean(name)); }

    /// True when another body may be added there: the scene is not full, and no body that moves by itself has the place. Otherwise
    /// the picture says why not. Without this, clicks at one place would pile up bodies whose pairs grow with the square of their number.
    bool may_add_at(Vec2 position);
    /// Shows a message for a few seconds.
    void say(std::string message);

    Camera camera_;

private:
    void draw_guests(DrawList& list) const;
    void draw_captions(DrawList& list) const;

    const SceneInfo& info_;
    Parameters parameters_;
    std::uint64_t seed_;
    World world_;
    std::vector<BodyId> guests_;
    double time_ = 0;
    std::string message_;
    double message_until_ = 0;
};

/// Most bodies that pointer actions may fill a scene with.
inline constexpr int max_bodies = 20000;

/// Of all broad phases, from the simplest to the fastest.
std::vector<std::string> broad_phase_names();

/// The parameters and controls that every scene has beside its own.
/// @param broad_phase the default
/// @param substeps    the default
std::vector<ParameterInfo> with_common_parameters(std::vector<ParameterInfo> own, BroadPhaseType broad_phase = BroadPhaseType::Tree,
                                                  int substeps = 4);
std::vector<Control> with_common_controls(std::vector<Control> own);

} // namespace carom::scenes
