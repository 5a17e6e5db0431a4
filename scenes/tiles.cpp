// Tiles: a ball and a box race over floors that are made of one piece and of many. What would trip on a seam shows in the trace of
// its height, a thousand times enlarged.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace carom::scenes
{

namespace
{

constexpr float lane_length = 60; // [m]
constexpr float lane_spacing = 6; // [m]
constexpr float half_size = 0.5f; // of the racers [m]
constexpr float enlarged = 1000;  // how much the trace exaggerates
constexpr float trace_above = 2.2f;
constexpr float highest_trace = 1.8f; // drawn [m]

enum class FloorKind
{
    OnePiece,
    Bodies,
    Shapes,
    Chain,
    Uneven
};

struct FloorName
{
    FloorKind kind;
    const char* text;
};
constexpr std::array floors = {
    FloorName{FloorKind::OnePiece, "one box"},
    FloorName{FloorKind::Bodies, "boxes, each a body of its own"},
    FloorName{FloorKind::Shapes, "boxes of one body"},
    FloorName{FloorKind::Chain, "a chain of segments"},
    FloorName{FloorKind::Uneven, "boxes with gaps of 2 mm that differ in height by 0.5 mm"},
};

class Tiles : public Scene
{
public:
    explicit Tiles(const SceneSetup& setup);

private:
    struct Racer
    {
        BodyId body;
        Color color;
        float start_x = 0;
        std::vector<Vec2> trace; ///< place along the lane, height over rest [m]
    };
    struct Lane
    {
        float top = 0; ///< height of the floor [m]
        std::vector<float> seams;
        std::array<Racer, 2> racers;
        float worst = 0; ///< farthest from rest since the start [m]
    };

    void add_floor(Lane& lane, FloorKind kind);
    void add_racers(Lane& lane);
    void start(const Lane& lane, Racer& racer);
    void start_all();

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    void draw_lane(const Lane& lane, const char* text, DrawList& list) const;
    std::string status() const override;

    Random random_;
    std::vector<Lane> lanes_;
};

Tiles::Tiles(const SceneSetup& setup) : Scene(setup, {}), random_(seed(), 1)
{
    for (std::size_t i = 0; i < floors.size(); ++i)
    {
        Lane& lane = lanes_.emplace_back();
        lane.top = -lane_spacing * static_cast<float>(i);
        add_floor(lane, floors[i].kind);
        add_racers(lane);
    }
    camera_ =
        framed(world(), {{-1, -lane_spacing * static_cast<float>(floors.size() - 1) - 1}, {lane_length + 1, trace_above + highest_trace}});
}

/// Tiles of many widths, and room before and behind the part that is raced over.
void Tiles::add_floor(Lane& lane, FloorKind kind)
{
    lane.seams = {-5};
    while (lane.seams.back() < lane_length + 5) lane.seams.push_back(lane.seams.back() + random_.uniform(0.5f, 1.5f));
    const float middle = lane.top - 0.5f;
    const auto body_at = [&](Vec2 position) { return world().create_body({.type = BodyType::Static, .position = position}); };
    const auto width_of = [&](std::size_t i) { return lane.seams[i + 1] - lane.seams[i]; };
    const auto middle_of = [&](std::size_t i) { return 0.5f * (lane.seams[i] + lane.seams[i + 1]); };
    const std::size_t count = lane.seams.size() - 1;

    switch (kind)
    {
    case FloorKind::OnePiece:
    {
        const float width = lane.seams.back() - lane.seams.front();
        world().create_shape(body_at({lane.seams.front() + 0.5f * width, middle}), box(width, 1));
        lane.seams.clear();
        return;
    }
    case FloorKind::Bodies:
        for (std::size_t i = 0; i < count; ++i) world().create_shape(body_at({middle_of(i), middle}), box(width_of(i), 1));
        return;
    case FloorKind::Shapes:
    {
        const BodyId body = body_at({});
        for (std::size_t i = 0; i < count; ++i) world().create_shape(body, offset_box(width_of(i), 1, {middle_of(i), middle}));
        return;
    }
    case FloorKind::Chain:
    {
        std::vector<Vec2> points;
        for (std::size_t i = lane.seams.size(); i-- > 0;) points.push_back({lane.seams[i], lane.top});
        world().create_chain(body_at({}), {.points = points, .sides = ChainSides::OneSided});
        return;
    }
    case FloorKind::Uneven:
        for (std::size_t i = 0; i < count; ++i)
        {
            const float lower = random_.uniform(0, 0.0005f);
            world().create_shape(body_at({middle_of(i), middle - lower}), box(width_of(i) - 0.002f, 1));
        }
        return;
    }
}

void Tiles::add_racers(Lane& lane)
{
    const ShapeDef slippery{.material = {.friction = 0}};
    const float place = random_.uniform(0, 1);
    lane.racers[0] = {
        .body = world().create_body({}, circle(half_size), slippery), .color = rgb(0.96f, 0.62f, 0.25f), .start_x = 5 + place, .trace = {}};
    lane.racers[1] = {.body = world().create_body({}, box(2 * half_size, 2 * half_size), slippery),
                      .color = rgb(0.36f, 0.70f, 0.93f),
                      .start_x = 1 + place,
                      .trace = {}};
    for (Racer& racer : lane.racers) start(lane, racer);
}

void Tiles::start(const Lane& lane, Racer& racer)
{
    Body body = world().body(racer.body);
    body.set_transform({racer.start_x, lane.top + half_size}, 0);
    body.set_linear_velocity({real("speed"), 0});
    body.set_angular_velocity(0);
    racer.trace.clear();
}

void Tiles::start_all()
{
    for (Lane& lane : lanes_)
    {
        lane.worst = 0;
        for (Racer& racer : lane.racers) start(lane, racer);
    }
}

void Tiles::on_parameter(std::string_view name)
{
    if (name == "speed") start_all();
}

void Tiles::on_pointer(const PointerEvent& event)
{
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left || !may_add_at(event.position)) return;
    world().create_body({.position = event.position}, rounded_box(0.8f, 0.8f, 0.1f), {.density = 0.2f});
}

void Tiles::on_key(std::string_view name)
{
    if (name == "space") return start_all();
    const ParameterInfo& speed = find_parameter(parameters().infos(), "speed");
    const float factor = name == "up" ? 1.25f : 0.8f;
    set_parameter("speed", std::clamp(static_cast<double>(real("speed") * factor), speed.min, speed.max));
}

void Tiles::after_step(const StepReport&)
{
    for (Lane& lane : lanes_)
        for (Racer& racer : lane.racers)
        {
            const Vec2 position = world().body(racer.body).position();
            const float rise = position.y - lane.top - half_size;
            const bool is_on_lane = position.x > -4 && position.x < lane_length && std::abs(rise) < 0.5f * lane_spacing;
            if (!is_on_lane)
            {
                start(lane, racer);
                continue;
            }
            lane.worst = std::max(lane.worst, std::abs(rise));
            racer.trace.push_back({position.x, rise});
            if (racer.trace.size() > 4000) racer.trace.erase(racer.trace.begin(), racer.trace.begin() + 2000); // it stands still
        }
}

void Tiles::draw_lane(const Lane& lane, const char* text, DrawList& list) const
{
    const float zero = lane.top + trace_above;
    list.line(Layer::Background, {0, zero}, {lane_length, zero}, with_alpha(paper, 0.15f), 1);
    for (const float x : lane.seams) list.line(Layer::Marks, {x, lane.top}, {x, lane.top - 0.35f}, with_alpha(paper, 0.5f), 1.5f);
    for (const Racer& racer : lane.racers)
    {
        const auto at = [&](Vec2 p) { return Vec2{p.x, zero + std::clamp(enlarged * p.y, -highest_trace, highest_trace)}; };
        for (std::size_t i = 1; i < racer.trace.size(); ++i)
            list.line(Layer::Trails, at(racer.trace[i - 1]), at(racer.trace[i]), racer.color, 2);
    }
    std::array<char, 160> line;
    std::snprintf(line.data(), line.size(), "%s: ball %.2f m/s, box %.2f m/s, at most %.2f mm from rest", text,
                  static_cast<double>(world().body(lane.racers[0].body).linear_velocity().x),
                  static_cast<double>(world().body(lane.racers[1].body).linear_velocity().x), static_cast<double>(1000 * lane.worst));
    list.text({.text = line.data(), .size = 17, .place = Place::World, .position = {0.5f * lane_length, lane.top - 1.7f}});
}

void Tiles::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const BodyId body = world().shape(id).body();
        if (world().body(body).type() == BodyType::Static)
        {
            const bool is_line = std::holds_alternative<Segment>(geometry);
            return list.shape(Layer::Bodies, geometry, transform,
                              {.fill = slate, .line = is_line ? lighter(slate, 0.4f) : Color{}, .line_width = 3});
        }
        Color color = rgb(0.6f, 0.6f, 0.65f);
        for (const Lane& lane : lanes_)
            for (const Racer& racer : lane.racers)
                if (racer.body == body) color = racer.color;
        list.shape(Layer::Bodies, geometry, transform, {.fill = color, .line = darker(color, 0.35f)});
    });
    for (std::size_t i = 0; i < lanes_.size(); ++i) draw_lane(lanes_[i], floors[i].text, list);
}

std::string Tiles::status() const
{
    return "lines: height over rest, enlarged " + std::to_string(static_cast<int>(enlarged)) + " times; started at " +
           to_text(std::round(10 * real("speed")) / 10.0) + " m/s, no friction";
}

} // namespace

SceneInfo tiles_scene()
{
    return {
        .name = "tiles",
        .title = "Tiles",
        .description =
            "A ball and a box race over five floors: one box, boxes that are bodies of their own, boxes of one body, a chain, and "
            "boxes with gaps and steps. Nothing trips on a seam.",
        .group = "Terrain",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a box"},
            {Control::Kind::Key, "space", "start again"},
            {Control::Kind::Key, "up", "start again, faster"},
            {Control::Kind::Key, "down", "start again, slower"},
        }),
        .parameters = with_common_parameters({
            real("speed", {1, 15, 50}, "m/s", Applies::Live, "with which the racers start"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Tiles>(setup); },
        .own_code = "racers that reach the end start again",
    };
}

} // namespace carom::scenes
