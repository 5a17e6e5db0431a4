// Questions about the surface that several shapes make together: which part of a face another shape hides, what lies in front of a corner,
// and where a shape touches one given face.
//
// A shape is the hull of a few points grown by a radius (ConvexPoints). Face i runs from point i to the next, its outward normal to the
// right. A capsule or a segment has two faces, one a side; a circle has none.
#pragma once

#include "geometry/distance.hpp"
#include "geometry/manifold.hpp"
#include "geometry/manifold_kernels.hpp"

namespace carom::detail
{

inline int face_count(const ConvexPoints& shape) { return shape.count > 1 ? shape.count : 0; }
Edge face_of(const ConvexPoints& shape, int face);
Vec2 normal_of(const Edge& face); ///< unit, outward
/// The same shape in another frame.
ConvexPoints moved(const ConvexPoints& shape, const Transform& transform);
LocalManifold moved(const LocalManifold& manifold, const Transform& transform);
Vec2 middle_of(const ConvexPoints& shape); ///< the mean of its points
/// Whether no part of `other` reaches more than `gap` in front of a face of `shape`.
/// @param gap Tolerances::adjoining_gap [m]
bool is_behind(const ConvexPoints& other, const ConvexPoints& shape, int face, float gap);
/// From the shape's surface to the point, negative inside; for points inside only the sign is exact.
float distance_to(const ConvexPoints& shape, Vec2 point);

/// A stretch along a face, from its first corner [m]. Empty when end <= start.
struct Stretch
{
    float start = 0;
    float end = 0;
};

/// The part of the face before which `other` lies: where a point `gap` outside of the face is inside it. A segment has no inside: it
/// hides what is behind it, if any of it is in front of the face.
/// @param viewer which side of a segment is its front: the one that faces this point
/// @param gap    Tolerances::adjoining_gap [m]
Stretch hidden_stretch(const ConvexPoints& shape, int face, const ConvexPoints& other, Vec2 viewer, float gap);

/// How far the point of `other` that lies farthest in front of a point of a surface does so, as a sine: 0 when all of it is behind the line
/// across `normal`. Points of `other` within `gap` do not count: heights may differ by that much.
/// @param gap Tolerances::adjoining_gap [m]
float rise_before(const ConvexPoints& other, Vec2 point, Vec2 normal, float gap);

/// Where `other` touches the given face of `shape`, whatever face separates the two best.
struct FaceContact
{
    LocalManifold manifold;     ///< in the common frame; the normal points from A to B
    float face_separation = 0;  ///< of other's deepest point, over the face or not [m]
    float point_separation = 0; ///< of the deepest contact point [m]
};

/// @param other      in the frame of `shape`
/// @param slack      how far beyond the ends of the face still counts as over it [m]
/// @param shape_is_b for the normal and the features
FaceContact collide_on_face(const ConvexPoints& shape, int face, const ConvexPoints& other, float slack, bool shape_is_b, float margin);

} // namespace carom::detail
