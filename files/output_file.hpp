// The one way in which Carom's programs write files.
//
//     files::OutputFile file("--still", path);   // a place that can't be written is found here, before the work
//     file.stream() << text;
//     file.commit();                             // throws unless every byte is where it belongs
//
// What a path leads to decides what happens:
//
//     a regular file, or nothing yet   a temporary file beside it is written, and replaces it as a whole at commit()
//     a symbolic link                  the same with the file that the link leads to; the link stays
//     a FIFO, a device, a socket       is written through, as the bytes come
//     "-", or what standard output is  standard output
//
// Until commit() an earlier file is untouched, and without commit() no temporary file stays behind. Those of processes that were killed are
// removed when the next file is written into the same folder. A file that is replaced hands on its permissions and, where the system lets
// it, its owner; a further hard link goes on to lead to the earlier file.
#pragma once

#include "files/errors.hpp"
#include "files/temporary.hpp"

#include <array>
#include <filesystem>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace carom::files
{

/// Whether an output goes to standard output: "-", or a path such as /dev/stdout that leads to the same file, pipe or terminal.
bool is_standard_output(const std::filesystem::path& path);

/// Refuses a name of a regular file, there or not, that does not fit its format. What is written through may have any name.
/// @param ending of the format, lower case: ".png"
/// @throws BadTarget naming the option and the ending
void require_ending(const std::string& option, const std::filesystem::path& path, const std::string& ending);

/// Whether the path leads to what is written through: standard output, a FIFO, a device, a socket.
bool is_written_through(const std::filesystem::path& path);

struct OutputOptions
{
    std::ostream* standard_output = nullptr; ///< what "-" means; null for std::cout
    /// Waits until the disk has the bytes, so that a power failure leaves the earlier file or the new one. Not worth it for what is written
    /// many times a second.
    bool is_durable = true;
};

class OutputFile
{
public:
    /// @param option names the output in messages: "--still"; may be empty
    /// @throws BadTarget when there can be no such file
    OutputFile(std::string option, std::filesystem::path path, const OutputOptions& options = {});
    /// Without commit() all is as it was, but for what was written through.
    ~OutputFile() = default;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::filesystem::path& path() const { return path_; } ///< as it was given
    /// Goes bad at the first write that fails; commit() tells why.
    std::ostream& stream() { return kind_ == Kind::StandardOutput ? *standard_output_ : stream_; }
    /// For libraries and programs that write files by their name: a temporary file whose bytes become the output at commit(), in place of
    /// what was written into stream().
    /// @throws BadTarget when it can't be made
    const std::filesystem::path& scratch();
    /// Whether both write the same file.
    bool has_same_target(const OutputFile& other) const;

    /// Everything is written: checks that it was, and gives the file its name.
    /// @throws CannotWrite; then an earlier file is untouched
    void commit();

private:
    enum class Kind
    {
        Replaced,
        WrittenThrough,
        StandardOutput
    };

    /// Bytes on their way to a file. After the first failure nothing more is written.
    class Buffer : public std::streambuf
    {
    public:
        Buffer() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
        void write_to(int file) { file_ = file; }
        int error() const { return error_; } ///< an errno; 0 when all went well

    private:
        int_type overflow(int_type c) override;
        int sync() override;

        std::array<char, 65536> bytes_;
        int file_ = -1;
        int error_ = 0;
    };

    void open_replaced();
    void open_through();
    void make_temporary(const std::filesystem::path& folder, const std::string& name, mode_t mode);
    void copy_scratch();
    void check_written();
    [[noreturn]] void refuse(const std::string& why) const; ///< throws BadTarget
    [[noreturn]] void fail(const std::string& why) const;   ///< throws CannotWrite
    std::string message(const std::string& why) const;

    std::string option_;
    std::filesystem::path path_;
    std::filesystem::path target_; ///< where links lead to
    std::ostream* standard_output_;
    bool is_durable_;
    Kind kind_ = Kind::Replaced;
    TemporaryFile temporary_; ///< of the kind Replaced, or the scratch file of the others
    Descriptor through_;      ///< of the kind WrittenThrough
    bool has_scratch_ = false;
    Buffer buffer_;
    std::ostream stream_{&buffer_};
};

/// Writes a whole file.
/// @throws BadTarget, CannotWrite
void write_file(const std::string& option, const std::filesystem::path& path, std::string_view text, const OutputOptions& options = {});

} // namespace carom::files
