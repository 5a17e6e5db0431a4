// Mass ratio: heavy boxes on towers of light ones, heavy balls on light chains, and by how much each gives way.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr int links = 10;            // of a chain
constexpr float link_length = 0.6f;  // [m]
constexpr float ball_radius = 0.45f; // [m]
constexpr float hook_height = 9;     // [m]
constexpr float tilt = 0.4f;         // of the chains when they are let go [rad]

class MassRatio : public Scene
{
public:
    explicit MassRatio(const SceneSetup& setup);

private:
    struct Specimen
    {
        Vec2 label;
        float ratio;
        BodyId end;
        float height = 0;            ///< of a tower's top box at the start [m]
        std::vector<JointId> joints; ///< of a chain
    };

    void add_tower(float x, float ratio);
    void add_chain(float x, float ratio);
    float give_of(const Specimen& specimen) const;

    void on_key(std::string_view name) override;
    void on_draw(DrawList& list) const override;

    Random random_;
    PerShape<Color> colors_; ///< the ground has none
    std::vector<Specimen> specimens_;
};

MassRatio::MassRatio(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -9.81f}}), random_(seed(), 1)
{
    const BodyId ground = world().create_body({.type = BodyType::Static, .name = "ground"});
    world().create_shape(ground, offset_box(80, 6, {0, -3}));
    for (int i = 0; i < 3; ++i)
    {
        const float ratio = real("heaviest") * std::pow(0.1f, static_cast<float>(2 - i));
        add_tower(-9 + 2.5f * static_cast<float>(i), ratio);
        add_chain(2 + 4 * static_cast<float>(i), ratio);
    }
    camera_ = framed(world(), {{-10, -0.6f}, {10, 9.5f}});
}

void MassRatio::add_tower(float x, float ratio)
{
    const int light = integer("tower");
    Specimen tower{.label = {x, static_cast<float>(light) + 1.6f}, .ratio = ratio, .end = {}, .joints = {}};
    for (int i = 0; i <= light; ++i)
    {
        tower.height = static_cast<float>(i) + 0.5f;
        tower.end = world().create_body({.position = {x, tower.height}});
        const ShapeId shape = world().create_shape(tower.end, box(1, 1), {.density = i == light ? ratio : 1});
        colors_[shape] = from_hue(i == light ? 0.02f : 0.56f, 0.55f, 0.6f);
    }
    specimens_.push_back(tower);
}

void MassRatio::add_chain(float x, float ratio)
{
    const float angle = tilt + random_.uniform(-0.05f, 0.05f);
    const SinCos v = sin_cos(angle);
    const Vec2 down{v.sin, -v.cos};
    const Vec2 hook{x, hook_height};
    const Polygon link = box(0.12f, link_length);
    const float density = 1 / (0.12f * link_length); // a link has 1 kg
    Specimen chain{.label = {x, hook_height + 0.6f}, .ratio = ratio, .end = {}, .joints = {}};
    for (int i = 0; i <= links; ++i)
    {
        const bool is_ball = i == links;
        const Vec2 pivot = hook + link_length * static_cast<float>(i) * down;
        const Vec2 position = pivot + (is_ball ? ball_radius : 0.5f * link_length) * down;
        const Filter apart{.group = -1};
        const BodyId body = world().create_body({.position = position, .angle = angle});
        const ShapeId shape = is_ball ? world().create_shape(body, circle(ball_radius),
                                                             {.density = ratio / (pi * ball_radius * ball_radius), .filter = apart})
                                      : world().create_shape(body, link, {.density = density, .filter = apart});
        colors_[shape] = from_hue(is_ball ? 0.02f : 0.56f, 0.55f, 0.6f);
        chain.joints.push_back(world().create_joint(world().joint_at(chain.end, body, pivot), RevoluteJoint{}));
        chain.end = body;
    }
    specimens_.push_back(chain);
}

/// How far a tower has sunk, or the gaps of all a chain's joints together [m].
float MassRatio::give_of(const Specimen& specimen) const
{
    if (specimen.joints.empty()) return specimen.height - world().body(specimen.end).position().y;
    float gaps = 0;
    for (const JointId joint : specimen.joints) gaps += world().joint(joint).error();
    return gaps;
}

void MassRatio::on_key(std::string_view)
{
    for (const Specimen& specimen : specimens_)
    {
        if (specimen.joints.empty()) continue;
        Body ball = world().body(specimen.end);
        ball.set_linear_velocity(ball.linear_velocity() + Vec2{2, 0});
    }
}

void MassRatio::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        const Color fill = color ? *color : slate;
        list.shape(Layer::Bodies, geometry, transform, {.fill = fill, .line = darker(fill, 0.35f)});
    });
    for (const Specimen& specimen : specimens_)
    {
        const std::string ratio = to_text(std::round(10 * static_cast<double>(specimen.ratio)) / 10) + " : 1";
        const std::string give = to_text(std::round(1e4 * static_cast<double>(give_of(specimen))) / 10) + " mm";
        list.text({.text = ratio, .place = Place::World, .position = specimen.label + Vec2{0, 0.5f}});
        list.text({.text = give, .place = Place::World, .position = specimen.label});
    }
}

} // namespace

SceneInfo mass_ratio_scene()
{
    return {
        .name = "mass-ratio",
        .title = "Mass ratios",
        .description = "Towers and chains whose last body is many times heavier than the others, with the sag or stretch of each.",
        .group = "Statics",
        .controls = with_common_controls({{Control::Kind::Key, "space", "push the balls"}}),
        .parameters = with_common_parameters({
            real("heaviest", {1, 1000, 10000}, "", Applies::OnRestart, "largest ratio of masses; the others are a tenth and a hundredth"),
            integer("tower", {1, 3, 10}, "", Applies::OnRestart, "light boxes under a heavy one"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<MassRatio>(setup); },
    };
}

} // namespace carom::scenes
