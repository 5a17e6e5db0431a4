// One run at a time has a folder.
#include "files/folder_lock.hpp"

#include "files/errors.hpp"
#include "files/testing.hpp"

#include <gtest/gtest.h>

namespace carom::files
{

TEST(FolderLock, a_second_run_is_refused_and_told_by_whom)
{
    const testing::TemporaryFolder folder("folder_lock_test");
    {
        const FolderLock first("--out", folder / "deep" / "er");
        const FolderLock other("--out", folder.path());
        try
        {
            FolderLock second("--out", folder / "deep" / "er");
            FAIL() << "it must be refused";
        }
        catch (const BadTarget& error)
        {
            const std::string words = error.what();
            EXPECT_NE(words.find("--out: can't use the folder"), std::string::npos) << words;
            EXPECT_NE(words.find("process " + std::to_string(::getpid())), std::string::npos) << words;
            EXPECT_NE(words.find("another folder"), std::string::npos) << words;
        }
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "deep" / "er")) << "nothing stays of a lock";
    const FolderLock again("--out", folder / "deep" / "er");
}

TEST(FolderLock, what_a_killed_run_left_locks_nobody_out)
{
    const testing::TemporaryFolder folder("folder_lock_test");
    std::ofstream(folder / ".lock") << "1\n";
    const FolderLock lock("--out", folder.path());
    EXPECT_EQ(testing::contents(folder / ".lock"), std::to_string(::getpid()) + "\n");
}

TEST(FolderLock, a_folder_that_can_not_be_made_is_named) { EXPECT_THROW(FolderLock("--out", "/proc/nothing"), BadTarget); }

} // namespace carom::files
