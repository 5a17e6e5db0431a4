// Card house: thin cards lean on each other, flat ones lie across their tops, and only friction holds them.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>

namespace carom::scenes
{

namespace
{

constexpr float card_length = 1;        // [m]
constexpr float card_thickness = 0.04f; // [m]
constexpr float rounding = 0.015f;      // of its corners [m]
constexpr float ball_radius = 0.25f;    // [m]
constexpr Vec2 thrown_from{-9, 2.5f};   // [m]
constexpr Vec2 throw_velocity{16, 2};   // [m/s]
constexpr Color ball_color = rgb(0.93f, 0.36f, 0.30f);

class CardHouse : public Scene
{
public:
    explicit CardHouse(const SceneSetup& setup);

private:
    struct Card
    {
        BodyId body;
        Vec2 position; ///< at the start
    };

    void add_ground();
    void add_house(int storeys);
    void add_card(Vec2 position, float angle, Color color, float length = card_length);
    void throw_ball(Vec2 position);

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    PerShape<Color> colors_; ///< the ground has none
    std::vector<Card> cards_;
};

CardHouse::CardHouse(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -9.81f}}), random_(seed(), 1)
{
    add_ground();
    add_house(integer("storeys"));
    camera_ = framed(world(), {{-1.9f, -0.1f}, {1.9f, 1}});
}

void CardHouse::add_ground()
{
    const BodyId ground = world().create_body({.type = BodyType::Static, .name = "ground"});
    const ShapeDef felt{.material = {.friction = 0.7f}};
    world().create_shape(ground, offset_box(80, 6, {0, -3}), felt);
}

/// Pairs whose tops meet, feet beside those of the next pair, and a flat card from top to top on which the next storey stands.
void CardHouse::add_house(int storeys)
{
    const float angle = real("lean") * pi / 180;
    const SinCos lean = sin_cos(angle);
    const Vec2 along = (card_length - 2 * rounding) * Vec2{lean.sin, lean.cos};      // of a card that leans to the right
    const Vec2 across = (card_thickness - 2 * rounding) * Vec2{lean.cos, -lean.sin}; // from its left side to its right side
    const float gap = 0.01f;                                                         // between the cards beside each other [m]
    const float spacing = 2 * (along.x + across.x + 2 * rounding) + gap;
    const float pair_height = along.y - across.y + 2 * rounding;
    float foot = 0;
    for (int storey = 0; storey < storeys; ++storey)
    {
        const int pairs = storeys - storey;
        const Color color = from_hue(0.56f + 0.30f * static_cast<float>(storey) / static_cast<float>(storeys), 0.5f, 0.62f);
        for (int i = 0; i < pairs; ++i)
        {
            const float x = spacing * (static_cast<float>(i) - 0.5f * static_cast<float>(pairs - 1));
            // A card stands on its inner lower corner and touches the other with its inner upper one.
            const Vec2 middle{0.5f * (along.x + across.x) + rounding, foot + 0.5f * pair_height};
            add_card({x - middle.x, middle.y}, angle, color);
            add_card({x + middle.x, middle.y}, -angle, color);
        }
        foot += pair_height;
        const int flats = std::max(1, pairs - 1);
        for (int i = 0; i < flats; ++i)
        {
            const float x = spacing * (static_cast<float>(i) - 0.5f * static_cast<float>(flats - 1));
            add_card({x, foot + 0.5f * card_thickness}, 0.5f * pi, darker(color, 0.15f), spacing - gap);
        }
        foot += card_thickness;
    }
}

/// No two weigh quite the same.
/// @param angle from the upright, to the right [rad]
void CardHouse::add_card(Vec2 position, float angle, Color color, float length)
{
    const BodyId body = world().create_body({.position = position, .angle = -angle});
    const ShapeDef paper_board{.density = random_.uniform(0.98f, 1.02f), .material = {.friction = real("friction")}};
    colors_[world().create_shape(body, rounded_box(card_thickness, length, rounding), paper_board)] = color;
    cards_.push_back({body, position});
}

void CardHouse::throw_ball(Vec2 position)
{
    if (!may_add_at(position)) return;
    const BodyId body = world().create_body({.position = position, .linear_velocity = throw_velocity});
    colors_[world().create_shape(body, circle(ball_radius), {.density = 2})] = ball_color;
}

void CardHouse::on_pointer(const PointerEvent& event)
{
    if (event.action == PointerEvent::Action::Down && event.button == PointerEvent::Button::Left) throw_ball(event.position);
}

void CardHouse::on_key(std::string_view) { throw_ball(thrown_from); }

void CardHouse::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        const Color* color = colors_.find(id);
        if (!color) return list.shape(Layer::Bodies, geometry, transform, {.fill = slate});
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f), .line_width = 1});
    });
}

std::string CardHouse::status() const
{
    const auto stands = [&](const Card& card) { return distance(world().body(card.body).position(), card.position) < 0.1f; };
    const auto standing = std::count_if(cards_.begin(), cards_.end(), stands);
    return std::to_string(standing) + " of " + std::to_string(cards_.size()) + " cards stand";
}

} // namespace

SceneInfo card_house_scene()
{
    return {
        .name = "card-house",
        .title = "House of cards",
        .description = "Cards lean on each other, storey upon storey, and friction alone holds them. Throw a ball at it.",
        .group = "Statics",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "throw a ball to the right from there"},
            {Control::Kind::Key, "space", "throw a ball at the house"},
        }),
        .parameters = with_common_parameters({
            integer("storeys", {1, 3, 5}, "", Applies::OnRestart, "of the house"),
            real("lean", {10, 20, 30}, "deg", Applies::OnRestart, "of the cards from the upright"),
            real("friction", {0, 0.7, 2}, "", Applies::OnRestart, "of the cards: Coulomb's coefficient"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<CardHouse>(setup); },
        .is_calm = true,
    };
}

} // namespace carom::scenes
