// Definitions of the passes, for the one file of each instruction set. Every function here is a template over the lane type, as in
// solver/isa/contact_passes_impl.hpp. tests: isa_symbols
#pragma once

#include "fields/isa/pull_passes.hpp"

namespace carom::detail
{

/// Partial sums of one quantity, added in pairs.
template <class F>
struct PartialSums
{
    float parts[pull_parts];

    void keep(int part, F lanes) { __builtin_memcpy(parts + part, &lanes, sizeof lanes); }
    float total() const { return ((parts[0] + parts[1]) + (parts[2] + parts[3])) + ((parts[4] + parts[5]) + (parts[6] + parts[7])); }
};

/// The value of a series at each target, as many targets at once as there are lanes.
template <class F>
void evaluate_series(const LocalPull& around, const float* targets, std::size_t count, float* pulls)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    constexpr int terms = static_cast<int>(sizeof(PullSeries<float>) / sizeof(float));
    float values[terms];
    __builtin_memcpy(values, &around.terms, sizeof values);
    F wide[terms];
    for (int k = 0; k < terms; ++k) wide[k] = F(values[k]);
    const float unit = around.radius > 0 ? around.radius : 1;
    for (std::size_t t = 0; t < count; t += width)
    {
        const std::size_t some = count - t < width ? count - t : width;
        float x[width] = {};
        float y[width] = {};
        for (std::size_t i = 0; i < some; ++i)
        {
            x[i] = targets[2 * (t + i)] - around.x;
            y[i] = targets[2 * (t + i) + 1] - around.y;
        }
        PullSeries<F> series;
        __builtin_memcpy(&series, wide, sizeof series);
        add_higher_orders<F>(series, load_lanes<F>(x) / F(unit), load_lanes<F>(y) / F(unit), 0);
        __builtin_memcpy(x, &series.value[0], sizeof x);
        __builtin_memcpy(y, &series.value[1], sizeof y);
        for (std::size_t i = 0; i < some; ++i)
        {
            pulls[2 * (t + i)] += x[i];
            pulls[2 * (t + i) + 1] += y[i];
        }
    }
}

template <class F>
[[gnu::flatten]] void sum_pulls(const PullList& list, const LocalPull& around, const float* targets, std::size_t count,
                                const PullLimits& limits, float* pulls)
{
    for (std::size_t t = 0; t < count; ++t)
    {
        const F x(targets[2 * t]);
        const F y(targets[2 * t + 1]);
        PartialSums<F> all_x;
        PartialSums<F> all_y;
        for (int part = 0; part < pull_parts; part += lane_width<F>)
        {
            PullLanes<F> sum;
            for (std::size_t i = static_cast<std::size_t>(part); i < list.bodies; i += pull_parts)
                add_bodies<F>(sum, list.body_x + i, list.body_y + i, list.body_pull + i, x, y, limits);
            for (std::size_t i = 0; i < list.group_blocks; ++i) add_groups<F>(sum, list.groups[i], part, x, y, limits);
            all_x.keep(part, sum.x);
            all_y.keep(part, sum.y);
        }
        pulls[2 * t] = all_x.total();
        pulls[2 * t + 1] = all_y.total();
    }
    evaluate_series<F>(around, targets, count, pulls);
}

/// Eight groups to a block: rows to columns.
template <class F>
void gather_block(const float* groups, const std::uint32_t* which, GroupBlock& block)
{
    float* const columns = block.x; // the first of the block's arrays, which lie one after the other
#if defined(__AVX2__)
    if constexpr (lane_width<F> == 8)
    {
        const Octet<F> o = gather_octet<F>(groups, group_floats, which);
        const auto store = [&](std::size_t k, __m256 column) { _mm256_storeu_ps(columns + k * pull_parts, column); };
        store(0, o.f0), store(1, o.f1), store(2, o.f2), store(3, o.f3), store(4, o.f4), store(5, o.f5), store(6, o.f6), store(7, o.f7);
        // Of groups i and i + 4 the last four floats.
        const auto rest = [&](std::size_t i)
        {
            const float* const low = groups + group_floats * which[i] + 8;
            return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(groups + group_floats * which[i + 4] + 8),
                                        1);
        };
        const __m256 s0 = rest(0), s1 = rest(1), s2 = rest(2), s3 = rest(3);
        const __m256 lo_a = _mm256_unpacklo_ps(s0, s1), hi_a = _mm256_unpackhi_ps(s0, s1);
        const __m256 lo_b = _mm256_unpacklo_ps(s2, s3), hi_b = _mm256_unpackhi_ps(s2, s3);
        constexpr int first = _MM_SHUFFLE(1, 0, 1, 0), second = _MM_SHUFFLE(3, 2, 3, 2);
        store(8, _mm256_shuffle_ps(lo_a, lo_b, first));
        store(9, _mm256_shuffle_ps(lo_a, lo_b, second));
        store(10, _mm256_shuffle_ps(hi_a, hi_b, first));
        store(11, _mm256_shuffle_ps(hi_a, hi_b, second));
        return;
    }
#endif
    for (std::size_t i = 0; i < pull_parts; ++i)
        for (std::size_t k = 0; k < group_floats; ++k) columns[k * pull_parts + i] = groups[group_floats * which[i] + k];
}

/// The last block of a list, filled up with groups that pull nothing where the last one is.
template <class F>
void gather_last_block(const float* groups, const std::uint32_t* which, std::size_t count, GroupBlock& block)
{
    std::uint32_t filled[pull_parts];
    for (std::size_t i = 0; i < pull_parts; ++i) filled[i] = which[i < count ? i : count - 1];
    gather_block<F>(groups, filled, block);
    for (std::size_t i = count; i < pull_parts; ++i) block.pull[i] = 0;
}

template <class F>
[[gnu::flatten]] void expand_groups(const float* groups, const std::uint32_t* which, std::size_t count, const PullLimits& limits,
                                    LocalPull& around)
{
    constexpr int terms = static_cast<int>(sizeof(PullSeries<float>) / sizeof(float));
    constexpr int parts = pull_parts / lane_width<F>;
    F lanes[terms];
    for (F& zero : lanes) zero = F(0);
    PullSeries<F> sums[parts];
    for (PullSeries<F>& sum : sums) __builtin_memcpy(&sum, lanes, sizeof sum);
    for (std::size_t i = 0; i < count; i += pull_parts)
    {
        GroupBlock block;
        if (i + pull_parts <= count)
            gather_block<F>(groups, which + i, block);
        else
            gather_last_block<F>(groups, which + i, count - i, block);
        for (int p = 0; p < parts; ++p)
            add_series<F>(sums[p], block, p * lane_width<F>, F(around.x), F(around.y), F(around.radius), limits);
    }
    PartialSums<F> all[terms];
    for (int p = 0; p < parts; ++p)
    {
        __builtin_memcpy(lanes, &sums[p], sizeof lanes);
        for (int k = 0; k < terms; ++k) all[k].keep(p * lane_width<F>, lanes[k]);
    }
    float values[terms];
    __builtin_memcpy(values, &around.terms, sizeof values);
    for (int k = 0; k < terms; ++k) values[k] += all[k].total();
    __builtin_memcpy(&around.terms, values, sizeof values);
}

template <class F>
inline constexpr PullPasses pull_passes = {&sum_pulls<F>, &expand_groups<F>};

} // namespace carom::detail
