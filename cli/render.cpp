// Traces each kind of shape as a path of Cairo's, in the world's metres, and letters in pixels.
#include "cli/render.hpp"

#include "cli/errors.hpp"
#include "cli/png.hpp"

#include <cairo.h>
#include <cmath>
#include <numbers>
#include <string>

#ifdef __SANITIZE_ADDRESS__
/// Fontconfig, through which Cairo finds its letters, keeps what it has read until the process ends: not a leak of ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

namespace carom::cli
{

namespace
{

using scenes::Camera;
using scenes::Color;
using scenes::DrawnText;
using scenes::Place;
using scenes::Viewport;

constexpr double full_turn = 2 * std::numbers::pi;
constexpr float reference_height = 720; // widths and text sizes of a draw list are in 1/720 of the picture's height

void set_color(cairo_t* context, Color c)
{
    cairo_set_source_rgba(context, static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b), static_cast<double>(c.a));
}

void move_to(cairo_t* context, Vec2 p) { cairo_move_to(context, static_cast<double>(p.x), static_cast<double>(p.y)); }

void line_to(cairo_t* context, Vec2 p) { cairo_line_to(context, static_cast<double>(p.x), static_cast<double>(p.y)); }

/// Counter-clockwise in the world.
void arc(cairo_t* context, Vec2 center, float radius, double from, double to)
{
    cairo_arc(context, static_cast<double>(center.x), static_cast<double>(center.y), static_cast<double>(radius), from, to);
}

double direction_of(Vec2 v) { return std::atan2(static_cast<double>(v.y), static_cast<double>(v.x)); }

void trace(cairo_t* context, const Circle& c, const Transform& t) { arc(context, t * c.center, c.radius, 0, full_turn); }

void trace(cairo_t* context, const Capsule& c, const Transform& t)
{
    const Vec2 p1 = t * c.p1;
    const Vec2 p2 = t * c.p2;
    const double along = direction_of(p2 - p1);
    arc(context, p1, c.radius, along + 0.25 * full_turn, along + 0.75 * full_turn);
    arc(context, p2, c.radius, along - 0.25 * full_turn, along + 0.25 * full_turn);
    cairo_close_path(context);
}

void trace(cairo_t* context, const Segment& s, const Transform& t)
{
    move_to(context, t * s.p1);
    line_to(context, t * s.p2);
}

void trace(cairo_t* context, const Polygon& p, const Transform& t)
{
    const auto count = static_cast<std::size_t>(p.count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec2 corner = t * p.vertices[i];
        if (p.radius <= 0)
        {
            line_to(context, corner);
            continue;
        }
        const double from = direction_of(rotate(t.q, p.normals[(i + count - 1) % count]));
        const double to = direction_of(rotate(t.q, p.normals[i]));
        arc(context, corner, p.radius, from, to);
    }
    cairo_close_path(context);
}

/// The part of the world that the picture shows.
Aabb visible_part(const Camera& camera, Viewport size)
{
    const float half_height = 0.5f * camera.height;
    const float half_width = half_height * static_cast<float>(size.width) / static_cast<float>(size.height);
    return {camera.center - Vec2{half_width, half_height}, camera.center + Vec2{half_width, half_height}};
}

/// Light letters with a dark rim, legible on every ground.
void draw_text(cairo_t* context, const DrawnText& text, Vec2 position, double size, Color rim)
{
    move_to(context, position);
    cairo_set_font_size(context, size);
    cairo_text_path(context, text.text.c_str());
    set_color(context, with_alpha(rim, 0.8f));
    cairo_set_line_width(context, 0.22 * size);
    cairo_stroke_preserve(context);
    set_color(context, text.color);
    cairo_fill(context);
}

/// From the middle of a text to where its letters start.
Vec2 to_start(cairo_t* context, const DrawnText& text, double size)
{
    cairo_text_extents_t box;
    cairo_set_font_size(context, size);
    cairo_text_extents(context, text.text.c_str(), &box);
    return {static_cast<float>(-box.x_bearing - 0.5 * box.width), static_cast<float>(-box.y_bearing - 0.5 * box.height)};
}

} // namespace

