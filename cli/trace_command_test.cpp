// `carom trace` on files of any kind, and what it draws.
#include "cli/memory_picture.hpp"
#include "cli/program.hpp"

#include <carom/profile.hpp>

#include <algorithm>
#include <cairo.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace carom::cli
{

namespace
{

class TraceCommand : public testing::Test
{
protected:
    TraceCommand() { std::filesystem::create_directory(folder_); }
    ~TraceCommand() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string written(const std::string& name, const std::string& text) const
    {
        std::ofstream(path(name)) << text;
        return path(name);
    }
    int run(const std::vector<std::string>& arguments)
    {
        out_.str("");
        err_.str("");
        return run_program(arguments, {out_, err_});
    }
    void expect_refused(const std::vector<std::string>& arguments, const std::string& words)
    {
        EXPECT_EQ(run(arguments), 2);
        EXPECT_EQ(out_.str(), "");
        EXPECT_NE(err_.str().find(words), std::string::npos) << err_.str();
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("carom_trace_test_" + std::to_string(getpid()));
    std::ostringstream out_;
    std::ostringstream err_;
};

const char* const small_trace = R"({"traceEvents":[
{"ph":"X","tid":1,"name":"step","ts":0,"dur":100},
{"ph":"C","name":"heap","cat":"memory","ts":0,"args":{"bytes":1000}},
{"ph":"C","name":"heap","cat":"memory","ts":50,"args":{"bytes":4000}}]})";

unsigned pixel(cairo_surface_t* picture, int x, int y)
{
    const unsigned char* const row = cairo_image_surface_get_data(picture) + y * cairo_image_surface_get_stride(picture);
    return row[4 * x] | static_cast<unsigned>(row[4 * x + 1]) << 8 | static_cast<unsigned>(row[4 * x + 2]) << 16;
}

} // namespace

TEST_F(TraceCommand, prints_the_zones_and_draws_the_memory)
{
    ASSERT_EQ(run({"trace", written("t.json", small_trace), "--memory", path("m.png")}), 0) << err_.str();
    EXPECT_NE(out_.str().find("1 zone, 0 frames, 0 plots, 1 pool of memory"), std::string::npos) << out_.str();
    EXPECT_NE(out_.str().find("step"), std::string::npos);
    cairo_surface_t* const picture = cairo_image_surface_create_from_png(path("m.png").c_str());
    ASSERT_EQ(cairo_surface_status(picture), CAIRO_STATUS_SUCCESS);
    // The band of the pool is low in the first half and high in the second: between their heights there is ground, then band.
    const unsigned ground = pixel(picture, 5, 5);
    EXPECT_EQ(pixel(picture, 200, 240), ground);
    EXPECT_NE(pixel(picture, 600, 240), ground);
    EXPECT_NE(pixel(picture, 200, 360), ground);
    EXPECT_EQ(pixel(picture, 600, 60), ground);
    cairo_surface_destroy(picture);
}

TEST_F(TraceCommand, without_memory_events_draws_what_the_world_says)
{
    const std::string trace = written("t.json", R"([{"ph":"X","tid":1,"name":"step","ts":0,"dur":100},
        {"ph":"C","name":"bytes in use","ts":1,"args":{"value":5000}}])");
    EXPECT_EQ(run({"trace", trace, "--memory", path("m.png")}), 0) << err_.str();
    EXPECT_TRUE(std::filesystem::exists(path("m.png")));
    EXPECT_NE(out_.str().find("0 pools"), std::string::npos) << out_.str();
}

TEST_F(TraceCommand, draws_any_number_of_pools_and_events)
{
    lab::Trace trace;
    for (int pool = 0; pool < 20; ++pool)
        for (int i = 0; i < 5000; ++i) trace.memory["pool " + std::to_string(pool)].push_back({i * 1e3, 1e6 * pool + i});
    std::ostringstream many;
    draw_memory(trace, many);
    EXPECT_GT(many.str().size(), 1000u);

    lab::Trace one;
    one.memory["nothing"].push_back({7, 0});
    std::ostringstream single;
    draw_memory(one, single);
    EXPECT_GT(single.str().size(), 1000u);
}

TEST_F(TraceCommand, refuses_what_is_no_trace)
{
    expect_refused({"trace", path("absent.json")}, "No such file");
    expect_refused({"trace", folder_.string()}, "it is a folder");
    expect_refused({"trace", written("empty.json", "")}, "is empty");
    expect_refused({"trace", written("text.json", "hello")}, "not a whole JSON text");
    expect_refused({"trace", written("cut.json", std::string(small_trace).substr(0, 150))}, "not a whole JSON text");
    expect_refused({"trace", written("other.json", "{\"a\": 1}")}, "without trace events");
    expect_refused({"trace", written("frames.json", R"([{"ph":"i","name":"frame","ts":1}])")}, "holds no zone");
    expect_refused({"trace"}, "required");
}

TEST_F(TraceCommand, refuses_a_picture_that_it_cannot_draw)
{
    const std::string trace = written("t.json", small_trace);
    expect_refused({"trace", trace, "--memory", path("m.jpg")}, "ends in .png");
    expect_refused({"trace", trace, "--memory", "/nowhere/m.png"}, "can't write");
    const std::string lean = written("lean.json", R"([{"ph":"X","tid":1,"name":"step","ts":0,"dur":100}])");
    expect_refused({"trace", lean, "--memory", path("m.png")}, "tells nothing of memory");
    EXPECT_FALSE(std::filesystem::exists(path("m.png")));
}

TEST_F(TraceCommand, a_build_that_records_no_trace_says_which_preset_does)
{
    if (profiler() == Profiler::Chrome) GTEST_SKIP() << "this build records traces";
    expect_refused({"run", "gravity", "--steps", "1", "--trace", path("t.json")},
                   "--trace: this engine records no trace; build it with the CMake preset `trace`");
    EXPECT_FALSE(std::filesystem::exists(path("t.json")));
}

} // namespace carom::cli
