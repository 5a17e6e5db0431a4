// Masses that act on a few points near each other, in the blocks that the pull kernels sum.
#pragma once

#include "fields/isa/pull_passes.hpp"

#include <carom/math.hpp>

#include <cstddef>
#include <cstring>
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
    float spread_xx, spread_xy, spread_yy;        ///< means of products of two offsets from the centre, weighed by pull [m^2]
    float skew_xxx, skew_xxy, skew_xyy, skew_yyy; ///< of three [m^3]
};

PullLimits pull_limits(float softening, std::size_t mass_count);

/// Pull of a single body.
Vec2 pull_of_one(const PointPull& body, Vec2 target, const PullLimits& limits);

/// Bodies by component, with room behind the last one for what a copy of eight writes too much.
struct BodyArrays
{
    explicit BodyArrays(std::pmr::memory_resource& memory) : x(&memory), y(&memory), pull(&memory) {}

    void resize(std::size_t count)
    {
        for (std::pmr::vector<float>* const component : {&x, &y, &pull}) component->resize(count + pull_parts);
    }
    void set(std::size_t at, const PointPull& body)
    {
        x[at] = body.position.x;
        y[at] = body.position.y;
        pull[at] = body.pull;
    }

    std::pmr::vector<float> x, y, pull;
};

class InteractionList
{
public:
    explicit InteractionList(std::pmr::memory_resource& memory) : bodies_(memory), groups_(&memory) {}

    /// Makes room for so many bodies, and for so many groups.
    void reserve(std::size_t bodies, std::size_t groups);
    void clear() { body_count_ = group_count_ = 0; }

    void add(const PointPull& body) { bodies_.set(body_count_++, body); }
    /// Adds the bodies from begin to before end.
    void add(const BodyArrays& from, std::size_t begin, std::size_t end)
    {
        for (std::size_t i = begin; i < end; i += pull_parts)
        {
            const std::size_t at = body_count_ + i - begin;
            std::memcpy(bodies_.x.data() + at, from.x.data() + i, pull_parts * sizeof(float));
            std::memcpy(bodies_.y.data() + at, from.y.data() + i, pull_parts * sizeof(float));
            std::memcpy(bodies_.pull.data() + at, from.pull.data() + i, pull_parts * sizeof(float));
        }
        body_count_ += end - begin;
    }
    void add(const GroupMass& group)
    {
        GroupBlock& block = groups_[group_count_ / pull_parts];
        const std::size_t at = group_count_++ % pull_parts;
        block.x[at] = group.center.x;
        block.y[at] = group.center.y;
        block.rest_x[at] = group.rest.x;
        block.rest_y[at] = group.rest.y;
        block.pull[at] = group.pull;
        block.spread_xx[at] = group.spread_xx;
        block.spread_xy[at] = group.spread_xy;
        block.spread_yy[at] = group.spread_yy;
        block.skew_xxx[at] = group.skew_xxx;
        block.skew_xxy[at] = group.skew_xxy;
        block.skew_xyy[at] = group.skew_xyy;
        block.skew_yyy[at] = group.skew_yyy;
    }

    /// Fills up with masses that pull nothing. Valid until the next change.
    PullList finished();

private:
    BodyArrays bodies_;
    std::pmr::vector<GroupBlock> groups_;
    std::size_t body_count_ = 0;
    std::size_t group_count_ = 0;
};

} // namespace carom::detail
