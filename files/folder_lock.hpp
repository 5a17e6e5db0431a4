// One process at a time in a folder of results.
#pragma once

#include "files/descriptor.hpp"

#include <filesystem>
#include <string>

namespace carom::files
{

/// Held from its construction to its end. The system gives it back when the process ends, however it ends.
class FolderLock
{
public:
    /// Makes the folder where it does not exist.
    /// @param option names the folder in messages: "--out"
    /// @throws BadTarget at once when another process holds the folder, naming that process, or when there can be no such folder
    FolderLock(const std::string& option, const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    std::filesystem::path path_; ///< of the file that carries the lock
    Descriptor file_;
};

} // namespace carom::files
