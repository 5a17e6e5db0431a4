// A file `.lock` in the folder, on which flock() is held and which holds the process's number.
#include "files/folder_lock.hpp"

#include "files/errors.hpp"
#include "files/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <span>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace carom::files
{

namespace
{

/// Whether the open file still has that name: the process that held it before may just have removed it.
bool has_name(int file, const std::filesystem::path& path)
{
    struct stat open{};
    struct stat named{};
    return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// " (process 1234)", from what the process that holds the lock wrote.
std::string holder(int file)
{
    std::array<char, 32> text{};
    const ssize_t count = ::pread(file, text.data(), text.size(), 0);
    std::string number(text.data(), static_cast<std::size_t>(count > 0 ? count : 0));
    number.resize(std::min(number.size(), number.find_first_not_of("0123456789")));
    return number.empty() ? "" : " (process " + number + ")";
}

} // namespace

FolderLock::FolderLock(const std::string& option, const std::filesystem::path& folder) : path_(folder / ".lock")
{
    const auto refuse = [&](const std::string& why) { throw BadTarget(option + ": can't use the folder " + quoted(folder) + ": " + why); };
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) refuse(error.message());
    while (true)
    {
        file_ = Descriptor(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
        if (!file_.is_open()) refuse(std::strerror(errno));
        if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0)
        {
            if (errno != EWOULDBLOCK) refuse(std::strerror(errno));
            refuse("another run" + holder(file_.number()) + " writes its results there; wait until it has ended, or give another folder");
        }
        if (has_name(file_.number(), path_)) break;
    }
    const std::string number = std::to_string(::getpid()) + "\n";
    if (::ftruncate(file_.number(), 0) != 0) refuse(std::strerror(errno));
    if (const int failure = write_all(file_.number(), std::as_bytes(std::span(number)))) refuse(std::strerror(failure));
}

FolderLock::~FolderLock()
{
    std::error_code ignored;
    if (file_.is_open()) std::filesystem::remove(path_, ignored);
}

} // namespace carom::files
