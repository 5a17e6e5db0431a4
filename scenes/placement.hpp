// Finds places for shapes in a field so that none of them overlap.
#pragma once

#include "scenes/random.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <optional>
#include <vector>

namespace carom::scenes
{

/// Random places, each tried against the shapes that lie near. Give large shapes first: they need the emptiest field.
/// Works on circles and boxes that are centred and not turned; of any other shape it takes the bounds.
class Placement
{
public:
    explicit Placement(const Aabb& field);

    /// Reserves a place for a shape, apart from all those before it.
    /// @return empty when none was found in `most_tries`
    std::optional<Vec2> find(const Geometry& shape, Random& random);
    static constexpr int most_tries = 2000;
    static constexpr float gap = 0.02f; ///< least distance between two shapes, and to the field's edge [m]

private:
    /// A box grown by a radius: circles have no box, boxes no radius. The distance of two is then one formula.
    struct Footprint
    {
        Vec2 center;
        Vec2 half;
        float radius = 0;
    };
    static Footprint footprint_of(const Geometry& shape);
    static bool are_apart(const Footprint& a, const Footprint& b);

    template <class Visit>
    bool all_cells(const Footprint& shape, const Visit& visit);
    bool is_free(const Footprint& shape);
    void reserve(const Footprint& shape);

    Aabb field_;
    float cell_size_;
    int columns_;
    int rows_;
    std::vector<Footprint> placed_;
    std::vector<std::vector<std::size_t>> cells_; ///< the shapes that reach into each cell of a grid over the field
};

} // namespace carom::scenes
