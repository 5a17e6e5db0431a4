#include "gallery/options.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace carom::gallery
{

namespace
{

Options read(const std::vector<std::string>& arguments)
{
    std::ostringstream out;
    return read_options(arguments, out).value();
}

std::string refusal_of(const std::vector<std::string>& arguments)
{
    try
    {
        read(arguments);
    }
    catch (const BadUsage& error)
    {
        return error.what();
    }
    catch (const scenes::SceneError& error)
    {
        return error.what();
    }
    return "none";
}

} // namespace

TEST(Options, open_the_first_scene_when_nothing_is_said)
{
    const Options options = read({});
    EXPECT_EQ(options.scene, "planets");
    EXPECT_EQ(options.frames, 0);
}

TEST(Options, are_read)
{
    const Options options =
        read({"--scene", "collisions", "--set", "circles=7", "--set", "boxes=8", "--size", "800x600", "--theme", "light", "--palette",
              "safe", "--show", "contacts", "--no-panels", "--screenshot", "a.png", "--seed", "9"});
    EXPECT_EQ(options.values.size(), 2u);
    EXPECT_EQ(options.width, 800);
    EXPECT_EQ(options.height, 600);
    EXPECT_EQ(options.theme, ThemeKind::Light);
    EXPECT_EQ(options.palette, Palette::ColorBlindSafe);
    EXPECT_FALSE(options.has_panels);
    EXPECT_EQ(options.seed, 9u);
    EXPECT_EQ(options.frames, 120) << "a screenshot needs an end";
}

TEST(Options, say_what_does_not_fit_and_what_would)
{
    EXPECT_NE(refusal_of({"--scene", "planet"}).find("did you mean planets"), std::string::npos);
    EXPECT_NE(refusal_of({"--scene", "collisions", "--set", "circles=-1"}).find("0 to 20000"), std::string::npos);
    EXPECT_NE(refusal_of({"--set", "planets"}).find("NAME=VALUE"), std::string::npos);
    EXPECT_NE(refusal_of({"--size", "0x10"}).find("WIDTHxHEIGHT"), std::string::npos);
    EXPECT_NE(refusal_of({"--size", "10x10x"}).find("WIDTHxHEIGHT"), std::string::npos);
    EXPECT_NE(refusal_of({"--show", "nothing"}).find("contacts"), std::string::npos);
    EXPECT_NE(refusal_of({"--frames", "0"}).find("--help"), std::string::npos);
    EXPECT_NE(refusal_of({"--theme", "pink"}).find("dark or light"), std::string::npos);
    EXPECT_NE(refusal_of({"--seed", "-1"}), "none");
    EXPECT_NE(refusal_of({"--inside", "3"}).find("--frames"), std::string::npos);
    EXPECT_EQ(refusal_of({"--screenshot", "a.jpg"}), "--screenshot: \"a.jpg\" has an unknown format; give a name that ends in .png");
    EXPECT_EQ(refusal_of({"--screenshot", "a.PNG"}), "none");
    EXPECT_EQ(refusal_of({"--screenshot", "-"}), "none");
    EXPECT_NE(refusal_of({"planets"}).find("--scene planets"), std::string::npos);
    EXPECT_NE(refusal_of({"none.json"}).find("No such file"), std::string::npos);
}

TEST(Options, print_the_help)
{
    std::ostringstream out;
    EXPECT_FALSE(read_options({"--help"}, out));
    EXPECT_NE(out.str().find("--screenshot"), std::string::npos);
}

} // namespace carom::gallery
