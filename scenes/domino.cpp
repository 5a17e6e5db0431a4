// Domino: four rows fall one stone after the other, along the flat, over a hill, down stairs, and from small to large.
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

constexpr float row_length = 9;       // [m]
constexpr float row_height = 6;       // from a lower row to an upper one [m]
constexpr float hill_height = 0.25f;  // [m]
constexpr float stairs_height = 1.5f; // from the first stair to the last [m]
constexpr float run_out = 3.4f;       // of the ground, for the last stone [m]
constexpr float push_speed = 4;       // that the top of a stone of 1 m gets [m/s]
constexpr Color ground_color = slate;

enum class Course
{
    Flat,
    Hill,
    Stairs,
    Growing
};
struct Row
{
    Course course;
    Vec2 start; ///< of its ground, left [m]
};
constexpr std::array rows = {
    Row{Course::Flat, {-13, row_height}},
    Row{Course::Hill, {-13, 0}},
    Row{Course::Stairs, {0.5f, row_height}},
    Row{Course::Growing, {0.5f, 0}},
};

/// How high the hill is at a place from 0 to 1 of its length [m].
float hill(float t) { return hill_height * 16 * t * t * (1 - t) * (1 - t); }
/// Its slope.
float hill_slope(float t) { return hill_height * 32 * t * (1 - t) * (1 - 2 * t) / row_length; }

class Domino : public Scene
{
public:
    explicit Domino(const SceneSetup& setup);

private:
    struct Stone
    {
        BodyId body;
        Vec2 position;
        float angle;
    };

    void add_row(std::size_t row);
    void add_stone(std::size_t row, Vec2 foot, float angle, float height);
    void set_up();
    void start();
    void push(BodyId body, float speed);
    int fallen() const;

    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void on_draw(DrawList& list) const override;
    std::string status() const override;

    Random random_;
    BodyId ground_;
    std::vector<Stone> stones_; ///< row by row, from left to right
    PerShape<Color> colors_;    ///< the ground has none
};

Domino::Domino(const SceneSetup& setup) : Scene(setup, {.gravity = {0, -9.81f}}), random_(seed(), 1)
{
    ground_ = world().create_body({.type = BodyType::Static, .name = "ground"});
    for (std::size_t row = 0; row < rows.size(); ++row) add_row(row);
    start();
    camera_ = framed(world(), {{-13, -2.5f}, {13, 9}});
}

void Domino::add_row(std::size_t row)
{
    const auto [course, start] = rows[row];
    const int count = integer("stones");
    const float pitch = row_length / static_cast<float>(count);
    const float height = std::min(pitch, 0.9f) / 0.42f;
    const float last = static_cast<float>(count - 1);
    if (course == Course::Hill)
    {
        std::vector<Vec2> points;
        for (int i = 32; i >= 0; --i)
        {
            const float t = static_cast<float>(i) / 32;
            points.push_back(start + Vec2{row_length * t, hill(t)});
        }
        world().create_chain(ground_, {.points = points});
        world().create_shape(ground_, offset_box(run_out, 0.4f, start + Vec2{row_length + 0.5f * run_out, -0.2f}));
    }
    else if (course != Course::Stairs)
        world().create_shape(ground_, offset_box(row_length + run_out, 0.4f, start + Vec2{0.5f * (row_length + run_out), -0.2f}));

    if (course == Course::Stairs)
        world().create_shape(ground_, offset_box(run_out, 0.4f, start + Vec2{row_length + 0.5f * run_out, -stairs_height - 0.2f}));

    float x = 0;
    for (int i = 0; i < count; ++i)
    {
        // The stones grow, and the row is as long as the others.
        const float size = course == Course::Growing ? 0.6f + 0.8f * static_cast<float>(i) / last : 1.0f;
        const float room = size * pitch;
        const Vec2 middle = start + Vec2{x + 0.5f * room + random_.uniform(-0.02f, 0.02f) * room, 0};
        const float t = (middle.x - start.x) / row_length;
        x += room;
        if (course == Course::Hill)
            add_stone(row, middle + Vec2{0, hill(t)}, atan2(hill_slope(t), 1), size * height);
        else if (course == Course::Stairs)
        {
            const float down = stairs_height * static_cast<float>(i) / last;
            world().create_shape(ground_, offset_box(room, 0.4f, {start.x + x - 0.5f * room, start.y - down - 0.2f}));
            add_stone(row, middle - Vec2{0, down}, 0, size * height);
        }
        else
            add_stone(row, middle, 0, size * height);
    }
}

