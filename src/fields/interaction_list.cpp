// Room for lists, and the bounds of what they sum.
#include "fields/interaction_list.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{

PullLimits pull_limits(float softening, std::size_t mass_count)
{
    constexpr float largest_float = std::numeric_limits<float>::max();
    // Up to 30 times the plain strength comes from a group that is as near as the largest opening angle allows, and more from a series.
    const float share = 1 / (1024 * static_cast<float>(mass_count + 1));
    return {std::min(softening * softening, largest_float / 4), largest_float * share};
}

Vec2 pull_of_one(const PointPull& body, Vec2 target, const PullLimits& limits)
{
    const Vec2 d = body.position - target;
    const Attraction<float> a = attraction(d.x, d.y, body.pull, limits);
    return a.counts ? Vec2{a.strength * a.n_x, a.strength * a.n_y} : Vec2{};
}

void InteractionList::reserve(std::size_t bodies, std::size_t groups)
{
    if (bodies_.x.size() < bodies + 2 * pull_parts) bodies_.resize(bodies + pull_parts);
    if (groups_.size() * pull_parts < groups) groups_.resize(2 * groups / pull_parts + 1);
}

PullList InteractionList::finished()
{
    while (body_count_ % pull_parts != 0) bodies_.set(body_count_++, {});
    while (group_count_ % pull_parts != 0) add(GroupMass{});
    return {bodies_.x.data(), bodies_.y.data(), bodies_.pull.data(), body_count_, groups_.data(), group_count_ / pull_parts};
}

} // namespace carom::detail
