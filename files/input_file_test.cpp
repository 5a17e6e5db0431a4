// A file that can't be read says why.
#include "files/input_file.hpp"

#include "files/testing.hpp"

#include <gtest/gtest.h>

namespace carom::files
{

namespace
{

std::string refusal_of(const std::filesystem::path& path, std::size_t most = 1 << 20)
{
    try
    {
        read_text(path, most);
    }
    catch (const CannotRead& error)
    {
        return error.what();
    }
    return "none";
}

} // namespace

TEST(InputFile, is_read_whole)
{
    const testing::TemporaryFolder folder("input_file_test");
    const std::string text = std::string(200'000, 'a') + '\0' + "\xFF\n";
    std::ofstream(folder / "a", std::ios::binary) << text;
    EXPECT_EQ(read_text(folder / "a", 1 << 20), text);
}

TEST(InputFile, says_why_it_can_not_be_read)
{
    const testing::TemporaryFolder folder("input_file_test");
    std::ofstream(folder / "a") << std::string(2 << 20, 'a');
    EXPECT_EQ(refusal_of(folder / "b"), "can't read \"" + (folder / "b").string() + "\": No such file or directory");
    EXPECT_NE(refusal_of(folder / "a" / "b").find("Not a directory"), std::string::npos);
    EXPECT_NE(refusal_of(folder.path()).find("it is a folder"), std::string::npos);
    EXPECT_NE(refusal_of(folder / "a").find("it is longer than 1 MiB"), std::string::npos);
    EXPECT_NE(refusal_of("/dev/zero").find("it is longer than 1 MiB"), std::string::npos);
    EXPECT_NE(refusal_of("/proc/self/mem").find("Input/output error"), std::string::npos);
    std::filesystem::permissions(folder / "a", std::filesystem::perms(0));
    const testing::PlainUser nobody;
    EXPECT_NE(refusal_of(folder / "a").find("Permission denied"), std::string::npos);
}

} // namespace carom::files
