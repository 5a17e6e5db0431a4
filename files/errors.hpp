// What goes wrong with a file, by when it is found.
#pragma once

#include <stdexcept>

namespace carom::files
{

/// A file could not be read or written. what() names it and gives the reason: `--still: can't write "a.png": No space left on device`.
struct FileError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// There can be no such output: it is a folder, its folder does not exist, it may not be written, another process holds it. Found before
/// anything is written.
struct BadTarget : FileError
{
    using FileError::FileError;
};

/// The file can't be opened, or reading it failed.
struct CannotRead : FileError
{
    using FileError::FileError;
};

/// A write failed in the middle of the work: the disk is full, the reader of a pipe has gone.
struct CannotWrite : FileError
{
    using FileError::FileError;
};

} // namespace carom::files
