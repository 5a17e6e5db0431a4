// Vectors and rotations whose components are lanes, with the operations that row kernels use.
#pragma once

#include "math/lanes.hpp"

namespace carom::detail
{

template <class F>
struct LaneVec
{
    F x;
    F y;
};

template <class F>
struct LaneRot
{
    F c;
    F s;
};

template <class F>
LaneVec<F> operator+(const LaneVec<F>& a, const LaneVec<F>& b)
{
    return {a.x + b.x, a.y + b.y};
}
template <class F>
LaneVec<F> operator-(const LaneVec<F>& a, const LaneVec<F>& b)
{
    return {a.x - b.x, a.y - b.y};
}
template <class F>
LaneVec<F> operator*(const LaneVec<F>& a, const F& s)
{
    return {a.x * s, a.y * s};
}
/// Component by component: an inverse mass by axis times an impulse.
template <class F>
LaneVec<F> scale(const LaneVec<F>& a, const LaneVec<F>& b)
{
    return {a.x * b.x, a.y * b.y};
}
template <class F>
F dot(const LaneVec<F>& a, const LaneVec<F>& b)
{
    return a.x * b.x + a.y * b.y;
}
template <class F>
F cross(const LaneVec<F>& a, const LaneVec<F>& b)
{
    return a.x * b.y - a.y * b.x;
}
/// w e_z x a
template <class F>
LaneVec<F> cross(const F& w, const LaneVec<F>& a)
{
    return {-w * a.y, w * a.x};
}
template <class F>
LaneVec<F> left_perp(const LaneVec<F>& a)
{
    return {-a.y, a.x};
}
template <class F>
LaneVec<F> right_perp(const LaneVec<F>& a)
{
    return {a.y, -a.x};
}
template <class F>
LaneVec<F> rotate(const LaneRot<F>& q, const LaneVec<F>& v)
{
    return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
}
template <class F>
LaneVec<F> inverse_rotate(const LaneRot<F>& q, const LaneVec<F>& v)
{
    return {q.c * v.x + q.s * v.y, -q.s * v.x + q.c * v.y};
}
/// The rotation that takes `a` to `b`.
template <class F>
LaneRot<F> relative(const LaneRot<F>& a, const LaneRot<F>& b)
{
    return {a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c};
}
/// Lane by lane.
template <class F, class Mask>
LaneVec<F> select(const Mask& mask, const LaneVec<F>& yes, const LaneVec<F>& no)
{
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}

/// Writes one lane of a vector.
/// @param value of components x and y
template <class F, class Vector>
void set_lane(LaneVec<F>& v, int i, const Vector& value)
{
    lane(v.x, i) = value.x;
    lane(v.y, i) = value.y;
}

} // namespace carom::detail
