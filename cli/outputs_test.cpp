// What the commands write is what they say they wrote, wherever it goes.
#include "cli/program.hpp"
#include "files/testing.hpp"

#include <csignal>
#include <cstdlib>
#include <future>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/stat.h>
#include <sys/wait.h>

namespace carom::cli
{

using files::testing::contents;
using nlohmann::json;

namespace
{

struct Ended
{
    int status;
    std::string out;
    std::string err;
};

Ended run_carom(const std::vector<std::string>& arguments)
{
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_program(arguments, {.out = out, .err = err});
    return {status, out.str(), err.str()};
}

bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

class OutputsTest : public ::testing::Test
{
protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string old_file(const std::string& name) const
    {
        std::ofstream(folder_ / name) << "old";
        return path(name);
    }
    /// Runs with a program of that name before all others.
    Ended carom_with(const std::string& program, const std::string& script, const std::vector<std::string>& arguments) const
    {
        const std::filesystem::path bin = folder_ / "bin";
        std::filesystem::create_directory(bin);
        std::ofstream(bin / program) << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(bin / program, std::filesystem::perms::owner_all);
        const std::string before = getenv("PATH");
        setenv("PATH", (bin.string() + ":" + before).c_str(), 1);
        const Ended outcome = run_carom(arguments);
        setenv("PATH", before.c_str(), 1);
        std::filesystem::remove_all(bin);
        return outcome;
    }
    /// A run whose animation takes more than 8 KiB.
    static std::vector<std::string> animation(const std::string& file) { return {"run", "gravity", "--steps", "12", "--animation", file}; }
    void expect_failed_film(const Ended& outcome, const std::string& file)
    {
        EXPECT_EQ(outcome.status, 1) << file;
        EXPECT_EQ(outcome.out, "") << file;
        EXPECT_NE(outcome.err.find("--animation"), std::string::npos) << file << ": " << outcome.err;
        EXPECT_EQ(contents(file), "old");
    }

