// Random numbers that are the same on every machine. The standard library's distributions differ among implementations, so
// scenes use only this.
#pragma once

#include <carom/math.hpp>

#include <cstdint>

namespace carom::scenes
{

/// A PCG32 generator.
///
/// Draw one number a statement, or inside braces: the arguments of a function call are evaluated in an order that each
/// compiler chooses, and the scene would differ between them.
/// @source M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms", 2014
class Random
{
public:
    /// @param stream separates generators of one seed, so that drawing more for the looks does not change the physics
    explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1) | 1)
    {
        bits();
        state_ += seed;
        bits();
    }

    /// 32 random bits.
    constexpr std::uint32_t bits()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }

    /// In [0, 1), in steps of 2^-24 so that every value is exact.
    constexpr float uniform() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
    constexpr float uniform(float low, float high) { return low + (high - low) * uniform(); }

    /// In [low, high], both included; high >= low.
    constexpr int integer(int low, int high)
    {
        const auto count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
        return static_cast<int>(low + static_cast<std::int64_t>((bits() * count) >> 32));
    }

    constexpr Vec2 point_in(const Aabb& box) { return {uniform(box.min.x, box.max.x), uniform(box.min.y, box.max.y)}; }

    /// A unit vector.
    Vec2 direction()
    {
        const SinCos v = sin_cos(uniform(-pi, pi));
        return {v.cos, v.sin};
    }

private:
    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

} // namespace carom::scenes
