// Runs other programs.
#pragma once

#include <functional>
#include <string>
#include <string_view>
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

/// Runs a program to its end.
/// @param command the program, looked for as a shell would, and its arguments
/// @param seconds after which it is killed, > 0
/// @param is_interrupted asked again and again; when it says so, the program is killed as if its time were over
/// @param on_output gets what the program writes to its standard output, part by part; empty: that goes nowhere
ProcessResult run_process(const std::vector<std::string>& command, double seconds, const std::function<bool()>& is_interrupted = {},
                          const std::function<void(std::string_view)>& on_output = {});

} // namespace carom::lab
