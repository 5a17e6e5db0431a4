// The scene that is being played: its time, what it looks like now, what its steps cost, and a look inside of one.
#pragma once

#include "gallery/blend.hpp"
#include "gallery/clock.hpp"
#include "gallery/file_watch.hpp"
#include "gallery/overlay.hpp"
#include "gallery/scene_source.hpp"
#include "gallery/stage_meter.hpp"
#include "gallery/step_film.hpp"
#include "scenes/scene.hpp"

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::gallery
{

/// Parts of the engine that can be switched off, to see what they are for.
enum class EngineSwitch
{
    Sleep,
    Continuous,
    WarmStarting
};
inline constexpr int engine_switch_count = 3;

class Session
{
public:
    /// @throws SceneError
    Session(const SceneSource& source, const scenes::ParameterValues& values, std::uint64_t seed);
    Session(std::string_view scene, const scenes::ParameterValues& values, std::uint64_t seed) : Session(find_source(scene), values, seed)
    {
    }

    const SceneSource& source() const { return source_; }                    ///< of the scene that is being played
    const std::vector<SceneSource>& opened_files() const { return opened_; } ///< in this session, the latest last

    scenes::Scene& scene() { return *scene_; }
    const scenes::Scene& scene() const { return *scene_; }
    Clock& clock() { return clock_; }
    const Clock& clock() const { return clock_; }
    const StageMeter& meter() const { return meter_; }
    std::uint64_t seed() const { return seed_; }
    /// Counts the scenes that were made: whoever keeps ids of one world sees that they are stale.
    int generation() const { return generation_; }

    // Each makes a new scene; when that can't be, it says why and the old one goes on.
    void open(const SceneSource& source);
    void open(const std::string& name);                ///< a scene that is built in
    void open_file(const std::filesystem::path& file); ///< and opens it again whenever it changes on disk
    void open_neighbor(int steps);                     ///< the next scene of the list, or the one before
    void restart();                                    ///< with the parameters as they are now
    void restart_with(std::uint64_t seed);
    /// Acts at once, or by a restart when the parameter needs one. Says why when the value can't be had.
    void set_parameter(const std::string& name, const scenes::ParameterValue& value);

    bool is_on(EngineSwitch which) const;
    /// Acts at once, and stays over restarts of this scene.
    void set_switch(EngineSwitch which, bool is_on);

    /// Steps as much as the clock says. An error of a step pauses the scene and is said.
    /// @param elapsed since the frame before [s]
    void advance(double elapsed);
    /// What is to be seen now; the caller may add to it. Valid until the next call.
    /// @param height of the part of the world that is seen [m]; marks are drawn in proportion
    scenes::DrawList& picture(const DrawOptions& options, float height);
    /// A body whose place in the picture someone wants to know; null for none.
    void watch(BodyId body) { watched_ = body; }
    BodyId watched() const { return watched_; }
    /// Between two steps, as the picture is; none when the body is gone.
    std::optional<Vec2> watched_place() const;
    double step_seconds() const { return step_seconds_; } ///< that steps took in the last advance()
    double real_time_factor() const { return factor_; }   ///< simulated seconds in a second

    // A look inside of a step, moment by moment.
    bool is_inside() const { return !films_.empty(); }
    void look_inside(); ///< of the next step; the scene stands still
    void leave_inside() { films_.clear(); }
    void next_moment(); ///< at the end of a step comes the next one
    void previous_moment();
    void show_moment(std::size_t index);
    const StepFilm& film() const { return films_[film_]; }
    std::size_t moment() const { return moment_; }

    /// What the person should know; empty when there is nothing.
    const std::string& message() const;
    void say(std::string message);     ///< until it is closed
    void mention(std::string message); ///< for a few seconds

private:
    void take(std::unique_ptr<scenes::Scene> scene);
    bool make(const SceneSource& source, const scenes::ParameterValues& values, std::uint64_t seed);
    void remember(const SceneSource& source);
    void reload_when_changed();
    void reload();
    void apply_switches();
    bool step(StepFilm* film);
    void keep_before();
    void measure(double elapsed, double simulated);

    SceneSource source_;
    std::uint64_t seed_ = 1;
    std::array<std::optional<bool>, engine_switch_count> switches_; ///< by EngineSwitch; none: as the scene has it
    std::vector<SceneSource> opened_;
    std::optional<FileWatch> watch_;                  ///< of the scene's file; none for a scene that is built in
    std::chrono::steady_clock::time_point next_look_; ///< at that file

    std::unique_ptr<scenes::Scene> scene_;
    int generation_ = 0;
    Clock clock_;
    StageMeter meter_;
    double step_seconds_ = 0;
    double factor_ = 1;

    scenes::DrawList picture_; ///< the last one; kept for its memory
    Places before_;            ///< as it was before the last step
    bool has_before_ = false;
    BodyId watched_;
    std::optional<Vec2> watched_before_;

    std::deque<StepFilm> films_; ///< of the last steps that were looked into
    std::size_t film_ = 0;
    std::size_t moment_ = 0;
    std::string message_;
    std::optional<std::chrono::steady_clock::time_point> message_until_; ///< none: until it is closed
};

} // namespace carom::gallery
