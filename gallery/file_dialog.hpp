// Which file to open: folders to walk through, and a path to type. How it looks is in gallery/file_dialog_window.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace carom::gallery
{

class FileDialog
{
public:
    struct Entry
    {
        std::string name;
        bool is_folder = false;
    };

    bool is_open() const { return is_open_; }
    /// In the folder where it was last; at first in the current one.
    void open();
    void close() { is_open_ = false; }

    const std::filesystem::path& folder() const { return folder_; }
    /// The folders here and then the scene files (*.json), each in the order of the alphabet; hidden ones are left out.
    const std::vector<Entry>& entries() const { return entries_; }

    /// A folder is entered, a file is what was chosen. Names count from the folder; "~/" is the person's own folder. What is neither says so in `error`.
    /// @return the path of a file
    std::optional<std::filesystem::path> choose(const std::string& name);

    std::string typed; ///< in the field for the path
    std::string error; ///< why the last choice could not be had; empty for none

private:
    void enter(const std::filesystem::path& folder);

    bool is_open_ = false;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
};

} // namespace carom::gallery
