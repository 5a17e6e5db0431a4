// An output is complete or it is not there; what was there before stays until then; what is no regular file is written through.
#include "files/output_file.hpp"

#include "files/testing.hpp"

#include <future>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace carom::files
{

namespace
{

namespace fs = std::filesystem;
using testing::contents;

class OutputFileTest : public ::testing::Test
{
protected:
    fs::path old_file(const std::string& name) const
    {
        std::ofstream(folder_ / name) << "old";
        return folder_ / name;
    }
    static mode_t mode_of(const fs::path& path)
    {
        struct stat status{};
        ::stat(path.c_str(), &status);
        return status.st_mode;
    }
    static std::string refusal_of(const fs::path& path)
    {
        try
        {
            OutputFile file("--out", path);
        }
        catch (const BadTarget& error)
        {
            return error.what();
        }
        return "none";
    }

    testing::TemporaryFolder folder_{"output_file_test"};
};

/// What the write of `bytes` bytes fails with; "none" when it does not.
std::string failure_of(const fs::path& path, std::size_t bytes)
{
    OutputFile file("--out", path);
    file.stream() << std::string(bytes, 'x');
    try
    {
        file.commit();
    }
    catch (const CannotWrite& error)
    {
        return error.what();
    }
    return "none";
}

std::string read_fifo(const fs::path& path) { return contents(path); }

} // namespace

TEST_F(OutputFileTest, a_file_appears_when_it_is_complete_and_replaces_the_earlier_one)
{
    const fs::path path = old_file("a.txt");
    OutputFile file("--out", path);
    file.stream() << std::string(200'000, 'n');
    EXPECT_EQ(contents(path), "old");
    file.commit();
    EXPECT_EQ(contents(path), std::string(200'000, 'n'));
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, what_is_not_committed_leaves_nothing)
{
    const fs::path path = old_file("a.txt");
    {
        OutputFile file("--out", path);
        OutputFile other("--out", folder_ / "new.txt");
        file.stream() << "new" << std::flush;
        EXPECT_EQ(folder_.names().size(), 3u) << "two temporary files";
    }
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, permissions_stay_and_a_private_file_has_a_private_temporary)
{
    const fs::path path = old_file("a.txt");
    fs::permissions(path, fs::perms(0604));
    write_file("--out", path, "new");
    EXPECT_EQ(mode_of(path) & 07777, 0604u);
    EXPECT_EQ(contents(path), "new");

    fs::permissions(path, fs::perms(0600));
    OutputFile file("--out", path);
    EXPECT_EQ(mode_of(file.scratch()) & 07777, 0600u);
}

TEST_F(OutputFileTest, a_link_stays_and_what_it_leads_to_is_replaced)
{
    fs::create_directory(folder_ / "deep");
    const fs::path path = old_file("deep/a.txt");
    fs::create_symlink("deep/a.txt", folder_ / "link");
    fs::create_symlink("link", folder_ / "link_to_link");
    write_file("--out", folder_ / "link_to_link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link_to_link"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(contents(path), "new");
    EXPECT_FALSE(fs::is_symlink(path));
}

TEST_F(OutputFileTest, a_link_to_nothing_makes_what_it_leads_to)
{
    fs::create_directory(folder_ / "deep");
    fs::create_symlink("deep/a.txt", folder_ / "link");
    write_file("--out", folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(contents(folder_ / "deep/a.txt"), "new");
    fs::create_symlink("nowhere/a.txt", folder_ / "lost");
    EXPECT_NE(refusal_of(folder_ / "lost").find("there is no folder"), std::string::npos);
    fs::create_symlink("round", folder_ / "round");
    EXPECT_NE(refusal_of(folder_ / "round").find("levels of symbolic links"), std::string::npos);
}

TEST_F(OutputFileTest, a_fifo_is_written_through)
{
    const fs::path path = folder_ / "fifo";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::future<std::string> reader = std::async(std::launch::async, read_fifo, path);
    const std::string text(300'000, 'f'); // more than a pipe holds
    write_file("--out", path, text);
    EXPECT_EQ(reader.get(), text);
    EXPECT_TRUE(S_ISFIFO(mode_of(path)));
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"fifo"});
}

TEST_F(OutputFileTest, what_another_program_writes_reaches_a_fifo_too)
{
    const fs::path path = folder_ / "fifo";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::future<std::string> reader = std::async(std::launch::async, read_fifo, path);
    OutputFile file("--out", path);
    const fs::path scratch = file.scratch();
    std::ofstream(scratch) << std::string(100'000, 's');
    file.commit();
    EXPECT_EQ(reader.get(), std::string(100'000, 's'));
}

TEST_F(OutputFileTest, a_reader_that_goes_away_is_a_failure_and_no_signal)
{
    const fs::path path = folder_ / "fifo";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const std::future<void> reader = std::async(std::launch::async, [&] { std::ifstream(path).get(); });
    EXPECT_NE(failure_of(path, 1 << 20).find("Broken pipe"), std::string::npos);
}

TEST_F(OutputFileTest, a_device_is_written_through_and_what_it_says_is_told)
{
    const fs::path path = folder_ / "full";
    if (::mknod(path.c_str(), S_IFCHR | 0600, makedev(1, 7)) != 0 || !std::ofstream(path)) GTEST_SKIP() << "no devices for this user";
    EXPECT_NE(failure_of(path, 10).find("No space left on device"), std::string::npos);
    EXPECT_TRUE(S_ISCHR(mode_of(path)));
    write_file("--out", "/dev/null", "gone");
    EXPECT_TRUE(S_ISCHR(mode_of("/dev/null")));
}

TEST_F(OutputFileTest, a_dash_is_standard_output)
{
    std::ostringstream out;
    write_file("--out", "-", "text", {.standard_output = &out});
    EXPECT_EQ(out.str(), "text");
    EXPECT_TRUE(is_standard_output("-"));
    EXPECT_FALSE(is_standard_output("./-"));
    EXPECT_FALSE(is_standard_output(folder_ / "a.txt"));
    EXPECT_FALSE(fs::exists("-"));

    OutputFile file("--out", "-", {.standard_output = &out});
    std::ofstream(file.scratch()) << " of a program";
    file.commit();
    EXPECT_EQ(out.str(), "text of a program");

    out.setstate(std::ios::badbit);
    OutputFile broken("--out", "-", {.standard_output = &out});
    broken.stream() << "lost";
    EXPECT_THROW(broken.commit(), CannotWrite);
}

TEST_F(OutputFileTest, a_full_disk_keeps_the_earlier_file)
{
    fs::create_directory(folder_ / "disk");
    const testing::SmallDisk disk(folder_ / "disk");
    if (!disk.is_mounted()) GTEST_SKIP() << "only root can mount a small disk";
    const fs::path path = old_file("disk/a.txt");
    EXPECT_NE(failure_of(path, 80'000).find("a.txt\": No space left on device"), std::string::npos);
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "disk"), {}), 1);
    EXPECT_EQ(failure_of(path, 30'000), "none") << "what was not kept takes no room";
}

TEST_F(OutputFileTest, a_limit_on_the_size_of_files_is_a_failure_and_no_signal)
{
    const fs::path path = old_file("a.txt");
    const testing::FileSizeLimit limit(64 << 10);
    EXPECT_NE(failure_of(path, 80'000).find("File too large"), std::string::npos);
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"a.txt"});
}

TEST_F(OutputFileTest, says_at_once_why_there_can_be_no_such_file)
{
    const auto expect = [&](const fs::path& path, const std::string& words)
    { EXPECT_NE(refusal_of(path).find(words), std::string::npos) << refusal_of(path); };
    expect("", "--out: can't write \"\": give the name of a file");
    expect(folder_.path(), "it is a folder");
    expect(folder_ / "no" / "a.txt", "there is no folder");
    expect(old_file("a.txt") / "b.txt", "Not a directory");
    expect(folder_ / std::string(300, 'n'), "File name too long");
    expect("/proc/a.txt", "\"/proc/a.txt\"");
    expect(folder_ / "\x1b[31m" / "a.txt", "\\x1b[31m");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"a.txt"});
    fs::permissions(folder_ / "a.txt", fs::perms(0400));
    const testing::PlainUser nobody;
    expect(folder_ / "a.txt", "Permission denied");
    expect("/etc/a.txt", "no file can be made in \"/etc\": Permission denied");
}

TEST_F(OutputFileTest, the_longest_name_of_a_file_can_be_written)
{
    const fs::path path = folder_ / std::string(255, 'n');
    write_file("--out", path, "new");
    EXPECT_EQ(contents(path), "new");
}

TEST_F(OutputFileTest, a_name_must_fit_the_format_when_it_names_a_regular_file)
{
    require_ending("--still", folder_ / "a.png", ".png");
    require_ending("--still", folder_ / "a.PNG", ".png");
    require_ending("--still", "-", ".png");
    require_ending("--still", "/dev/null", ".png");
    for (const char* name : {"a.jpg", "a", "a.png.txt", ".png"})
        EXPECT_THROW(require_ending("--still", folder_ / name, ".png"), BadTarget) << name;
    try
    {
        require_ending("--still", "a.jpg", ".png");
    }
    catch (const BadTarget& error)
    {
        EXPECT_STREQ(error.what(), "--still: \"a.jpg\" has an unknown format; give a name that ends in .png");
    }
}

TEST_F(OutputFileTest, two_options_with_one_target_are_known)
{
    const fs::path path = old_file("a.txt");
    fs::create_symlink("a.txt", folder_ / "link");
    const OutputFile a("--a", path);
    EXPECT_TRUE(a.has_same_target(OutputFile("--b", folder_ / "link")));
    EXPECT_TRUE(a.has_same_target(OutputFile("--b", folder_ / "." / "a.txt")));
    EXPECT_FALSE(a.has_same_target(OutputFile("--b", folder_ / "b.txt")));
    EXPECT_FALSE(a.has_same_target(OutputFile("--b", "-")));
}

} // namespace carom::files