/// @param foot the middle of its base
void Domino::add_stone(std::size_t row, Vec2 foot, float angle, float height)
{
    const Vec2 position = foot + rotate(rotation(angle), Vec2{0, 0.5f * height});
    const BodyId body = world().create_body({.position = position, .angle = angle});
    const ShapeId shape = world().create_shape(body, box(0.15f * height, height), {.material = {.friction = real("friction")}});
    colors_[shape] = from_hue(0.1f + 0.25f * static_cast<float>(row) + 0.004f * static_cast<float>(stones_.size()), 0.55f, 0.6f);
    stones_.push_back({.body = body, .position = position, .angle = angle});
}

/// All stones stand again.
void Domino::set_up()
{
    for (const Stone& stone : stones_)
    {
        Body body = world().body(stone.body);
        body.set_transform(stone.position, stone.angle);
        body.set_linear_velocity({});
        body.set_angular_velocity(0);
    }
}

/// Pushes the first stone of every row.
void Domino::start()
{
    for (std::size_t row = 0; row < rows.size(); ++row) push(stones_[row * stones_.size() / rows.size()].body, push_speed);
}

/// Tips a stone about its base.
/// @param speed of the top of a stone of 1 m to the right [m/s]; larger ones go faster, as they fall slower
void Domino::push(BodyId id, float speed)
{
    Body body = world().body(id);
    const float height = std::max(2 * (body.bounds().max.y - body.position().y), 0.1f);
    const float top = speed * std::sqrt(height);
    body.set_linear_velocity({0.5f * top, 0});
    body.set_angular_velocity(-top / height);
}

void Domino::on_pointer(const PointerEvent& event)
{
    if (event.action != PointerEvent::Action::Down) return;
    const bool is_left = event.button == PointerEvent::Button::Left;
    if (!is_left && event.button != PointerEvent::Button::Right) return;
    const std::optional<ShapeId> shape = shape_at(world(), event.position);
    if (!shape) return say("There is no stone there.");
    push(world().shape(*shape).body(), is_left ? push_speed : -push_speed);
}

void Domino::on_key(std::string_view name)
{
    if (name == "s") set_up();
    if (name == "space") start();
}

void Domino::on_draw(DrawList& list) const
{
    for_each_shape(world(), [&](ShapeId id, const Geometry& geometry, const Transform& transform)
    {
        if (std::holds_alternative<Segment>(geometry))
            return list.shape(Layer::Bodies, geometry, transform, {.line = ground_color, .line_width = 6});
        const Color* color = colors_.find(id);
        if (!color) return list.shape(Layer::Bodies, geometry, transform, {.fill = ground_color});
        list.shape(Layer::Bodies, geometry, transform, {.fill = *color, .line = darker(*color, 0.35f)});
    });
}

int Domino::fallen() const
{
    return static_cast<int>(std::count_if(stones_.begin(), stones_.end(), [&](const Stone& stone)
    {
        constexpr float leaning = 0.6f; // [rad]
        return std::abs(world().body(stone.body).angle() - stone.angle) > leaning;
    }));
}

std::string Domino::status() const { return std::to_string(fallen()) + " of " + std::to_string(stones_.size()) + " stones have fallen"; }

} // namespace

SceneInfo domino_scene()
{
    return {
        .name = "domino",
        .title = "Domino",
        .description =
            "Four rows of stones fall one after the other: along the flat, over a hill, down stairs, and each stone onto a larger one.",
        .group = "Gravity",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "push a stone to the right"},
            {Control::Kind::Pointer, "right", "push a stone to the left"},
            {Control::Kind::Key, "s", "set all stones up again"},
            {Control::Kind::Key, "space", "push the first stone of every row"},
        }),
        .parameters = with_common_parameters({
            integer("stones", {8, 10, 40}, "", Applies::OnRestart, "in a row"),
            real("friction", {0.1, 0.5, 2}, "", Applies::OnRestart, "of the stones: Coulomb's coefficient"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Domino>(setup); },
    };
}

} // namespace carom::scenes
