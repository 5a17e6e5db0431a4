// Columns of records into registers and back, by transposes. See math/lane_records.hpp for what each function does.
#pragma once

#include "math/lane_records.hpp"
#include "math/wide_lanes.hpp"

namespace carom::detail
{

template <int Width>
LaneIndices<Lanes<Width>> indices_where(LaneMask<Width> mask, const LaneIndices<Lanes<Width>>& indices)
{
    LaneIndices<Lanes<Width>> kept;
    decltype(mask.v) bits;
    __builtin_memcpy(&bits, indices.at, sizeof bits);
    bits &= mask.v;
    __builtin_memcpy(kept.at, &bits, sizeof bits);
    return kept;
}

#if defined(__SSE2__) && !defined(__AVX2__)

inline FourLanes<Lanes<4>> gather_four(const LaneRecords<Lanes<4>, const float>& records, std::size_t first)
{
    const auto record = [&](std::size_t i) { return _mm_loadu_ps(records.at[i] + first); };
    const Quad<Lanes<4>> columns = transposed<Lanes<4>>({record(0), record(1), record(2), record(3)});
    return {columns.x, columns.y, columns.z, columns.w};
}

inline EightLanes<Lanes<4>> gather_eight(const LaneRecords<Lanes<4>, const float>& records, std::size_t first)
{
    const FourLanes<Lanes<4>> l = gather_four(records, first);
    const FourLanes<Lanes<4>> r = gather_four(records, first + 4);
    return {l.f0, l.f1, l.f2, l.f3, r.f0, r.f1, r.f2, r.f3};
}

inline void scatter_two(const LaneRecords<Lanes<4>, float>& records, std::size_t first, const TwoLanes<Lanes<4>>& lanes)
{
    const __m128 of_01 = _mm_unpacklo_ps(lanes.f0.v, lanes.f1.v), of_23 = _mm_unpackhi_ps(lanes.f0.v, lanes.f1.v);
    const auto to = [&](std::size_t i) { return reinterpret_cast<__m64*>(records.at[i] + first); };
    _mm_storel_pi(to(0), of_01);
    _mm_storeh_pi(to(1), of_01);
    _mm_storel_pi(to(2), of_23);
    _mm_storeh_pi(to(3), of_23);
}

inline void scatter_four(const LaneRecords<Lanes<4>, float>& records, std::size_t first, const FourLanes<Lanes<4>>& lanes)
{
    const Quad<Lanes<4>> rows = transposed<Lanes<4>>({lanes.f0.v, lanes.f1.v, lanes.f2.v, lanes.f3.v});
    _mm_storeu_ps(records.at[0] + first, rows.x);
    _mm_storeu_ps(records.at[1] + first, rows.y);
    _mm_storeu_ps(records.at[2] + first, rows.z);
    _mm_storeu_ps(records.at[3] + first, rows.w);
}

inline void scatter_eight(const LaneRecords<Lanes<4>, float>& records, std::size_t first, const EightLanes<Lanes<4>>& lanes)
{
    scatter_four(records, first, {lanes.f0, lanes.f1, lanes.f2, lanes.f3});
    scatter_four(records, first + 4, {lanes.f4, lanes.f5, lanes.f6, lanes.f7});
}

#endif

#if defined(__AVX2__)

/// Four columns of eight records.
template <class Tag>
struct EightQuads
{
    __m256 f0, f1, f2, f3;
};

/// Rows to columns in both halves. A row holds the four floats of a record in its lower half, and in the upper those of the record four further on.
template <class Tag>
EightQuads<Tag> transposed_quads(EightQuads<Tag> q)
{
    const __m256 lo_01 = _mm256_unpacklo_ps(q.f0, q.f1), hi_01 = _mm256_unpackhi_ps(q.f0, q.f1);
    const __m256 lo_23 = _mm256_unpacklo_ps(q.f2, q.f3), hi_23 = _mm256_unpackhi_ps(q.f2, q.f3);
    constexpr int first = _MM_SHUFFLE(1, 0, 1, 0), second = _MM_SHUFFLE(3, 2, 3, 2);
    return {_mm256_shuffle_ps(lo_01, lo_23, first), _mm256_shuffle_ps(lo_01, lo_23, second), _mm256_shuffle_ps(hi_01, hi_23, first),
            _mm256_shuffle_ps(hi_01, hi_23, second)};
}

/// @param records of eight lanes
template <class Tag>
EightQuads<Tag> load_quads(const float* const* records, std::size_t first)
{
    const auto both = [&](std::size_t i)
    { return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(records[i] + first)), _mm_loadu_ps(records[i + 4] + first), 1); };
    return transposed_quads<Tag>({both(0), both(1), both(2), both(3)});
}

