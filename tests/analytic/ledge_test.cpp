// What overhangs the corner of a ledge rests, slides on and slides off as it would on one solid box, whatever the ledge is made of.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace carom::ledge_test
{

namespace
{

constexpr float edge = 4; ///< x of the corner [m]
constexpr float top = 2;  ///< y of the corner [m]

/// Makes a ledge: its top runs from x = 0 to the edge, its wall from the edge down to y = 0. The body is a fixed one to put shapes on.
struct Ledge
{
    const char* name;
    std::function<void(World&, BodyId)> make;
};

BodyId another(World& world, BodyId like) { return world.create_body({.type = BodyType::Static, .angle = world.body(like).angle()}); }

void add_chain(World& world, BodyId body, const std::vector<Vec2>& points, ChainSides sides)
{
    world.create_chain(body, {.points = points, .sides = sides});
}

std::vector<Vec2> from_wall_to_top(int pieces)
{
    std::vector<Vec2> points;
    for (int i = 0; i < pieces; ++i) points.push_back({edge, top * static_cast<float>(i) / static_cast<float>(pieces)});
    for (int i = 0; i <= pieces; ++i) points.push_back({edge - edge * static_cast<float>(i) / static_cast<float>(pieces), top});
    return points;
}

const std::vector<Ledge>& ledges()
{
    static const std::vector<Ledge> all = {
        {"one box", [](World& w, BodyId b) { w.create_shape(b, offset_box(edge, top, {2, 1})); }},
        {"boxes of one body",
         [](World& w, BodyId b)
    {
        w.create_shape(b, offset_box(3.9f, top, {1.95f, 1}));
        w.create_shape(b, offset_box(0.1f, top, {3.95f, 1}));
    }},
        {"boxes one on another",
         [](World& w, BodyId b)
    {
        w.create_shape(b, offset_box(edge, 1, {2, 0.5f}));
        w.create_shape(another(w, b), offset_box(edge, 1, {2, 1.5f}));
    }},
        {"box on a wedge",
         [](World& w, BodyId b)
    {
        w.create_shape(b, offset_box(edge, 1, {2, 1.5f}));
        const std::vector<Vec2> wedge = {{edge, top}, {3.9f, 0}, {4.1f, 0}};
        w.create_shape(b, convex_hull(wedge));
    }},
        {"two-sided chain", [](World& w, BodyId b) { add_chain(w, b, from_wall_to_top(1), ChainSides::TwoSided); }},
        {"two-sided chain of many segments", [](World& w, BodyId b) { add_chain(w, b, from_wall_to_top(20), ChainSides::TwoSided); }},
        {"one-sided chain", [](World& w, BodyId b) { add_chain(w, b, from_wall_to_top(1), ChainSides::OneSided); }},
        {"one-sided chain of many segments", [](World& w, BodyId b) { add_chain(w, b, from_wall_to_top(20), ChainSides::OneSided); }},
        {"chain with an overhanging wall",
         [](World& w, BodyId b) { add_chain(w, b, {{3, 0}, {edge, top}, {0, top}}, ChainSides::TwoSided); }},
        {"chain with a sloping wall", [](World& w, BodyId b) { add_chain(w, b, {{5, 0}, {edge, top}, {0, top}}, ChainSides::TwoSided); }},
        {"segments of one body",
         [](World& w, BodyId b)
    {
        w.create_shape(b, segment({edge, 0}, {edge, top}));
        w.create_shape(b, segment({edge, top}, {0, top}));
    }},
        {"segments of two bodies",
         [](World& w, BodyId b)
    {
        w.create_shape(b, segment({edge, top}, {edge, 0}));
        w.create_shape(another(w, b), segment({0, top}, {edge, top}));
    }},
        {"capsules",
         [](World& w, BodyId b)
    {
        w.create_shape(b, capsule({edge, 0}, {edge, top - 0.1f}, 0.1f));
        w.create_shape(b, capsule({edge, top - 0.1f}, {0, top - 0.1f}, 0.1f));
    }},
    };
    return all;
}

struct Slider
{
    const char* name;
    Geometry geometry;
    float half_width;
    float height; ///< of its origin above what it stands on [m]
    float foot;   ///< half the width on which it stands [m]
};

const std::vector<Slider>& sliders()
{
    static const std::vector<Vec2> corners = {{-0.25f, 0}, {0.25f, 0}, {0, 0.4f}};
    static const std::vector<Slider> all = {{"box", box(0.5f, 0.5f), 0.25f, 0.25f, 0.25f},
                                            {"rounded box", rounded_box(0.5f, 0.5f, 0.05f), 0.25f, 0.25f, 0.2f},
                                            {"circle", circle(0.25f), 0.25f, 0.25f, 0},
                                            {"capsule", capsule({-0.15f, 0}, {0.15f, 0}, 0.1f), 0.25f, 0.1f, 0.15f},
                                            {"triangle", convex_hull(corners), 0.25f, 0, 0.25f}};
    return all;
}

/// A slider on a ledge. The ledge stands in a frame of its own, turned with gravity: what happens there doesn't depend on it.
struct Scene
{
    Rot turn;
    World world;
    BodyId body;

    Scene(const Ledge& ledge, const Slider& slider, float overhang, bool is_locked, float angle)
        : turn(rotation(angle)),
          world({.gravity = rotate(turn, Vec2{0, -10})})
    {
        ledge.make(world, world.create_body({.type = BodyType::Static, .angle = angle}));
        const Vec2 at = {edge - slider.half_width + overhang, top + slider.height};
        body = world.create_body({.position = rotate(turn, at), .angle = angle, .locks = {.rotation = is_locked}}, slider.geometry,
                                 {.material = {.friction = 0}});
    }
    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) world.step(dt);
    }
    Vec2 position() const { return inverse_rotate(turn, world.body(body).position()); }
    Vec2 velocity() const { return inverse_rotate(turn, world.body(body).linear_velocity()); }
    bool can_tip() const { return !world.body(body).locks().rotation; }
    void push(float speed) { world.body(body).set_linear_velocity(rotate(turn, Vec2{speed, 0})); }
};

