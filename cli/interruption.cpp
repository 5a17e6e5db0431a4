// The signal handler, which does nothing but keep the signal's number.
#include "cli/interruption.hpp"

#include <csignal>
#include <initializer_list>

namespace carom::cli
{

namespace
{

volatile std::sig_atomic_t noted = 0; // a handler may write to nothing else

extern "C" void note(int signal) { noted = signal; }

} // namespace

void note_interruptions()
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    {
        struct sigaction action = {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = note;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        ::sigaction(signal, &action, nullptr);
    }
}

int interruption() { return noted; }

} // namespace carom::cli
