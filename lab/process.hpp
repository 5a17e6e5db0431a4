// Runs other programs.
#pragma once

#include <string>
#include <vector>

namespace carom::lab
{

struct ProcessResult
{
    bool is_started = false; ///< false when there is no such program, or it may not be run
    bool is_timeout = false; ///< it took too long and was ended
    int status = -1;         ///< exit status; 128 plus the signal's number when a signal ended it
    std::string errors;      ///< what it wrote to its standard error: the last 4000 characters
};

/// Runs a program to its end. Its standard output goes nowhere.
/// @param command the program, looked for as a shell would, and its arguments
/// @param seconds after which it is killed, > 0
ProcessResult run_process(const std::vector<std::string>& command, double seconds);

} // namespace carom::lab
