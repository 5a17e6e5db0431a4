// The pull kernels: of bodies, and of groups to the second moment.
#include "fields/interaction_list.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{
namespace
{

constexpr float largest_float = std::numeric_limits<float>::max();

struct Pull4
{
    Float4 x = {};
    Float4 y = {};
};

Float4 clamp4(Float4 v, float limit)
{
    const Float4 high = splat4(limit);
    const Float4 below = v < high ? v : high;
    return below > -high ? below : -high;
}

/// Four masses at d from the target; with s = sqrt(|d|^2 + softening^2) each gives (pull / s / s) (d / s). In this order nothing but the
/// clamped factor can overflow, even where s^2 is the smallest float.
struct Attraction4
{
    Float4 inverse_s;
    Float4 n_x; ///< d / s
    Float4 n_y;
    Float4 strength;
    Int4 counts; ///< not at distance 0 (a body and itself), nor so far away that s^2 is no finite float

    Attraction4(Float4 d_x, Float4 d_y, Float4 pull, const PullLimits& limits)
    {
        const Float4 s_squared = d_x * d_x + d_y * d_y + limits.softening_squared;
        counts = (s_squared > splat4(0)) & (s_squared <= splat4(largest_float));
        inverse_s = splat4(1) / sqrt4(s_squared);
        n_x = d_x * inverse_s;
        n_y = d_y * inverse_s;
        strength = clamp4(pull * inverse_s * inverse_s, limits.largest);
    }
};

void add_pull(Pull4& sum, const InteractionList::BodyBlock& b, Vec2 target, const PullLimits& limits)
{
    const Attraction4 a(load4(b.x) - target.x, load4(b.y) - target.y, load4(b.pull), limits);
    sum.x += zero_unless(a.counts, a.strength * a.n_x);
    sum.y += zero_unless(a.counts, a.strength * a.n_y);
}

/// The mean of g(d + e) = (d + e) / s^3 over the offsets e of the group's bodies, to second order. The first order is zero, because
/// offsets are from the centre of mass. With Q = mean(e e^T), `spread`, and n = d / s:
///
///     d_j d_k g_i = -3 (delta_ij d_k + delta_ik d_j + delta_jk d_i) / s^5 + 15 d_i d_j d_k / s^7
///     1/2 Q_jk d_j d_k g = (1 / s^2) (n (7.5 n.Qn - 1.5 tr Q) - 3 Qn) / s^2
///
/// Without it an opening angle of 0.5 errs by 4% of a body's acceleration (root mean square over 10,000 bodies spread evenly), with it
/// by under 1%; to get there by the angle alone takes twice the time.
void add_pull(Pull4& sum, const InteractionList::GroupBlock& b, Vec2 target, const PullLimits& limits)
{
    const Attraction4 a(load4(b.x) - target.x + load4(b.rest_x), load4(b.y) - target.y + load4(b.rest_y), load4(b.pull), limits);
    const Float4 q_xx = load4(b.spread_xx) * a.inverse_s * a.inverse_s;
    const Float4 q_xy = load4(b.spread_xy) * a.inverse_s * a.inverse_s;
    const Float4 q_yy = load4(b.spread_yy) * a.inverse_s * a.inverse_s;
    const Float4 qn_x = q_xx * a.n_x + q_xy * a.n_y;
    const Float4 qn_y = q_xy * a.n_x + q_yy * a.n_y;
    const Float4 along = 1.0f + 7.5f * (a.n_x * qn_x + a.n_y * qn_y) - 1.5f * (q_xx + q_yy);
    sum.x += zero_unless(a.counts, a.strength * (a.n_x * along - 3.0f * qn_x));
    sum.y += zero_unless(a.counts, a.strength * (a.n_y * along - 3.0f * qn_y));
}

/// Always in this order, so that the bits are the same everywhere.
Vec2 sum_of_lanes(const Pull4& sum)
{
    return {(sum.x[0] + sum.x[1]) + (sum.x[2] + sum.x[3]), (sum.y[0] + sum.y[1]) + (sum.y[2] + sum.y[3])};
}

} // namespace

PullLimits pull_limits(float softening, std::size_t mass_count)
{
    // Up to 30 times the plain strength comes from a group that is as near as the largest opening angle allows.
    const float share = 1 / (64 * static_cast<float>(mass_count + 1));
    return {std::min(softening * softening, largest_float / 4), largest_float * share};
}

Vec2 pull_of_one(const PointPull& body, Vec2 target, const PullLimits& limits)
{
    InteractionList::BodyBlock block = {};
    block.set(0, body);
    Pull4 sum;
    add_pull(sum, block, target, limits);
    return sum_of_lanes(sum);
}

void InteractionList::reserve(std::size_t count)
{
    const std::size_t blocks = count / 4 + 1;
    if (bodies_.size() < blocks) bodies_.resize(blocks);
    if (groups_.size() < blocks) groups_.resize(blocks);
}

void InteractionList::finish()
{
    while (body_count_ % 4 != 0) add(PointPull{});
    while (group_count_ % 4 != 0) add(GroupMass{});
}

Vec2 InteractionList::pull_at(Vec2 target, const PullLimits& limits) const
{
    Pull4 sum;
    for (std::size_t i = 0; i < body_count_ / 4; ++i) add_pull(sum, bodies_[i], target, limits);
    for (std::size_t i = 0; i < group_count_ / 4; ++i) add_pull(sum, groups_[i], target, limits);
    return sum_of_lanes(sum);
}

} // namespace carom::detail
