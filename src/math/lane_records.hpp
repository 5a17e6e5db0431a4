// Records of floats, one lane each: their columns are loaded into lanes, and lanes are written back to the records.
#pragma once

#include "math/lanes.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// An index for each lane. A struct of its own for each lane type, so that its functions are too.
template <class F>
struct LaneIndices
{
    std::uint32_t at[static_cast<std::size_t>(lane_width<F>)];

    std::uint32_t& operator[](std::size_t i) { return at[i]; }
    const std::uint32_t& operator[](std::size_t i) const { return at[i]; }
    void fill(std::uint32_t index)
    {
        for (std::uint32_t& i : at) i = index;
    }
};

/// A record for each lane. `Float` is const where they are only read.
template <class F, class Float>
struct LaneRecords
{
    Float* at[static_cast<std::size_t>(lane_width<F>)];
};

template <class F>
struct TwoLanes
{
    F f0, f1;
};

template <class F>
struct FourLanes
{
    F f0, f1, f2, f3;
};

template <class F>
struct EightLanes
{
    F f0, f1, f2, f3, f4, f5, f6, f7;
};

/// Float by float; wide lanes have versions of their own, by transposes (math/wide_records.hpp).
template <class Columns, class F>
Columns gather_columns(const LaneRecords<F, const float>& records, std::size_t first)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    float columns[sizeof(Columns) / sizeof(F)][width];
    for (std::size_t c = 0; c < sizeof(Columns) / sizeof(F); ++c)
        for (std::size_t i = 0; i < width; ++i) columns[c][i] = records.at[i][first + c];
    Columns lanes;
    __builtin_memcpy(&lanes, columns, sizeof lanes);
    return lanes;
}

template <class Columns, class F>
void scatter_columns(const LaneRecords<F, float>& records, std::size_t first, const Columns& lanes)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    float columns[sizeof(Columns) / sizeof(F)][width];
    __builtin_memcpy(columns, &lanes, sizeof lanes);
    for (std::size_t c = 0; c < sizeof(Columns) / sizeof(F); ++c)
        for (std::size_t i = 0; i < width; ++i) records.at[i][first + c] = columns[c][i];
}

/// The columns of four floats from the `first` of each record on.
template <class F>
FourLanes<F> gather_four(const LaneRecords<F, const float>& records, std::size_t first)
{
    return gather_columns<FourLanes<F>>(records, first);
}

template <class F>
EightLanes<F> gather_eight(const LaneRecords<F, const float>& records, std::size_t first)
{
    return gather_columns<EightLanes<F>>(records, first);
}

template <class F>
void scatter_two(const LaneRecords<F, float>& records, std::size_t first, const TwoLanes<F>& lanes)
{
    scatter_columns(records, first, lanes);
}

template <class F>
void scatter_four(const LaneRecords<F, float>& records, std::size_t first, const FourLanes<F>& lanes)
{
    scatter_columns(records, first, lanes);
}

template <class F>
void scatter_eight(const LaneRecords<F, float>& records, std::size_t first, const EightLanes<F>& lanes)
{
    scatter_columns(records, first, lanes);
}

/// One float for each index.
template <class F>
F gather_floats(const float* floats, const LaneIndices<F>& indices)
{
    float lanes[static_cast<std::size_t>(lane_width<F>)];
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) lanes[i] = floats[indices[i]];
    F wide;
    __builtin_memcpy(&wide, lanes, sizeof wide);
    return wide;
}

/// The index where the mask is set, else 0.
inline LaneIndices<float> indices_where(bool mask, const LaneIndices<float>& indices) { return {{mask ? indices.at[0] : 0}}; }

} // namespace carom::detail
