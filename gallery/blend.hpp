// A picture between two steps, so that motion is smooth whatever the rates of steps and frames.
#pragma once

#include "scenes/draw_list.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace carom::gallery
{

/// Where the things of a picture were: what blending needs of it, a tenth of its memory.
class Places
{
public:
    void note(const scenes::DrawList& list);

    struct ShapePlace
    {
        Transform transform;
        std::size_t kind; ///< of the geometry
    };
    struct LinePlace
    {
        Vec2 from;
        Vec2 to;
    };
    struct TextPlace
    {
        Vec2 position;
        scenes::Place place;
    };
    struct LayerPlaces
    {
        std::vector<ShapePlace> shapes;
        std::vector<LinePlace> lines;
        std::vector<TextPlace> texts;
    };
    const LayerPlaces& layer(std::size_t index) const { return layers_[index]; }

private:
    std::array<LayerPlaces, scenes::layer_count> layers_;
};

/// Moves what a picture shows back towards where it was. Things are told apart by their place in the list. A list that has another length
/// than before, a thing of another kind, and one that jumped stay as they are.
/// @param t    0 gives the places of `before`, 1 those of `list`
/// @param jump farther than this nothing moves in a step [m]
void blend(const Places& before, float t, float jump, scenes::DrawList& list);

/// The transform between two, turning the short way.
Transform between(const Transform& a, const Transform& b, float t);

} // namespace carom::gallery
