// The program `carom`.
#include "cli/heap_counter.hpp"
#include "cli/program.hpp"

#include <iostream>
#include <unistd.h>

int main(int argc, char** argv)
{
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    const bool err_is_terminal = isatty(STDERR_FILENO) != 0;
    return carom::cli::run_program(arguments, {std::cout, std::cerr, err_is_terminal, carom::cli::heap_allocations});
}
