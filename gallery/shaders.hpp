// The two programs that run on the graphics card, in OpenGL's shading language.
#pragma once

namespace carom::gallery
{

/// Puts a frame of two nested rectangles around a shape, turned as its first edge is, since every pixel costs. The frame leaves out the
/// inside of a box or a disc that is not filled, where nothing is drawn. Around all others the inner rectangle shrinks to the outer
/// corner 3, so that of the frame's eight triangles two cover everything and the others are empty.
inline constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec4 corners01;
layout(location = 1) in vec4 corners23;
layout(location = 2) in vec4 corners45;
layout(location = 3) in vec4 corners67;
layout(location = 4) in vec4 sizes; // radius, half of the line's width, number of corners, power or flat ends
layout(location = 5) in vec4 fill;
layout(location = 6) in vec4 line;

uniform vec2 half_picture; // [pixels]

out vec2 point; // from the middle of the picture, y up [pixels]
flat out vec4 shape01; // the corners; of a box, which says 0 corners, its middle and direction and half of its size
flat out vec4 shape23;
flat out vec4 shape45;
flat out vec4 shape67;
flat out vec4 shape_sizes;
flat out vec4 fill_color; // times its opacity
flat out vec4 line_color;
flat out vec2 most;       // of a pixel that fill and line can cover

void main()
{
    vec2 corners[8] = vec2[8](corners01.xy, corners01.zw, corners23.xy, corners23.zw, corners45.xy, corners45.zw, corners67.xy, corners67.zw);
    float radius = sizes.x;
    float half_line = sizes.y;
    int count = int(sizes.z);

    vec2 along = count > 1 ? corners[1] - corners[0] : vec2(1.0, 0.0);
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    vec2 low = vec2(dot(corners[0], along), dot(corners[0], across));
    vec2 high = low;
    for (int i = 1; i < count; ++i)
    {
        vec2 p = vec2(dot(corners[i], along), dot(corners[i], across));
        low = min(low, p);
        high = max(high, p);
    }

    // The soft edge adds pi / 12 to a disc's area: it is made smaller by that. Below a pixel it stays as large and becomes fainter.
    float share = 1.0;
    float drawn_radius = radius;
    if (count == 1 && radius < 16.0)
    {
        float least = max(radius, 0.6);
        share = radius * radius / (least * least);
        drawn_radius = sqrt(least * least - 1.0 / 12.0);
    }

    // Other shapes thinner than a pixel cover only a part of every pixel that they meet.
    vec2 fill_part = min(high - low + 2.0 * radius, 1.0);
    vec2 line_part = min(high - low + 2.0 * radius + 2.0 * half_line, 1.0);
    most = vec2(count == 1 ? 1.0 : fill_part.x * fill_part.y, line_part.x * line_part.y);

    vec2 middle = 0.5 * (low + high);
    vec2 outer = 0.5 * (high - low) + radius + half_line + 1.0;
    vec2 inner = vec2(0.0);
    vec2 diagonals = corners[0] + corners[2] - corners[1] - corners[3];
    bool is_box = count == 4 && dot(diagonals, diagonals) < 1e-4 && abs(dot(corners[2] - corners[1], along)) < 1e-2;
    if (fill.a == 0.0 && is_box) inner = 0.5 * (high - low) - half_line - 1.0;
    if (fill.a == 0.0 && count == 1) inner = vec2(0.7 * (radius - half_line - 1.0));
    bool is_hollow = min(inner.x, inner.y) > 0.0;
    vec2 side = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    vec2 place = middle + (gl_VertexID < 4 ? side * outer : is_hollow ? side * inner : outer);
    point = place.x * along + place.y * across;
    gl_Position = vec4(point / half_picture, 0.0, 1.0);

    shape01 = corners01;
    shape23 = corners23;
    shape45 = corners45;
    shape67 = corners67;
    shape_sizes = vec4(drawn_radius, sizes.yzw);
    if (is_box)
    {
        shape01 = vec4(middle.x * along + middle.y * across, along);
        shape23 = vec4(0.5 * (high - low), 0.0, 0.0);
        shape_sizes.z = 0.0;
    }
    fill_color = share * vec4(fill.rgb * fill.a, fill.a);
    line_color = vec4(line.rgb * line.a, line.a);
}
)";

