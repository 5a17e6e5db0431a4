#include "gallery/file_watch.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace carom::gallery
{

namespace
{

/// A file of its own in the folder of temporary files.
struct File
{
    explicit File(const std::string& name) : path(std::filesystem::path(::testing::TempDir()) / name) { write("one"); }
    ~File() { std::filesystem::remove(path); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void write(const std::string& text) const { std::ofstream(path) << text; }

    std::filesystem::path path;
};

} // namespace

TEST(FileWatch, tells_a_change_once_when_it_has_settled)
{
    const File file("carom_file_watch_change");
    FileWatch watch(file.path);
    EXPECT_FALSE(watch.has_changed());
    file.write("two and more");
    EXPECT_FALSE(watch.has_changed()) << "it may still be written";
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
}

TEST(FileWatch, sees_a_change_that_keeps_the_size)
{
    const File file("carom_file_watch_size");
    FileWatch watch(file.path);
    file.write("two");
    std::filesystem::last_write_time(file.path, std::filesystem::last_write_time(file.path) + std::chrono::seconds(2));
    watch.has_changed();
    EXPECT_TRUE(watch.has_changed());
}

TEST(FileWatch, waits_while_the_file_grows)
{
    const File file("carom_file_watch_growth");
    FileWatch watch(file.path);
    std::string text;
    for (int i = 0; i < 5; ++i)
    {
        file.write(text += "more and more");
        EXPECT_FALSE(watch.has_changed());
    }
    EXPECT_TRUE(watch.has_changed());
}

TEST(FileWatch, does_not_mind_a_file_that_is_replaced)
{
    const File file("carom_file_watch_replaced");
    FileWatch watch(file.path);
    std::filesystem::remove(file.path);
    EXPECT_FALSE(watch.has_changed());
    file.write("another");
    EXPECT_FALSE(watch.has_changed());
    EXPECT_TRUE(watch.has_changed());
    std::filesystem::remove(file.path);
    watch.has_changed();
    EXPECT_TRUE(watch.has_changed()) << "a file that is gone is a change too";
}

} // namespace carom::gallery
