// Runs the command-line program inside a test.
#pragma once

#include "cli/program.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace carom::cli
{

struct Outcome
{
    int status = 0;
    std::string out; ///< what it wrote to standard output
    std::string err;
};

inline Outcome carom(const std::vector<std::string>& arguments, bool is_terminal = false)
{
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_program(arguments, {out, err, is_terminal});
    return {status, out.str(), err.str()};
}

} // namespace carom::cli
