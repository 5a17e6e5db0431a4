// A signal is noted instead of ending the process, once.
#include "cli/interruption.hpp"

#include <csignal>
#include <gtest/gtest.h>

namespace carom::cli
{

TEST(Interruption, a_signal_is_noted_once)
{
    note_interruptions();
    EXPECT_EQ(interruption(), 0);
    std::raise(SIGTERM);
    EXPECT_EQ(interruption(), SIGTERM);
    EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL); // a second one would have ended the process
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
}

} // namespace carom::cli