template <class Tag>
void store_pairs(float* const* records, std::size_t first, __m256 f0, __m256 f1)
{
    const auto both = [&](std::size_t i, __m128 pairs)
    {
        _mm_storel_pi(reinterpret_cast<__m64*>(records[i] + first), pairs);
        _mm_storeh_pi(reinterpret_cast<__m64*>(records[i + 1] + first), pairs);
    };
    const __m256 lo = _mm256_unpacklo_ps(f0, f1), hi = _mm256_unpackhi_ps(f0, f1);
    both(0, _mm256_castps256_ps128(lo));
    both(2, _mm256_castps256_ps128(hi));
    both(4, _mm256_extractf128_ps(lo, 1));
    both(6, _mm256_extractf128_ps(hi, 1));
}

template <class Tag>
void store_quads(float* const* records, std::size_t first, EightQuads<Tag> columns)
{
    const EightQuads<Tag> rows = transposed_quads<Tag>(columns);
    const auto both = [&](std::size_t i, __m256 row)
    {
        _mm_storeu_ps(records[i] + first, _mm256_castps256_ps128(row));
        _mm_storeu_ps(records[i + 4] + first, _mm256_extractf128_ps(row, 1));
    };
    both(0, rows.f0);
    both(1, rows.f1);
    both(2, rows.f2);
    both(3, rows.f3);
}

template <class Tag>
Octet<Tag> load_octet(const float* const* records, std::size_t first)
{
    const auto record = [&](std::size_t i) { return _mm256_loadu_ps(records[i] + first); };
    return transposed<Tag>({record(0), record(1), record(2), record(3), record(4), record(5), record(6), record(7)});
}

template <class Tag>
void store_octet(float* const* records, std::size_t first, const Octet<Tag>& columns)
{
    const Octet<Tag> rows = transposed<Tag>(columns);
    _mm256_storeu_ps(records[0] + first, rows.f0);
    _mm256_storeu_ps(records[1] + first, rows.f1);
    _mm256_storeu_ps(records[2] + first, rows.f2);
    _mm256_storeu_ps(records[3] + first, rows.f3);
    _mm256_storeu_ps(records[4] + first, rows.f4);
    _mm256_storeu_ps(records[5] + first, rows.f5);
    _mm256_storeu_ps(records[6] + first, rows.f6);
    _mm256_storeu_ps(records[7] + first, rows.f7);
}

#if !defined(__AVX512F__)

inline Lanes<8> gather_floats(const float* floats, const LaneIndices<Lanes<8>>& indices)
{
    return _mm256_i32gather_ps(floats, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(indices.at)), 4);
}

inline FourLanes<Lanes<8>> gather_four(const LaneRecords<Lanes<8>, const float>& records, std::size_t first)
{
    const EightQuads<Lanes<8>> q = load_quads<Lanes<8>>(records.at, first);
    return {q.f0, q.f1, q.f2, q.f3};
}

inline EightLanes<Lanes<8>> gather_eight(const LaneRecords<Lanes<8>, const float>& records, std::size_t first)
{
    const Octet<Lanes<8>> o = load_octet<Lanes<8>>(records.at, first);
    return {o.f0, o.f1, o.f2, o.f3, o.f4, o.f5, o.f6, o.f7};
}

