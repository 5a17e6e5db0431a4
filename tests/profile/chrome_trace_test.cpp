// What the recorder writes, the laboratory reads: zones, plots, frames and pools of one thread and of many.
#include "lab/trace.hpp"
#include "profile/chrome_trace.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>
#include <vector>

namespace carom::profile
{

namespace
{

using namespace std::chrono_literals;

class Recorder : public testing::Test
{
protected:
    Recorder()
    {
        recorder_.start({});
        now_ = ChromeTrace::Clock::now();
    }
    ~Recorder() override { std::filesystem::remove(path_); }

    TraceResult write() { return recorder_.write(path_); }
    nlohmann::json written()
    {
        EXPECT_TRUE(write()) << "could not write";
        std::ifstream file(path_);
        return nlohmann::json::parse(file);
    }
    lab::Trace trace()
    {
        const TraceResult result = write();
        EXPECT_TRUE(result) << result.problem;
        std::ifstream file(path_);
        return lab::read_trace(file);
    }

    ChromeTrace recorder_;
    const std::string path_ = (std::filesystem::temp_directory_path() / ("carom_recorder_" + std::to_string(getpid()) + ".json")).string();
    ChromeTrace::Clock::time_point now_; ///< the recording has just begun
};

} // namespace

TEST_F(Recorder, writes_zones_to_the_nanosecond)
{
    recorder_.add_zone("inner", now_ + 1001ns, now_ + 3004ns);
    recorder_.add_zone("outer", now_, now_ + 12345ns);
    const lab::Trace trace = this->trace();
    ASSERT_EQ(trace.zones.size(), 2u);
    const lab::TraceZone& outer = trace.zones[0];
    const lab::TraceZone& inner = trace.zones[1];
    EXPECT_EQ(trace.names[outer.name], "outer");
    EXPECT_EQ(trace.names[inner.name], "inner");
    EXPECT_DOUBLE_EQ(outer.duration_us, 12.345);
    EXPECT_DOUBLE_EQ(inner.duration_us, 2.003);
    EXPECT_NEAR(inner.start_us - outer.start_us, 1.001, 1e-9);
}

TEST_F(Recorder, leaves_out_zones_that_began_before_the_recording)
{
    recorder_.add_zone("early", now_ - 10s, now_);
    recorder_.add_zone("late", now_, now_ + 1us);
    EXPECT_EQ(trace().names, std::vector<std::string>{"late"});
}

TEST_F(Recorder, keeps_plots_and_leaves_out_what_is_not_finite)
{
    recorder_.add_plot("speed", 0.1);
    recorder_.add_plot("speed", std::numeric_limits<double>::quiet_NaN());
    recorder_.add_plot("speed", -std::numeric_limits<double>::infinity());
    recorder_.add_plot("speed", -1e300);
    const lab::Trace trace = this->trace();
    const std::vector<lab::TracePoint>& points = trace.plots.at("speed");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].value, 0.1);
    EXPECT_EQ(points[1].value, -1e300);
}

TEST_F(Recorder, notes_pools_at_frames_with_the_peak_between)
{
    std::vector<char> memory(3);
    recorder_.add_block(&memory[0], 100, "mine");
    recorder_.add_frame();
    recorder_.add_block(&memory[1], 900, "mine");
    recorder_.remove_block(&memory[1]);
    recorder_.add_frame();
    recorder_.add_frame(); // nothing has changed
    recorder_.remove_block(&memory[0]);
    const lab::Trace trace = this->trace(); // the end counts as well
    std::vector<double> bytes;
    for (const lab::TracePoint& point : trace.memory.at("mine")) bytes.push_back(point.value);
    EXPECT_EQ(bytes, (std::vector<double>{100, 1000, 100, 0}));
    EXPECT_EQ(trace.frames_us.size(), 3u);
}

TEST_F(Recorder, a_recording_starts_with_the_memory_that_is_in_use)
{
    char memory = 0;
    recorder_.add_block(&memory, 64, "old");
    ASSERT_TRUE(write());
    recorder_.start({});
    const lab::Trace trace = this->trace();
    ASSERT_FALSE(trace.memory.at("old").empty());
    EXPECT_EQ(trace.memory.at("old").front().value, 64);
}

