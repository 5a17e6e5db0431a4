// Random places that are tried against a grid of the shapes that are there.
#include "scenes/placement.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float wanted_cell_size = 3; // [m], about a shape's size, so that a shape reaches into few cells
constexpr int most_cells_a_side = 512;

int cell_count(float length, float cell_size) { return std::max(1, static_cast<int>(std::ceil(length / cell_size))); }

} // namespace

Placement::Placement(const Aabb& field) : field_(field)
{
    const Vec2 size = field.max - field.min;
    cell_size_ = std::max(wanted_cell_size, std::max(size.x, size.y) / most_cells_a_side);
    columns_ = cell_count(size.x, cell_size_);
    rows_ = cell_count(size.y, cell_size_);
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

std::optional<Vec2> Placement::find(const Geometry& shape, Random& random)
{
    Footprint footprint = footprint_of(shape);
    const Vec2 reach = footprint.half + Vec2{footprint.radius + gap, footprint.radius + gap};
    const Aabb room{field_.min + reach, field_.max - reach};
    if (room.min.x > room.max.x || room.min.y > room.max.y) return std::nullopt;
    for (int attempt = 0; attempt < most_tries; ++attempt)
    {
        footprint.center = random.point_in(room);
        if (!is_free(footprint)) continue;
        reserve(footprint);
        return footprint.center;
    }
    return std::nullopt;
}

Placement::Footprint Placement::footprint_of(const Geometry& shape)
{
    if (const auto* c = std::get_if<Circle>(&shape)) return {.center = {}, .half = {}, .radius = c->radius};
    return {.center = {}, .half = aabb_of(shape, {}).half_extent(), .radius = 0};
}

bool Placement::are_apart(const Footprint& a, const Footprint& b)
{
    const Vec2 offset = b.center - a.center;
    const Vec2 between_boxes{std::max(std::abs(offset.x) - a.half.x - b.half.x, 0.0f),
                             std::max(std::abs(offset.y) - a.half.y - b.half.y, 0.0f)};
    return length(between_boxes) > a.radius + b.radius + gap;
}

/// Visits the cells that a shape and the gap around it reach into, until a visit returns false.
template <class Visit>
bool Placement::all_cells(const Footprint& shape, const Visit& visit)
{
    const Vec2 reach = shape.half + Vec2{shape.radius + gap, shape.radius + gap};
    const Vec2 low = (shape.center - reach - field_.min) / cell_size_;
    const Vec2 high = (shape.center + reach - field_.min) / cell_size_;
    const int last_column = std::clamp(static_cast<int>(high.x), 0, columns_ - 1);
    const int last_row = std::clamp(static_cast<int>(high.y), 0, rows_ - 1);
    for (int row = std::clamp(static_cast<int>(low.y), 0, last_row); row <= last_row; ++row)
    {
        for (int column = std::clamp(static_cast<int>(low.x), 0, last_column); column <= last_column; ++column)
        {
            if (!visit(cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)]))
                return false;
        }
    }
    return true;
}

bool Placement::is_free(const Footprint& shape)
{
    const auto is_apart = [&](std::size_t other) { return are_apart(shape, placed_[other]); };
    return all_cells(shape, [&](const auto& cell) { return std::all_of(cell.begin(), cell.end(), is_apart); });
}

void Placement::reserve(const Footprint& shape)
{
    all_cells(shape, [&](auto& cell)
    {
        cell.push_back(placed_.size());
        return true;
    });
    placed_.push_back(shape);
}

} // namespace carom::scenes
