// Makes series, and moves them from a node to its children.
#include "fields/local_series.hpp"

#include <algorithm>

namespace carom::detail
{
namespace
{

template <int Count>
void take_scaled(float (&to)[Count], const float (&from)[Count], float factor)
{
    for (int i = 0; i < Count; ++i) to[i] = from[i] * factor;
}

} // namespace

LocalPull series_around(const Aabb& box)
{
    const Vec2 center = 0.5f * box.min + 0.5f * box.max;
    return {center.x, center.y, std::max(0.5f * box.max.x - 0.5f * box.min.x, 0.5f * box.max.y - 0.5f * box.min.y), {}};
}

void inherit(LocalPull& child, const LocalPull& parent)
{
    if (!(parent.radius > 0)) return; // a node of one place has no children
    const float t_x = (child.x - parent.x) / parent.radius;
    const float t_y = (child.y - parent.y) / parent.radius;
    const float scale = child.radius / parent.radius;
    PullSeries<float> moved = parent.terms;
    for (int last = 0; last < 5; ++last) add_higher_orders(moved, t_x, t_y, last);
    float factor = 1;
    take_scaled(child.terms.value, moved.value, factor);
    take_scaled(child.terms.first, moved.first, factor *= scale);
    take_scaled(child.terms.second, moved.second, factor *= scale);
    take_scaled(child.terms.third, moved.third, factor *= scale);
    take_scaled(child.terms.fourth, moved.fourth, factor *= scale);
    take_scaled(child.terms.fifth, moved.fifth, factor *= scale);
}

} // namespace carom::detail
