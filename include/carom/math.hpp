// Vectors, rotations, transforms and boxes of the plane, and the engine's own trigonometry.
// Everything here gives the same bits on every machine: no library trigonometry, no fused multiply-add.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace carom
{

inline constexpr float pi = 3.14159265358979323846f;

/// A vector or a point of the plane; the unit follows from the use, [m] unless said otherwise.
struct Vec2
{
    float x = 0;
    float y = 0;

    constexpr Vec2& operator+=(Vec2 v) { return *this = {x + v.x, y + v.y}; }
    constexpr Vec2& operator-=(Vec2 v) { return *this = {x - v.x, y - v.y}; }
    constexpr Vec2& operator*=(float s) { return *this = {x * s, y * s}; }
    friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator*(Vec2 a, float s) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator/(Vec2 a, float s) { return {a.x / s, a.y / s}; }

constexpr float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Third component of the product of two vectors that lie in the plane; positive when b is to the left of a.
constexpr float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// w e_z x a: the velocity of an arm `a` that turns with w [rad/s].
constexpr Vec2 cross(float w, Vec2 a) { return {-w * a.y, w * a.x}; }
/// a turned left by a quarter turn.
constexpr Vec2 left_perp(Vec2 a) { return {-a.y, a.x}; }
/// a turned right by a quarter turn.
constexpr Vec2 right_perp(Vec2 a) { return {a.y, -a.x}; }
constexpr float length_squared(Vec2 a) { return dot(a, a); }
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline float distance(Vec2 a, Vec2 b) { return length(b - a); }
constexpr Vec2 min(Vec2 a, Vec2 b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
constexpr Vec2 max(Vec2 a, Vec2 b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }
constexpr Vec2 lerp(Vec2 a, Vec2 b, float t) { return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y}; }
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

/// The unit vector along `a`, or (0, 0) when `a` is too short to have a direction.
inline Vec2 normalize(Vec2 a)
{
    const float l = length(a);
    return l > 1e-18f ? Vec2{a.x / l, a.y / l} : Vec2{};
}

/// The sine and the cosine of one angle.
struct SinCos
{
    float sin;
    float cos;
};

/// Sine and cosine, the same bits on every machine; error under 1e-6 up to |angle| = 8000 rad, slowly growing past it.
/// @param angle [rad], any finite value
SinCos sin_cos(float angle);

/// The angle of the vector (x, y) from the x axis, in [-pi, pi], the same bits on every machine; error under 1e-6.
/// atan2(0, 0) is 0.
float atan2(float y, float x);

/// A rotation, held as its cosine and sine. The default is no rotation.
struct Rot
{
    float c = 1;
    float s = 0;

    friend constexpr bool operator==(Rot, Rot) = default;
};

/// The rotation by an angle [rad], counter-clockwise.
inline Rot rotation(float angle)
{
    const SinCos v = sin_cos(angle);
    return {v.cos, v.sin};
}

/// The angle of a rotation, in [-pi, pi] [rad].
inline float angle(Rot q) { return atan2(q.s, q.c); }

constexpr Vec2 rotate(Rot q, Vec2 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
constexpr Vec2 inverse_rotate(Rot q, Vec2 v) { return {q.c * v.x + q.s * v.y, -q.s * v.x + q.c * v.y}; }
/// First `b`, then `a`.
constexpr Rot operator*(Rot a, Rot b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }
/// The rotation that takes `a` to `b`: a * relative(a, b) = b.
constexpr Rot relative(Rot a, Rot b) { return {a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c}; }
constexpr Rot inverse(Rot q) { return {q.c, -q.s}; }

inline Rot normalize(Rot q)
{
    const float l = std::sqrt(q.c * q.c + q.s * q.s);
    return l > 0 ? Rot{q.c / l, q.s / l} : Rot{};
}

/// A rigid motion: rotate, then translate. Takes points of a local frame to its parent's.
struct Transform
{
    Vec2 p; ///< [m]
    Rot q;

    friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

constexpr Vec2 operator*(const Transform& t, Vec2 point) { return rotate(t.q, point) + t.p; }
constexpr Vec2 inverse_transform(const Transform& t, Vec2 point) { return inverse_rotate(t.q, point - t.p); }
/// First `b`, then `a`.
constexpr Transform operator*(const Transform& a, const Transform& b) { return {a * b.p, a.q * b.q}; }
/// The frame of `b` seen from the frame of `a`: a * relative(a, b) = b.
constexpr Transform relative(const Transform& a, const Transform& b) { return {inverse_rotate(a.q, b.p - a.p), relative(a.q, b.q)}; }

/// A box along the axes. Empty when min exceeds max.
struct Aabb
{
    Vec2 min;
    Vec2 max;

    constexpr Vec2 center() const { return {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)}; }
    constexpr Vec2 half_extent() const { return {0.5f * (max.x - min.x), 0.5f * (max.y - min.y)}; }
    constexpr float perimeter() const { return 2 * ((max.x - min.x) + (max.y - min.y)); }
    friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

/// True when the boxes share at least a point; touching edges count.
constexpr bool overlaps(const Aabb& a, const Aabb& b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}
constexpr bool contains(const Aabb& outer, const Aabb& inner)
{
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && inner.max.x <= outer.max.x && inner.max.y <= outer.max.y;
}
constexpr bool contains(const Aabb& box, Vec2 p) { return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y; }
constexpr Aabb merge(const Aabb& a, const Aabb& b) { return {min(a.min, b.min), max(a.max, b.max)}; }
constexpr Aabb expanded(const Aabb& a, float margin)
{
    return {{a.min.x - margin, a.min.y - margin}, {a.max.x + margin, a.max.y + margin}};
}

} // namespace carom
