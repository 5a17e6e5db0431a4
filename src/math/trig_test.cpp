// The engine's trigonometry against the double precision library, and against itself on other compilers.
#include <carom/math.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace carom
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();

double sin_cos_error(float angle)
{
    const SinCos v = sin_cos(angle);
    return std::max(std::abs(v.sin - std::sin(double{angle})), std::abs(v.cos - std::cos(double{angle})));
}

/// Every finite float, uniformly over the bit patterns, that is over all magnitudes.
float random_float(std::mt19937& random)
{
    for (;;)
    {
        const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isfinite(f)) return f;
    }
}

void add_bits(std::uint64_t& hash, float value)
{
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3ull; // Fowler, Noll, Vo
}

} // namespace

TEST(Trig, SinCosFollowsTheLibraryInTheRangeOfBodyAngles)
{
    double worst = 0;
    for (int i = -800000; i <= 800000; ++i) worst = std::max(worst, sin_cos_error(static_cast<float>(i) * 0.01f));
    EXPECT_LT(worst, 1e-7);
}

TEST(Trig, SinCosFollowsTheLibraryForEveryMagnitude)
{
    std::mt19937 random(1);
    double worst = 0;
    double worst_norm = 0;
    for (int i = 0; i < 1000000; ++i)
    {
        const float angle = random_float(random);
        const SinCos v = sin_cos(angle);
        worst = std::max(worst, sin_cos_error(angle));
        worst_norm = std::max(worst_norm, std::abs(double{v.sin} * v.sin + double{v.cos} * v.cos - 1));
    }
    EXPECT_LT(worst, 1e-7);
    EXPECT_LT(worst_norm, 1e-6);
}

TEST(Trig, SinCosIsContinuousWhereTheReductionChanges)
{
    for (float angle : {33554428.0f, 33554430.0f, 33554432.0f, 33554436.0f, 33554440.0f, 67108864.0f, 3.4028235e38f, 1e10f, 1e22f})
    {
        EXPECT_LT(sin_cos_error(angle), 1e-7) << angle;
        EXPECT_LT(sin_cos_error(-angle), 1e-7) << -angle;
    }
}

TEST(Trig, SinCosAtQuarterTurns)
{
    const SinCos zero = sin_cos(0);
    EXPECT_EQ(zero.sin, 0);
    EXPECT_EQ(zero.cos, 1);
    for (int k = -40; k <= 40; ++k)
    {
        const float angle = static_cast<float>(k) * 0.5f * pi;
        EXPECT_LT(sin_cos_error(angle), 1e-7) << k;
        EXPECT_LT(sin_cos_error(std::nextafter(angle, -infinity)), 1e-7) << k;
        EXPECT_LT(sin_cos_error(std::nextafter(angle, infinity)), 1e-7) << k;
    }
}

TEST(Trig, SinIsOddAndCosIsEven)
{
    std::mt19937 random(2);
    for (int i = 0; i < 100000; ++i)
    {
        const float angle = random_float(random);
        const SinCos plus = sin_cos(angle);
        const SinCos minus = sin_cos(-angle);
        ASSERT_EQ(plus.sin, -minus.sin) << angle;
        ASSERT_EQ(plus.cos, minus.cos) << angle;
    }
}

TEST(Trig, SinCosOfNoNumberIsNoNumber)
{
    for (float angle : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity})
    {
        EXPECT_TRUE(std::isnan(sin_cos(angle).sin));
        EXPECT_TRUE(std::isnan(sin_cos(angle).cos));
    }
}

TEST(Trig, Atan2FollowsTheLibraryAroundTheCircle)
{
    double worst = 0;
    for (int i = 0; i < 1000000; ++i)
    {
        const double angle = -3.14159265 + 2 * 3.14159265 * i / 1e6;
        const float y = static_cast<float>(3 * std::sin(angle));
        const float x = static_cast<float>(3 * std::cos(angle));
        worst = std::max(worst, std::abs(atan2(y, x) - std::atan2(double{y}, double{x})));
    }
    EXPECT_LT(worst, 2e-7);
}

TEST(Trig, Atan2FollowsTheLibraryForEveryMagnitude)
{
    std::mt19937 random(3);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i)
    {
        const float y = random_float(random);
        const float x = random_float(random);
        if (y == 0) continue; // the sign of zero makes no difference here
        worst = std::max(worst, std::abs(atan2(y, x) - std::atan2(double{y}, double{x})));
    }
    EXPECT_LT(worst, 2e-7);
}

TEST(Trig, Atan2OnTheAxes)
{
    EXPECT_EQ(atan2(0, 0), 0);
    EXPECT_EQ(atan2(-0.0f, -0.0f), 0);
    EXPECT_EQ(atan2(0, 5), 0);
    EXPECT_EQ(atan2(0, -5), pi);
    EXPECT_EQ(atan2(-0.0f, -5), pi);
    EXPECT_EQ(atan2(2, 0), 0.5f * pi);
    EXPECT_EQ(atan2(-2, 0), -0.5f * pi);
    EXPECT_EQ(atan2(3, 3), 0.25f * pi);
    EXPECT_EQ(atan2(-3, -3), -0.75f * pi);
    EXPECT_EQ(atan2(1e-45f, 3e38f), 0);
    EXPECT_TRUE(std::isnan(atan2(std::numeric_limits<float>::quiet_NaN(), 1)));
    EXPECT_TRUE(std::isnan(atan2(1, std::numeric_limits<float>::quiet_NaN())));
}

TEST(Trig, Atan2UndoesSinCos)
{
    for (int i = -31415; i <= 31415; ++i)
    {
        const float expected = static_cast<float>(i) * 1e-4f;
        ASSERT_NEAR(angle(rotation(expected)), expected, 3e-7f);
    }
}

/// The bits themselves: this number is the same for every compiler, build type and architecture, or worlds would drift apart.
TEST(Trig, GivesTheSameBitsEverywhere)
{
    std::mt19937 random(4); // the standard fixes its sequence
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (int i = 0; i < 1000000; ++i)
    {
        const float any = random_float(random);
        const float body_angle = static_cast<float>(static_cast<std::int32_t>(random())) * 1e-6f;
        for (float angle : {any, body_angle})
        {
            const SinCos v = sin_cos(angle);
            add_bits(hash, v.sin);
            add_bits(hash, v.cos);
            add_bits(hash, atan2(angle, body_angle));
        }
    }
    EXPECT_EQ(hash, 12599684532547343971ull);
}

} // namespace carom
