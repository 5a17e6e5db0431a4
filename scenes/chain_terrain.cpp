// Chain terrain: a landscape from one chain whose stretches have materials of their own. Balls, boxes and capsules roll and slide over it.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float half_width = 42;       // of the landscape [m]
constexpr float segment_length = 0.5f; // along x [m]
constexpr float lost_below = -30;      // height at which a body that left the landscape is taken away [m]
constexpr float lost_beyond = 200;     // distance to the side at which it is too [m]

/// What a stretch of the ground is made of.
struct Ground
{
    const char* name;
    Color color;
    Material material;
};
const std::array grounds = {
    Ground{"grass", rgb(0.36f, 0.66f, 0.36f), {.friction = 0.7f}},
    Ground{"ice", rgb(0.62f, 0.86f, 0.98f), {.friction = 0.01f}},
    Ground{"mud", rgb(0.55f, 0.40f, 0.27f), {.friction = 1, .rolling_resistance = 0.35f}},
    Ground{"rubber", rgb(0.93f, 0.42f, 0.62f), {.friction = 0.6f, .restitution = 0.8f}},
    Ground{"conveyor", rgb(0.95f, 0.76f, 0.30f), {.friction = 1, .tangent_speed = 4}},
};
constexpr float stretch_length = 12; // of one ground [m]

class ChainTerrain : public Scene
{
public:
    explicit ChainTerrain(const SceneSetup& setup);

private:
    float height_at(float x) const;
    static std::size_t ground_at(float x);
    void add_landscape();
    void add_body(Vec2 position);

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    std::array<float, 3> phases_ = {};
    std::vector<Vec2> points_; ///< left to right
    ChainId chain_;
    std::vector<BodyId> bodies_;
    PerShape<Color> colors_;
};

ChainTerrain::ChainTerrain(const SceneSetup& setup) : Scene(setup, {}), random_(seed(), 1)
{
    for (float& phase : phases_) phase = random_.uniform(-pi, pi);
    add_landscape();
    // A rain that lasts for a while.
    for (int i = 0; i < integer("bodies"); ++i)
    {
        const float x = random_.uniform(-half_width + 9, half_width - 9);
        add_body({x, 12 + 0.7f * static_cast<float>(i)});
    }
    camera_ = framed({{-half_width, -8}, {half_width, 29}});
}

float ChainTerrain::height_at(float x) const
{
    const float hills = 2.2f * sin_cos(0.16f * x + phases_[0]).sin + 1.1f * sin_cos(0.37f * x + phases_[1]).sin +
                        0.35f * sin_cos(0.9f * x + phases_[2]).sin;
    // High walls at the sides keep things in.
    const float beyond = std::max(std::abs(x) - (half_width - 8), 0.0f);
    return hills + 0.22f * beyond * beyond;
}

std::size_t ChainTerrain::ground_at(float x)
{
    const int stretch = static_cast<int>((x + half_width + stretch_length) / stretch_length);
    return static_cast<std::size_t>(stretch) % grounds.size();
}

void ChainTerrain::add_landscape()
{
    const int count = static_cast<int>(2 * half_width / segment_length);
    for (int i = 0; i <= count; ++i)
    {
        const float x = -half_width + segment_length * static_cast<float>(i);
        points_.push_back({x, height_at(x)});
    }
    // The front of a one-sided chain is on the right of its way: from right to left, that is above.
    const std::vector<Vec2> leftwards(points_.rbegin(), points_.rend());
    std::vector<Material> materials;
    for (std::size_t i = 1; i < leftwards.size(); ++i)
        materials.push_back(grounds[ground_at(0.5f * (leftwards[i - 1].x + leftwards[i].x))].material);
    const BodyId body = world().create_body({.type = BodyType::Static, .name = "landscape"});
    chain_ = world().create_chain(body, {.points = leftwards, .sides = ChainSides::OneSided, .materials = materials});
}

