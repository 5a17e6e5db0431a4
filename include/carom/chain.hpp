// Chains: ground from a line of points, smooth to roll and slide on.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace carom
{

namespace detail
{
struct WorldState;
}

enum class ChainSides
{
    TwoSided, ///< solid from both sides
    OneSided  ///< solid in front, on the right of the way from point to point; what comes from behind passes
};

/// A line of segments on one body. Nothing catches on its corners: a shape that slides over two segments in line feels one.
///
///     open, 4 points, 3 segments             loop, counter-clockwise
///
///            front                              p3 <------ p2
///     p3 <--- p2 <--- p1 <--- p0                 |          ^      the front of a one-sided loop is
///            back                                v          |      outside when its points go around
///                                               p0 ------> p1      counter-clockwise: a solid island
///
/// A thing passes a one-sided chain when its middle has been behind it, and goes on passing until it is clear of the segment, so that the chain
/// never pulls it through.
struct ChainDef
{
    std::span<const Vec2>
        points;           ///< in the body's frame, neighbours at least 1 mm apart [m]; 2 to 1,000,000 of them, for a loop 3 at least
    bool is_loop = false; ///< a last segment leads back to the first point
    ChainSides sides = ChainSides::TwoSided;
    std::span<const Material> materials = {}; ///< none for the default, one for all segments, or one for each
    Filter filter = {};
    bool contact_events = true;  ///< as in ShapeDef, for each segment
    bool persist_events = false; ///< as in ShapeDef
    bool sensor_events = true;   ///< as in ShapeDef
    bool hit_events = false;     ///< as in ShapeDef
    bool pre_solve = false;      ///< as in ShapeDef
    std::uint64_t user_data = 0; ///< yours; the engine does not read it
};

/// Reads a chain. A light value, like BodyView: every call throws UsageError once the chain is gone.
class ChainView
{
public:
    ChainId id() const { return id_; }
    BodyId body() const;
    int segment_count() const;
    std::vector<ShapeId> segments() const; ///< in the order of the points; each is a shape, with a Segment as its geometry
    bool is_loop() const;
    ChainSides sides() const;
    const Material& material(int segment) const; ///< valid until any shape is created, changed or destroyed
    std::uint64_t user_data() const;

protected:
    friend class World;
    ChainView(detail::WorldState& world, ChainId id) : world_(&world), id_(id) {}

    detail::WorldState* world_;
    ChainId id_;
};

/// Reads and changes a chain. Its segments can be changed as shapes too, but for their geometry, and go only all together.
class Chain : public ChainView
{
public:
    void set_material(const Material& material);              ///< of all segments, also for contacts that exist
    void set_material(int segment, const Material& material); ///< of one
    void set_filter(const Filter& filter);                    ///< of all segments; contacts that it no longer allows end
    void set_user_data(std::uint64_t user_data);

private:
    friend class World;
    using ChainView::ChainView;
};

} // namespace carom
