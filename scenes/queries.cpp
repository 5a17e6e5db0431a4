// Queries: what a world answers while its bodies move. A scanner of rays, a box that is cast, and at the pointer the shapes that overlap, the
// nearest point, and explosions.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace carom::scenes
{

namespace
{

constexpr Aabb field = {{-15.6f, -8.6f}, {15.6f, 8.6f}};
constexpr Vec2 scanner{-9, 0};       // where the rays start [m]
constexpr Vec2 caster{9, -6.5f};     // where the box starts that is cast [m]
constexpr float far_away = 40;       // longer than the field is wide [m]
constexpr double between_bursts = 4; // explosions by itself, until a person clicks [s]
constexpr double burst_seconds = 0.5;

constexpr Color ray_color = rgb(0.30f, 0.85f, 0.95f);
constexpr Color cast_color = rgb(0.98f, 0.62f, 0.22f);
constexpr Color overlap_color = rgb(1.0f, 0.84f, 0.25f);
constexpr Color burst_color = rgb(1.0f, 0.42f, 0.30f);

const Geometry cast_box = rounded_box(1.2f, 0.7f, 0.1f);

Vec2 direction(double turns)
{
    const Rot q = rotation(2 * pi * static_cast<float>(turns - std::floor(turns)));
    return {q.c, q.s};
}

class Queries : public Scene
{
public:
    explicit Queries(const SceneSetup& setup);

private:
    void add_drifters(int count);
    void burst(Vec2 at);
    void draw_scan(DrawList& list) const;
    void draw_cast(DrawList& list) const;
    void draw_pointer(DrawList& list) const;

    void on_pointer(const PointerEvent& event) override;
    void before_step() override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    PerShape<Color> colors_;
    Vec2 pointer_ = {3, 2};
    float radius_ = 1.6f;      ///< of the circle at the pointer [m]
    bool has_pointer_ = false; ///< a person has moved it; until then it goes round by itself
    bool has_clicked_ = false;
    double next_burst_ = 1;
    Vec2 burst_at_;
    double burst_time_ = -10;
    int burst_count_ = 0; ///< shapes that the last one pushed
};

Queries::Queries(const SceneSetup& setup) : Scene(setup, {.gravity = {}}), random_(seed(), 1)
{
    camera_ = framed_field(field);
    add_walls(world(), field, {.friction = 0, .restitution = 1});
    add_drifters(integer("bodies"));
}

void Queries::add_drifters(int count)
{
    for (int i = 0; i < count; ++i)
    {
        // Apart from each other, from the scanner and from the caster: a query finds the room.
        for (int attempt = 0; attempt < 200; ++attempt)
        {
            const Vec2 at = random_.point_in(expanded(field, -1));
            const float size = random_.uniform(0.35f, 0.85f);
            const bool is_free = world().overlapping(circle(size + 0.1f), {at, {}}).empty();
            if (!is_free || distance(at, scanner) < 1.6f || distance(at, caster) < 1.6f) continue;
            const float speed = real("speed") * random_.uniform(0.3f, 1);
            const Vec2 velocity = speed * random_.direction();
            const BodyId body = world().create_body({.position = at,
                                                     .angle = random_.uniform(-pi, pi),
                                                     .linear_velocity = velocity,
                                                     .angular_velocity = 0.5f,
                                                     .linear_damping = 0.02f});
            const Geometry geometry = i % 3 == 0   ? Geometry{circle(size)}
                                      : i % 3 == 1 ? Geometry{capsule({-0.5f * size, 0}, {0.5f * size, 0}, 0.5f * size)}
                                                   : Geometry{random_polygon(random_, size)};
            const ShapeId shape = world().create_shape(body, geometry, {.material = {.friction = 0.1f, .restitution = 0.9f}});
            colors_[shape] = from_hue(random_.uniform(0.55f, 0.75f), 0.35f, 0.45f);
            break;
        }
    }
}

void Queries::on_pointer(const PointerEvent& event)
{
    has_pointer_ = true;
    pointer_ = max(field.min, min(field.max, event.position));
    if (event.action == PointerEvent::Action::Wheel)
        radius_ = std::clamp(radius_ * (1 + 0.1f * std::clamp(event.wheel, -5.0f, 5.0f)), 0.1f, 6.0f);
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left) return;
    has_clicked_ = true;
    burst(pointer_);
}

void Queries::burst(Vec2 at)
{
    burst_count_ = world().explode({.center = at, .radius = 1, .falloff = 4, .impulse_per_metre = real("blast")});
    burst_at_ = at;
    burst_time_ = time();
}

void Queries::before_step()
{
    const auto t = static_cast<float>(time());
    if (!has_pointer_) pointer_ = {2 + 10 * sin_cos(0.41f * t).sin, 5.5f * sin_cos(0.67f * t).sin};
    if (has_clicked_ || time() < next_burst_) return;
    burst(pointer_);
    next_burst_ = time() + between_bursts;
}

/// All rays of the scanner are cast as one batch.
void Queries::draw_scan(DrawList& list) const
{
    const int count = integer("rays");
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) rays.push_back({scanner, far_away * direction(static_cast<double>(i) / count + 0.01 * time())});
    std::vector<std::optional<RayHit>> hits(rays.size());
    world().cast_rays(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
        if (!hits[i]) continue;
        // A bright beam goes round as a radar's.
        const double behind = 0.25 * time() - static_cast<double>(i) / count - 0.01 * time();
        const auto glow = static_cast<float>(1 - (behind - std::floor(behind)));
        list.line(Layer::Trails, scanner, hits[i]->point, with_alpha(ray_color, 0.10f + 0.5f * glow * glow * glow * glow), 1);
        list.disc(Layer::Marks, hits[i]->point, 0.05f, {.fill = ray_color});
        list.line(Layer::Marks, hits[i]->point, hits[i]->point + 0.22f * hits[i]->normal, with_alpha(ray_color, 0.7f), 1);
    }
    list.disc(Layer::Marks, scanner, 0.22f, {.fill = ray_color});
    list.text({.text = "rays", .color = ray_color, .size = 16, .place = Place::World, .position = scanner + Vec2{0, 0.55f}});
}

