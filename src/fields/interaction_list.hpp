// Masses that act on a few points near each other, and the sum of their pulls: the inner loop of every N-body method.
#pragma once

#include "math/float4.hpp"

#include <carom/math.hpp>

#include <cstddef>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// One body.
struct PointPull
{
    Vec2 position; ///< [m]
    float pull;    ///< gravitational constant times mass [m^3/s^2]
};

/// Many bodies near each other, seen from afar.
struct GroupMass
{
    Vec2 center; ///< of mass [m]
    Vec2 rest;   ///< what float leaves over: the centre of bodies a million metres from the origin lies between the places it can name
    float pull;  ///< of all [m^3/s^2]
    float spread_xx, spread_xy, spread_yy; ///< mean of (offset from the centre) x (offset from the centre), weighed by pull [m^2]
};

/// What bounds a pull.
struct PullLimits
{
    float softening_squared; ///< [m^2]
    float largest;           ///< of one mass [m/s^2]: so many times below the largest float as there are masses, so no sum overflows
};

PullLimits pull_limits(float softening, std::size_t mass_count);

/// Pull of a single body.
Vec2 pull_of_one(const PointPull& body, Vec2 target, const PullLimits& limits);

/// Bodies and groups in blocks of four, so that four pulls are computed at once.
class InteractionList
{
public:
    explicit InteractionList(std::pmr::memory_resource& memory) : bodies_(&memory), groups_(&memory) {}

    /// Makes room for so many bodies and groups together.
    void reserve(std::size_t count);
    void clear() { body_count_ = group_count_ = 0; }

    void add(const PointPull& body) { bodies_[body_count_ / 4].set(body_count_ % 4, body), ++body_count_; }
    void add(const GroupMass& group) { groups_[group_count_ / 4].set(group_count_ % 4, group), ++group_count_; }
    /// Fills the last blocks with masses that pull nothing. After the last add, before pull_at.
    void finish();

    /// Sum of the pulls, pull d / (|d|^2 + softening^2)^(3/2) for a body.
    Vec2 pull_at(Vec2 target, const PullLimits& limits) const;

    struct alignas(16) BodyBlock
    {
        float x[4], y[4], pull[4];

        void set(std::size_t lane, const PointPull& body)
        {
            x[lane] = body.position.x;
            y[lane] = body.position.y;
            pull[lane] = body.pull;
        }
    };

    struct alignas(16) GroupBlock
    {
        float x[4], y[4], rest_x[4], rest_y[4], pull[4];
        float spread_xx[4], spread_xy[4], spread_yy[4];

        void set(std::size_t lane, const GroupMass& group)
        {
            x[lane] = group.center.x;
            y[lane] = group.center.y;
            rest_x[lane] = group.rest.x;
            rest_y[lane] = group.rest.y;
            pull[lane] = group.pull;
            spread_xx[lane] = group.spread_xx;
            spread_xy[lane] = group.spread_xy;
            spread_yy[lane] = group.spread_yy;
        }
    };

private:
    std::pmr::vector<BodyBlock> bodies_;
    std::pmr::vector<GroupBlock> groups_;
    std::size_t body_count_ = 0;
    std::size_t group_count_ = 0;
};

} // namespace carom::detail
