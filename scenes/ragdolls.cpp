// Ragdolls: bodies of eleven limbs whose joints bend as far as ours do, tumbling down a slide and stairs, and through pegs.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/painted_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float lost_beyond = 60; // where a doll that was thrown out is taken away [m]
constexpr double row_every = 1.2; // [s]
constexpr int most_dolls = 200;
/// Where the feet of the dolls of a row are: above the slide and above the pegs.
constexpr std::array drop_places = {Vec2{-10.6f, 9.2f}, Vec2{-6.6f, 8}, Vec2{4.6f, 7.6f}, Vec2{8.8f, 7.6f}};

/// A limb is a capsule between two points of a doll that stands upright with its feet at the origin and looks to the right.
struct Limb
{
    Vec2 from;
    Vec2 to;
    float radius;
    int part_of;  ///< the limb that it hangs on, -1 for none
    Vec2 joint;   ///< where
    Range bend;   ///< [rad], forwards counts as the drawing below has it
    bool is_bare; ///< skin, or cloth
};

//        o        head 1
//        |        chest 0, from which all hangs
//      --+--      arms 3-6: forearms bend forwards (to the left of the arm, > 0)
//        |        pelvis 2
//       / \       legs 7-10: knees bend backwards (< 0)
constexpr std::array limbs = {
    Limb{{0, 1.28f}, {0, 1.46f}, 0.17f, -1, {}, {}, false},
    Limb{{0, 1.78f}, {0, 1.84f}, 0.13f, 0, {0, 1.64f}, {-0.6f, 0.5f}, true},
    Limb{{0, 1.02f}, {0, 1.08f}, 0.16f, 0, {0, 1.17f}, {-0.3f, 0.8f}, false},
    Limb{{0, 1.48f}, {0, 1.26f}, 0.08f, 0, {0, 1.50f}, {-1.2f, 3.0f}, false},
    Limb{{0, 1.16f}, {0, 0.92f}, 0.06f, 3, {0, 1.21f}, {0, 2.5f}, true},
    Limb{{0, 1.48f}, {0, 1.26f}, 0.08f, 0, {0, 1.50f}, {-1.2f, 3.0f}, false},
    Limb{{0, 1.16f}, {0, 0.92f}, 0.06f, 5, {0, 1.21f}, {0, 2.5f}, true},
    Limb{{0, 0.92f}, {0, 0.62f}, 0.10f, 2, {0, 0.96f}, {-0.5f, 2.1f}, false},
    Limb{{0, 0.48f}, {0, 0.10f}, 0.08f, 7, {0, 0.55f}, {-2.4f, 0}, false},
    Limb{{0, 0.92f}, {0, 0.62f}, 0.10f, 2, {0, 0.96f}, {-0.5f, 2.1f}, false},
    Limb{{0, 0.48f}, {0, 0.10f}, 0.08f, 9, {0, 0.55f}, {-2.4f, 0}, false},
};

class Ragdolls : public PaintedScene
{
public:
    explicit Ragdolls(const SceneSetup& setup);

private:
    struct Doll
    {
        std::array<BodyId, limbs.size()> bodies;
    };

    void add_course();
    void drop_row();
    bool drop_doll(Vec2 place);
    void add_doll(Vec2 feet, float angle);

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void before_step() override;
    void on_draw(DrawList& list) const override;
    void after_step(const StepReport& report) override;
    std::string status() const override;

    Random random_;
    std::vector<Doll> dolls_;
    int made_ = 0;        ///< dolls so far: each has a collision group of its own
    int waiting_ = 0;     ///< dolls of the start that have not been dropped yet
    double next_row_ = 0; ///< when they are [s]
};

Ragdolls::Ragdolls(const SceneSetup& setup) : PaintedScene(setup, {}), random_(seed(), 1)
{
    camera_ = framed(world(), {{-12.5f, -0.6f}, {12.5f, 11.5f}});
    add_course();
    waiting_ = integer("dolls");
    drop_row();
}

/// The places are so far apart that no two dolls touch, however they are turned.
void Ragdolls::drop_row()
{
    next_row_ = time() + row_every;
    for (const Vec2 place : drop_places)
        if (waiting_ > 0 && drop_doll(place)) --waiting_;
}

/// @return false when another doll is in the way
bool Ragdolls::drop_doll(Vec2 place)
{
    const Vec2 feet = place + Vec2{random_.uniform(-0.4f, 0.4f), 0};
    const float angle = random_.uniform(-1.2f, 1.2f);
    const float size = real("size");
    const Vec2 middle = feet + Vec2{0, size};
    const auto is_near = [&](const Doll& doll)
    {
        const BodyView chest = world().body(doll.bodies[0]);
        return distance(chest.center_of_mass(), middle) < 1.5f * size;
    };
    if (std::any_of(dolls_.begin(), dolls_.end(), is_near)) return false;
    add_doll(feet, angle);
    return true;
}

