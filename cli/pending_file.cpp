// A temporary file beside the place of the real one, and the move.
#include "cli/pending_file.hpp"

#include "cli/errors.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace carom::cli
{

PendingFile::PendingFile(std::string option, std::filesystem::path path) : option_(std::move(option)), path_(std::move(path))
{
    const auto refuse = [&](const std::string& why) { throw BadUsage(option_ + ": can't write \"" + path_.string() + "\": " + why); };
    std::error_code ignored;
    if (!path_.has_filename()) refuse("give the name of a file");
    if (std::filesystem::is_directory(path_, ignored)) refuse("it is a folder");

    temporary_ = path_.parent_path() / ("." + path_.filename().string() + "." + std::to_string(::getpid()) + ".part");
    const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0) refuse(std::strerror(errno));
    ::close(file);
}

PendingFile::~PendingFile()
{
    std::error_code ignored;
    if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void PendingFile::commit()
{
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) throw Failure(option_ + ": can't write \"" + path_.string() + "\": " + error.message());
    temporary_.clear();
}

} // namespace carom::cli
