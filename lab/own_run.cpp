// Steps a scene file and writes down what the laboratory asks for.
#include "lab/own_run.hpp"

#include "lab/sampling.hpp"
#include "lab/scene_file/painting.hpp"
#include "scene_file/player.hpp"

#include <carom/version.hpp>

#include <algorithm>
#include <map>

namespace carom::lab
{

namespace
{

std::optional<BodySample> sample_of(const World& world, BodyId id)
{
    const std::optional<BodyView> body = world.find_body(id);
    if (!body) return std::nullopt;
    const Vec2 p = body->position();
    const Vec2 v = body->linear_velocity();
    return BodySample{.x = static_cast<double>(p.x),
                      .y = static_cast<double>(p.y),
                      .angle = static_cast<double>(body->angle()),
                      .vx = static_cast<double>(v.x),
                      .vy = static_cast<double>(v.y),
                      .w = static_cast<double>(body->angular_velocity())};
}

Sample sample_of(const World& world, const FilePlayback& playback, int step)
{
    Sample sample{.step = step, .bodies = {}};
    for (int i = 0; i < playback.body_count(); ++i) sample.bodies.push_back(sample_of(world, playback.body(i)));
    return sample;
}

/// Lets time pass with work.
/// @return how long it was [ms]
double waited_ms(double ms)
{
    return timed_ms([&]
    {
        const auto start = std::chrono::steady_clock::now();
        while (std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() < ms)
        {
        }
    });
}

/// Sums over steps.
class Counts
{
public:
    void add(const StepReport& report, bool is_late)
    {
        ++steps_;
        pairs_tested_ += static_cast<double>(report.broad_phase.pairs_tested);
        find_pairs_ms_ += 1000 * report.stage_seconds[static_cast<std::size_t>(Stage::FindPairs)];
        memory_ = std::max(memory_, report.memory.total.peak_bytes);
        if (!is_late) return;
        ++late_steps_;
        allocations_ += static_cast<double>(report.allocations);
    }

    std::map<std::string, double> means() const
    {
        return {{"pairs_tested", pairs_tested_ / std::max(steps_, 1)},
                {"find_pairs_ms", find_pairs_ms_ / std::max(steps_, 1)},
                {"allocations", allocations_ / std::max(late_steps_, 1)},
                {"memory_bytes", static_cast<double>(memory_)}};
    }

private:
    int steps_ = 0;
    int late_steps_ = 0;
    double pairs_tested_ = 0;
    double find_pairs_ms_ = 0;
    double allocations_ = 0;
    std::size_t memory_ = 0;
};

/// Draws the world as it is.
class Pictures
{
public:
    Pictures(const SceneFile& file, const World& world, const OwnRunOptions& options)
        : options_(options),
          camera_(FilePainting::camera_of(file, world)),
          painting_(file)
    {
    }

    void draw(const World& world, const FilePlayback& playback)
    {
        painting_.paint_new_bodies(world, playback);
        list_.clear();
        painting_.draw(world, camera_, list_);
        options_.draw(list_, camera_);
    }

private:
    const OwnRunOptions& options_;
    scenes::Camera camera_;
    FilePainting painting_;
    scenes::DrawList list_;
};

} // namespace

EngineRun run_carom(const SceneFile& file, const std::string& name, const OwnRunOptions& options)
{
    EngineRun run;
    run.engine = "carom";
    run.scene = name;
    if (options.threads > 1) run.differences.emplace_back("steps on one thread, however many are offered");
    if (options.broad_phase != BroadPhaseType::Tree)
        run.differences.push_back("finds pairs by the broad phase " + std::string(name_of(options.broad_phase)));
    WorldDef def = FilePlayback::world_def(file);
    def.broad_phase = options.broad_phase;
    def.simd = options.simd;
    World world(def);
    run.version = std::string(CAROM_VERSION) + ", " + std::string(name_of(world.simd()));
    FilePlayback playback(file, name);
    playback.begin(world);
    Counts counts;
    Pictures pictures(file, world, options);
    for (int step = 0; step < file.steps; ++step)
    {
        const double event_ms = timed_ms([&] { playback.before_step(world, step); });
        StepReport report;
        const double step_ms = timed_ms([&] { report = world.step(file.time_step, file.substeps); });
        run.step_ms.push_back(step_ms + (options.slowdown > 0 ? waited_ms(options.slowdown * step_ms) : 0));
        counts.add(report, 2 * step >= file.steps);
        if (!file.events.empty()) run.event_ms.push_back(event_ms);
        if (options.draw) run.draw_ms.push_back(timed_ms([&] { pictures.draw(world, playback); }));
        if (!file.rays.empty()) run.ray_ms.push_back(timed_ms([&] { run.ray_hits = playback.cast_rays(world).hits; }));
        if (is_sampled(step, file.steps, options.samples)) run.samples.push_back(sample_of(world, playback, step + 1));
    }
    run.counters = counts.means();
    return run;
}

} // namespace carom::lab
