// A file descriptor that is closed at the end of its scope, and writes that report failure instead of ending the process.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace carom::files
{

class Descriptor
{
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; } ///< -1 when it is not open
    /// @return 0, or the errno of what the system could not do
    int close();

private:
    int number_ = -1;
};

/// Writes all bytes. A full disk, a file size limit and a pipe without a reader are errors here: SIGXFSZ and SIGPIPE, which end a process
/// by default, are held back in the calling thread.
/// @return 0, or an errno
int write_all(int file, std::span<const std::byte> bytes);

} // namespace carom::files