void Ragdolls::add_course()
{
    const ShapeDef stone{.material = {.friction = 0.5f}};
    add_static(offset_box(60, 4, {0, -2}), stone);
    for (const float side : {-13.4f, 13.4f}) add_static(offset_box(1, 30, {side, 14}), stone);
    // A slide to stairs, and pegs over a ramp.
    add_static(offset_box(8.6f, 0.4f, {-8.6f, 7.4f}, -0.3f), {.material = {.friction = 0.1f}});
    for (int i = 0; i < 7; ++i)
    {
        const float height = 3.5f - 0.5f * static_cast<float>(i);
        add_static(offset_box(1.1f, height, {-5.2f + 1.1f * static_cast<float>(i), 0.5f * height}), stone);
    }
    for (int row = 0; row < 3; ++row)
    {
        for (int i = 0; i < 4; ++i)
        {
            const Vec2 place{3.4f + 2.4f * static_cast<float>(i) + 1.2f * static_cast<float>(row % 2),
                             6.3f - 1.6f * static_cast<float>(row)};
            add_static(circle(0.28f, place), stone);
        }
    }
    add_static(convex_hull(std::array{Vec2{8, 0}, Vec2{13, 0}, Vec2{13, 1.4f}}), stone);
}

void Ragdolls::add_doll(Vec2 feet, float angle)
{
    ++made_;
    const float size = real("size");
    const float stiffness = real("stiffness") * size * size * size;
    const Color shirt = from_hue(0.13f * static_cast<float>(made_), 0.5f, 0.55f);
    const Color skin = rgb(0.90f, 0.74f, 0.60f);
    const Rot q = rotation(angle);
    const Vec2 middle = size * Vec2{0, 1};
    // The body's origin is where its doll's feet are, turned about the doll's middle.
    const Vec2 origin = feet + middle - rotate(q, middle);
    const ShapeDef flesh{.material = {.friction = 0.5f, .rolling_resistance = 0.1f}, .filter = {.group = -made_}};
    Doll doll;
    for (std::size_t i = 0; i < limbs.size(); ++i)
    {
        const Limb& limb = limbs[i];
        const Color color = limb.is_bare ? skin : (i > 6 || i == 2 ? darker(shirt, 0.35f) : shirt);
        doll.bodies[i] =
            add({.position = origin, .angle = angle}, capsule(size * limb.from, size * limb.to, size * limb.radius), color, flesh);
        if (limb.part_of < 0) continue;
        const BodyId parent = doll.bodies[static_cast<std::size_t>(limb.part_of)];
        const Vec2 joint = size * limb.joint;
        world().create_joint({.body_a = parent, .body_b = doll.bodies[i], .frame_a = {joint, {}}, .frame_b = {joint, {}}},
                             RevoluteJoint{.limit = limb.bend, .motor = Motor{0, stiffness}});
    }
    dolls_.push_back(doll);
}

void Ragdolls::on_pointer(const PointerEvent& event)
{
    const bool is_click = event.action == PointerEvent::Action::Down && event.button == PointerEvent::Button::Left;
    if (grabber_.on_pointer(world(), event) || !is_click || !may_add_at(event.position)) return;
    if (dolls_.size() >= most_dolls) return say("There are " + std::to_string(most_dolls) + " dolls; no more are made.");
    const float angle = random_.uniform(-1, 1);
    add_doll(event.position - Vec2{0, real("size")}, angle);
}

void Ragdolls::on_key(std::string_view)
{
    if (dolls_.size() >= most_dolls) return say("There are " + std::to_string(most_dolls) + " dolls; no more are made.");
    const auto place = static_cast<std::size_t>(random_.integer(0, static_cast<int>(drop_places.size()) - 1));
    if (!drop_doll(drop_places[place])) say("A doll is in the way.");
}

void Ragdolls::before_step()
{
    if (waiting_ > 0 && time() >= next_row_) drop_row();
}

void Ragdolls::after_step(const StepReport&)
{
    std::erase_if(dolls_, [&](const Doll& doll)
    {
        const Vec2 place = world().body(doll.bodies[0]).position();
        const bool is_lost = std::abs(place.x) > lost_beyond || std::abs(place.y) > lost_beyond;
        if (is_lost)
            for (const BodyId body : doll.bodies) world().destroy_body(body);
        return is_lost;
    });
}

void Ragdolls::on_draw(DrawList& list) const
{
    draw_painted(world(), colors_, list);
    grabber_.draw(world(), list);
}

std::string Ragdolls::status() const
{
    float worst = 0;
    for (const JointId id : world().joints()) worst = std::max(worst, world().joint(id).error());
    return std::to_string(dolls_.size()) + " dolls of " + std::to_string(limbs.size()) + " limbs; joints are open by at most " +
           std::to_string(static_cast<int>(std::round(1000 * worst))) + " mm";
}

} // namespace

SceneInfo ragdolls_scene()
{
    return {
        .name = "ragdolls",
        .title = "Ragdolls",
        .description = "Dolls of eleven limbs tumble down a slide and stairs, and through pegs. Their joints bend only as far as ours.",
        .group = "Joints",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "drag a doll, or add one where there is none"},
            {Control::Kind::Key, "space", "drop another doll"},
        }),
        .parameters = with_common_parameters(
            {
                integer("dolls", {0, 12, most_dolls}, "", Applies::OnRestart, "that fall at the start, four at a time"),
                real("size", {0.5, 1.15, 2}, "", Applies::Live, "of the next doll: 1 is 1.97 m"),
                real("stiffness", {0, 1.5, 50}, "N m", Applies::Live,
                     "of the next doll's joints: torque against bending, for a doll of size 1"),
            },
            BroadPhaseType::Tree, 8),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Ragdolls>(setup); },
        .drags_bodies = true,
        .own_code = "further dolls are dropped, and lost ones taken away",
    };
}

} // namespace carom::scenes
