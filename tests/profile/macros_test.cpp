// The macros are statements that compile with every back end, also where nothing else uses their arguments.
#include <carom/profile.hpp>

#include <gtest/gtest.h>

namespace carom
{

TEST(Profile, macros_are_statements_and_evaluate_their_arguments_at_most_once)
{
    int plotted = 0;
    char block = 0;
    CAROM_THREAD("tests");
    CAROM_ALLOCATED(&block, sizeof(block), "tests");
    for (int i = 0; i < 3; ++i)
    {
        CAROM_ZONE("outer");
        CAROM_ZONE("inner");
        if (i >= 0) CAROM_PLOT("i", ++plotted);
        CAROM_FRAME;
    }
    CAROM_FREED(&block, "tests");
    EXPECT_EQ(plotted, profiler() == Profiler::None ? 0 : 3);
}

TEST(Profile, every_back_end_has_a_name)
{
    EXPECT_EQ(name_of(Profiler::None), "none");
    EXPECT_EQ(name_of(Profiler::Tracy), "tracy");
    EXPECT_EQ(name_of(Profiler::Chrome), "chrome");
}

TEST(Profile, an_engine_that_records_no_trace_says_how_to_get_one_that_does)
{
    if (profiler() == Profiler::Chrome) GTEST_SKIP() << "this engine records traces";
    for (const TraceResult& result : {start_trace(), write_trace("never written")})
    {
        EXPECT_FALSE(result);
        EXPECT_NE(result.problem.find("preset `trace`"), std::string::npos);
        EXPECT_NE(result.problem.find("CAROM_PROFILER=chrome"), std::string::npos);
    }
}

} // namespace carom
