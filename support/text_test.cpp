// Which name a slip is taken for.
#include "support/text.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace carom::support
{

namespace
{

const std::vector<std::string> names = {"circles", "boxes", "cover", "speed"};

} // namespace

TEST(Text, finds_the_name_that_was_meant)
{
    EXPECT_EQ(closest("circels", names), "circles");
    EXPECT_EQ(closest("CIRCLE", names), "circles");
    EXPECT_EQ(closest("box", names), "");
    EXPECT_EQ(closest("boxs", names), "boxes");
    EXPECT_EQ(closest("temperature", names), "");
    EXPECT_EQ(closest("", names), "");
    EXPECT_EQ(closest(std::string(1000000, 'c'), names), "");
}

TEST(Text, suggests_all_names_when_none_is_close)
{
    EXPECT_EQ(suggestion("sped", names), "did you mean speed?");
    EXPECT_EQ(suggestion("temperature", names), "there are circles, boxes, cover, speed");
}

} // namespace carom::support
