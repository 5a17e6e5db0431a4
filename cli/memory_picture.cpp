// One column of the chart is one pixel wide and shows the moment of its time at which most memory was in use.
#include "cli/memory_picture.hpp"

#include "cli/png.hpp"
#include "scenes/color.hpp"

#include <algorithm>
#include <array>
#include <cairo.h>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <span>
#include <tuple>

namespace carom::cli
{

namespace
{

using scenes::Color;

constexpr int width = 1000; // of the picture [pixels]
constexpr int height = 420;
constexpr double left = 90; // the chart's edges
constexpr double right = 700;
constexpr double top = 50;
constexpr double bottom = height - 50;
constexpr std::size_t columns = static_cast<std::size_t>(right - left);
constexpr std::size_t most_bands = 8;

/// What is drawn in one colour.
struct Band
{
    std::string name;
    double peak = 0;                 ///< [bytes]
    double last = 0;                 ///< [bytes]
    std::array<double, columns> use; ///< [bytes]
};

struct Chart
{
    std::vector<Band> bands; ///< from the bottom
    double first_us = 0;
    double last_us = 0;
    double peak = 0; ///< of all bands together [bytes]
};

struct MemoryEvent
{
    double time_us;
    std::size_t number; ///< in the order in which the trace tells them
    std::size_t band;
    double change; ///< [bytes]
};

std::string formatted(const char* format, double value)
{
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, value);
    return buffer.data();
}

std::string bytes_text(double bytes)
{
    if (bytes < 1024) return formatted("%.0f B", bytes);
    if (bytes < 1024 * 1024) return formatted("%.4g KiB", bytes / 1024);
    if (bytes < 1024.0 * 1024 * 1024) return formatted("%.4g MiB", bytes / (1024 * 1024));
    return formatted("%.4g GiB", bytes / (1024.0 * 1024 * 1024));
}

double peak_of(std::span<const lab::TracePoint> points)
{
    double peak = 0;
    for (const lab::TracePoint& point : points) peak = std::max(peak, point.value);
    return peak;
}

/// The pools, those that take most first. From the eighth on they share a band.
std::vector<Band> make_bands(const lab::Trace& trace, std::vector<MemoryEvent>& events)
{
    std::vector<std::pair<double, const std::string*>> order;
    for (const auto& [name, points] : trace.memory) order.emplace_back(-peak_of(points), &name);
    std::sort(order.begin(), order.end(),
              [](const auto& a, const auto& b) { return std::tie(a.first, *a.second) < std::tie(b.first, *b.second); });
    std::vector<Band> bands;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const bool is_shared = order.size() > most_bands && i >= most_bands - 1;
        if (bands.size() < most_bands) bands.push_back({.name = is_shared ? "the others" : order[i].second->substr(0, 30), .use = {}});
        double before = 0;
        for (const lab::TracePoint& point : trace.memory.at(*order[i].second))
        {
            events.push_back({point.time_us, events.size(), bands.size() - 1, point.value - before});
            before = point.value;
        }
    }
    std::sort(events.begin(), events.end(),
              [](const MemoryEvent& a, const MemoryEvent& b) { return std::tie(a.time_us, a.number) < std::tie(b.time_us, b.number); });
    return bands;
}

/// From the first to the last that the trace tells of, and longer than nothing.
void set_times(Chart& chart, const lab::Trace& trace, std::span<const MemoryEvent> events)
{
    chart.first_us = events.front().time_us;
    chart.last_us = events.back().time_us;
    for (const lab::TraceZone& zone : trace.zones) chart.last_us = std::max(chart.last_us, zone.start_us + zone.duration_us);
    chart.last_us = std::max(chart.last_us, chart.first_us + 1);
}

Chart make_chart(const lab::Trace& trace)
{
    Chart chart;
    std::vector<MemoryEvent> events;
    chart.bands = make_bands(trace, events);
    set_times(chart, trace, events);
    const double column_us = (chart.last_us - chart.first_us) / static_cast<double>(columns);
    std::vector<double> now(chart.bands.size());
    std::size_t next = 0;
    for (std::size_t column = 0; column < columns; ++column)
    {
        double most = -1;
        const auto note = [&]
        {
            const double total = std::accumulate(now.begin(), now.end(), 0.0);
            if (total <= most) return;
            most = total;
            for (std::size_t i = 0; i < now.size(); ++i) chart.bands[i].use[column] = now[i];
        };
        if (column > 0) note();
        const double end_us = column + 1 < columns ? chart.first_us + column_us * static_cast<double>(column + 1) : INFINITY;
        for (; next < events.size() && events[next].time_us < end_us; ++next)
        {
            Band& band = chart.bands[events[next].band];
            band.last = now[events[next].band] += events[next].change;
            band.peak = std::max(band.peak, band.last);
            // Pools that change at one moment, as at the end of a frame, change together.
            if (next + 1 == events.size() || events[next + 1].time_us > events[next].time_us) note();
        }
        chart.peak = std::max(chart.peak, most);
    }
    return chart;
}

