#include "gallery/file_dialog.hpp"

#include "files/testing.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

namespace fs = std::filesystem;

/// A folder with two scene files, something else, and a folder.
class FileDialogs : public ::testing::Test
{
protected:
    void SetUp() override
    {
        fs::create_directories(folder_ / "levels");
        for (const char* name : {"b.json", "a.json", "notes.txt", ".hidden.json"}) std::ofstream(folder_ / name) << "{}";
        dialog_.open();
        dialog_.choose(folder_.string());
    }

    const files::testing::TemporaryFolder temporary_{"file_dialog"};
    const fs::path folder_ = temporary_.path();
    FileDialog dialog_;
};

} // namespace

TEST_F(FileDialogs, list_folders_and_then_scene_files)
{
    std::vector<std::string> names;
    for (const FileDialog::Entry& entry : dialog_.entries()) names.push_back(entry.name + (entry.is_folder ? "/" : ""));
    EXPECT_EQ(names, (std::vector<std::string>{"levels/", "a.json", "b.json"}));
}

TEST_F(FileDialogs, enter_folders_and_come_back)
{
    EXPECT_FALSE(dialog_.choose("levels"));
    EXPECT_EQ(dialog_.folder(), folder_ / "levels");
    EXPECT_TRUE(dialog_.entries().empty());
    EXPECT_FALSE(dialog_.choose(".."));
    EXPECT_EQ(dialog_.entries().size(), 3u);
    dialog_.close();
    dialog_.open();
    EXPECT_EQ(dialog_.entries().size(), 3u) << "it opens where it was";
}

TEST_F(FileDialogs, give_the_path_of_a_file)
{
    EXPECT_EQ(dialog_.choose("a.json"), folder_ / "a.json");
    EXPECT_EQ(dialog_.choose((folder_ / "notes.txt").string()), folder_ / "notes.txt") << "a typed name may be any file's";
    EXPECT_EQ(dialog_.error, "");
}

TEST_F(FileDialogs, say_why_a_path_can_not_be_had)
{
    EXPECT_FALSE(dialog_.choose("nothing.json"));
    EXPECT_NE(dialog_.error.find("nothing.json"), std::string::npos) << dialog_.error;
    EXPECT_NE(dialog_.error.find("No such file"), std::string::npos) << dialog_.error;
    EXPECT_FALSE(dialog_.choose("levels"));
    EXPECT_EQ(dialog_.error, "");
}

} // namespace carom::gallery
