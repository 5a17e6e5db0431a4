// A scene of coloured shapes and joints that can be dragged: what most mechanical scenes have in common.
#pragma once

#include "scenes/grabber.hpp"
#include "scenes/helpers.hpp"
#include "scenes/scene.hpp"

#include <vector>

namespace carom::scenes
{

/// Draws every joint as what it is: pins, rods, ropes, springs, rails, pulleys. A mouse joint is left to its Grabber.
/// @param size radius of a pin [m]
void draw_joints(const World& world, DrawList& list, float size);

/// Draws every shape: coloured ones as they are painted, with a spoke in discs to see them roll; others in slate.
void draw_painted(const World& world, const PerShape<Color>& colors, DrawList& list);

class PaintedScene : public Scene
{
protected:
    using Scene::Scene;

    /// A body with one coloured shape.
    BodyId add(const BodyDef& def, const Geometry& geometry, Color color, const ShapeDef& shape = {});
    void add_shape(BodyId body, const Geometry& geometry, Color color, const ShapeDef& shape = {});
    /// A static body in slate.
    BodyId add_static(const Geometry& geometry, const ShapeDef& shape = {});

    /// A static chain.
    void add_ground(const std::vector<Vec2>& points, const Material& material = {}, const Filter& filter = {});

    void on_pointer(const PointerEvent& event) override { grabber_.on_pointer(world(), event); }
    void on_draw(DrawList& list) const override;
    /// What is said about the bodies, over them.
    virtual void draw_marks(DrawList& /*list*/) const {}
    void label(DrawList& list, Vec2 place, std::string text, float size = 16) const;

    Grabber grabber_;
    PerShape<Color> colors_;
};

/// The control that every scene with a Grabber has.
Control drag_control();

} // namespace carom::scenes