void ChainTerrain::add_body(Vec2 position)
{
    const float size = random_.uniform(0.7f, 1.5f);
    const int kind = random_.integer(0, 3);
    const Geometry geometry = kind == 0   ? Geometry(circle(0.5f * size))
                              : kind == 1 ? Geometry(box(size, 0.8f * size))
                              : kind == 2 ? Geometry(capsule({-0.3f * size, 0}, {0.3f * size, 0}, 0.3f * size))
                                          : Geometry(random_polygon(random_, 0.55f * size));
    const float speed = random_.uniform(-6, 6);
    const BodyId body = world().create_body({.position = position, .linear_velocity = {speed, 0}});
    const ShapeId shape = world().create_shape(body, geometry);
    colors_[shape] = from_hue(random_.uniform(0.5f, 1.1f), 0.55f, 0.6f);
    bodies_.push_back(body);
}

void ChainTerrain::after_step(const StepReport&)
{
    std::erase_if(bodies_, [&](BodyId body)
    {
        const Vec2 position = world().body(body).position();
        const bool is_lost = position.y < lost_below || std::abs(position.x) > lost_beyond;
        if (is_lost) world().destroy_body(body);
        return is_lost;
    });
}

void ChainTerrain::on_pointer(const PointerEvent& event)
{
    if (event.action == PointerEvent::Action::Down && event.button == PointerEvent::Button::Left && may_add_at(event.position))
        add_body(event.position);
}

void ChainTerrain::on_key(std::string_view)
{
    for (const BodyId body : bodies_) world().destroy_body(body);
    bodies_.clear();
}

void ChainTerrain::on_draw(DrawList& list) const
{
    // The earth below, a little darker than the surface, and the surface in the colour of its ground.
    for (std::size_t i = 1; i < points_.size(); ++i)
    {
        const Vec2 a = points_[i - 1];
        const Vec2 b = points_[i];
        const Color color = grounds[ground_at(0.5f * (a.x + b.x))].color;
        const float depth = -60;
        const float over = 0.05f; // the next strip covers the seam
        const std::array<Vec2, 4> strip = {Vec2{a.x, depth}, Vec2{b.x + over, depth}, Vec2{b.x + over, b.y}, a};
        list.shape(Layer::Background, convex_hull(strip), {}, {.fill = darker(color, 0.78f)});
        list.line(Layer::Bodies, a, b, color, 4);
    }
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        if (!color) return; // the landscape
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f)});
        if (const auto* disc = std::get_if<Circle>(&geometry)) // a spoke, to see it roll
            list.line(Layer::Marks, transform.p, transform * Vec2{0.95f * disc->radius, 0}, darker(*color, 0.4f));
    });
    for (float x = -half_width; x < half_width; x += stretch_length)
    {
        const float middle = x + 0.5f * stretch_length;
        if (middle > half_width) break;
        const Ground& ground = grounds[ground_at(middle)];
        list.text(
            {.text = ground.name, .color = lighter(ground.color, 0.25f), .size = 20, .place = Place::World, .position = {middle, -8}});
    }
}

std::string ChainTerrain::status() const
{
    return std::to_string(bodies_.size()) + " bodies on one chain of " + std::to_string(world().chain(chain_).segment_count()) +
           " segments";
}

} // namespace

SceneInfo chain_terrain_scene()
{
    return {
        .name = "chain-terrain",
        .title = "Chain terrain",
        .description =
            "A landscape from one chain of segments, whose stretches are of grass, ice, mud, rubber and a conveyor. What rolls or slides "
            "over it does not catch on the corners.",
        .group = "Terrain",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a shape"},
            {Control::Kind::Key, "c", "clear: take away everything but the landscape"},
        }),
        .parameters = with_common_parameters({
            integer("bodies", {0, 80, 2000}, "", Applies::OnRestart, "that rain down"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<ChainTerrain>(setup); },
        .own_code = "bodies that fall out of the scene are taken away",
    };
}

} // namespace carom::scenes
