// Lanes as they lie in memory, for code that fills rows and reads them lane by lane. Arithmetic is for the wide lanes of solver/isa/, which lie alike.
#pragma once

#include "math/lanes.hpp"

namespace carom::detail
{

template <int Width>
struct alignas(4 * Width) LaneArray
{
    LaneArray() = default;
    explicit LaneArray(float all)
    {
        for (float& lane : f) lane = all;
    }

    float f[Width];
};

template <int Width>
struct LaneTraits<LaneArray<Width>>
{
    static constexpr int width = Width;
};

template <int Width>
float& lane(LaneArray<Width>& lanes, int i)
{
    return lanes.f[i];
}
template <int Width>
float lane(const LaneArray<Width>& lanes, int i)
{
    return lanes.f[i];
}

} // namespace carom::detail