/// Pushed towards the ledge it goes on at its speed and height; pushed over the edge, at its speed at least.
void expect_slides_on(Scene& scene, const World& start_of_push, float speed, float foot)
{
    SCOPED_TRACE(std::to_string(speed) + " m/s");
    scene.world.restore(start_of_push);
    const Vec2 start = scene.position();
    scene.push(speed);
    const bool goes_off = speed > 0;
    const int steps = goes_off ? 40 : std::min(40, static_cast<int>(3 / (-speed * dt)));
    for (int i = 0; i < steps; ++i)
    {
        scene.run(1);
        const float height = scene.position().y - start.y;
        ASSERT_GT(std::copysign(1.0f, speed) * scene.velocity().x, 0.98f * std::abs(speed)) << "step " << i;
        ASSERT_LT(height, 0.001f) << "step " << i;
        if (goes_off && scene.position().x > edge + (scene.can_tip() ? 0 : foot)) continue; // it leaves
        ASSERT_GT(height, -0.001f) << "step " << i;
    }
    const float way = speed * dt * static_cast<float>(steps);
    EXPECT_TRUE(goes_off || std::abs(scene.position().x - start.x - way) < 0.001f + 0.01f * std::abs(way)) << scene.position().x - start.x;
}

/// The overhangs at which the slider stays where it is put: up to that of its middle, or to the end of its foot if it can't tip.
float last_overhang(const Slider& slider, bool is_locked) { return slider.half_width + (is_locked ? slider.foot : 0) - 0.01f; }