inline void scatter_two(const LaneRecords<Lanes<8>, float>& records, std::size_t first, const TwoLanes<Lanes<8>>& l)
{
    store_pairs<Lanes<8>>(records.at, first, l.f0.v, l.f1.v);
}

inline void scatter_four(const LaneRecords<Lanes<8>, float>& records, std::size_t first, const FourLanes<Lanes<8>>& l)
{
    store_quads<Lanes<8>>(records.at, first, {l.f0.v, l.f1.v, l.f2.v, l.f3.v});
}

inline void scatter_eight(const LaneRecords<Lanes<8>, float>& records, std::size_t first, const EightLanes<Lanes<8>>& l)
{
    store_octet<Lanes<8>>(records.at, first, {l.f0.v, l.f1.v, l.f2.v, l.f3.v, l.f4.v, l.f5.v, l.f6.v, l.f7.v});
}

#endif
#endif

#if defined(__AVX512F__)

inline Lanes<16> joined(__m256 low, __m256 high) { return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1); }
inline __m256 low_of(Lanes<16> lanes) { return _mm512_castps512_ps256(lanes.v); }
inline __m256 high_of(Lanes<16> lanes) { return _mm512_extractf32x8_ps(lanes.v, 1); }

inline Lanes<16> gather_floats(const float* floats, const LaneIndices<Lanes<16>>& indices)
{
    return _mm512_i32gather_ps(_mm512_loadu_si512(indices.at), floats, 4);
}

inline FourLanes<Lanes<16>> gather_four(const LaneRecords<Lanes<16>, const float>& records, std::size_t first)
{
    const EightQuads<Lanes<16>> l = load_quads<Lanes<16>>(records.at, first);
    const EightQuads<Lanes<16>> r = load_quads<Lanes<16>>(records.at + 8, first);
    return {joined(l.f0, r.f0), joined(l.f1, r.f1), joined(l.f2, r.f2), joined(l.f3, r.f3)};
}

inline EightLanes<Lanes<16>> gather_eight(const LaneRecords<Lanes<16>, const float>& records, std::size_t first)
{
    const Octet<Lanes<16>> l = load_octet<Lanes<16>>(records.at, first);
    const Octet<Lanes<16>> r = load_octet<Lanes<16>>(records.at + 8, first);
    return {joined(l.f0, r.f0), joined(l.f1, r.f1), joined(l.f2, r.f2), joined(l.f3, r.f3),
            joined(l.f4, r.f4), joined(l.f5, r.f5), joined(l.f6, r.f6), joined(l.f7, r.f7)};
}

inline void scatter_two(const LaneRecords<Lanes<16>, float>& records, std::size_t first, const TwoLanes<Lanes<16>>& l)
{
    store_pairs<Lanes<16>>(records.at, first, low_of(l.f0), low_of(l.f1));
    store_pairs<Lanes<16>>(records.at + 8, first, high_of(l.f0), high_of(l.f1));
}

inline void scatter_four(const LaneRecords<Lanes<16>, float>& records, std::size_t first, const FourLanes<Lanes<16>>& l)
{
    store_quads<Lanes<16>>(records.at, first, {low_of(l.f0), low_of(l.f1), low_of(l.f2), low_of(l.f3)});
    store_quads<Lanes<16>>(records.at + 8, first, {high_of(l.f0), high_of(l.f1), high_of(l.f2), high_of(l.f3)});
}

inline void scatter_eight(const LaneRecords<Lanes<16>, float>& records, std::size_t first, const EightLanes<Lanes<16>>& l)
{
    store_octet<Lanes<16>>(
        records.at, first,
        {low_of(l.f0), low_of(l.f1), low_of(l.f2), low_of(l.f3), low_of(l.f4), low_of(l.f5), low_of(l.f6), low_of(l.f7)});
    store_octet<Lanes<16>>(
        records.at + 8, first,
        {high_of(l.f0), high_of(l.f1), high_of(l.f2), high_of(l.f3), high_of(l.f4), high_of(l.f5), high_of(l.f6), high_of(l.f7)});
}

#endif

} // namespace carom::detail
