// Walks around both shapes at once and takes the edges in the order of their directions.
// @source M. de Berg et al., "Computational Geometry", 2008, section 13.3
#include "geometry/minkowski.hpp"

namespace carom::detail
{

namespace
{

using Corners = std::array<Vec2d, max_polygon_vertices>;

/// The corner where edges begin to turn from direction 0: the lowest one, of several the leftmost.
int lowest(const Corners& corners, int count)
{
    int best = 0;
    for (int i = 1; i < count; ++i)
    {
        const Vec2d p = corners[static_cast<std::size_t>(i)];
        const Vec2d q = corners[static_cast<std::size_t>(best)];
        if (p.y < q.y || (p.y == q.y && p.x < q.x)) best = i;
    }
    return best;
}

/// Whether the direction is in [pi, 2 pi).
bool is_lower_half(Vec2d edge) { return edge.y < 0 || (edge.y == 0 && edge.x < 0); }

bool comes_first(Vec2d a, Vec2d b)
{
    const bool is_lower_a = is_lower_half(a);
    if (is_lower_a != is_lower_half(b)) return !is_lower_a;
    return cross(a, b) >= 0;
}

/// One of the two shapes on the way around.
class Walk
{
public:
    Walk(const Corners& corners, int count) : corners_(corners), count_(count), at_(lowest(corners, count)), left_(count > 1 ? count : 0) {}

    int index() const { return at_; }
    Vec2d position() const { return corners_[static_cast<std::size_t>(at_)]; }
    Vec2d edge() const { return corners_[static_cast<std::size_t>(next())] - position(); }
    bool is_done() const { return left_ == 0; }
    void advance()
    {
        at_ = next();
        --left_;
    }

private:
    int next() const { return at_ + 1 < count_ ? at_ + 1 : 0; }

    const Corners& corners_;
    int count_;
    int at_;
    int left_; ///< edges to come
};

} // namespace

MinkowskiHull minkowski_difference(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a)
{
    Corners corners_a;
    Corners corners_b; // of -B: turned by half a turn, and so still counter-clockwise
    for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) corners_a[i] = Vec2d(a.points[i]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(b.count); ++i)
        corners_b[i] = -(rotated(b_in_a.q, Vec2d(b.points[i])) + Vec2d(b_in_a.p));

    Walk walk_a(corners_a, a.count);
    Walk walk_b(corners_b, b.count);
    MinkowskiHull hull;
    do
    {
        hull.corners[static_cast<std::size_t>(hull.count++)] = {walk_a.position() + walk_b.position(), walk_a.index(), walk_b.index()};
        if (walk_a.is_done() && walk_b.is_done()) break; // two points
        const bool takes_a = walk_b.is_done() || (!walk_a.is_done() && comes_first(walk_a.edge(), walk_b.edge()));
        (takes_a ? walk_a : walk_b).advance();
    } while (!walk_a.is_done() || !walk_b.is_done());
    return hull;
}

MinkowskiHull minkowski_difference(const ConvexPoints& a, Vec2 point)
{
    MinkowskiHull hull;
    hull.count = a.count;
    for (int i = 0; i < a.count; ++i)
    {
        const auto place = static_cast<std::size_t>(i);
        hull.corners[place] = {Vec2d(a.points[place]) - Vec2d(point), i, 0};
    }
    return hull;
}

} // namespace carom::detail
