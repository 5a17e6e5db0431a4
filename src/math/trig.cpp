// The engine's own sine, cosine and arctangent. Library versions differ between systems in the last bits; these use only
// additions, multiplications, divisions and comparisons in a fixed order, so every IEEE machine computes the same bits.
//
// Everything runs in double precision: it costs the same per operation as float, the reduction of the angle needs no more than two
// parts of pi/2, and the final rounding to float hides the polynomials' errors (below 1e-10) almost everywhere.
#include <carom/math.hpp>

#include <array>
#include <bit>

namespace carom
{

namespace
{

/// An angle as `quarter` quarter turns and a rest in about [-pi/4, pi/4].
struct ReducedAngle
{
    int quarter; ///< only the last two bits count
    double rest; ///< [rad]
};

/// Above this, whole quarter turns are found in integers. Chosen so that the integer path never needs bits before the binary point
/// of 2/pi, and that below it the rounding of k pi/2 stays under 4e-9.
constexpr double largest_simple_angle = 33554432; // 2^25

/// Cody and Waite: pi/2 in two parts, the first so short that its products with small integers are exact.
ReducedAngle reduce_simple(double angle)
{
    constexpr double two_over_pi = 0.6366197723675814;
    constexpr double half_pi_high = 1.5707963267341256; // 33 bits
    constexpr double half_pi_low = 6.077100506506192e-11;
    const double turns = angle * two_over_pi;
    const int k = static_cast<int>(turns + (turns < 0 ? -0.5 : 0.5));
    return {k, (angle - k * half_pi_high) - k * half_pi_low};
}

/// Payne and Hanek: |angle| = m 2^e with an integer m < 2^24, and the quarter turns in it are m 2^e (2/pi) modulo 4. Bits of 2/pi that
/// are worth 4 or more after the product change nothing, so a window of 64 bits behind them is enough: the bits cut off at its
/// end are worth under 2^24 2^-62 quarter turns.
ReducedAngle reduce_large(float angle)
{
    constexpr std::array<std::uint32_t, 6> two_over_pi = {0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041};
    constexpr double quarter_per_unit = 3.4061215800865545e-19; // pi/2 2^-62

    const std::uint32_t bits = std::bit_cast<std::uint32_t>(angle);
    const std::uint64_t m = (bits & 0x7fffffu) | 0x800000u;
    const int e = static_cast<int>((bits >> 23) & 0xffu) - 150;

    const unsigned first_bit = static_cast<unsigned>(e - 2); // its product with m is worth 2 units of the lowest bit of m
    const unsigned word = first_bit / 32;
    const unsigned shift = first_bit % 32;
    const std::uint64_t high = (std::uint64_t{two_over_pi[word]} << 32) | two_over_pi[word + 1];
    const std::uint64_t low = two_over_pi[word + 2];
    const std::uint64_t window = shift == 0 ? high : (high << shift) | (low >> (32 - shift));

    const std::uint64_t turns = m * window; // two bits of quarter turns, 62 bits of fraction
    const std::uint64_t quarter = (turns + (std::uint64_t{1} << 61)) >> 62;
    const double rest = static_cast<double>(static_cast<std::int64_t>(turns - (quarter << 62))) * quarter_per_unit;
    const int k = static_cast<int>(quarter);
    return angle < 0 ? ReducedAngle{-k, -rest} : ReducedAngle{k, rest};
}

// Minimax polynomials by the algorithm of Remez, on [0, pi/4] and [0, tan(pi/8)].

/// Error under 5e-12 relative.
double sine_polynomial(double r)
{
    const double u = r * r;
    const double p = -0.16666666641626982 + u * (0.008333329385940958 + u * (-0.0001983933485235872 + u * 2.7183116453441974e-06));
    return r + r * (u * p);
}

/// Error under 1e-13.
double cosine_polynomial(double r)
{
    const double u = r * r;
    const double p = 0.041666666622828016 + u * (-0.001388888375341009 + u * (2.4799520009254082e-05 + u * -2.7210237827409537e-07));
    return (1 - 0.5 * u) + u * u * p;
}

/// Error under 3e-11 relative.
double arctangent_polynomial(double t)
{
    const double u = t * t;
    const double high = 0.11045093321038991 + u * (-0.08478404832147166 + u * 0.047482721406790294);
    const double p = -0.3333333251460258 + u * (0.19999905186321693 + u * (-0.14282042058432648 + u * high));
    return t + t * (u * p);
}

} // namespace

SinCos sin_cos(float angle)
{
    const double magnitude = angle < 0 ? -double{angle} : double{angle};
    if (!(magnitude <= largest_simple_angle) && !std::isfinite(angle))
    {
        const float not_a_number = angle - angle; // stays visible to whoever watches for states gone wrong
        return {not_a_number, not_a_number};
    }
    const ReducedAngle reduced = magnitude <= largest_simple_angle ? reduce_simple(angle) : reduce_large(angle);

    const double s = sine_polynomial(reduced.rest);
    const double c = cosine_polynomial(reduced.rest);
    const bool is_odd = (reduced.quarter & 1) != 0;
    const float sine = static_cast<float>(is_odd ? c : s);
    const float cosine = static_cast<float>(is_odd ? s : c);
    return {(reduced.quarter & 2) != 0 ? -sine : sine, ((reduced.quarter + 1) & 2) != 0 ? -cosine : cosine};
}

/// atan2 folds the plane into the first eighth turn, where the tangent t lies in [0, 1], and halves that once more:
///     atan(t) = pi/4 + atan((t - 1) / (t + 1)),
/// which takes (tan(pi/8), 1] to (-tan(pi/8), 0]. With t = smaller / larger one division serves both halves.
float atan2(float y, float x)
{
    constexpr double tan_eighth_pi = 0.41421356237309503;
    constexpr double quarter_pi = 0.7853981633974483;
    const double abs_x = x < 0 ? -double{x} : double{x};
    const double abs_y = y < 0 ? -double{y} : double{y};
    const bool is_steep = abs_x < abs_y;
    const double larger = is_steep ? abs_y : abs_x;
    const double smaller = is_steep ? abs_x : abs_y;
    if (larger == 0) return 0;

    const bool is_upper_half = smaller > tan_eighth_pi * larger;
    const double t = (is_upper_half ? smaller - larger : smaller) / (is_upper_half ? smaller + larger : larger);
    double result = arctangent_polynomial(t) + (is_upper_half ? quarter_pi : 0);
    if (is_steep) result = 2 * quarter_pi - result;
    if (x < 0) result = 4 * quarter_pi - result;
    if (y < 0) result = -result;
    return static_cast<float>(result);
}

} // namespace carom
