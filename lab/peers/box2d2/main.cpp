// Runs a scene file with Box2D 2.4: see lab/engine_run.hpp for the protocol.
#include "files/output_file.hpp"
#include "files/text.hpp"
#include "lab/peers/box2d2/engine.hpp"
#include "lab/sampling.hpp"
#include "scene_file/reader.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace
{

using namespace carom::lab;

struct Arguments
{
    std::string scene;
    std::string out;
    int threads = 1;
    int samples = 1;
};

std::string version()
{
    return std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." + std::to_string(b2_version.revision);
}

void run(const Arguments& arguments)
{
    const SceneFile file = read_scene_file(arguments.scene);
    box2d2::require_features(file);
    carom::files::OutputFile out("--out", arguments.out);
    EngineRun run;
    run.scene = arguments.scene;
    run.engine = "box2d2";
    run.version = version();
    run.differences = box2d2::differences(file, arguments.threads);
    box2d2::Engine engine(file);
    for (int step = 0; step < file.steps; ++step)
    {
        const double event_ms = timed_ms([&] { engine.before_step(step); });
        run.step_ms.push_back(timed_ms([&] { engine.step(); }));
        const double break_ms = timed_ms([&] { engine.break_joints(); });
        if (!file.events.empty()) run.event_ms.push_back(event_ms + break_ms);
        if (!file.rays.empty()) run.ray_ms.push_back(timed_ms([&] { run.ray_hits = engine.cast_rays(); }));
        if (is_sampled(step, file.steps, arguments.samples)) run.samples.push_back({step + 1, engine.bodies()});
    }
    out.stream() << to_json(run);
    out.commit();
}

} // namespace

int main(int argc, char** argv)
{
    Arguments arguments;
    CLI::App app("Runs a scene file of Carom with Box2D 2.4", "carom-peer-box2d2");
    app.add_option("SCENE", arguments.scene, "the scene file")->required();
    app.add_option("--threads", arguments.threads)->check(CLI::Range(1, 64));
    app.add_option("--samples", arguments.samples, "moments at which the bodies are written")->check(CLI::Range(1, 1'000'000));
    app.add_option("--out", arguments.out, "the result")->required();
    CLI11_PARSE(app, argc, argv);
    try
    {
        run(arguments);
        return 0;
    }
    catch (const box2d2::Lacking& lacking)
    {
        std::fprintf(stderr, "carom-peer-box2d2: %s: the engine lacks %s\n", carom::files::printable(arguments.scene).c_str(),
                     lacking.what());
        return status_can_not;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "carom-peer-box2d2: %s\n", carom::files::printable(error.what()).c_str());
        return 1;
    }
}