TEST_F(Recorder, has_a_log_for_each_thread_also_after_its_end)
{
    recorder_.name_thread("the first");
    recorder_.add_zone("here", now_, now_ + 1us);
    for (int i = 0; i < 2; ++i)
    {
        std::thread([&]
        {
            recorder_.name_thread("a worker");
            recorder_.add_zone("there", now_, now_ + 1us);
        }).join();
    }
    std::vector<std::string> names;
    std::vector<int> threads;
    const nlohmann::json trace = written();
    for (const nlohmann::json& event : trace["traceEvents"])
    {
        if (event["name"] == "thread_name") names.push_back(event["args"]["name"]);
        if (event["ph"] == "X") threads.push_back(event["tid"]);
    }
    EXPECT_EQ(std::count(names.begin(), names.end(), "the first"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "a worker"), 2);
    std::sort(threads.begin(), threads.end());
    EXPECT_EQ(threads.size(), 3u);
    EXPECT_EQ(std::unique(threads.begin(), threads.end()), threads.end());
}

TEST_F(Recorder, escapes_names)
{
    recorder_.add_zone("a \"quoted\" \\ and\na line\x01", now_, now_ + 1us);
    EXPECT_EQ(trace().names, std::vector<std::string>{"a \"quoted\" \\ and\na line\x01"});
}

TEST_F(Recorder, drops_what_finds_no_room_and_counts_it)
{
    recorder_.start({.max_events = 1}); // rounded up to 2048
    for (int i = 0; i < 3000; ++i) recorder_.add_plot("n", i);
    const TraceResult result = write();
    EXPECT_TRUE(result);
    EXPECT_EQ(result.events, 2048u);
    EXPECT_EQ(result.dropped, 952u);
    std::ifstream file(path_);
    const lab::Trace trace = lab::read_trace(file);
    EXPECT_EQ(trace.dropped, 952u);
    EXPECT_EQ(trace.plots.at("n").size(), 2048u);
}

TEST_F(Recorder, records_nothing_outside_of_a_recording)
{
    ASSERT_TRUE(write());
    recorder_.add_plot("n", 1);
    const TraceResult result = write();
    EXPECT_FALSE(result);
    EXPECT_NE(result.problem.find("start_trace"), std::string::npos);
    recorder_.start({});
    recorder_.add_plot("m", 1);
    EXPECT_FALSE(trace().plots.contains("n"));
}

TEST_F(Recorder, keeps_the_recording_when_the_file_cannot_be_written)
{
    recorder_.add_plot("n", 1);
    const TraceResult result = recorder_.write("/nowhere/at/all.json");
    EXPECT_FALSE(result);
    EXPECT_NE(result.problem.find("/nowhere/at/all.json"), std::string::npos);
    EXPECT_EQ(trace().plots.at("n").size(), 1u);
}

TEST_F(Recorder, tells_when_the_disk_is_full)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    for (int i = 0; i < 10000; ++i) recorder_.add_plot("n", i);
    EXPECT_FALSE(recorder_.write("/dev/full"));
    EXPECT_EQ(trace().plots.at("n").size(), 10000u);
}

TEST_F(Recorder, threads_may_record_while_it_starts_and_writes)
{
    std::atomic<bool> is_over = false;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
    {
        threads.emplace_back([&]
        {
            while (!is_over)
            {
                const auto now = ChromeTrace::Clock::now();
                recorder_.add_zone("busy", now, now + 1us);
                recorder_.add_block(&now, 8, "pool");
                recorder_.add_frame();
                recorder_.remove_block(&now);
            }
        });
    }
    for (int i = 0; i < 10; ++i)
    {
        recorder_.start({.max_events = 4000});
        std::this_thread::sleep_for(1ms);
        const TraceResult result = write();
        EXPECT_TRUE(result) << result.problem;
        std::ifstream file(path_);
        const lab::Trace trace = lab::read_trace(file);
        EXPECT_LE(trace.zones.size() + trace.frames_us.size(), result.events);
    }
    is_over = true;
    for (std::thread& thread : threads) thread.join();
}

} // namespace carom::profile
