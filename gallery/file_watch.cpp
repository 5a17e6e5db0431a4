// Asks the file system twice before it tells of a change.
#include "gallery/file_watch.hpp"

#include <system_error>
#include <utility>

namespace carom::gallery
{

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)), known_(look()), seen_(known_) {}

std::optional<FileWatch::State> FileWatch::look() const
{
    std::error_code error;
    State state;
    state.time = std::filesystem::last_write_time(file_, error);
    if (!error) state.size = std::filesystem::file_size(file_, error);
    return error ? std::nullopt : std::optional(state);
}

bool FileWatch::has_changed()
{
    const std::optional<State> now = look();
    const bool is_settled = std::exchange(seen_, now) == now;
    if (now == known_ || !is_settled) return false;
    known_ = now;
    return true;
}

} // namespace carom::gallery