    files::testing::TemporaryFolder folder_{"outputs_test"};
};

} // namespace

TEST_F(OutputsTest, a_scene_is_exported_through_a_fifo)
{
    ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
    std::future<std::string> reader = std::async(std::launch::async, [&] { return contents(path("fifo")); });
    const Ended outcome = run_carom({"export", "planets", path("fifo")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(json::parse(reader.get())["carom_scene"], 1);
    EXPECT_TRUE(std::filesystem::is_fifo(path("fifo")));
}

TEST_F(OutputsTest, a_scene_is_exported_to_where_a_link_leads)
{
    old_file("real.json");
    std::filesystem::create_symlink("real.json", path("link.json"));
    EXPECT_EQ(run_carom({"export", "planets", path("link.json")}).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(path("link.json")));
    EXPECT_EQ(json::parse(contents(path("real.json")))["carom_scene"], 1);
}

TEST_F(OutputsTest, a_dash_is_standard_output_and_words_go_beside_it)
{
    const Ended scene = run_carom({"export", "planets", "-", "--steps", "7"});
    EXPECT_EQ(scene.status, 0) << scene.err;
    EXPECT_EQ(json::parse(scene.out)["steps"], 7);
    EXPECT_NE(scene.err.find("planets: "), std::string::npos) << scene.err;

    const Ended still = run_carom({"run", "gravity", "--steps", "2", "--still", "-"});
    EXPECT_TRUE(still.out.starts_with("\x89PNG")) << still.err;
    EXPECT_TRUE(still.out.ends_with("IEND\xAE\x42\x60\x82"));
    EXPECT_NE(still.err.find("hash of the world"), std::string::npos);

    ASSERT_EQ(run_carom({"export", "planets", path("p.json"), "--steps", "3"}).status, 0);
    const Ended step = run_carom({"lab", "step", path("p.json"), "--out", "-"});
    EXPECT_EQ(json::parse(step.out)["step_ms"].size(), 3u);
    EXPECT_EQ(json::parse(step.out)["scene"], path("p.json"));
    EXPECT_FALSE(std::filesystem::exists("-"));

    std::ofstream(path("t.json")) << R"([{"ph":"X","tid":1,"name":"step","ts":0,"dur":100},
        {"ph":"C","name":"heap","cat":"memory","ts":0,"args":{"bytes":1000}}])";
    const Ended memory = run_carom({"trace", path("t.json"), "--memory", "-"});
    EXPECT_TRUE(memory.out.starts_with("\x89PNG"));
    EXPECT_NE(memory.err.find("1 zone"), std::string::npos) << memory.err;
}

TEST_F(OutputsTest, an_animation_goes_to_standard_output_whole)
{
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const Ended outcome = run_carom({"run", "gravity", "--steps", "8", "--animation", "-"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x1A\x45\xDF\xA3"));
    EXPECT_NE(outcome.out.find("webm"), std::string::npos);
}

TEST_F(OutputsTest, two_options_can_not_have_one_file)
{
    const Ended outcome = run_carom({"run", "gravity", "--steps", "2", "--still", path("a.png"), "--animation", "-", "--still", "-"});
    EXPECT_EQ(outcome.status, 2);
    const Ended both = run_carom({"run", "gravity", "--steps", "2", "--still", "-", "--animation", "-"});
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.err.find("--animation: another option writes \"-\" too"), std::string::npos) << both.err;
    EXPECT_EQ(both.out, "");
}

TEST_F(OutputsTest, a_full_disk_fails_every_output_and_keeps_the_earlier_file)
{
    std::filesystem::create_directory(folder_ / "disk");
    ASSERT_EQ(run_carom({"export", "collisions", path("scene.json"), "--steps", "100"}).status, 0);
    const files::testing::SmallDisk disk(folder_ / "disk");
    if (!disk.is_mounted()) GTEST_SKIP() << "only root can mount a small disk";
    const auto refused = [&](const std::vector<std::string>& arguments)
    {
        const Ended outcome = run_carom(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments.front();
        EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    };
    refused({"export", "collisions", old_file("disk/a.json")});
    refused({"lab", "step", path("scene.json"), "--out", path("disk/s.json")});
    EXPECT_EQ(contents(path("disk/a.json")), "old");
    EXPECT_FALSE(std::filesystem::exists(path("disk/s.json")));
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    std::ofstream(path("disk/ballast")) << std::string(44 << 10, 'b'); // short films are enough then
    for (const char* name : {"film.webm", "film.mp4", "film.gif"})
        expect_failed_film(run_carom(animation(old_file(std::string("disk/") + name))), path(std::string("disk/") + name));
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_ / "disk")) ++files;
    EXPECT_EQ(files, 5) << "no temporary file stays";
}

TEST_F(OutputsTest, a_limit_on_the_size_of_files_fails_an_animation)
{
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    for (const char* name : {"film.webm", "film.mp4", "film.gif"})
    {
        const std::string file = old_file(name);
        const files::testing::FileSizeLimit limit(8 << 10);
        expect_failed_film(run_carom(animation(file)), file);
    }
}

TEST_F(OutputsTest, an_encoder_that_claims_to_be_done_is_checked)
{
    if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const std::string real = "/usr/bin/env PATH=\"${PATH#*:}\" ffmpeg \"$@\"";
    const std::string last = "for last; do :; done; file=${last#file:}; ";
    for (const char* name : {"film.webm", "film.mp4", "film.gif"})
    {
        const std::string file = old_file(name);
        expect_failed_film(carom_with("ffmpeg", "cat >/dev/null", animation(file)), file);
        const std::string cut = last + real + "; case $file in -) ;; *) truncate -s -1 \"$file\";; esac; exit 0";
        expect_failed_film(carom_with("ffmpeg", cut, animation(file)), file);
        EXPECT_EQ(carom_with("ffmpeg", "exec " + real, {"run", "gravity", "--steps", "6", "--animation", file}).status, 0) << name;
        EXPECT_NE(contents(file), "old");
    }
}

TEST_F(OutputsTest, messages_obey_no_name)
{
    const std::string name = folder_ / "\x1b[31mred\xff.json";
    std::ofstream(name) << R"({"carom_scene": 1, "name": "\u001b]0;title\u0007\u009b31m", "steps": 2, "bodies": [{}]})";
    std::ofstream(path("bad.json")) << "{\"carom_scene\": 1, \"\x1b[2J\": 1}";
    const std::vector<std::vector<std::string>> commands = {{"run", name},
                                                            {"run", name + ".json"},
                                                            {"run", path("bad.json")},
                                                            {"run", "\x1b[31m\xff"},
                                                            {"run", "gravity", "--set", "\x1b=1"},
                                                            {"run", "gravity", "--\x1b"},
                                                            {"\x1b[2J"},
                                                            {"run", "gravity", "--still", name},
                                                            {"export", name, folder_ / "\x1b\xff.json"},
                                                            {"trace", name},
                                                            {"lab", "step", name, "--out", "/nowhere/\x1b"},
                                                            {"lab", "run", "\x1b", "--out", path("x")},
                                                            {"lab", "report", name}};
    for (const std::vector<std::string>& command : commands)
    {
        const Ended outcome = run_carom(command);
        const std::string all = outcome.out + outcome.err;
        EXPECT_NE(all, "");
        EXPECT_EQ(all.find('\x1b'), std::string::npos) << command[0] << ": " << all;
        EXPECT_EQ(all.find('\xff'), std::string::npos) << command[0];
        EXPECT_EQ(all.find("\xC2\x9B"), std::string::npos) << command[0] << ": " << all;
    }
    EXPECT_EQ(run_carom({"run", name}).status, 0);
    EXPECT_NE(run_carom({"run", name}).out.find("\\x1b]0;title\\x07\\u009b31m"), std::string::npos);
}

TEST_F(OutputsTest, a_file_that_can_not_be_read_says_why)
{
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"run", path("none.json")},
                                                                                         {"run", "gravity", "--input", path("none.json")},
                                                                                         {"trace", path("none.json")},
                                                                                         {"lab", "report", path("none.json")},
                                                                                         {"lab", "step", path("none.json"), "--out", "-"}})
    {
        const Ended outcome = run_carom(command);
        EXPECT_EQ(outcome.status, 2) << command[0];
        EXPECT_NE(outcome.err.find("No such file or directory"), std::string::npos) << outcome.err;
    }
    const std::string secret = old_file("secret.json");
    std::filesystem::permissions(secret, std::filesystem::perms(0));
    const files::testing::PlainUser nobody;
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"run", secret}, {"run", "gravity", "--input", secret}, {"trace", secret}})
    {
        const Ended outcome = run_carom(command);
        EXPECT_EQ(outcome.status, 2) << command[0];
        EXPECT_NE(outcome.err.find("Permission denied"), std::string::npos) << outcome.err;
    }
}

} // namespace carom::cli