Color color_of(std::size_t band, std::size_t count)
{
    return scenes::from_hue(0.55f + static_cast<float>(band) / static_cast<float>(std::max<std::size_t>(count, 3)), 0.55f, 0.58f);
}

/// Draws with Cairo; frees what it holds.
class Painter
{
public:
    Painter() : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), context_(cairo_create(surface_.get()))
    {
        cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context_.get(), 13);
        fill(0, 0, width, height, scenes::night);
    }

    void fill(double x, double y, double w, double h, Color color)
    {
        set(color);
        cairo_rectangle(context_.get(), x, y, w, h);
        cairo_fill(context_.get());
    }
    /// @param align 0 starts at x, 0.5 is centred there, 1 ends there
    void text(double x, double y, const std::string& words, double align, Color color = scenes::paper)
    {
        cairo_text_extents_t box;
        cairo_text_extents(context_.get(), words.c_str(), &box);
        set(color);
        cairo_move_to(context_.get(), x - align * box.x_advance, y);
        cairo_show_text(context_.get(), words.c_str());
    }
    void write(std::ostream& out) { write_png(surface_.get(), out); }

private:
    struct Release
    {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    void set(Color c)
    {
        cairo_set_source_rgba(context_.get(), static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b),
                              static_cast<double>(c.a));
    }

    std::unique_ptr<cairo_surface_t, Release> surface_;
    std::unique_ptr<cairo_t, Release> context_;
};

/// 1, 2 or 5 times a power of ten (of 1024 and two, for bytes): so that there are 3 to 8 lines up to `most`.
double round_step(double most, bool is_binary)
{
    double step = is_binary ? std::exp2(std::floor(std::log2(most / 4))) : std::pow(10, std::floor(std::log10(most / 4)));
    if (is_binary) return std::max(step, 1.0);
    for (const double factor : {5.0, 2.0})
    {
        if (most / (factor * step) >= 4) return factor * step;
    }
    return step;
}

void draw_axes(Painter& painter, const Chart& chart, double scale)
{
    const double step = round_step(std::max(chart.peak, 8.0), true);
    for (double bytes = 0; scale * bytes <= bottom - top; bytes += step)
    {
        painter.fill(left - 4, bottom - scale * bytes, right - left + 4, 1, scenes::with_alpha(scenes::paper, 0.15f));
        painter.text(left - 10, bottom - scale * bytes + 5, bytes_text(bytes), 1);
    }
    const double span_us = chart.last_us - chart.first_us;
    const double time_step = round_step(span_us, false);
    const bool is_long = span_us >= 2e6;
    for (double us = 0; us <= span_us; us += time_step)
    {
        const double x = left + us / span_us * (right - left);
        painter.fill(x, bottom, 1, 5, scenes::paper);
        painter.text(x, bottom + 20, formatted("%g", us / (is_long ? 1e6 : 1e3)), 0.5);
    }
    painter.text((left + right) / 2, bottom + 40, is_long ? "time [s]" : "time [ms]", 0.5);
}

void draw_bands(Painter& painter, const Chart& chart, double scale)
{
    for (std::size_t column = 0; column < columns; ++column)
    {
        double below = 0;
        for (std::size_t i = 0; i < chart.bands.size(); ++i)
        {
            const double above = below + chart.bands[i].use[column];
            const double x = left + static_cast<double>(column);
            painter.fill(x, bottom - scale * above, 1, scale * (above - below), color_of(i, chart.bands.size()));
            below = above;
        }
    }
}

void draw_legend(Painter& painter, const Chart& chart)
{
    double y = top + 14;
    for (std::size_t i = chart.bands.size(); i-- > 0; y += 40)
    {
        const Band& band = chart.bands[i];
        painter.fill(right + 20, y - 11, 13, 13, color_of(i, chart.bands.size()));
        painter.text(right + 42, y, band.name, 0);
        painter.text(right + 42, y + 17, "peak " + bytes_text(band.peak) + ", at the end " + bytes_text(band.last), 0,
                     scenes::with_alpha(scenes::paper, 0.65f));
    }
}

} // namespace

void draw_memory(const lab::Trace& trace, std::ostream& out)
{
    const Chart chart = make_chart(trace);
    const double scale = (bottom - top) / (1.08 * std::max(chart.peak, 8.0)); // pixels a byte
    Painter painter;
    painter.text(left, 28, "memory in use by pool, at most " + bytes_text(chart.peak), 0);
    draw_bands(painter, chart, scale);
    draw_axes(painter, chart, scale);
    draw_legend(painter, chart);
    painter.write(out);
}

} // namespace carom::cli
