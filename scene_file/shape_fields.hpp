// The fields of shapes and chains in a scene file.
#pragma once

#include "scene_file/field_rules.hpp"

namespace carom::scene_file
{

template <>
struct Fields<Circle>
{
    static constexpr const char* name = "circle";
    static constexpr const char* what = "A disc.";
    template <class V>
    static void visit(V& v)
    {
        v("center", &Circle::center, place("in the body's frame"));
        v("radius", &Circle::radius, {.what = "", .unit = "m", .min = 0, .max = max_coordinate, .is_above_min = true, .is_required = true});
    }
};
template <>
struct Fields<Capsule>
{
    static constexpr const char* name = "capsule";
    static constexpr const char* what = "All points within the radius of a line segment.";
    template <class V>
    static void visit(V& v)
    {
        constexpr double most = max_coordinate;
        v("p1", &Capsule::p1, {.what = "centre of one end", .unit = "m", .min = -most, .max = most, .is_required = true});
        v("p2", &Capsule::p2,
          {.what = "centre of the other, at least 1 mm away", .unit = "m", .min = -most, .max = most, .is_required = true});
        v("radius", &Capsule::radius, {.what = "", .unit = "m", .min = 0, .max = most, .is_above_min = true, .is_required = true});
    }
};
template <>
struct Fields<Segment>
{
    static constexpr const char* name = "segment";
    static constexpr const char* what = "A line without thickness or mass, solid from both sides.";
    template <class V>
    static void visit(V& v)
    {
        constexpr double most = max_coordinate;
        v("p1", &Segment::p1, {.what = "one end", .unit = "m", .min = -most, .max = most, .is_required = true});
        v("p2", &Segment::p2, {.what = "the other, at least 1 mm away", .unit = "m", .min = -most, .max = most, .is_required = true});
    }
};

/// A Polygon as it is written: what follows from the vertices is left out.
struct PolygonFields
{
    std::vector<Vec2> vertices;
    float radius = 0;
    std::vector<Vec2> normals = {};
    std::optional<Vec2> centroid = {};
};
template <>
struct Fields<PolygonFields>
{
    static constexpr const char* name = "polygon";
    static constexpr const char* what = "A convex polygon, grown by its radius.";
    template <class V>
    static void visit(V& v)
    {
        v("vertices", &PolygonFields::vertices,
          {.what = "corners, counter-clockwise, at least 1 mm apart [m]", .min = 3, .max = max_polygon_vertices, .is_required = true});
        v("radius", &PolygonFields::radius, length_of("rounding"));
        v("normals", &PolygonFields::normals,
          {.what =
               "outward unit normal of the edge from each vertex to the next; left out where it follows from the vertices to the last bit",
           .min = 0,
           .max = max_polygon_vertices});
        v("centroid", &PolygonFields::centroid, place("left out where it follows from the vertices to the last bit"));
    }
};

template <>
struct Fields<Material>
{
    static constexpr const char* name = "material";
    static constexpr const char* what = "How a surface behaves on contact.";
    template <class V>
    static void visit(V& v)
    {
        v("friction", &Material::friction, factor("Coulomb's coefficient"));
        v("restitution", &Material::restitution, {.what = "part of the approach speed that comes back", .min = 0, .max = 1});
        v("rolling_resistance", &Material::rolling_resistance, factor("share of the normal force that brakes rolling"));
        v("tangent_speed", &Material::tangent_speed, speed("of a conveyor's surface; positive carries to the right of the outward normal"));
        v("id", &Material::id, about("the program's own"));
    }
};
template <>
struct Fields<Filter>
{
    static constexpr const char* name = "filter";
    static constexpr const char* what =
        "Which shapes meet: category and mask of 64 bits, and a group; two of one group always meet when it is "
        "positive and never when it is negative.";
    template <class V>
    static void visit(V& v)
    {
        v("category", &Filter::category, about("bits"));
        v("mask", &Filter::mask, about("bits of the categories that it meets"));
        v("group", &Filter::group, {.what = "0 for none", .min = -2147483648.0, .max = 2147483647.0});
    }
};
template <>
struct Fields<ShapeDef>
{
    template <class V>
    static void visit(V& v)
    {
        v("density", &ShapeDef::density, {.what = "", .unit = "kg/m^2", .min = 0, .max = 1e30});
        v("material", &ShapeDef::material, about(""));
        v("filter", &ShapeDef::filter, about(""));
        v("is_sensor", &ShapeDef::is_sensor, about("reports overlaps and pushes nothing"));
        v("contact_events", &ShapeDef::contact_events, about("begin and end of its contacts are reported"));
        v("persist_events", &ShapeDef::persist_events, about("so is each further step"));
        v("sensor_events", &ShapeDef::sensor_events, about("its overlaps with sensors are reported"));
        v("hit_events", &ShapeDef::hit_events, about("its fast collisions are reported"));
        v("pre_solve", &ShapeDef::pre_solve, about("its contacts are shown to hooks"));
        v("user_data", &ShapeDef::user_data, about("the program's own"));
    }
};
template <>
struct Fields<FileShape>
{
    static constexpr const char* name = "shape";
    static constexpr const char* what =
        "A shape: its geometry under one of the keys circle, capsule, segment, polygon, and what else it is.";
    template <class V>
    static void visit(V& v)
    {
        v("name", &FileShape::name, about("may repeat"));
        v.choice(&FileShape::geometry, {.what = "", .is_required = true});
        v.flat(&FileShape::def);
    }
};
template <>
struct Fields<ChainDef>
{
    template <class V>
    static void visit(V& v)
    {
        v("is_loop", &ChainDef::is_loop, about("a last segment leads back to the first point"));
        v("sides", &ChainDef::sides, about("one_sided: solid on the right of the way from point to point, what comes from behind passes"));
        v("filter", &ChainDef::filter, about(""));
        v("contact_events", &ChainDef::contact_events, about("as of a shape, for each segment"));
        v("persist_events", &ChainDef::persist_events, about("as of a shape"));
        v("sensor_events", &ChainDef::sensor_events, about("as of a shape"));
        v("hit_events", &ChainDef::hit_events, about("as of a shape"));
        v("pre_solve", &ChainDef::pre_solve, about("as of a shape"));
        v("user_data", &ChainDef::user_data, about("the program's own"));
    }
};
template <>
struct Fields<FileChain>
{
    static constexpr const char* name = "chain";
    static constexpr const char* what = "A line of segments on which nothing catches.";
    template <class V>
    static void visit(V& v)
    {
        v("name", &FileChain::name, about("may repeat"));
        v("points", &FileChain::points,
          {.what = "in the body's frame, neighbours at least 1 mm apart [m]", .min = 2, .max = 1e6, .is_required = true});
        v("materials", &FileChain::materials, {.what = "none for the default, one for all segments, or one for each", .max = 1e6});
        v.flat(&FileChain::def);
    }
};

} // namespace carom::scene_file
