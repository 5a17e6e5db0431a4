// Reads and writes what an engine told.
#include "lab/engine_run.hpp"

#include "files/input_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

namespace carom::lab
{

using nlohmann::ordered_json;

namespace
{

/// Bytes that are not UTF-8, as a path may have, are replaced.
std::string text_of(const ordered_json& json) { return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace); }

ordered_json json_of(const Sample& sample)
{
    ordered_json bodies = ordered_json::array();
    for (const std::optional<BodySample>& b : sample.bodies)
        bodies.push_back(b ? ordered_json{b->x, b->y, b->angle, b->vx, b->vy, b->w} : ordered_json());
    return {{"step", sample.step}, {"bodies", bodies}};
}

/// A peer that lost a body writes null for its numbers, since JSON knows no NaN: those stay NaN for the evaluator to count.
double number_from(const ordered_json& value) { return value.is_null() ? std::nan("") : value.get<double>(); }

std::optional<BodySample> body_from(const ordered_json& j)
{
    if (j.is_null()) return std::nullopt;
    if (j.size() != 6) throw std::runtime_error("a body has " + std::to_string(j.size()) + " numbers; six are expected");
    return BodySample{number_from(j[0]), number_from(j[1]), number_from(j[2]), number_from(j[3]), number_from(j[4]), number_from(j[5])};
}

Sample sample_from(const ordered_json& j)
{
    Sample sample;
    j.at("step").get_to(sample.step);
    for (const ordered_json& body : j.at("bodies")) sample.bodies.push_back(body_from(body));
    return sample;
}

void check_times(const EngineRun& run)
{
    if (run.step_ms.empty()) throw std::runtime_error("it made no step");
    for (const std::vector<double>* times : {&run.step_ms, &run.event_ms, &run.ray_ms})
    {
        if (!times->empty() && times->size() != run.step_ms.size())
            throw std::runtime_error("it has " + std::to_string(times->size()) + " times for " + std::to_string(run.step_ms.size()) +
                                     " steps");
        for (const double ms : *times)
            if (!(ms >= 0) || !std::isfinite(ms)) throw std::runtime_error("a step took " + std::to_string(ms) + " ms");
    }
}

EngineRun run_from(const ordered_json& json)
{
    EngineRun run;
    json.at("engine").get_to(run.engine);
    json.at("version").get_to(run.version);
    json.at("differences").get_to(run.differences);
    json.at("step_ms").get_to(run.step_ms);
    if (json.contains("scene")) json.at("scene").get_to(run.scene);
    if (json.contains("event_ms")) json.at("event_ms").get_to(run.event_ms);
    if (json.contains("draw_ms")) json.at("draw_ms").get_to(run.draw_ms);
    if (json.contains("ray_ms")) json.at("ray_ms").get_to(run.ray_ms);
    if (json.contains("ray_hits")) run.ray_hits = json.at("ray_hits").get<int>();
    for (const ordered_json& sample : json.at("samples")) run.samples.push_back(sample_from(sample));
    if (json.contains("counters")) json.at("counters").get_to(run.counters);
    check_times(run);
    return run;
}

} // namespace

double mean_of(const std::vector<double>& values)
{
    return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> EngineRun::work_ms() const
{
    std::vector<double> work = step_ms;
    for (const std::vector<double>* more : {&event_ms, &ray_ms})
        for (std::size_t i = 0; i < more->size(); ++i) work[i] += (*more)[i];
    return work;
}

bool EngineRun::is_of(const std::filesystem::path& file) const
{
    return scene.empty() || scene == ordered_json::parse(text_of(file.string())).get<std::string>();
}

double EngineRun::mean_ms() const { return mean_of(work_ms()); }

std::vector<double> EngineRun::frame_ms() const
{
    std::vector<double> frames = step_ms;
    for (std::size_t i = 0; i < std::min(frames.size(), draw_ms.size()); ++i) frames[i] += draw_ms[i];
    return frames;
}

std::vector<double> EngineRun::curve(int parts) const
{
    const std::vector<double> work = work_ms();
    const std::size_t count = std::min(static_cast<std::size_t>(parts), work.size());
    std::vector<double> means;
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::size_t begin = i * work.size() / count;
        const std::size_t end = (i + 1) * work.size() / count;
        double sum = 0;
        for (std::size_t step = begin; step < end; ++step) sum += work[step];
        means.push_back(sum / static_cast<double>(end - begin));
    }
    return means;
}

std::string to_json(const EngineRun& run)
{
    ordered_json samples = ordered_json::array();
    for (const Sample& sample : run.samples) samples.push_back(json_of(sample));
    ordered_json json = {{"engine", run.engine}, {"version", run.version}, {"differences", run.differences}, {"step_ms", run.step_ms}};
    if (!run.scene.empty()) json["scene"] = run.scene;
    if (!run.event_ms.empty()) json["event_ms"] = run.event_ms;
    if (!run.draw_ms.empty()) json["draw_ms"] = run.draw_ms;
    if (!run.ray_ms.empty()) json["ray_ms"] = run.ray_ms;
    if (run.ray_hits) json["ray_hits"] = *run.ray_hits;
    if (!run.counters.empty()) json["counters"] = run.counters;
    json["samples"] = samples;
    return text_of(json) + "\n";
}

EngineRun read_run(const std::filesystem::path& file)
{
    if (!std::filesystem::exists(file)) throw std::runtime_error("it wrote no " + file.filename().string());
    std::ifstream in = files::open_input(file);
    try
    {
        return run_from(ordered_json::parse(in));
    }
    catch (const nlohmann::json::exception& error)
    {
        throw std::runtime_error(std::string("its result can't be read: ") + error.what());
    }
}

} // namespace carom::lab
