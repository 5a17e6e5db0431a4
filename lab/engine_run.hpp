// What a program that runs a scene file for the laboratory tells about its run.
//
// Carom and its peers are programs of one kind:
//
//     PROGRAM SCENE.json --threads N --samples K --out RESULT.json
//
// They make the scene, step it as often as its file says, time every step by itself, and write where the bodies are at K moments at equal
// distances, the last one at the end. A step's time is that of the engine's own step alone; events and rays are timed by themselves. The result
// names the scene as the command line did; a program that leaves the name out is believed. Exit status: 0 done, 3 the engine lacks something
// that the scene needs (said on standard error), anything else failed.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carom::lab
{

inline constexpr int status_can_not = 3;

/// Where a body is and how it moves.
struct BodySample
{
    double x = 0; ///< of the origin [m]
    double y = 0;
    double angle = 0; ///< [rad]
    double vx = 0;    ///< of the centre of mass [m/s]
    double vy = 0;
    double w = 0; ///< [rad/s]
};

/// All bodies of a file after a step, by their numbers; none for those that are not there then.
struct Sample
{
    int step = 0; ///< steps that were made
    std::vector<std::optional<BodySample>> bodies;
};

struct EngineRun
{
    std::string engine;
    std::string version;
    std::vector<std::string> differences;        ///< of its settings from those that the file asks for
    std::vector<double> step_ms;                 ///< of every step [ms]
    std::vector<double> event_ms = {};           ///< before every step, for what the file's events ask for; empty without events [ms]
    std::vector<double> draw_ms = {};            ///< after every step, for drawing the picture; empty when nothing is drawn [ms]
    std::vector<double> ray_ms = {};             ///< after every step, for all rays; empty without rays [ms]
    std::optional<int> ray_hits = {};            ///< rays that met something after the last step
    std::vector<Sample> samples;                 ///< by step
    std::map<std::string, double> counters = {}; ///< what else an engine counts, by name; may be left out
    std::string scene = {};                      ///< the file, as the command line named it; empty when the program does not tell

    /// What the scene asks of the engine in each step, which is what engines are compared by: the step, the events before it and the rays after it [ms].
    std::vector<double> work_ms() const;
    double mean_ms() const; ///< of the work
    /// Whether it says that it is of that file, or does not say of which.
    bool is_of(const std::filesystem::path& file) const;
    /// Of every step and the drawing of its picture [ms].
    std::vector<double> frame_ms() const;
    /// Of the work, means of `parts` equal parts of the run, or of every step when there are fewer.
    std::vector<double> curve(int parts) const;
};

double mean_of(const std::vector<double>& values); ///< 0 of none

std::string to_json(const EngineRun& run);
/// @throws std::runtime_error saying what is wrong with the file, or that a number in it is not finite
EngineRun read_run(const std::filesystem::path& file);

} // namespace carom::lab
