// Bodies gathered into wide lanes and scattered back by transposes.
#pragma once

#include "math/wide_records.hpp"
#include "solver/kernels/body_lanes.hpp"

namespace carom::detail
{

#if defined(__SSE2__) && !defined(__AVX2__)

inline BodyLanes<Lanes<4>> gather(const float* motions, const BodyIndices<Lanes<4>>& indices)
{
    const auto half = [&](std::size_t from) -> Quad<Lanes<4>>
    {
        const auto body = [&](std::size_t i) { return _mm_loadu_ps(motions + motion_floats * indices[i] + from); };
        return transposed<Lanes<4>>({body(0), body(1), body(2), body(3)});
    };
    const Quad<Lanes<4>> lower = half(0);
    const Quad<Lanes<4>> upper = half(4);
    return {{lower.x, lower.y}, lower.z, {lower.w, upper.x}, {upper.y, upper.z}};
}

inline BodyLanes<Lanes<4>> gather_velocities(const float* motions, const BodyIndices<Lanes<4>>& indices)
{
    const auto body = [&](std::size_t i) { return _mm_loadu_ps(motions + motion_floats * indices[i]); };
    const Quad<Lanes<4>> q = transposed<Lanes<4>>({body(0), body(1), body(2), body(3)});
    const Lanes<4> none(0.0f);
    return {{q.x, q.y}, q.z, {q.w, none}, {none, none}};
}

/// The way along x, which no kernel changes, is written back beside the velocities.
inline void scatter(float* motions, const BodyIndices<Lanes<4>>& indices, const BodyLanes<Lanes<4>>& lanes)
{
    const Quad<Lanes<4>> bodies = transposed<Lanes<4>>({lanes.v.x.v, lanes.v.y.v, lanes.w.v, lanes.dp.x.v});
    const auto store = [&](std::size_t i, __m128 body)
    {
        if (indices[i] != 0) _mm_storeu_ps(motions + motion_floats * indices[i], body);
    };
    store(0, bodies.x);
    store(1, bodies.y);
    store(2, bodies.z);
    store(3, bodies.w);
}

#endif

#if !defined(__SSE2__)

inline BodyLanes<Lanes<4>> gather(const float* motions, const BodyIndices<Lanes<4>>& indices)
{
    BodyLanes<Lanes<4>> lanes;
    for (int i = 0; i < 4; ++i)
    {
        const float* motion = motions + motion_floats * indices[static_cast<std::size_t>(i)];
        lanes.v.x.v[i] = motion[0];
        lanes.v.y.v[i] = motion[1];
        lanes.w.v[i] = motion[2];
        lanes.dp.x.v[i] = motion[3];
        lanes.dp.y.v[i] = motion[4];
        lanes.dq.c.v[i] = motion[5];
        lanes.dq.s.v[i] = motion[6];
    }
    return lanes;
}

#endif

#if defined(__AVX2__)

/// The first four floats of eight bodies.
template <class Tag>
EightQuads<Tag> gather_quads(const float* motions, const std::uint32_t* indices)
{
    const auto both = [&](std::size_t i)
    {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(motions + motion_floats * indices[i])),
                                    _mm_loadu_ps(motions + motion_floats * indices[i + 4]), 1);
    };
    return transposed_quads<Tag>({both(0), both(1), both(2), both(3)});
}

/// Writes the first four floats of eight bodies.
template <class Tag>
void scatter_octet(float* motions, const std::uint32_t* indices, __m256 v_x, __m256 v_y, __m256 w, __m256 dp_x)
{
    const EightQuads<Tag> rows = transposed_quads<Tag>({v_x, v_y, w, dp_x});
    const auto store = [&](std::size_t i, __m128 body)
    {
        if (indices[i] != 0) _mm_storeu_ps(motions + motion_floats * indices[i], body);
    };
    const auto store_both = [&](std::size_t i, __m256 bodies)
    {
        store(i, _mm256_castps256_ps128(bodies));
        store(i + 4, _mm256_extractf128_ps(bodies, 1));
    };
    store_both(0, rows.f0);
    store_both(1, rows.f1);
    store_both(2, rows.f2);
    store_both(3, rows.f3);
}

#if !defined(__AVX512F__)

inline BodyLanes<Lanes<8>> gather(const float* motions, const BodyIndices<Lanes<8>>& indices)
{
    const Octet<Lanes<8>> o = gather_octet<Lanes<8>>(motions, motion_floats, indices.at);
    return {{o.f0, o.f1}, o.f2, {o.f3, o.f4}, {o.f5, o.f6}};
}

inline BodyLanes<Lanes<8>> gather_velocities(const float* motions, const BodyIndices<Lanes<8>>& indices)
{
    const EightQuads<Lanes<8>> q = gather_quads<Lanes<8>>(motions, indices.at);
    const Lanes<8> none(0.0f);
    return {{q.f0, q.f1}, q.f2, {q.f3, none}, {none, none}};
}

inline void scatter(float* motions, const BodyIndices<Lanes<8>>& indices, const BodyLanes<Lanes<8>>& lanes)
{
    scatter_octet<Lanes<8>>(motions, indices.at, lanes.v.x.v, lanes.v.y.v, lanes.w.v, lanes.dp.x.v);
}

#endif
#endif

#if defined(__AVX512F__)

inline BodyLanes<Lanes<16>> gather(const float* motions, const BodyIndices<Lanes<16>>& indices)
{
    const Octet<Lanes<16>> l = gather_octet<Lanes<16>>(motions, motion_floats, indices.at);
    const Octet<Lanes<16>> r = gather_octet<Lanes<16>>(motions, motion_floats, indices.at + 8);
    const auto both = [](__m256 low, __m256 high) { return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1); };
    return {
        {both(l.f0, r.f0), both(l.f1, r.f1)}, both(l.f2, r.f2), {both(l.f3, r.f3), both(l.f4, r.f4)}, {both(l.f5, r.f5), both(l.f6, r.f6)}};
}

inline BodyLanes<Lanes<16>> gather_velocities(const float* motions, const BodyIndices<Lanes<16>>& indices)
{
    const EightQuads<Lanes<16>> l = gather_quads<Lanes<16>>(motions, indices.at);
    const EightQuads<Lanes<16>> r = gather_quads<Lanes<16>>(motions, indices.at + 8);
    const Lanes<16> none(0.0f);
    return {{joined(l.f0, r.f0), joined(l.f1, r.f1)}, joined(l.f2, r.f2), {joined(l.f3, r.f3), none}, {none, none}};
}

inline void scatter(float* motions, const BodyIndices<Lanes<16>>& indices, const BodyLanes<Lanes<16>>& lanes)
{
    const auto low = [](__m512 v) { return _mm512_castps512_ps256(v); };
    const auto high = [](__m512 v) { return _mm512_extractf32x8_ps(v, 1); };
    scatter_octet<Lanes<16>>(motions, indices.at, low(lanes.v.x.v), low(lanes.v.y.v), low(lanes.w.v), low(lanes.dp.x.v));
    scatter_octet<Lanes<16>>(motions, indices.at + 8, high(lanes.v.x.v), high(lanes.v.y.v), high(lanes.w.v), high(lanes.dp.x.v));
}

#endif

} // namespace carom::detail
