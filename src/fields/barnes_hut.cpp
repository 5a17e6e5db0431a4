// Centres of mass from the leaves up, then a walk down both trees.
#include "fields/barnes_hut.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{
namespace
{

/// Smaller buckets make longer walks through more nodes, larger ones longer lists. Timed with 100,000 bodies around a sun.
constexpr std::uint32_t source_bucket = 12;
constexpr std::uint32_t target_bucket = 24;
/// Of the opening angle what the side of sources and that of targets may take up of their distance in a series. Chosen so that every
/// cloud of gravity_test gets accelerations at least as exact as when each group near or far is summed for each target: at an opening angle of 0.5,
/// evenly spread bodies err by 0.13% in place of 0.18%, clustered ones by 0.02% in place of 0.1%.
constexpr float series_share = 0.8f;
/// Beyond this a series converges slowly.
constexpr float largest_series_angle = 0.6f;
/// Squares of lengths stay finite below this [m^2], with that of the softening.
constexpr float farthest_squared = std::numeric_limits<float>::max() / 8;
/// Entries of open_ for each node of sources: several times what bodies spread evenly need.
constexpr std::size_t open_room = 4;

/// Room for so many, and twice that where it has to grow, so that it rarely does.
template <class T>
void make_room_for(std::pmr::vector<T>& list, std::size_t count)
{
    if (list.capacity() < count) list.reserve(2 * count);
}

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
                    std::span<const Vec2> targets, std::span<Vec2> acceleration, const PullPasses& passes, bool are_as_before)
{
    update(source_tree_, positions, source_bucket, are_as_before);
    update(target_tree_, targets, target_bucket, are_as_before);
    sum_groups(positions, pull);
    const std::size_t nodes = masses_.size();
    near_.reserve(positions.size(), nodes);
    make_room_for(open_, open_room * nodes);
    for (std::pmr::vector<std::uint32_t>* const list : {&queue_, &rest_, &far_}) make_room_for(*list, nodes);
    targets_.resize(targets.size());
    pulls_.resize(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) targets_[i] = targets[target_tree_.point_at(i)];

    const float series_angle = std::min(series_share * opening_angle, largest_series_angle);
    const Walk walk{opening_angle * opening_angle, series_angle * series_angle, pull_limits(softening, positions.size()), passes};
    open_.assign(1, 0);
    visit(walk, 0, 0, 1, {});
    for (std::size_t i = 0; i < targets.size(); ++i) acceleration[target_tree_.point_at(i)] += pulls_[i];
}

void BarnesHut::update(PointTree& tree, std::span<const Vec2> points, std::uint32_t bucket_size, bool is_kept)
{
    if (is_kept)
        tree.refit(points);
    else
        tree.build(points, bucket_size);
}

/// Adds up the parts that for_each_part calls its argument with: first the centre, then the moments about it. In double, because offsets
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
        sum.xxx += part.xxx + x * (3 * part.xx + part.pull * x * x);
        sum.xxy += part.xxy + 2 * x * part.xy + y * (part.xx + part.pull * x * x);
        sum.xyy += part.xyy + 2 * y * part.xy + x * (part.yy + part.pull * y * y);
        sum.yyy += part.yyy + y * (3 * part.yy + part.pull * y * y);
    });
    return sum;
}

void BarnesHut::sum_groups(std::span<const Vec2> positions, std::span<const float> pull)
{
    sources_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        const std::uint32_t source = source_tree_.point_at(i);
        sources_.set(i, {positions[source], pull[source]});
    }
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    make_room_for(masses_, nodes.size());
    make_room_for(extents_, nodes.size());
    make_room_for(moments_, nodes.size());
    masses_.resize(nodes.size());
    extents_.resize(nodes.size());
    moments_.resize(nodes.size());
    for (std::size_t n = nodes.size(); n-- > 0;) // descendants first
    {
        const auto for_each_source = [&](auto add)
        {
            for (std::uint32_t i = nodes[n].begin; i < nodes[n].end; ++i) add(Moments{sources_.pull[i], sources_.x[i], sources_.y[i]});
        };
        const auto for_each_child = [&](auto add)
        {
            for (std::size_t child = n + 1; child < nodes[n].next; child = nodes[child].next) add(moments_[child]);
        };
        const Moments m = nodes[n].is_leaf ? moments_of(for_each_source) : moments_of(for_each_child);
        moments_[n] = m;
        masses_[n] = mass_of(m);
        extents_[n] = {masses_[n].center, longer_side(nodes[n].bounds)};
    }
}