/// Fills where the signed distance to the shape is negative and draws the border where it is near 0. A pixel on an edge is covered by as
/// much as a pixel's width around its distance is.
inline constexpr const char* fragment_shader = R"(#version 330 core
in vec2 point;
flat in vec4 shape01;
flat in vec4 shape23;
flat in vec4 shape45;
flat in vec4 shape67;
flat in vec4 shape_sizes;
flat in vec4 fill_color;
flat in vec4 line_color;
flat in vec2 most;

out vec4 color; // times its opacity

/// Beyond this radius [pixels] the difference of two large lengths would be off by a visible part of a pixel.
const float large_radius = 4096.0;

/// With |p - c| - r = (|p - c|^2 - r^2) / (|p - c| + r), and the numerator's large parts subtracted beforehand.
float distance_to_disc(vec2 c, float radius, float power)
{
    float apart = length(point - c);
    return radius < large_radius ? apart - radius : (dot(point, point) - 2.0 * dot(point, c) + power) / (apart + radius);
}

vec2 way_from_edge(vec2 a, vec2 b)
{
    vec2 edge = b - a;
    vec2 way = point - a;
    return way - edge * clamp(dot(way, edge) / max(dot(edge, edge), 1e-12), 0.0, 1.0);
}

float distance_to_polygon(int count)
{
    vec2 corners[8] = vec2[8](shape01.xy, shape01.zw, shape23.xy, shape23.zw, shape45.xy, shape45.zw, shape67.xy, shape67.zw);
    float nearest = 3e38; // squared
    bool is_inside = true;
    vec2 a = corners[count - 1];
    for (int i = 0; i < count; ++i)
    {
        vec2 b = corners[i];
        vec2 way = way_from_edge(a, b);
        nearest = min(nearest, dot(way, way));
        vec2 edge = b - a;
        is_inside = is_inside && edge.x * (point.y - a.y) >= edge.y * (point.x - a.x);
        a = b;
    }
    return is_inside ? -sqrt(nearest) : sqrt(nearest);
}

float distance_to_box(vec2 middle, vec2 along, vec2 half_size)
{
    vec2 way = point - middle;
    vec2 beyond = abs(vec2(dot(way, along), dot(way, vec2(-along.y, along.x)))) - half_size;
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
}

/// The distance to an endless line, and how much of the pixel lies between its two ends.
vec2 distance_to_flat_line(vec2 a, vec2 b)
{
    float size = length(b - a);
    vec2 along = (b - a) / max(size, 1e-6);
    vec2 way = point - a;
    float place = dot(way, along);
    return vec2(abs(dot(way, vec2(-along.y, along.x))), clamp(min(place, size - place) + 0.5, 0.0, 1.0));
}

void main()
{
    float radius = shape_sizes.x;
    float half_line = shape_sizes.y;
    int count = int(shape_sizes.z);
    float lined = 1.0;
    float apart;
    if (count == 0)
        apart = distance_to_box(shape01.xy, shape01.zw, shape23.xy) - radius;
    else if (count == 1)
        apart = distance_to_disc(shape01.xy, radius, shape_sizes.w);
    else if (count == 2 && shape_sizes.w > 0.0)
    {
        vec2 flat_line = distance_to_flat_line(shape01.xy, shape01.zw);
        apart = flat_line.x;
        lined = flat_line.y;
    }
    else if (count == 2)
        apart = length(way_from_edge(shape01.xy, shape01.zw)) - radius;
    else
        apart = distance_to_polygon(count) - radius;

    float filled = min(clamp(0.5 - apart, 0.0, 1.0), most.x);
    lined *= min(max(min(apart + 0.5, half_line) - max(apart - 0.5, -half_line), 0.0), most.y);
    vec4 over = line_color * lined;
    color = over + fill_color * filled * (1.0 - over.a);
}
)";

} // namespace carom::gallery
