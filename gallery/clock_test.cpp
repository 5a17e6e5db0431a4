#include "gallery/clock.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

TEST(Clock, steps_as_much_time_as_passes_whatever_the_frame_rate)
{
    for (const double frames_a_second : {24.0, 60.0, 144.0, 333.0})
    {
        Clock clock;
        int steps = 0;
        for (int i = 0; i < static_cast<int>(10 * frames_a_second); ++i)
        {
            steps += clock.advance(1 / frames_a_second, 1 / 60.0);
            EXPECT_GE(clock.blend(), 0);
            EXPECT_LE(clock.blend(), 1);
        }
        EXPECT_NEAR(steps, 600, 1) << frames_a_second;
    }
}

TEST(Clock, makes_one_step_a_frame_when_both_are_as_long)
{
    Clock clock;
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(clock.advance(1 / 60.0, static_cast<double>(1 / 60.0f)), 1);
}

TEST(Clock, slows_down_and_blends_between_steps)
{
    Clock clock;
    clock.set_speed(0.25);
    EXPECT_EQ(clock.advance(0.02, 0.01), 0);
    EXPECT_NEAR(clock.blend(), 0.5f, 1e-5f);
    EXPECT_EQ(clock.advance(0.02, 0.01), 1);
    EXPECT_NEAR(clock.blend(), 0, 1e-5f);
}

TEST(Clock, a_pause_makes_only_the_steps_that_were_asked_for)
{
    Clock clock;
    clock.request_step();
    clock.request_step();
    EXPECT_EQ(clock.advance(1, 0.01), 2);
    EXPECT_TRUE(clock.is_paused());
    EXPECT_EQ(clock.advance(1, 0.01), 0);
    EXPECT_EQ(clock.blend(), 1);
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(0.01, 0.01), 1);
}

TEST(Clock, does_not_make_up_for_a_frame_of_minutes)
{
    Clock clock;
    EXPECT_LE(clock.advance(300, 0.01), 10);
    clock.set_speed(1e9);
    EXPECT_EQ(clock.speed(), Clock::fastest);
    clock.set_speed(-1);
    EXPECT_EQ(clock.speed(), Clock::slowest);
}

} // namespace carom::gallery
