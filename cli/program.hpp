// The command line: reads it, does what it asks, and says what went wrong.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace carom::cli
{

/// What the program reaches outside of itself; tests give their own.
struct Surroundings
{
    std::ostream& out;
    std::ostream& err;
    bool err_is_terminal = false;
    std::function<std::uint64_t()> heap_allocations = {}; ///< of the whole process so far; empty when nobody counts
    std::function<bool()> is_interrupted = {};            ///< asked after each step: whether the run is to be given up
};

/// @param arguments without the program's name
/// @return the process's exit status: 0 done, 1 failed, 2 bad usage
int run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings);

} // namespace carom::cli
