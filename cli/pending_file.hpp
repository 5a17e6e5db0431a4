// A file that appears under its name only when it is complete.
#pragma once

#include <filesystem>
#include <string>

namespace carom::cli
{

/// Made under a temporary name beside its place, so that a run that fails leaves what was there before.
class PendingFile
{
public:
    /// Makes the temporary file, so that a place that can't be written is found before the work is done.
    /// @param option the command-line option that names the file, for messages
    /// @throws BadUsage when there can be no such file
    PendingFile(std::string option, std::filesystem::path path);
    ~PendingFile(); ///< removes the temporary file unless it was committed
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& path() const { return path_; }           ///< where it will be
    const std::filesystem::path& temporary() const { return temporary_; } ///< where it is to be written

    /// Moves it to its place.
    /// @throws Failure
    void commit();

private:
    std::string option_;
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

} // namespace carom::cli
