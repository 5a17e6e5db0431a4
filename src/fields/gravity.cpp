// The pull of a fixed point, and of bodies on each other by the method asked for.
#include "fields/gravity.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{
namespace
{

constexpr float largest_pull = std::numeric_limits<float>::max();

} // namespace

void add_point_field(const PointField& field, std::span<const Vec2> targets, std::span<Vec2> acceleration)
{
    const PointPull center{field.center, field.strength};
    const PullLimits limits = pull_limits(field.softening, 1);
    for (std::size_t i = 0; i < targets.size(); ++i) acceleration[i] += pull_of_one(center, targets[i], limits);
}

NBodySolver::NBodySolver(std::pmr::memory_resource& memory)
    : positions_(&memory),
      pull_(&memory),
      pulls_(&memory),
      all_(memory),
      barnes_hut_(memory)
{
}

void NBodySolver::add(const NBodyField& field, const PointMasses& sources, std::span<const Vec2> targets, std::span<Vec2> acceleration,
                      const PullPasses& passes, bool are_as_before)
{
    gather(field.gravitational_constant, sources);
    if (positions_.empty() || targets.empty()) return;
    if (field.method == NBodyMethod::BarnesHut)
        barnes_hut_.add(positions_, pull_, field.softening, field.opening_angle, targets, acceleration, passes, are_as_before);
    else
        add_direct(field.softening, targets, acceleration, passes);
}

/// Keeps the sources that pull.
void NBodySolver::gather(float gravitational_constant, const PointMasses& sources)
{
    positions_.clear();
    pull_.clear();
    for (std::size_t i = 0; i < sources.position.size(); ++i)
    {
        const float pull = std::clamp(gravitational_constant * sources.mass[i], -largest_pull, largest_pull);
        if (!(sources.mass[i] > 0) || pull == 0) continue;
        positions_.push_back(sources.position[i]);
        pull_.push_back(pull);
    }
}

/// Every source at every target. The list of 10,000 sources fits into the second-level cache and the sum is bound by its square root
/// and division, so there is nothing to gain from tiles.
void NBodySolver::add_direct(float softening, std::span<const Vec2> targets, std::span<Vec2> acceleration, const PullPasses& passes)
{
    all_.clear();
    all_.reserve(positions_.size(), 0);
    for (std::size_t i = 0; i < positions_.size(); ++i) all_.add(PointPull{positions_[i], pull_[i]});
    pulls_.resize(targets.size());
    passes.sum(all_.finished(), {}, &targets[0].x, targets.size(), pull_limits(softening, positions_.size()), &pulls_[0].x);
    for (std::size_t i = 0; i < targets.size(); ++i) acceleration[i] += pulls_[i];
}

} // namespace carom::detail
