#include "gallery/scene_source.hpp"

#include "files/testing.hpp"
#include "gallery/session.hpp"
#include "scenes/framing.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

namespace carom::gallery
{

namespace
{

namespace fs = std::filesystem;

std::string scene_text(int balls)
{
    std::string text = R"({"carom_scene": 1, "name": "Balls", "bodies": [)";
    for (int i = 0; i < balls; ++i)
        text += std::string(i > 0 ? ", " : "") + R"({"position": [)" + std::to_string(2 * i) +
                R"(, 5], "shapes": [{"circle": {"radius": 0.5}}]})";
    return text + "]}";
}

/// A folder with a scene of two balls.
class SceneFiles : public ::testing::Test
{
protected:
    void SetUp() override { write(scene_text(2)); }
    void write(const std::string& text) const { std::ofstream(file_) << text; }

    /// Frames until a condition holds, or for five seconds.
    template <class Condition>
    static bool comes_true(Session& session, const Condition& condition)
    {
        for (int i = 0; i < 500 && !condition(); ++i)
        {
            session.advance(1 / 60.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return condition();
    }

    const files::testing::TemporaryFolder folder_{"scene_source"};
    const fs::path file_ = folder_ / "balls.json";
};

} // namespace

TEST(SceneSource, the_list_has_benchmarks_with_a_size)
{
    for (const char* name : {"large_pyramid", "tumbler", "rain", "joint_grid", "spinner"})
    {
        const SceneSource& source = find_source(name);
        EXPECT_EQ(source.info().group, "Benchmarks");
        const scenes::ParameterInfo& size = scenes::find_parameter(source.info().parameters, "size");
        EXPECT_LT(size.min, size.max);
        const auto usual = source.make({}, 1);
        const auto small = source.make({{"size", std::int64_t{3}}}, 1);
        for (scenes::Scene* scene : {usual.get(), small.get()})
            for (int i = 0; i < 30; ++i) scene->step(); // dolls of the rain come one column after the other
        EXPECT_GT(usual->world().body_count(), small->world().body_count()) << name;
        EXPECT_EQ(std::get<std::int64_t>(usual->parameters().value("size")), std::get<std::int64_t>(size.initial));
        EXPECT_EQ(usual->info().title, source.info().title);
    }
    EXPECT_THROW(find_source("large_pyramids"), scenes::SceneError);
}

TEST(SceneSource, benchmarks_begin_in_the_picture)
{
    for (const SceneSource& source : catalogue())
    {
        if (source.info().group != "Benchmarks") continue;
        const auto scene = source.make({}, 1);
        const Aabb seen = scenes::visible_box(scene->camera());
        if (source.info().name == "rain") continue; // nothing has begun to fall
        const Aabb movable = scenes::movable_bounds(scene->world()).value();
        EXPECT_GE(movable.min.x, seen.min.x) << source.info().name;
        EXPECT_LE(movable.max.x, seen.max.x) << source.info().name;
        EXPECT_GE(movable.min.y, seen.min.y) << source.info().name;
        EXPECT_LE(movable.max.y, seen.max.y) << source.info().name;
        EXPECT_GE(scene->camera().width, movable.max.x - movable.min.x) << source.info().name;
    }
}

TEST_F(SceneFiles, open_and_are_kept_in_the_list)
{
    Session session("gravity", {}, 1);
    session.open_file(file_);
    EXPECT_EQ(session.message(), "");
    EXPECT_EQ(session.scene().world().body_count(), 2);
    EXPECT_EQ(session.source().info().title, "Balls");
    ASSERT_EQ(session.opened_files().size(), 1u);
    session.open_file(file_);
    EXPECT_EQ(session.opened_files().size(), 1u) << "once";
    session.restart();
    EXPECT_EQ(session.scene().world().body_count(), 2);
    session.open_neighbor(1);
    EXPECT_EQ(session.source().info().name, "planets") << "from a file the list goes on at its start";
}

TEST_F(SceneFiles, say_why_they_do_not_open_and_the_scene_goes_on)
{
    Session session("gravity", {}, 1);
    session.open_file(folder_ / "missing.json");
    EXPECT_NE(session.message().find("missing.json"), std::string::npos);
    EXPECT_NE(session.message().find("No such file"), std::string::npos) << session.message();
    session.open_file(folder_.path());
    EXPECT_NE(session.message().find("folder"), std::string::npos) << session.message();
    write("{\"carom_scene\": 1, \"bodies\": [\n  {\"position\": [1,, 2]}\n]}");
    session.open_file(file_);
    EXPECT_NE(session.message().find("balls.json:2:"), std::string::npos) << session.message();
    EXPECT_EQ(session.source().info().name, "gravity");
}

TEST_F(SceneFiles, are_read_again_when_they_change)
{
    Session session(SceneSource::of_file(file_), {{"show_bounds", true}}, 1);
    write(scene_text(5));
    EXPECT_TRUE(comes_true(session, [&] { return session.scene().world().body_count() == 5; }));
    EXPECT_TRUE(session.scene().parameters().boolean("show_bounds")) << "what the person has set stays";
}

TEST_F(SceneFiles, that_break_keep_the_last_good_scene_and_say_where)
{
    Session session(SceneSource::of_file(file_), {}, 1);
    write("{\n\"bodies\": [{]");
    EXPECT_TRUE(comes_true(session, [&] { return session.message().find("balls.json:2:") != std::string::npos; })) << session.message();
    EXPECT_NE(session.message().find("balls.json:2:13"), std::string::npos) << session.message() << ": line and column";
    EXPECT_EQ(session.scene().world().body_count(), 2);
    session.restart();
    EXPECT_EQ(session.scene().world().body_count(), 2) << "a restart is of the last good one";
    write(scene_text(3));
    EXPECT_TRUE(comes_true(session, [&] { return session.scene().world().body_count() == 3; }));
}

TEST(EngineSwitches, stay_over_a_restart_and_end_with_the_scene)
{
    Session session("gravity", {}, 1);
    for (const EngineSwitch which : {EngineSwitch::Sleep, EngineSwitch::Continuous, EngineSwitch::WarmStarting})
    {
        EXPECT_TRUE(session.is_on(which));
        session.set_switch(which, false);
        EXPECT_FALSE(session.is_on(which));
        session.restart();
        EXPECT_FALSE(session.is_on(which));
        session.set_switch(which, true);
        EXPECT_TRUE(session.is_on(which));
        session.set_switch(which, false);
    }
    EXPECT_FALSE(session.scene().world().solver_tuning().warm_starting);
    session.open("bridge");
    EXPECT_TRUE(session.is_on(EngineSwitch::WarmStarting));
}

TEST(EngineSwitches, are_the_parameters_of_scenes_that_have_them)
{
    Session session("bullets", {}, 1);
    session.set_switch(EngineSwitch::Continuous, false);
    EXPECT_FALSE(session.scene().parameters().boolean("continuous"));
    EXPECT_FALSE(session.is_on(EngineSwitch::Continuous));
}

} // namespace carom::gallery
