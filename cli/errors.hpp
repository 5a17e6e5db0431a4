// What goes wrong in the command-line program, by whose fault it is.
#pragma once

#include <stdexcept>

namespace carom::cli
{

inline constexpr int status_failed = 1;    ///< something outside of the command line failed: a disk, another program
inline constexpr int status_bad_usage = 2; ///< the command line asks for what can't be had

/// The command line, or a file that it names, asks for what can't be had. Found before anything is written.
struct BadUsage : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// A file could not be written, or another program failed, in the middle of the work.
struct Failure : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

} // namespace carom::cli