/// The box where it starts, where it is stopped, and the way in between.
void Queries::draw_cast(DrawList& list) const
{
    const double t = time();
    const Vec2 way = far_away * direction(0.31 + 0.12 * static_cast<double>(sin_cos(static_cast<float>(0.5 * t)).sin));
    const Transform start = {caster, rotation(static_cast<float>(0.4 * t))};
    const auto hit = world().cast_shape(cast_box, start, way);
    const Vec2 end = caster + (hit ? hit->fraction : 1) * way;
    const Vec2 along = normalize(way);
    // The silhouette: the outermost points to either side of the way.
    float left = 0;
    float right = 0;
    const Polygon& box = std::get<Polygon>(cast_box);
    for (const Vec2 corner : std::span(box.vertices).first(static_cast<std::size_t>(box.count)))
    {
        left = std::max(left, dot(rotate(start.q, corner), left_perp(along)) + box.radius);
        right = std::min(right, dot(rotate(start.q, corner), left_perp(along)) - box.radius);
    }
    for (const float side : {left, right})
        list.line(Layer::Trails, caster + side * left_perp(along), end + side * left_perp(along), with_alpha(cast_color, 0.6f));
    list.shape(Layer::Marks, cast_box, start, {.fill = with_alpha(cast_color, 0.25f), .line = cast_color});
    list.shape(Layer::Marks, cast_box, {end, start.q}, {.fill = with_alpha(cast_color, 0.55f), .line = cast_color});
    if (hit)
    {
        list.disc(Layer::Marks, hit->point, 0.09f, {.fill = paper});
        list.line(Layer::Marks, hit->point, hit->point + 0.6f * hit->normal, paper, 2);
    }
    list.text({.text = "a box is cast", .color = cast_color, .size = 16, .place = Place::World, .position = caster + Vec2{0, -1.0f}});
}

void Queries::draw_pointer(DrawList& list) const
{
    const Geometry probe = circle(radius_);
    world().visit_overlapping(probe, {pointer_, {}}, [&](ShapeId id)
    {
        const ShapeView shape = world().shape(id);
        const BodyView body = world().body(shape.body());
        if (body.type() != BodyType::Static)
            list.shape(Layer::Bodies, shape.geometry(), body.transform(),
                       {.fill = with_alpha(overlap_color, 0.75f), .line = overlap_color});
    });
    list.disc(Layer::Marks, pointer_, radius_, {.fill = with_alpha(overlap_color, 0.06f), .line = overlap_color});
    if (const auto nearest = world().closest_point(pointer_, far_away))
    {
        list.line(Layer::Marks, pointer_, nearest->point, paper, 2);
        list.disc(Layer::Marks, nearest->point, 0.1f, {.fill = paper});
    }
    list.text({.text = "overlaps, nearest point",
               .color = overlap_color,
               .size = 16,
               .place = Place::World,
               .position = pointer_ + Vec2{0, radius_ + 0.35f}});
    const auto age = static_cast<float>((time() - burst_time_) / burst_seconds);
    if (age > 1) return;
    list.disc(Layer::Marks, burst_at_, 1 + 4 * age,
              {.fill = with_alpha(burst_color, 0.25f * (1 - age)), .line = with_alpha(burst_color, 1 - age), .line_width = 3});
}

void Queries::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        list.shape(Layer::Bodies, geometry, transform,
                   color ? Paint{.fill = *color, .line = lighter(*color, 0.25f)} : Paint{.fill = slate});
    });
    draw_scan(list);
    draw_cast(list);
    draw_pointer(list);
}

std::string Queries::status() const
{
    int overlaps = 0;
    world().visit_overlapping(circle(radius_), {pointer_, {}}, [&overlaps](ShapeId) { ++overlaps; });
    return std::to_string(integer("rays")) + " rays, " + std::to_string(overlaps) + " shapes in the circle, " +
           std::to_string(burst_count_) + " pushed by the last explosion";
}

} // namespace

SceneInfo queries_scene()
{
    return {
        .name = "queries",
        .title = "Queries",
        .description =
            "Bodies drift about while the world is asked: a scanner sees by rays, a box is cast until something stops it, and at the "
            "pointer shine the shapes that overlap a circle, with a line to the nearest point of all. A click sets off an explosion.",
        .group = "Queries",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "move", "move the circle"},
            {Control::Kind::Pointer, "wheel", "make the circle larger or smaller"},
            {Control::Kind::Pointer, "left", "explode"},
        }),
        .parameters = with_common_parameters({
            integer("bodies", {0, 45, 400}, "", Applies::OnRestart, "that drift about, as far as there is room"),
            integer("rays", {1, 240, 5000}, "", Applies::Live, "of the scanner"),
            real("speed", {0, 1.5, 20}, "m/s", Applies::OnRestart, "of the fastest body"),
            real("blast", {-50, 6, 50}, "N s/m", Applies::Live, "impulse of an explosion on each metre of width"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Queries>(setup); },
        .own_code = "bursts push the bodies",
    };
}

} // namespace carom::scenes