void try_ledge(const Ledge& ledge, int overhangs, const std::vector<float>& speeds)
{
    int turns = 0;
    for (const Slider& slider : sliders())
        for (const bool is_locked : {false, true})
            for (int i = 0; i < overhangs; ++i)
            {
                const float share = static_cast<float>(i) / static_cast<float>(overhangs - 1);
                const float overhang = -0.02f + share * (last_overhang(slider, is_locked) + 0.02f);
                SCOPED_TRACE(std::string(ledge.name) + ", " + slider.name + (is_locked ? ", can't turn" : "") + ", overhangs by " +
                             std::to_string(overhang));
                Scene scene(ledge, slider, overhang, is_locked, 0.7f * static_cast<float>(turns++ % 5));
                const Vec2 start = scene.position();
                scene.run(30);
                EXPECT_LT(distance(scene.position(), start), 0.001f) << "at rest";
                const World at_rest = scene.world.copy();
                for (const float speed : speeds)
                    for (const float direction : {-1.0f, 1.0f}) expect_slides_on(scene, at_rest, direction * speed, slider.foot);
                if (testing::Test::HasFailure()) return;
            }
}

} // namespace

TEST(Ledge, what_overhangs_a_corner_rests_and_slides_on)
{
    for (const Ledge& ledge : ledges()) try_ledge(ledge, 5, {0.1f, 2, 10});
}

TEST(Ledge, a_tilted_box_that_cannot_turn_rests_past_the_edge_of_a_one_sided_chain)
{
    for (const float tilt : {-0.02f, -0.001f, -1e-5f, 0.0f, 1e-5f, 0.001f, 0.02f})
    {
        World world({.gravity = {0, -10}});
        add_chain(world, world.create_body({.type = BodyType::Static}), from_wall_to_top(1), ChainSides::OneSided);
        const Vec2 start = {edge + 0.05f, top + 0.25f + 0.2f * std::abs(tilt)}; // its lower corner, or the edge, is just touched
        const BodyId body = world.create_body({.position = start, .angle = tilt, .locks = {.rotation = true}}, box(0.5f, 0.5f),
                                              {.material = {.friction = 1}});
        for (int i = 0; i < 60; ++i) world.step(dt);
        EXPECT_LT(distance(world.body(body).position(), start), 0.01f) << tilt;
    }
}

TEST(Ledge, what_meets_the_end_of_a_one_sided_segment_is_pushed_off_it_and_not_up)
{
    for (const bool is_first_end : {false, true})
        for (const float tilt : {-0.3f, -0.01f, 0.0f, 0.01f, 0.3f})
        {
            World world({.gravity = {}});
            const std::vector<Vec2> shelf = {{2, 0}, {0, 0}}; // solid above
            add_chain(world, world.create_body({.type = BodyType::Static}), shelf, ChainSides::OneSided);
            const float side = is_first_end ? 1.0f : -1.0f;
            const float end = is_first_end ? 2.0f : 0.0f;
            const BodyId body = world.create_body({.position = {end + side * 0.45f, 0.02f}, .angle = tilt}, box(1, 1));
            for (int i = 0; i < 60; ++i) world.step(dt);
            const Vec2 position = world.body(body).position();
            EXPECT_GT(side * (position.x - end), 0.48f) << tilt;
            EXPECT_LT(side * (position.x - end), 0.65f) << tilt;
            EXPECT_NEAR(position.y, 0.02f, 0.05f) << tilt;
        }
}

TEST(Ledge, what_sinks_into_a_one_sided_chain_is_pushed_up_wherever_its_seams_are)
{
    const std::vector<Vec2> points = {{0, -0.3f}, {-0.05f, 0.1f}, {0.05f, 0.1f}};
    for (int i = 0; i < 20; ++i)
    {
        World world({.gravity = {}});
        add_chain(world, world.create_body({.type = BodyType::Static}), from_wall_to_top(20), ChainSides::OneSided);
        // It stands on its tip, which is so deep that the way down is the shorter one.
        const Vec2 start = {2 + 0.02f * static_cast<float>(i), top + 0.04f};
        const BodyId body = world.create_body({.position = start, .locks = {.rotation = true}}, convex_hull(points));
        for (int step = 0; step < 60; ++step) world.step(dt);
        EXPECT_NEAR(world.body(body).position().y, top + 0.3f, 0.02f) << start.x;
    }
}

TEST(SlowLedge, what_overhangs_a_corner_by_any_length_slides_on_at_any_speed)
{
    for (const Ledge& ledge : ledges()) try_ledge(ledge, 40, {0.1f, 0.3f, 1, 2, 5, 10});
}

} // namespace carom::ledge_test
