// Traces by hand, good and bad.
#include "lab/trace.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace carom::lab
{

namespace
{

Trace parsed(const std::string& text)
{
    std::istringstream stream(text);
    return read_trace(stream);
}

std::string problem_with(const std::string& text)
{
    try
    {
        parsed(text);
    }
    catch (const TraceError& error)
    {
        return error.what();
    }
    return "none";
}

std::string zone(const std::string& name, double start, double length, int thread = 1)
{
    std::ostringstream text;
    text << R"({"ph":"X","pid":1,"tid":)" << thread << R"(,"name":")" << name << R"(","ts":)" << start << R"(,"dur":)" << length << "}";
    return text.str();
}

const ZoneSummary& find(const std::vector<ZoneSummary>& zones, const std::string& name)
{
    for (const ZoneSummary& zone : zones)
    {
        if (zone.name == name) return zone;
    }
    throw std::out_of_range(name);
}

} // namespace

TEST(Trace, sums_up_zones_with_what_is_their_own)
{
    // Two steps of 100 and 200 us, whose stages take 90 and 150; another thread at the same time.
    const Trace trace = parsed("[" + zone("solve", 5, 90) + "," + zone("step", 0, 100) + "," + zone("other", 0, 1000, 2) + "," +
                               zone("solve", 310, 100) + "," + zone("relax", 410, 50) + "," + zone("step", 300, 200) + "]");
    const std::vector<ZoneSummary> zones = summarize_zones(trace);
    ASSERT_EQ(zones.size(), 4u);
    EXPECT_EQ(zones[0].name, "other"); // the greatest total first
    const ZoneSummary& step = find(zones, "step");
    EXPECT_EQ(step.count, 2u);
    EXPECT_DOUBLE_EQ(step.total_us, 300);
    EXPECT_DOUBLE_EQ(step.self_us, 60);
    EXPECT_DOUBLE_EQ(step.mean_us, 150);
    EXPECT_DOUBLE_EQ(step.median_us, 150);
    EXPECT_DOUBLE_EQ(step.p99_us, 199);
    EXPECT_DOUBLE_EQ(find(zones, "solve").self_us, 190);
    EXPECT_DOUBLE_EQ(find(zones, "other").self_us, 1000);
    EXPECT_NE(zone_table(trace).find("100.0%   20.0%"), std::string::npos) << zone_table(trace);
}

TEST(Trace, only_direct_children_are_taken_off)
{
    const std::vector<ZoneSummary> zones =
        summarize_zones(parsed("[" + zone("a", 0, 100) + "," + zone("b", 0, 60) + "," + zone("c", 10, 20) + "]"));
    EXPECT_DOUBLE_EQ(find(zones, "a").self_us, 40);
    EXPECT_DOUBLE_EQ(find(zones, "b").self_us, 40);
    EXPECT_DOUBLE_EQ(find(zones, "c").self_us, 20);
}

TEST(Trace, zones_that_follow_at_once_are_no_children)
{
    const std::vector<ZoneSummary> zones = summarize_zones(parsed("[" + zone("a", 0, 0.1) + "," + zone("b", 0.1, 0.2) + "]"));
    EXPECT_DOUBLE_EQ(find(zones, "a").self_us, 0.1);
    EXPECT_DOUBLE_EQ(find(zones, "b").self_us, 0.2);
}

TEST(Trace, takes_an_object_and_leaves_out_what_it_does_not_know)
{
    const Trace trace =
        parsed(R"({"displayTimeUnit":"ns","otherData":{"dropped_events":3,"ph":"X"},"stackFrames":{"a":{"ph":"X"}},"traceEvents":[
        {"ph":"B","name":"begin","ts":1}, 17, {"no":"phase"}, {"ph":"i","name":"frame","ts":4.5,"s":"p"},
        {"ph":"C","name":"heap","ts":2,"cat":"memory","args":{"bytes":8}}, {"ph":"C","name":"memory: heap","ts":1,"cat":"memory","args":{"bytes":6}},
        {"ph":"C","name":"n","ts":2,"args":{"value":-1.5}}, {"ph":"C","name":"n","ts":2,"args":{"value":"text"}},
        {"ph":"X","name":"zone","ts":1,"dur":2,"args":{"ph":{"ph":"X"}}}]})");
    EXPECT_EQ(trace.dropped, 3u);
    EXPECT_EQ(trace.frames_us, std::vector<double>{4.5});
    EXPECT_EQ(trace.zones.size(), 1u);
    ASSERT_EQ(trace.memory.at("heap").size(), 2u);
    EXPECT_EQ(trace.memory.at("heap")[0].value, 6); // by time
    EXPECT_EQ(trace.plots.at("n").size(), 1u);
}

TEST(Trace, refuses_what_is_none)
{
    EXPECT_NE(problem_with("").find("is empty"), std::string::npos);
    for (const char* text : {"hello", "{", "[{\"ph\":\"X\",",
                             "["
                             "\x80"
                             "]",
                             "[1e999]", "\n\n"})
        EXPECT_NE(problem_with(text).find("not a whole JSON text"), std::string::npos) << text << ": " << problem_with(text);
    for (const char* text : {"[]", "{}", "17", "null", R"({"traceEvents":17})", R"({"events":[{"ph":"X","name":"a","ts":1,"dur":1}]})"})
        EXPECT_NE(problem_with(text).find("without trace events"), std::string::npos) << text << ": " << problem_with(text);
    EXPECT_NE(problem_with(R"([{"ph":"X","name":"solve","dur":1}])").find("\"solve\", has no number \"ts\""), std::string::npos);
    EXPECT_NE(problem_with(std::string(2'000'000, '[')).find("not a whole JSON text"), std::string::npos);
}

TEST(Trace, every_prefix_of_a_trace_is_refused)
{
    const std::string whole = R"({"traceEvents":[)" + zone("a", 0, 1) + "," + zone("b", 2, 1) + "]}";
    for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(problem_with(whole.substr(0, length)), "none") << length;
    EXPECT_EQ(problem_with(whole), "none");
}

TEST(Trace, a_table_needs_a_zone)
{
    const Trace trace = parsed(R"([{"ph":"i","name":"frame","ts":1}])");
    EXPECT_THROW(zone_table(trace), TraceError);
}

TEST(Trace, without_steps_shares_are_of_the_time_that_zones_cover)
{
    const std::string table = zone_table(parsed("[" + zone("draw", 10, 50) + "," + zone("load", 60, 50) + "]"));
    EXPECT_NE(table.find("of time"), std::string::npos);
    EXPECT_NE(table.find("50.0%"), std::string::npos) << table;
}

} // namespace carom::lab
