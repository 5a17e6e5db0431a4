// Random numbers for tests of the engine. Test code only; the same sequence on every machine.
#pragma once

#include <carom/math.hpp>

#include <random>

namespace carom::detail
{

/// The standard fixes the sequence of std::mt19937, but not what its distributions make of it; so none is used. Draw one number a
/// statement, or inside braces: the arguments of a call are evaluated in an order that each compiler chooses.
class Random
{
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    unsigned below(unsigned end) { return static_cast<unsigned>(engine_() % end); }
    bool chance(double probability) { return between(0, 1) < probability; }
    float between(float low, float high) { return low + (high - low) * (static_cast<float>(engine_() >> 8) / 16777216.0f); }
    Vec2 point(float reach) { return {between(-reach, reach), between(-reach, reach)}; }

private:
    std::mt19937 engine_;
};

} // namespace carom::detail
