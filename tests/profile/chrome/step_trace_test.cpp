// A trace of the collision scene, from the command line to the file: every stage in every step, and nothing in a step that no stage covers.
#include "cli/program.hpp"
#include "lab/trace.hpp"

#include <carom/carom.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <unistd.h>

namespace carom
{

namespace
{

constexpr int steps = 600;
constexpr int substeps = 4;

class StepTrace : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        path = (std::filesystem::temp_directory_path() / ("carom_step_" + std::to_string(getpid()) + ".json")).string();
        std::ostringstream out;
        std::ostringstream err;
        const int status = cli::run_program({"run", "collisions", "--steps", std::to_string(steps), "--trace", path}, {out, err});
        ASSERT_EQ(status, 0) << err.str();
        ASSERT_EQ(err.str(), "");
        std::ifstream file(path);
        trace = lab::read_trace(file);
    }
    static void TearDownTestSuite() { std::filesystem::remove(path); }

    static inline std::string path;
    static inline lab::Trace trace;
};

bool is_per_substep(Stage stage)
{
    return stage == Stage::IntegrateVelocities || stage == Stage::WarmStart || stage == Stage::Solve ||
           stage == Stage::IntegratePositions || stage == Stage::Relax;
}

/// A step's zone and those of its stages.
struct Step
{
    double start_us;
    double end_us;
    double self_us;
    std::map<std::string, int> stages;
};

std::vector<Step> steps_of(const lab::Trace& trace)
{
    std::vector<Step> found;
    for (const lab::TraceZone& zone : trace.zones)
    {
        const std::string& name = trace.names[zone.name];
        if (name == "step")
            found.push_back({zone.start_us, zone.start_us + zone.duration_us, zone.duration_us, {}});
        else
        {
            EXPECT_FALSE(found.empty()) << name << " stands before the first step";
            if (found.empty()) continue;
            EXPECT_LE(zone.start_us + zone.duration_us, found.back().end_us + 0.001) << name << " reaches out of its step";
            found.back().self_us -= zone.duration_us;
            ++found.back().stages[name];
        }
    }
    return found;
}

} // namespace

TEST_F(StepTrace, holds_every_stage_in_every_step)
{
    const std::vector<Step> found = steps_of(trace);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(steps));
    for (const Step& step : found)
    {
        ASSERT_EQ(step.stages.size(), static_cast<std::size_t>(stage_count));
        for (int i = 0; i < stage_count; ++i)
        {
            const Stage stage = static_cast<Stage>(i);
            const int times = step.stages.at(std::string(name_of(stage)));
            ASSERT_GE(times, 1) << name_of(stage);
            ASSERT_TRUE(!is_per_substep(stage) || times == substeps) << name_of(stage) << " stands " << times << " times";
        }
    }
}

TEST_F(StepTrace, stages_add_up_to_the_step_within_5_percent)
{
    const std::vector<Step> found = steps_of(trace);
    double whole = 0;
    double uncovered = 0;
    int well_covered = 0;
    for (const Step& step : found)
    {
        whole += step.end_us - step.start_us;
        uncovered += step.self_us;
        well_covered += step.self_us < 0.05 * (step.end_us - step.start_us);
    }
    EXPECT_GE(uncovered, 0);
    EXPECT_LT(uncovered, 0.05 * whole);
    // A step may be interrupted by another program between two stages.
    EXPECT_GE(well_covered, 0.95 * steps);
}

TEST_F(StepTrace, has_a_frame_and_a_point_of_every_plot_for_each_step)
{
    EXPECT_EQ(trace.frames_us.size(), static_cast<std::size_t>(steps));
    for (const char* plot : {"bodies", "awake bodies", "contacts", "pairs", "islands awake", "bytes in use"})
        EXPECT_EQ(trace.plots.at(plot).size(), static_cast<std::size_t>(steps)) << plot;
    EXPECT_EQ(trace.plots.at("bodies").back().value, 1001);
    EXPECT_GT(trace.plots.at("bytes in use").back().value, 1e5);
    EXPECT_EQ(trace.dropped, 0u);
}

TEST_F(StepTrace, pools_of_memory_add_up_to_the_bytes_in_use)
{
    double pools = 0;
    for (const char* pool : {"bodies", "shapes", "broad phase", "contacts", "islands", "events", "scratch"})
    {
        ASSERT_TRUE(trace.memory.contains(pool)) << pool;
        pools += trace.memory.at(pool).back().value;
    }
    // All but the world object itself, which comes from no category's resource.
    const double in_use = trace.plots.at("bytes in use").back().value;
    EXPECT_LT(pools, in_use);
    EXPECT_GT(pools, in_use - 10000);
}

TEST_F(StepTrace, the_command_sums_it_up)
{
    std::ostringstream out;
    std::ostringstream err;
    ASSERT_EQ(cli::run_program({"trace", path}, {out, err}), 0) << err.str();
    for (int i = 0; i < stage_count; ++i) EXPECT_NE(out.str().find(name_of(static_cast<Stage>(i))), std::string::npos) << i;
    EXPECT_NE(out.str().find("600 frames"), std::string::npos) << out.str();
}

TEST(GameTrace, zones_of_a_game_stand_around_those_of_the_engine)
{
    const std::string path = (std::filesystem::temp_directory_path() / ("carom_game_" + std::to_string(getpid()) + ".json")).string();
    ASSERT_TRUE(start_trace());
    World world(WorldDef{});
    world.create_body({}, circle(1));
    {
        CAROM_ZONE("my game");
        world.step(1 / 60.0f);
    }
    const TraceResult result = write_trace(path);
    ASSERT_TRUE(result) << result.problem;
    std::ifstream file(path);
    const lab::Trace trace = lab::read_trace(file);
    ASSERT_GE(trace.zones.size(), 2u);
    EXPECT_EQ(trace.names[trace.zones[0].name], "my game");
    EXPECT_EQ(trace.names[trace.zones[1].name], "step");
    EXPECT_LE(trace.zones[1].duration_us, trace.zones[0].duration_us);
    std::filesystem::remove(path);
}

TEST(GameTrace, zones_and_memory_cost_little)
{
    char block = 0;
    ASSERT_TRUE(start_trace());
    const auto start = std::chrono::steady_clock::now();
    constexpr int rounds = 100000;
    for (int i = 0; i < rounds; ++i)
    {
        CAROM_ZONE("zone");
        CAROM_ALLOCATED(&block, 1, "pool");
        CAROM_FREED(&block, "pool");
    }
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count() / rounds, 5); // about 0.15 us; a thing of milliseconds would be a lock or a file
}

} // namespace carom
