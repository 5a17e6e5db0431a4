// Four lanes made of nothing but what math/lanes.hpp asks of a lane type: for tests that wide rows give the bits of scalar ones.
#pragma once

#include "math/lane_trig.hpp"

#include <array>

namespace carom::detail
{

/// Four numbers, one after the other.
struct FourLanes
{
    FourLanes() = default;
    explicit FourLanes(float all) : f{all, all, all, all} {}

    std::array<float, 4> f;
};

struct FourMask
{
    std::array<bool, 4> m;
};

template <>
struct LaneTraits<FourLanes>
{
    static constexpr int width = 4;
    using Mask = FourMask;
};

template <class Operation>
FourLanes by_lane(const FourLanes& a, const FourLanes& b, Operation&& operation)
{
    FourLanes out;
    for (std::size_t i = 0; i < 4; ++i) out.f[i] = operation(a.f[i], b.f[i]);
    return out;
}

template <class Relation>
FourMask compare(const FourLanes& a, const FourLanes& b, Relation&& relation)
{
    FourMask out;
    for (std::size_t i = 0; i < 4; ++i) out.m[i] = relation(a.f[i], b.f[i]);
    return out;
}

inline FourLanes operator+(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return x + y; });
}
inline FourLanes operator-(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return x - y; });
}
inline FourLanes operator*(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return x * y; });
}
inline FourLanes operator/(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return x / y; });
}
inline FourLanes operator-(const FourLanes& a)
{
    return by_lane(a, a, [](float x, float) { return -x; });
}
inline FourMask operator>(const FourLanes& a, const FourLanes& b)
{
    return compare(a, b, [](float x, float y) { return x > y; });
}
inline FourMask operator<(const FourLanes& a, const FourLanes& b)
{
    return compare(a, b, [](float x, float y) { return x < y; });
}
inline FourMask operator&(const FourMask& a, const FourMask& b)
{
    FourMask out;
    for (std::size_t i = 0; i < 4; ++i) out.m[i] = a.m[i] && b.m[i];
    return out;
}

inline FourLanes select(const FourMask& mask, const FourLanes& yes, const FourLanes& no)
{
    FourLanes out;
    for (std::size_t i = 0; i < 4; ++i) out.f[i] = mask.m[i] ? yes.f[i] : no.f[i];
    return out;
}
inline FourLanes lane_max(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return lane_max(x, y); });
}
inline FourLanes lane_min(const FourLanes& a, const FourLanes& b)
{
    return by_lane(a, b, [](float x, float y) { return lane_min(x, y); });
}
inline FourLanes lane_sqrt(const FourLanes& a)
{
    return by_lane(a, a, [](float x, float) { return lane_sqrt(x); });
}
inline FourLanes lane_atan2(const FourLanes& y, const FourLanes& x)
{
    return by_lane(y, x, [](float p, float q) { return lane_atan2(p, q); });
}
inline float& lane(FourLanes& f, int i) { return f.f[static_cast<std::size_t>(i)]; }
inline float lane(const FourLanes& f, int i) { return f.f[static_cast<std::size_t>(i)]; }

} // namespace carom::detail
