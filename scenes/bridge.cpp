// Bridge: planks pinned together hang between two banks and carry what is dropped on them.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float span = 20;         // from bank to bank [m]
constexpr float rise = 2;          // by which the middle is laid lower than the banks [m]
constexpr float thickness = 0.3f;  // of a plank [m]
constexpr float plank_density = 4; // [kg/m^2]
constexpr float gap = 0.04f;       // between two planks [m]
constexpr float lost_below = -40;  // height at which a load that fell off is taken away [m]
constexpr Aabb field{{-14, 0.8f}, {14, 30}};
constexpr Color wood = rgb(0.72f, 0.52f, 0.33f);

class Bridge : public Scene
{
public:
    explicit Bridge(const SceneSetup& setup);

private:
    void add_banks();
    void add_planks(int count);
    void add_load(Vec2 position);
    void remove_load();
    float sag() const;
    float joint_error() const;

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    BodyId banks_;
    std::vector<BodyId> planks_; ///< from left to right
    std::vector<BodyId> loads_;  ///< in the order in which they were added
    PerShape<Color> colors_;     ///< banks have none
};

Bridge::Bridge(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -9.81f}}), random_(seed(), 1)
{
    add_banks();
    add_planks(integer("planks"));
    for (int i = 0; i < integer("loads"); ++i)
    {
        const float column = static_cast<float>(i % 7) - 3;
        const float row = static_cast<float>(i / 7);
        add_load({2 * column + random_.uniform(-0.4f, 0.4f), 1 + 1.5f * row});
    }
    camera_ = framed(world(), {{-12, -3.5f}, {12, 5.5f}});
}

void Bridge::add_banks()
{
    banks_ = world().create_body({.type = BodyType::Static, .name = "banks"});
    for (const float side : {-1.0f, 1.0f})
    {
        world().create_shape(banks_, offset_box(20, 12, {side * (0.5f * span + 10), 0.5f * thickness - 6}));
        world().create_shape(banks_, offset_box(1, 2, {side * (0.5f * span + 5), 0.5f * thickness + 1})); // a kerb
    }
}

/// Along a parabola, so that the chain has slack and its tension stays finite.
void Bridge::add_planks(int count)
{
    const auto pin = [&](int i)
    {
        const float t = 2 * static_cast<float>(i) / static_cast<float>(count) - 1;
        return Vec2{0.5f * span * t, rise * (t * t - 1)};
    };
    BodyId before = banks_;
    for (int i = 0; i < count; ++i)
    {
        const Vec2 left = pin(i);
        const Vec2 right = pin(i + 1);
        const Vec2 along = right - left;
        const BodyId plank = world().create_body({.position = 0.5f * (left + right), .angle = atan2(along.y, along.x)});
        const Geometry geometry = box(distance(left, right) - gap, thickness);
        colors_[world().create_shape(plank, geometry, {.density = plank_density, .material = {.friction = 0.8f}})] = wood;
        world().create_joint(world().joint_at(before, plank, left), RevoluteJoint{});
        planks_.push_back(plank);
        before = plank;
    }
    world().create_joint(world().joint_at(before, banks_, pin(count)), RevoluteJoint{});
}

void Bridge::add_load(Vec2 position)
{
    const bool is_ball = random_.integer(0, 1) == 1;
    const float size = random_.uniform(0.6f, 1.1f);
    const Geometry geometry = is_ball ? Geometry(circle(0.5f * size)) : Geometry(box(size, size));
    const float turn = random_.uniform(-0.2f, 0.2f);
    const BodyId load = world().create_body({.position = position, .angle = turn});
    const Color color = from_hue(is_ball ? random_.uniform(0.5f, 0.6f) : random_.uniform(0.0f, 0.12f), 0.55f, 0.6f);
    colors_[world().create_shape(load, geometry, {.density = real("density")})] = color;
    loads_.push_back(load);
}

void Bridge::remove_load()
{
    if (loads_.empty()) return say("There is no load left.");
    world().destroy_body(loads_.back());
    loads_.pop_back();
}

void Bridge::on_pointer(const PointerEvent& event)
{
    if (event.action != PointerEvent::Action::Down || event.button != PointerEvent::Button::Left) return;
    if (!contains(field, event.position)) return say("Loads can be dropped only above the bridge.");
    if (may_add_at(event.position)) add_load(event.position);
}

void Bridge::on_key(std::string_view name)
{
    if (name == "x") remove_load();
}

void Bridge::after_step(const StepReport&)
{
    std::erase_if(loads_, [&](BodyId load)
    {
        const bool is_lost = world().body(load).position().y < lost_below;
        if (is_lost) world().destroy_body(load);
        return is_lost;
    });
}

void Bridge::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        if (!color) return list.shape(Layer::Bodies, geometry, transform, {.fill = slate});
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f)});
    });
    for (const JointId id : world().joints())
    {
        const JointView joint = world().joint(id);
        const Vec2 pin = world().body(joint.body_b()).transform() * joint.frame_b().p;
        list.disc(Layer::Marks, pin, 0.07f, {.fill = paper});
    }
}

/// How far the lowest plank is below the banks [m].
float Bridge::sag() const
{
    float lowest = 0;
    for (const BodyId plank : planks_) lowest = std::min(lowest, world().body(plank).position().y);
    return -lowest;
}

/// The largest of all pins [m].
float Bridge::joint_error() const
{
    float largest = 0;
    for (const JointId joint : world().joints()) largest = std::max(largest, world().joint(joint).error());
    return largest;
}

std::string Bridge::status() const
{
    return std::to_string(loads_.size()) + " loads, sag " + to_text(std::round(100 * sag()) / 100.0) + " m, joint error " +
           to_text(std::round(100'000 * joint_error()) / 100.0) + " mm";
}

} // namespace

SceneInfo bridge_scene()
{
    return {
        .name = "bridge",
        .title = "Bridge",
        .description = "Planks pinned together hang between two banks and carry crates and balls. Drop more until it sags.",
        .group = "Joints",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drop a load"},
            {Control::Kind::Key, "x", "take the last load away"},
        }),
        .parameters = with_common_parameters({
            integer("planks", {2, 20, 60}, "", Applies::OnRestart, "from bank to bank"),
            integer("loads", {0, 14, 200}, "", Applies::OnRestart, "at the start"),
            real("density", {0.1, 1, 10}, "kg/m^2", Applies::Live, "of the next load; planks have 4"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Bridge>(setup); },
        .own_code = "bodies that fall out of the scene are taken away",
    };
}

} // namespace carom::scenes
