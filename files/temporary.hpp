// Temporary files and folders that say by a lock whether their process still lives, so that a later one can clean up after a killed one.
//
// Their names are `.NAME.carom-PID-N.part`. Whoever makes one holds flock() on it until it is gone or has its final name; the system gives
// the lock back when a process ends, however it ends.
#pragma once

#include "files/descriptor.hpp"

#include <filesystem>
#include <string>
#include <sys/types.h>

namespace carom::files
{

/// A temporary file, open for reading and writing. It is removed at the end unless it got its final name.
class TemporaryFile
{
public:
    TemporaryFile() = default; ///< none
    /// @param name of the file that it will become; the folder must exist
    /// @param mode permissions before the umask
    /// @throws std::system_error when it can't be made
    TemporaryFile(const std::filesystem::path& folder, const std::string& name, mode_t mode);
    TemporaryFile(TemporaryFile&& other) noexcept { swap(other); }
    TemporaryFile& operator=(TemporaryFile&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~TemporaryFile();

    bool is_open() const { return lock_.is_open(); }
    int number() const { return lock_.number(); } ///< of its descriptor
    const std::filesystem::path& path() const { return path_; }
    /// Replaces what has that name, in one step.
    /// @return 0, or an errno
    int rename_to(const std::filesystem::path& name);

private:
    void swap(TemporaryFile& other) noexcept
    {
        std::swap(lock_, other.lock_);
        std::swap(path_, other.path_);
    }

    Descriptor lock_;
    std::filesystem::path path_; ///< empty once it has its final name
};

/// Removes the temporary files and folders of this kind in `folder` that belong to this user and whose process is gone. Nothing else is
/// touched, and what can't be removed stays.
void remove_leftovers(const std::filesystem::path& folder);

/// A folder for intermediate files, removed with all in it at the end.
class ScratchFolder
{
public:
    /// Makes `parent` too where it does not exist. Removes what killed processes left there.
    /// @throws BadTarget when there can be no such folder
    explicit ScratchFolder(const std::filesystem::path& parent);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    Descriptor lock_;
    std::filesystem::path path_;
};

} // namespace carom::files
