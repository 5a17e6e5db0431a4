// Centres of mass from the leaves up, then one walk for each bucket of targets.
#include "fields/barnes_hut.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{
namespace
{

/// Smaller buckets make longer walks through more nodes, larger ones longer lists. Timed with 10,000 bodies, even and clustered.
constexpr std::uint32_t source_bucket = 16;
constexpr std::uint32_t target_bucket = 32;

/// The nearest finite float.
float to_float(double v)
{
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(v, -largest, largest));
}

float longer_side(const Aabb& box)
{
    return std::max(box.max.x - box.min.x, box.max.y - box.min.y); // infinity is right here: never seen as one mass
}

float distance_squared(const Aabb& box, Vec2 p)
{
    const float d_x = std::max({box.min.x - p.x, p.x - box.max.x, 0.0f});
    const float d_y = std::max({box.min.y - p.y, p.y - box.max.y, 0.0f});
    return d_x * d_x + d_y * d_y;
}

} // namespace

void BarnesHut::add(std::span<const Vec2> positions, std::span<const float> pull, float softening, float opening_angle,
                    std::span<const Vec2> targets, std::span<Vec2> acceleration)
{
    source_tree_.build(positions, source_bucket);
    target_tree_.build(targets, target_bucket);
    sum_groups(positions, pull);
    list_.reserve(positions.size()); // a group stands for one source at least
    const PullLimits limits = pull_limits(softening, positions.size());
    for (const PointTree::Node& bucket : target_tree_.nodes())
    {
        if (!bucket.is_leaf) continue;
        list_masses(bucket.bounds, opening_angle);
        for (std::uint32_t i = bucket.begin; i < bucket.end; ++i)
        {
            const std::uint32_t target = target_tree_.point_at(i);
            acceleration[target] += list_.pull_at(targets[target], limits);
        }
    }
}

/// Adds up the parts that for_each_part calls its argument with: first the centre, then the spread about it. In double, because offsets
/// are small differences of coordinates.
template <class ForEachPart>
BarnesHut::Moments BarnesHut::moments_of(ForEachPart for_each_part)
{
    Moments sum;
    for_each_part([&sum](const Moments& part)
    {
        sum.pull += part.pull;
        sum.x += part.pull * part.x;
        sum.y += part.pull * part.y;
    });
    sum.x /= sum.pull;
    sum.y /= sum.pull;
    for_each_part([&sum](const Moments& part)
    {
        const double x = part.x - sum.x;
        const double y = part.y - sum.y;
        sum.xx += part.xx + part.pull * x * x;
        sum.xy += part.xy + part.pull * x * y;
        sum.yy += part.yy + part.pull * y * y;
    });
    return sum;
}

void BarnesHut::sum_groups(std::span<const Vec2> positions, std::span<const float> pull)
{
    sources_.clear();
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        const std::uint32_t source = source_tree_.point_at(i);
        sources_.push_back({positions[source], pull[source]});
    }
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    groups_.resize(nodes.size());
    moments_.resize(nodes.size());
    for (std::size_t n = nodes.size(); n-- > 0;) // descendants first
    {
        const auto for_each_source = [&](auto add)
        {
            for (std::uint32_t i = nodes[n].begin; i < nodes[n].end; ++i)
                add(Moments{sources_[i].pull, sources_[i].position.x, sources_[i].position.y});
        };
        const auto for_each_child = [&](auto add)
        {
            for (std::size_t child = n + 1; child < nodes[n].next; child = nodes[child].next) add(moments_[child]);
        };
        const Moments m = nodes[n].is_leaf ? moments_of(for_each_source) : moments_of(for_each_child);
        moments_[n] = m;
        groups_[n] = {mass_of(m), longer_side(nodes[n].bounds)};
    }
}

GroupMass BarnesHut::mass_of(const Moments& m)
{
    const Vec2 center{to_float(m.x), to_float(m.y)};
    const Vec2 rest{to_float(m.x - static_cast<double>(center.x)), to_float(m.y - static_cast<double>(center.y))};
    return {center, rest, to_float(m.pull), to_float(m.xx / m.pull), to_float(m.xy / m.pull), to_float(m.yy / m.pull)};
}

/// Collects what acts on targets within a box.
void BarnesHut::list_masses(const Aabb& targets, float opening_angle)
{
    list_.clear();
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    const float angle_squared = opening_angle * opening_angle;
    for (std::uint32_t n = 0; n < nodes.size();)
    {
        const Group& group = groups_[n];
        const bool is_far = group.side * group.side < angle_squared * distance_squared(targets, group.mass.center);
        if (is_far && !overlaps(nodes[n].bounds, targets))
        {
            list_.add(group.mass);
            n = nodes[n].next;
            continue;
        }
        if (nodes[n].is_leaf)
            for (std::uint32_t i = nodes[n].begin; i < nodes[n].end; ++i) list_.add(sources_[i]);
        ++n; // past a leaf, or to the first child
    }
    list_.finish();
}

} // namespace carom::detail