void Canvas::Release::operator()(_cairo_surface* surface) const { cairo_surface_destroy(surface); }

void Canvas::Release::operator()(_cairo* context) const { cairo_destroy(context); }

Canvas::Canvas(Viewport size, Quality quality)
    : size_(size),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)),
      context_(cairo_create(surface_.get()))
{
    const cairo_status_t status = cairo_status(context_.get());
    if (status != CAIRO_STATUS_SUCCESS) throw Failure(std::string("can't make a picture: ") + cairo_status_to_string(status));
    cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    if (quality == Quality::Quick)
    {
        cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);
        cairo_set_tolerance(context_.get(), 1); // [pixels]
    }
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::draw(const scenes::DrawList& list, const Camera& camera)
{
    cairo_t* const context = context_.get();
    set_color(context, list.background);
    cairo_paint(context);

    cairo_save(context);
    const auto scale = static_cast<double>(pixels_per_metre(camera, size_));
    cairo_translate(context, 0.5 * size_.width, 0.5 * size_.height);
    cairo_scale(context, scale, -scale);
    cairo_translate(context, static_cast<double>(-camera.center.x), static_cast<double>(-camera.center.y));
    for (const scenes::DrawnLayer& layer : list.layers()) draw_layer(layer, camera);
    cairo_restore(context);

    draw_texts(list, camera);
}

void Canvas::draw_layer(const scenes::DrawnLayer& layer, const Camera& camera)
{
    cairo_t* const context = context_.get();
    const Aabb visible = visible_part(camera, size_);
    const double width_unit = static_cast<double>(camera.height / reference_height);
    for (const scenes::DrawnShape& shape : layer.shapes)
    {
        if (!overlaps(visible, aabb_of(shape.geometry, shape.transform))) continue;
        cairo_new_path(context);
        std::visit([&](const auto& geometry) { trace(context, geometry, shape.transform); }, shape.geometry);
        set_color(context, shape.paint.fill);
        if (shape.paint.fill.a > 0) cairo_fill_preserve(context);
        set_color(context, shape.paint.line);
        cairo_set_line_width(context, width_unit * static_cast<double>(shape.paint.line_width));
        if (shape.paint.line.a > 0) cairo_stroke(context);
    }
    for (const scenes::DrawnLine& line : layer.lines)
    {
        if (!overlaps(visible, {min(line.from, line.to), max(line.from, line.to)})) continue;
        cairo_new_path(context);
        move_to(context, line.from);
        line_to(context, line.to);
        set_color(context, line.color);
        cairo_set_line_width(context, width_unit * static_cast<double>(line.width));
        cairo_stroke(context);
    }
}

void Canvas::draw_texts(const scenes::DrawList& list, const Camera& camera)
{
    const float unit = static_cast<float>(size_.height) / reference_height;
    const float margin = 18 * unit;
    const float spacing = 1.4f;
    float top = margin;
    float bottom = static_cast<float>(size_.height) - margin;
    cairo_new_path(context_.get());
    for (const scenes::DrawnLayer& layer : list.layers())
    {
        for (const DrawnText& text : layer.texts)
        {
            const float size = unit * text.size;
            const auto font_size = static_cast<double>(size);
            Vec2 position{margin, top + size};
            if (text.place == Place::TopLeft) top += spacing * size;
            if (text.place == Place::BottomLeft)
            {
                position.y = bottom;
                bottom -= spacing * size;
            }
            if (text.place == Place::World) position = to_pixels(camera, size_, text.position) + to_start(context_.get(), text, font_size);
            draw_text(context_.get(), text, position, font_size, list.background);
        }
    }
}

std::span<const std::byte> Canvas::pixels()
{
    // Each row of RGB24 is 4 bytes a pixel without padding.
    cairo_surface_flush(surface_.get());
    const auto bytes = static_cast<std::size_t>(4) * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
    return {reinterpret_cast<const std::byte*>(cairo_image_surface_get_data(surface_.get())), bytes};
}

void Canvas::write(std::ostream& out) { write_png(surface_.get(), out); }

} // namespace carom::cli
