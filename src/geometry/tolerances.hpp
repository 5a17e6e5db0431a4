// Every length and speed that the engine itself chooses, derived from one number: the typical size of a body.
//
// A tolerance is right for bodies of a certain size. Half a centimetre of slop does not show on a crate of 1 m, and is half of a screw of 1 cm.
// So every such constant is written here once, for a world whose bodies measure about 1 m, times the world's length unit. Angles, shares,
// times and rates are the same in every world. docs/decisions/0007-length-unit.md lists what scales, what does not, and why.
//
// No global holds these: a world derives them once from WorldDef::length_unit and passes them down.
#pragma once

namespace carom::detail
{

struct Tolerances
{
    float length_unit = 1; ///< typical size of a body [m]

    // Shapes.
    /// Least length of an edge, and least distance of two points that are not one.
    float min_edge_length = 0.001f * length_unit;
    /// A hull's corner nearer than this to the line through its neighbours is dropped: too blunt to matter, and its two normals would
    /// be one. Test: ConvexHull.DropsPointsOnAnEdge.
    double collinear_distance = 1e-4 * double{length_unit};
    /// A corner lies this far inside every edge but its own. Keeps the normals of neighbouring edges distinct; far below what convex_hull()
    /// leaves standing (tests: Validate.*, ConvexHull.RandomPointsGiveAValidHull).
    double least_convexity = 1e-5 * double{length_unit};

    // Contacts.
    /// Points farther apart than this make no contact. Contacts are made before shapes touch ("speculative"), so that the solver can stop a
    /// body at the surface instead of pushing it back out.
    float speculative_distance = 0.02f * length_unit;
    /// Rounding that the solver and the tests of overlap do not care about.
    float linear_slop = 0.005f * length_unit;
    /// A face of B becomes the reference only when it separates better than the best one of A by this, so that rounding does not change the
    /// reference of nearly parallel faces from step to step. Test: Manifold.PrefersTheFaceOfA.
    float reference_preference = 0.1f * linear_slop;
    /// Cores nearer than this are treated as overlapping; below it, a normal from corner to corner would be rounding.
    float least_core_distance = 0.01f * linear_slop;
    /// A contact is settled when its spring has no more than this left to come up by: bodies do not sleep before, or they would keep the
    /// sag for as long as they do. stacking_test breaks.
    float settled_within = 0.00025f * length_unit;
    /// Bounds grow by an eighth of a shape's size, at most by this: enough for things that tremble in a pile, little enough to keep false
    /// pairs rare.
    float max_bounds_margin = 0.05f * length_unit;

    // Surfaces that several shapes make together.
    /// Shapes whose edges or corners are no farther apart than this adjoin: the gap between them is no groove that a thing could fall into or
    /// catch on. Test: Terrain.a_gap_of_4_mm_between_tiles_is_none.
    float adjoining_gap = linear_slop;
    /// What sticks out of a hidden face by less than this is a difference in height between tiles, not a step.
    /// Terrain.tiles_that_differ_in_height_by_1_mm_lift_by_no_more breaks.
    float tile_step_height = 0.003f * length_unit;
    /// How far around the contact points a face has to be hidden: enough that the corner of a box pressed into a nook between wall and floor
    /// still feels the part of the floor beside it. Terrain.a_box_in_a_nook_keeps_both_contacts breaks.
    float seen_around = 0.01f * length_unit;
    /// A contact made with a second face is at the deepest point of the sliding shape, but for this.
    float deepest_within = 0.1f * linear_slop;
    /// A gap wider than this between a tile and a tip that sank into it is a real one.
    float real_gap = 0.1f * linear_slop;
    /// Bodies whose material at a contact moves alike to within this are one surface [m/s].
    float same_velocity = 0.01f * length_unit;

    // Continuous collision and time of impact.
    /// How near two shapes are when they count as touching. The contact solver takes over well before.
    float impact_distance = 0.5f * linear_slop;
    /// What counts as having come as near as the target of a time of impact.
    float impact_tolerance = 2.5e-4f * length_unit;
    /// How near a shape comes to a sensor when it enters it on its way.
    float crossing_distance = 5e-4f * length_unit;

    // Queries.
    /// Shapes as near as this count as touching: a box that stands exactly on another overlaps it, whatever rounding says.
    float touch_distance = 5e-6f * length_unit;
};

} // namespace carom::detail
