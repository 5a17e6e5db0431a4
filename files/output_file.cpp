// Finds out what a path leads to, writes, and checks everything that the system says.
#include "files/output_file.hpp"

#include "files/text.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <optional>
#include <span>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace carom::files
{

namespace fs = std::filesystem;

namespace
{

using Status = struct stat;

std::optional<Status> status_of(const fs::path& path)
{
    Status status{};
    return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

bool is_same_file(const Status& a, const Status& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// Where a symbolic link leads to that leads to nothing yet; the path itself when it is no link.
fs::path link_target(fs::path path)
{
    constexpr int most_links = 40; // as the kernel has it
    for (int i = 0; i < most_links; ++i)
    {
        std::error_code error;
        const fs::path next = fs::read_symlink(path, error);
        if (error) break;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

/// Owner and group, as far as the system lets this user.
void hand_on_owner(int file, const Status& earlier)
{
    const bool is_done = ::fchown(file, earlier.st_uid, earlier.st_gid) == 0 || ::fchown(file, ::geteuid(), earlier.st_gid) == 0;
    static_cast<void>(is_done); // a file of the own user is better than none
}

/// The bytes of a file from its start.
/// @return 0, or an errno
int copy(int from, int to)
{
    std::vector<std::byte> part(1 << 16);
    for (off_t at = 0;;)
    {
        const ssize_t count = ::pread(from, part.data(), part.size(), at);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        if (count == 0) return 0;
        if (const int error = write_all(to, std::span(part).first(static_cast<std::size_t>(count)))) return error;
        at += count;
    }
}

/// Tells late failures of a disk or a server: those that come with the last bytes.
/// @return 0, or an errno
int flush_to_disk(int file, bool is_durable)
{
    const bool can_sync = !is_durable || ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
    if (!can_sync) return errno;
    // Network file systems tell of a full disk when a descriptor is closed. The file's own must stay open: it holds the lock.
    Descriptor further(::fcntl(file, F_DUPFD_CLOEXEC, 0));
    return further.is_open() ? further.close() : errno;
}

} // namespace

bool is_standard_output(const fs::path& path)
{
    if (path == "-") return true;
    const std::optional<Status> target = status_of(path);
    Status out{};
    if (!target || ::fstat(STDOUT_FILENO, &out) != 0) return false;
    return !S_ISDIR(target->st_mode) && is_same_file(*target, out);
}

bool is_written_through(const fs::path& path)
{
    const std::optional<Status> status = status_of(path);
    return is_standard_output(path) || (status && !S_ISREG(status->st_mode) && !S_ISDIR(status->st_mode));
}

void require_ending(const std::string& option, const fs::path& path, const std::string& ending)
{
    std::string given = path.extension().native();
    for (char& c : given) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (given == ending || is_written_through(path)) return;
    throw BadTarget(option + ": " + quoted(path) + " has an unknown format; give a name that ends in " + ending);
}

OutputFile::Buffer::int_type OutputFile::Buffer::overflow(int_type c)
{
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
}

int OutputFile::Buffer::sync()
{
    const std::span<const char> waiting(pbase(), pptr());
    if (error_ == 0) error_ = write_all(file_, std::as_bytes(waiting));
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return error_ == 0 ? 0 : -1;
}

OutputFile::OutputFile(std::string option, fs::path path, const OutputOptions& options)
    : option_(std::move(option)),
      path_(std::move(path)),
      target_(path_),
      standard_output_(options.standard_output ? options.standard_output : &std::cout),
      is_durable_(options.is_durable)
{
    if (is_standard_output(path_))
    {
        kind_ = Kind::StandardOutput;
        return;
    }
    if (!path_.has_filename()) refuse("give the name of a file");
    const std::optional<Status> status = status_of(path_);
    if (!status && errno != ENOENT) refuse(std::strerror(errno));
    if (status && S_ISDIR(status->st_mode)) refuse("it is a folder");

    std::error_code error;
    target_ = status ? fs::canonical(path_, error) : link_target(path_);
    const std::optional<Status> found = status_of(target_);
    // What only /proc/self/fd leads to has no name that could be given to another file.
    const bool has_name = !status || (!error && found && is_same_file(*found, *status));
    if (status && (!S_ISREG(status->st_mode) || !has_name))
        open_through();
    else
        open_replaced();
}

void OutputFile::open_through()
{
    kind_ = Kind::WrittenThrough;
    target_ = path_;
    through_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC | O_NOCTTY));
    if (!through_.is_open()) refuse(std::strerror(errno));
    buffer_.write_to(through_.number());
}

void OutputFile::open_replaced()
{
    const fs::path folder = target_.parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) refuse("there is no folder " + quoted(folder));
    const std::optional<Status> earlier = status_of(target_);
    if (earlier && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) refuse(std::strerror(errno));

    make_temporary(folder, target_.filename(), earlier ? 0600 : 0666); // a private file has a private temporary
    buffer_.write_to(temporary_.number());
    if (!earlier) return;
    hand_on_owner(temporary_.number(), *earlier);
    if (::fchmod(temporary_.number(), earlier->st_mode & 0777) != 0) refuse(std::strerror(errno));
}

void OutputFile::make_temporary(const fs::path& folder, const std::string& name, mode_t mode)
{
    remove_leftovers(folder);
    try
    {
        temporary_ = TemporaryFile(folder, name, mode);
    }
    catch (const std::system_error& error)
    {
        refuse("no file can be made in " + quoted(folder.empty() ? "." : folder) + ": " + std::strerror(error.code().value()));
    }
}

const fs::path& OutputFile::scratch()
{
    if (kind_ != Kind::Replaced && !temporary_.is_open())
    {
        std::error_code error;
        const fs::path folder = fs::temp_directory_path(error);
        if (error) refuse("there is no folder for temporary files: " + error.message());
        make_temporary(folder, "output", 0600);
    }
    has_scratch_ = true;
    return temporary_.path();
}

bool OutputFile::has_same_target(const OutputFile& other) const
{
    std::error_code error;
    if (kind_ != other.kind_) return false;
    return kind_ == Kind::StandardOutput || fs::weakly_canonical(target_, error) == fs::weakly_canonical(other.target_, error);
}

void OutputFile::commit()
{
    if (has_scratch_ && kind_ != Kind::Replaced) copy_scratch();
    check_written();
    if (kind_ != Kind::Replaced) return;
    if (const int error = flush_to_disk(temporary_.number(), is_durable_)) fail(std::strerror(error));
    if (const int error = temporary_.rename_to(target_)) fail(std::strerror(error));
}

/// From the scratch file to what is written through.
void OutputFile::copy_scratch()
{
    if (kind_ == Kind::WrittenThrough)
    {
        if (const int error = copy(temporary_.number(), through_.number())) fail(std::strerror(error));
        return;
    }
    std::vector<char> part(1 << 16);
    for (off_t at = 0;;)
    {
        const ssize_t count = ::pread(temporary_.number(), part.data(), part.size(), at);
        if (count < 0) fail(std::strerror(errno));
        if (count == 0 || !standard_output_->write(part.data(), count)) return;
        at += count;
    }
}

void OutputFile::check_written()
{
    stream().flush();
    if (buffer_.error() != 0) fail(std::strerror(buffer_.error()));
    if (!stream()) fail("it takes no more bytes");
    if (kind_ != Kind::WrittenThrough) return;
    if (const int error = through_.close()) fail(std::strerror(error));
}

void OutputFile::refuse(const std::string& why) const { throw BadTarget(message(why)); }

void OutputFile::fail(const std::string& why) const { throw CannotWrite(message(why)); }

std::string OutputFile::message(const std::string& why) const
{
    const std::string name = path_ == "-" ? "standard output" : quoted(path_);
    return (option_.empty() ? "" : option_ + ": ") + "can't write " + name + ": " + why;
}

void write_file(const std::string& option, const fs::path& path, std::string_view text, const OutputOptions& options)
{
    OutputFile file(option, path, options);
    file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
    file.commit();
}

} // namespace carom::files
