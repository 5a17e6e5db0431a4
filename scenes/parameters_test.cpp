// What parameters take and refuse, and the words with which they do.
#include "scenes/parameters.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace carom::scenes
{

namespace
{

const std::vector<ParameterInfo> infos = {
    integer("circles", {0, 500, 20000}, "", Applies::OnRestart, "how many"),
    real("speed", {0, 10, 50}, "m/s", Applies::Live, "how fast"),
    boolean("spin", true, Applies::Live, "whether"),
    choice("kind", {"Quadtree", "Tree"}, Applies::Live, "which"),
};

std::string message_of(const auto& action)
{
    try
    {
        action();
    }
    catch (const SceneError& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(Parameters, start_at_their_defaults)
{
    const Parameters parameters(infos);
    EXPECT_EQ(parameters.integer("circles"), 500);
    EXPECT_EQ(parameters.real("speed"), 10);
    EXPECT_TRUE(parameters.boolean("spin"));
    EXPECT_EQ(parameters.choice("kind"), "Quadtree");
}

TEST(Parameters, take_values_of_their_kind)
{
    Parameters parameters(infos);
    parameters.set("circles", 20000);
    parameters.set("speed", 2.5);
    parameters.set("spin", false);
    parameters.set("kind", "tree");
    EXPECT_EQ(parameters.integer("circles"), 20000);
    EXPECT_EQ(parameters.real("speed"), 2.5f);
    EXPECT_FALSE(parameters.boolean("spin"));
    EXPECT_EQ(parameters.choice("kind"), "Tree");
}

TEST(Parameters, take_an_integer_for_a_real_and_a_whole_real_for_an_integer)
{
    Parameters parameters(infos);
    parameters.set("speed", 3);
    parameters.set("circles", 7.0);
    EXPECT_EQ(parameters.real("speed"), 3);
    EXPECT_EQ(parameters.integer("circles"), 7);
}

TEST(Parameters, refuse_what_does_not_fit_and_keep_their_value)
{
    Parameters parameters(infos);
    EXPECT_EQ(message_of([&] { parameters.set("circles", 30000); }), "circles: 30000 is out of range; give an integer from 0 to 20000");
    EXPECT_EQ(message_of([&] { parameters.set("speed", -0.5); }), "speed: -0.5 is out of range; give a number from 0 to 50 m/s");
    EXPECT_EQ(message_of([&] { parameters.set("speed", std::numeric_limits<double>::quiet_NaN()); }),
              "speed: nan is out of range; give a number from 0 to 50 m/s");
    EXPECT_EQ(message_of([&] { parameters.set("circles", 1.5); }), "circles: 1.5 is not an integer; give an integer from 0 to 20000");
    EXPECT_EQ(message_of([&] { parameters.set("circles", true); }),
              "circles: true is not of type integer; give an integer from 0 to 20000");
    EXPECT_EQ(message_of([&] { parameters.set("spin", 1); }), "spin: 1 is not of type boolean; give true or false");
    EXPECT_EQ(message_of([&] { parameters.set("kind", "Tee"); }),
              "kind: \"Tee\" is not a choice (did you mean Tree?); give one of Quadtree, Tree");
    EXPECT_EQ(message_of([&] { parameters.set("circels", 1); }), "circels: no such parameter; did you mean circles?");
    EXPECT_EQ(parameters.values(), Parameters(infos).values());
}

TEST(Parameters, are_read_from_text)
{
    EXPECT_EQ(parsed(infos[0], "1e3"), ParameterValue(1000));
    EXPECT_EQ(parsed(infos[1], "2.5"), ParameterValue(2.5));
    EXPECT_EQ(parsed(infos[2], "off"), ParameterValue(false));
    EXPECT_EQ(parsed(infos[3], "QUADTREE"), ParameterValue("Quadtree"));
}

TEST(Parameters, refuse_text_that_does_not_fit)
{
    EXPECT_EQ(message_of([] { parsed(infos[0], "ten"); }), "circles: \"ten\" can't be read; give an integer from 0 to 20000");
    for (const char* text : {"", " 1", "1 ", "1x", "0x10", "1,5", "--1", "nan", "inf", "1e999", "-1", "99999999999999999999"})
    {
        EXPECT_THROW(parsed(infos[0], text), SceneError) << text;
        EXPECT_THROW(parsed(infos[1], text), SceneError) << text;
        EXPECT_THROW(parsed(infos[2], text), SceneError) << text;
        EXPECT_THROW(parsed(infos[3], text), SceneError) << text;
    }
}

TEST(Parameters, are_written_as_a_person_would)
{
    EXPECT_EQ(to_text(34.0), "34");
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(100000.0), "100000");
    EXPECT_EQ(to_text(-9.81), "-9.81");
    EXPECT_EQ(to_text(1e-20), "1e-20");
    EXPECT_EQ(to_text(std::int64_t{12}), "12");
    EXPECT_EQ(to_text(true), "true");
}

} // namespace carom::scenes
