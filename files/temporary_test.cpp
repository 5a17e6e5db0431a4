// What a killed process leaves behind is removed by the next one, and nothing else is.
#include "files/output_file.hpp"
#include "files/testing.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace carom::files
{

namespace
{

namespace fs = std::filesystem;

class TemporaryTest : public ::testing::Test
{
protected:
    /// A process that makes an output file and a scratch folder in the folder, and waits.
    /// @return its number, once both are there
    pid_t start_writer() const
    {
        const pid_t writer = ::fork();
        if (writer == 0)
        {
            const OutputFile file("--out", folder_ / "film.mp4");
            const ScratchFolder scratch(folder_.path());
            std::ofstream(scratch.path() / "run.json") << "{";
            for (;;) ::pause();
        }
        const auto has_both = [&] { return folder_.names().size() == 2; };
        for (int i = 0; i < 5000 && !has_both(); ++i) ::usleep(1000);
        EXPECT_TRUE(has_both());
        return writer;
    }
    static void kill_and_wait(pid_t process)
    {
        ::kill(process, SIGKILL);
        ::waitpid(process, nullptr, 0);
    }

    testing::TemporaryFolder folder_{"temporary_test"};
};

} // namespace

TEST_F(TemporaryTest, what_a_killed_process_left_is_removed_by_the_next)
{
    const pid_t writer = start_writer();
    kill_and_wait(writer);
    EXPECT_EQ(folder_.names().size(), 2u);
    write_file("--out", folder_ / "other.txt", "new");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"other.txt"});
}

TEST_F(TemporaryTest, what_a_living_process_writes_stays)
{
    const pid_t writer = start_writer();
    const std::vector<std::string> before = folder_.names();
    remove_leftovers(folder_.path());
    EXPECT_EQ(folder_.names(), before);
    kill_and_wait(writer);

    const OutputFile own("--out", folder_ / "a.txt");
    const OutputFile same("--out", folder_ / "a.txt");
    EXPECT_EQ(folder_.names().size(), 2u) << "two of one process beside each other";
}

TEST_F(TemporaryTest, files_of_another_kind_stay)
{
    const std::vector<std::string> others = {
        ".a.txt.12.part",        ".a.txt.carom-12-1", ".a.txt.carom-12.part", ".a.txt.carom-x-1.part", ".carom-12-1.part",
        "a.txt.carom-12-1.part", "film.part"};
    for (const std::string& name : others) std::ofstream(folder_ / name) << "mine";
    fs::create_symlink("film.part", folder_ / ".link.carom-12-1.part");
    std::ofstream(folder_ / ".a.txt.carom-12-1.part") << "left over";
    remove_leftovers(folder_.path());
    EXPECT_EQ(folder_.names().size(), others.size() + 1);
    EXPECT_FALSE(fs::exists(folder_ / ".a.txt.carom-12-1.part"));
    remove_leftovers(folder_ / "nowhere");
}

TEST_F(TemporaryTest, a_scratch_folder_goes_with_what_is_in_it)
{
    {
        const ScratchFolder a(folder_ / "deep");
        const ScratchFolder b(folder_ / "deep");
        EXPECT_NE(a.path(), b.path());
        fs::create_directory(a.path() / "more");
        std::ofstream(a.path() / "more" / "a.txt") << "text";
    }
    EXPECT_TRUE(fs::is_empty(folder_ / "deep"));
    EXPECT_THROW(ScratchFolder("/proc/nothing"), BadTarget);
}

} // namespace carom::files
