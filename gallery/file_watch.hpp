// Notices that a file has changed on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carom::gallery
{

/// Compares the time of the last change and the size. A file that is being written changes from look to look, so that a change
/// counts only when two looks in a row see the same; editors that replace a file leave none for a moment.
class FileWatch
{
public:
    /// Changes from now on count.
    explicit FileWatch(std::filesystem::path file);

    const std::filesystem::path& file() const { return file_; }
    /// Looks at the file.
    /// @return whether it has changed since the last change that was told, and has stayed so since the look before
    bool has_changed();

private:
    struct State
    {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const State&, const State&) = default;
    };
    std::optional<State> look() const; ///< none: there is no such file

    std::filesystem::path file_;
    std::optional<State> known_; ///< as it was told last
    std::optional<State> seen_;  ///< at the last look
};

} // namespace carom::gallery
