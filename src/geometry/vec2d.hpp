// Vectors in double precision, for work that must not lose digits: making shapes, and casting over long ways.
#pragma once

#include <carom/math.hpp>

namespace carom::detail
{

struct Vec2d
{
    double x = 0;
    double y = 0;

    constexpr Vec2d() = default;
    constexpr Vec2d(double x_, double y_) : x(x_), y(y_) {}
    constexpr explicit Vec2d(Vec2 v) : x(v.x), y(v.y) {}

    constexpr Vec2d& operator+=(Vec2d v) { return *this = {x + v.x, y + v.y}; }
};

constexpr Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2d operator-(Vec2d a) { return {-a.x, -a.y}; }
constexpr Vec2d operator*(double s, Vec2d a) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
/// w e_z x a.
constexpr Vec2d cross(double w, Vec2d a) { return {-w * a.y, w * a.x}; }
constexpr Vec2d right_perp(Vec2d a) { return {a.y, -a.x}; }
constexpr Vec2d rotated(Rot q, Vec2d v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
inline double length(Vec2d a) { return std::sqrt(dot(a, a)); }
/// @param a not (0, 0)
inline Vec2d unit(Vec2d a) { return (1 / length(a)) * a; }
constexpr Vec2 to_float(Vec2d a) { return {static_cast<float>(a.x), static_cast<float>(a.y)}; }

} // namespace carom::detail
