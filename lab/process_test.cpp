#include "lab/process.hpp"

#include <chrono>
#include <gtest/gtest.h>

namespace carom::lab
{

TEST(Process, tells_the_status_and_what_was_said)
{
    const ProcessResult done = run_process({"sh", "-c", "echo lost; echo said >&2; exit 3"}, 10);
    EXPECT_TRUE(done.is_started);
    EXPECT_EQ(done.status, 3);
    EXPECT_EQ(done.errors, "said\n");
}

TEST(Process, that_does_not_exist_does_not_start)
{
    EXPECT_FALSE(run_process({"carom-no-such-program"}, 10).is_started);
    EXPECT_FALSE(run_process({}, 10).is_started);
}

TEST(Process, that_hangs_is_ended)
{
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult hung = run_process({"sleep", "60"}, 0.2);
    EXPECT_TRUE(hung.is_timeout);
    EXPECT_EQ(hung.status, 128 + 9);
    EXPECT_TRUE(run_process({"sh", "-c", "exec 2>&-; sleep 60"}, 0.2).is_timeout) << "though it has closed its errors";
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Process, that_nobody_waits_for_is_ended)
{
    const auto start = std::chrono::steady_clock::now();
    int asked = 0;
    EXPECT_TRUE(run_process({"sleep", "60"}, 60, [&] { return ++asked > 2; }).is_timeout);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Process, what_it_writes_is_handed_on)
{
    std::string written;
    const ProcessResult done =
        run_process({"sh", "-c", "seq 1 30000; echo said >&2"}, 20, {}, [&](std::string_view text) { written += text; });
    EXPECT_EQ(done.status, 0);
    EXPECT_EQ(done.errors, "said\n");
    EXPECT_TRUE(written.starts_with("1\n2\n"));
    EXPECT_TRUE(written.ends_with("30000\n"));
    EXPECT_EQ(written.size(), 168894u);
}

TEST(Process, that_crashes_tells_the_signal) { EXPECT_EQ(run_process({"sh", "-c", "kill -SEGV $$"}, 10).status, 128 + 11); }

TEST(Process, that_says_much_is_heard_to_its_end)
{
    const ProcessResult much = run_process({"sh", "-c", "seq 1 100000 >&2"}, 20);
    EXPECT_EQ(much.status, 0);
    EXPECT_LE(much.errors.size(), 4000u);
    EXPECT_TRUE(much.errors.ends_with("100000\n"));
}

} // namespace carom::lab
