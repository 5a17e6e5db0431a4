// The program `carom`.
#include "cli/heap_counter.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"

#include <csignal>
#include <iostream>
#include <unistd.h>

int main(int argc, char** argv)
{
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    const bool err_is_terminal = isatty(STDERR_FILENO) != 0;
    carom::cli::note_interruptions();
    std::signal(SIGXFSZ, SIG_IGN); // a write past a limit on the size of files is to fail, and the program to say so
    const int status = carom::cli::run_program(
        arguments, {std::cout, std::cerr, err_is_terminal, carom::cli::heap_allocations, [] { return carom::cli::interruption() != 0; }});
    // Now that all is tidy the signal may end the process, so that a shell sees it and ends its loop too.
    if (const int signal = carom::cli::interruption()) std::raise(signal);
    return status;
}
