// The passes of a run: one to draw the animation, one to measure.
#include "cli/run_command.hpp"

#include "cli/encoder.hpp"
#include "cli/errors.hpp"
#include "cli/input_script.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/render.hpp"
#include "cli/run_report.hpp"
#include "cli/scene_source.hpp"
#include "files/text.hpp"
#include "lab/runner.hpp"

#include <carom/profile.hpp>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace carom::cli
{

using scenes::Scene;
using scenes::SceneInfo;

namespace
{

constexpr scenes::Viewport still_size{1280, 720};
constexpr float animation_rate = 30; // pictures a second, about

scenes::ParameterValues all_values(const RunRequest& request, const SceneInfo& scene)
{
    scenes::ParameterValues values = scenes::parsed_settings(scene.parameters, request.settings);
    if (request.broad_phase)
        values.emplace_back("broad_phase", parsed(find_parameter(scene.parameters, "broad_phase"), *request.broad_phase));
    return values;
}

/// Before any work is done.
void check_formats(const RunRequest& request)
{
    if (request.animation) animation_format_of(*request.animation);
    if (request.still) files::require_ending("--still", *request.still, ".png");
}

void check_profiler(const RunRequest& request)
{
    if (request.trace && profiler() != Profiler::Chrome) throw BadUsage(std::string("--trace: ") + profile::no_chrome_back_end);
}

void start_recording()
{
    if (const TraceResult result = start_trace(); !result) throw Failure("--trace: " + result.problem);
}

void write_recording(files::OutputFile& file, const Surroundings& surroundings)
{
    const TraceResult result = write_trace(file.scratch().string());
    if (!result) throw Failure("--trace: " + result.problem);
    file.commit();
    if (result.dropped > 0)
        surroundings.err << "carom: --trace: " << result.dropped << " events found no room and are not in the file; run fewer steps\n";
}

void draw(const Scene& scene, scenes::DrawList& list, Canvas& canvas)
{
    list.clear();
    scene.draw(list);
    canvas.draw(list, scene.camera());
}

/// What the passes over a scene share.
struct Job
{
    const RunRequest& request;
    const SceneSource& source;
    int steps;
    scenes::ParameterValues values;
    InputScript input;
    Progress progress;
    const Surroundings& surroundings;

    std::unique_ptr<Scene> make() const
    {
        std::unique_ptr<Scene> scene = source.make(values, request.seed.value_or(1));
        if (request.simd) scene->world().set_simd(*request.simd);
        return scene;
    }
    /// A step is done. Files that are not complete go away when this throws.
    void advance()
    {
        progress.advance();
        if (surroundings.is_interrupted && surroundings.is_interrupted()) throw Failure("interrupted");
    }
};

/// Draws every step that a picture shows, so that it plays in real time.
/// @return the hash of the world at the end
std::uint64_t animate(Job& job, files::OutputFile& file)
{
    const std::unique_ptr<Scene> scene = job.make();
    const AnimationFormat format = animation_format_of(file.path());
    const float step_rate = scene->parameters().real("step_rate");
    const int steps_per_frame = std::max(1, static_cast<int>(std::lround(step_rate / animation_rate)));
    Encoder encoder(file.scratch(), format, animation_size(format), static_cast<double>(step_rate) / steps_per_frame);
    Canvas canvas(animation_size(format));
    scenes::DrawList list;

    for (int step = 0; step < job.steps; ++step)
    {
        job.input.apply(*scene, step);
        scene->step();
        job.advance();
        if (step % steps_per_frame != 0) continue;
        draw(*scene, list, canvas);
        encoder.add_frame(canvas.pixels());
    }
    encoder.finish();
    return scene->world().hash();
}

lab::RunResult measure(Job& job, Scene& scene)
{
    return lab::run(scene, {.steps = job.steps, .before_step = [&](Scene& s, int step) {
        job.input.apply(s, step);
    }, .after_step = [&](const Scene&, int) { job.advance(); }, .heap_allocations = job.surroundings.heap_allocations});
}

} // namespace

void run_command(const RunRequest& request, const Surroundings& surroundings)
{
    const SceneSource source = SceneSource::find(request.scene);
    const SceneInfo& info = source.info();
    if (request.seed && !source.has_seed()) throw BadUsage("--seed: a scene file holds no random numbers; leave it out");
    const int steps = request.steps.value_or(source.steps().value_or(600));
    check_formats(request);
    check_profiler(request);
    const int passes = request.animation ? 2 : 1;
    Job job{request,
            source,
            steps,
            all_values(request, info),
            request.input ? InputScript::read(*request.input, info) : InputScript(),
            Progress(surroundings.err, surroundings.err_is_terminal, passes * steps),
            surroundings};
    const std::unique_ptr<Scene> scene = job.make();
    Outputs outputs(surroundings);
    files::OutputFile* const still = outputs.open("--still", request.still);
    files::OutputFile* const animation = outputs.open("--animation", request.animation);
    files::OutputFile* const trace = outputs.open("--trace", request.trace);

    // The animation is drawn in a pass of its own, since drawing between the steps would slow them down.
    const std::uint64_t drawn_hash = animation ? animate(job, *animation) : 0;
    if (trace) start_recording();
    const lab::RunResult result = measure(job, *scene);
    if (trace) write_recording(*trace, surroundings);
    if (animation && drawn_hash != result.hash) throw Failure("two runs of the same scene ended differently; please report this bug");

    if (still)
    {
        Canvas canvas(still_size);
        scenes::DrawList list;
        draw(*scene, list, canvas);
        canvas.write(still->stream());
        still->commit();
    }
    if (animation) animation->commit();
    job.progress.clear();
    if (const std::size_t late = job.input.count_from(steps); late > 0)
        surroundings.err << "carom: --input: " << late << " of " << job.input.size() << " events come after the last step, " << steps - 1
                         << ", and were not used; give more --steps\n";
    outputs.words() << (request.is_json ? run_json(*scene, result).dump(2) + "\n" : files::printable(run_table(*scene, result)));
}

} // namespace carom::cli
