// Uniform numbers for random calls.
#pragma once

#include <cstdint>

namespace carom::fuzz
{

/// The same everywhere (SplitMix64).
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    float from(float min, float max) { return min + (max - min) * static_cast<float>(bits() >> 40) / 16777216.0f; }

private:
    std::uint64_t state_;
};

} // namespace carom::fuzz