GroupMass BarnesHut::mass_of(const Moments& m)
{
    const Vec2 center{to_float(m.x), to_float(m.y)};
    const Vec2 rest{to_float(m.x - static_cast<double>(center.x)), to_float(m.y - static_cast<double>(center.y))};
    const auto mean = [&m](double sum) { return to_float(sum / m.pull); };
    return {center, rest, to_float(m.pull), mean(m.xx), mean(m.xy), mean(m.yy), mean(m.xxx), mean(m.xxy), mean(m.xyy), mean(m.yyy)};
}

/// Adds what acts on a node of targets and its descendants. Recursion is as deep as the tree: see PointTree::add_node.
/// @param begin, end of open_: the sources that are near its parent
void BarnesHut::visit(const Walk& walk, std::uint32_t target, std::size_t begin, std::size_t end, const LocalPull& inherited)
{
    const PointTree::Node& node = target_tree_.nodes()[target];
    LocalPull around = series_around(node.bounds);
    inherit(around, inherited);
    near_.clear();
    far_.clear();
    queue_.assign(open_.begin() + static_cast<std::ptrdiff_t>(begin), open_.begin() + static_cast<std::ptrdiff_t>(end));
    while (!queue_.empty())
    {
        take_far(walk, around, longer_side(node.bounds));
        if (node.is_leaf)
            take_near(walk, node.bounds);
        else
            leave_small(longer_side(node.bounds));
    }
    if (!far_.empty()) walk.passes.expand(&masses_[0].center.x, far_.data(), far_.size(), walk.limits, around);
    if (node.is_leaf)
        sum_bucket(walk, node, around);
    else
    {
        const std::size_t left = open_.size();
        for (std::uint32_t child = target + 1; child < node.next; child = target_tree_.nodes()[child].next)
        {
            visit(walk, child, end, left, around);
            open_.resize(left);
        }
    }
}

/// Moves those of queue_ that are far from a node of targets to far_, and the others to rest_. Both are written to in any case, because a
/// processor can't foretell which it is.
void BarnesHut::take_far(const Walk& walk, const LocalPull& around, float side)
{
    std::size_t rest_count = 0;
    std::size_t far_count = far_.size();
    rest_.resize(queue_.size());
    far_.resize(far_count + queue_.size());
    std::uint32_t* const rest = rest_.data();
    std::uint32_t* const far = far_.data();
    for (const std::uint32_t n : queue_)
    {
        const Extent& extent = extents_[n];
        const Vec2 way = extent.center - Vec2{around.x, around.y};
        const float way_squared = way.x * way.x + way.y * way.y;
        const float longer = std::max(extent.side, side);
        const bool is_far = (longer * longer < walk.series_angle_squared * way_squared) & (way_squared < farthest_squared);
        far[far_count] = rest[rest_count] = n;
        far_count += is_far;
        rest_count += !is_far;
    }
    far_.resize(far_count);
    rest_.resize(rest_count);
    queue_.clear();
}

/// Of rest_, bodies and groups that are far for their own size from each target of a bucket go to near_, and the children of others to queue_.
void BarnesHut::take_near(const Walk& walk, const Aabb& targets)
{
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    for (const std::uint32_t n : rest_)
    {
        const PointTree::Node& node = nodes[n];
        const Extent& extent = extents_[n];
        if (node.is_leaf)
        {
            near_.add(sources_, node.begin, node.end);
            continue;
        }
        const bool is_far = extent.side * extent.side < walk.angle_squared * distance_squared(targets, extent.center);
        if (is_far && !overlaps(node.bounds, targets))
            near_.add(masses_[n]);
        else
            add_children(n);
    }
}

/// Of rest_, those that are smaller than a node of targets are left to its children, and the children of others go to queue_.
void BarnesHut::leave_small(float side)
{
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    for (const std::uint32_t n : rest_)
    {
        if (nodes[n].is_leaf || extents_[n].side < side)
            open_.push_back(n);
        else
            add_children(n);
    }
}

void BarnesHut::add_children(std::uint32_t source)
{
    const std::span<const PointTree::Node> nodes = source_tree_.nodes();
    for (std::uint32_t child = source + 1; child < nodes[source].next; child = nodes[child].next) queue_.push_back(child);
}

void BarnesHut::sum_bucket(const Walk& walk, const PointTree::Node& bucket, const LocalPull& around)
{
    walk.passes.sum(near_.finished(), around, &targets_[bucket.begin].x, bucket.end - bucket.begin, walk.limits, &pulls_[bucket.begin].x);
}

} // namespace carom::detail
