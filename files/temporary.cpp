// Makes temporary files and folders, and finds those that nobody holds.
#include "files/temporary.hpp"

#include "files/errors.hpp"
#include "files/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace carom::files
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view mark = ".carom-";
constexpr std::string_view ending = ".part";
constexpr int most_tries = 1000;          // names that may be taken by temporaries of processes that had the same number
constexpr std::size_t longest_name = 200; // of the final file, within the temporary's: file systems allow 255 bytes

fs::path temporary_name(const std::string& name, int number)
{
    return "." + name.substr(0, longest_name) + std::string(mark) + std::to_string(::getpid()) + "-" + std::to_string(number) +
           std::string(ending);
}

bool is_number(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether it is ".NAME.carom-PID-N.part".
bool is_temporary_name(std::string_view name)
{
    if (!name.starts_with('.') || !name.ends_with(ending)) return false;
    name.remove_suffix(ending.size());
    const std::size_t at = name.rfind(mark);
    if (at == std::string_view::npos || at == 0) return false;
    const std::string_view numbers = name.substr(at + mark.size());
    const std::size_t dash = numbers.find('-');
    return dash != std::string_view::npos && is_number(numbers.substr(0, dash)) && is_number(numbers.substr(dash + 1));
}

/// Locks what was just made, unless a process that cleans up was quicker and has taken it for a leftover.
bool can_claim(int file)
{
    struct stat status{};
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    return ::fstat(file, &status) == 0 && status.st_nlink > 0;
}

/// Opens it when it is this user's, and of the kind that is made here.
Descriptor open_candidate(const fs::path& path)
{
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status{};
    const bool is_ours = file.is_open() && ::fstat(file.number(), &status) == 0 && status.st_uid == ::geteuid() &&
                         (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
    return is_ours ? std::move(file) : Descriptor();
}

std::vector<fs::path> candidates_in(const fs::path& folder)
{
    std::vector<fs::path> candidates;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (is_temporary_name(entry->path().filename().native())) candidates.push_back(entry->path());
    return candidates;
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& folder, const std::string& name, mode_t mode)
{
    const auto fail = [](int error) { throw std::system_error(error, std::generic_category()); };
    for (int number = 1; number <= most_tries; ++number)
    {
        const fs::path path = folder / temporary_name(name, number);
        Descriptor file(::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, mode));
        if (!file.is_open() && errno == EEXIST) continue;
        if (!file.is_open()) fail(errno);
        if (!can_claim(file.number())) continue;
        lock_ = std::move(file);
        path_ = path;
        return;
    }
    fail(EEXIST);
}

TemporaryFile::~TemporaryFile()
{
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
}

int TemporaryFile::rename_to(const fs::path& name)
{
    if (::rename(path_.c_str(), name.c_str()) != 0) return errno;
    path_.clear();
    lock_.close();
    return 0;
}

void remove_leftovers(const fs::path& folder)
{
    for (const fs::path& path : candidates_in(folder.empty() ? fs::path(".") : folder))
    {
        const Descriptor file = open_candidate(path);
        if (!file.is_open() || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) continue; // its process lives
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
}

ScratchFolder::ScratchFolder(const fs::path& parent)
{
    const auto refuse = [&](const std::string& why) { throw BadTarget("can't make a folder in " + quoted(parent) + ": " + why); };
    std::error_code error;
    fs::create_directories(parent, error);
    if (error) refuse(error.message());
    remove_leftovers(parent);
    for (int number = 1; number <= most_tries; ++number)
    {
        const fs::path path = parent / temporary_name("scratch", number);
        if (::mkdir(path.c_str(), 0777) != 0 && errno == EEXIST) continue;
        lock_ = Descriptor(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (!lock_.is_open() && errno != ENOENT) break;
        if (!lock_.is_open() || !can_claim(lock_.number())) continue;
        path_ = path;
        return;
    }
    refuse(std::strerror(errno));
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace carom::files
