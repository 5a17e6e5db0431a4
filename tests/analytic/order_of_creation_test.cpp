// What happens doesn't depend on which of two bodies was created first. Every function of a pair sees A and B swapped here: each scene is built
// once in every order of its bodies, and all runs must agree within rounding.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

namespace carom::order_of_creation_test
{

namespace
{

/// Creates one body.
using Part = std::function<BodyId(World&)>;
using Bodies = std::vector<BodyId>;

struct Scene
{
    std::string name;
    std::vector<Part> parts;
    WorldDef def = {.gravity = {0, -10}};
    int steps = 60;
    std::function<void(World&, const Bodies&)> finish = [](World&, const Bodies&) {}; ///< joints between the bodies
    bool times_count = true; ///< whether events must come in the same steps: not where rounding decides when a gap closes
    float tolerance =
        1e-3f; ///< of positions [m] and angles [rad]; ten times that of velocities. The two points of a face are solved in turn, which shows by that much.
};

Part part(const BodyDef& body, const Geometry& shape, const ShapeDef& def = {})
{
    return [=](World& world) { return world.create_body(body, shape, def); };
}

Part fixed(const Geometry& shape, Vec2 position = {}, const ShapeDef& def = {})
{
    return part({.type = BodyType::Static, .position = position}, shape, def);
}

/// An event told by parts, not by ids: its kind, its step, the two parts.
using Note = std::tuple<std::string, int, std::size_t, std::size_t>;

struct Outcome
{
    std::vector<Transform> places;
    std::vector<Vec2> velocities;
    std::vector<float> spins;
    std::vector<Note> notes;
};

class Notebook
{
public:
    Notebook(const World& world, const Bodies& bodies)
    {
        for (const BodyId body : bodies)
        {
            shapes_.emplace_back();
            for (const ShapeId shape : world.body(body).shapes()) shapes_.back().push_back(shape);
        }
    }
    void read(const World& world, int step, std::vector<Note>& notes) const
    {
        const Events events = world.events();
        const auto pair = [&](const char* kind, ShapeId a, ShapeId b)
        { notes.emplace_back(kind, step, std::min(part_of(a), part_of(b)), std::max(part_of(a), part_of(b))); };
        for (const ContactBegin& event : events.contact_begin) pair("begin", event.shape_a, event.shape_b);
        for (const ContactEnd& event : events.contact_end) pair("end", event.shape_a, event.shape_b);
        for (const ContactHit& event : events.contact_hit) pair("hit", event.shape_a, event.shape_b);
        for (const SensorEvent& event : events.sensor_begin)
            notes.emplace_back("seen", step, part_of(event.sensor), part_of(event.visitor));
        for (const SensorEvent& event : events.sensor_end) notes.emplace_back("gone", step, part_of(event.sensor), part_of(event.visitor));
        for (std::size_t i = 0; i < events.joint_break.size(); ++i) notes.emplace_back("break", step, 0, 0);
    }

private:
    std::size_t part_of(ShapeId shape) const
    {
        for (std::size_t i = 0; i < shapes_.size(); ++i)
            if (std::find(shapes_[i].begin(), shapes_[i].end(), shape) != shapes_[i].end()) return i;
        return shapes_.size();
    }
    std::vector<std::vector<ShapeId>> shapes_;
};

Outcome run(const Scene& scene, const std::vector<std::size_t>& order)
{
    World world(scene.def);
    Bodies bodies(scene.parts.size());
    for (const std::size_t i : order) bodies[i] = scene.parts[i](world);
    scene.finish(world, bodies);
    const Notebook notebook(world, bodies);
    Outcome outcome;
    for (int step = 0; step < scene.steps; ++step)
    {
        world.step(dt);
        notebook.read(world, step, outcome.notes);
    }
    for (Note& note : outcome.notes)
        if (!scene.times_count) std::get<1>(note) = 0;
    std::sort(outcome.notes.begin(), outcome.notes.end());
    for (const BodyId id : bodies)
    {
        outcome.places.push_back(world.body(id).transform());
        outcome.velocities.push_back(world.body(id).linear_velocity());
        outcome.spins.push_back(world.body(id).angular_velocity());
    }
    return outcome;
}

void expect_no_order_shows(const Scene& scene)
{
    std::vector<std::size_t> order(scene.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const Outcome reference = run(scene, order);
    while (std::next_permutation(order.begin(), order.end()))
    {
        std::string trace = scene.name + ", created in the order";
        for (const std::size_t i : order) trace += " " + std::to_string(i);
        SCOPED_TRACE(trace);
        const Outcome outcome = run(scene, order);
        EXPECT_EQ(outcome.notes, reference.notes);
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            EXPECT_LT(distance(outcome.places[i].p, reference.places[i].p), scene.tolerance) << "place of part " << i;
            EXPECT_LT(std::abs(angle(relative(reference.places[i].q, outcome.places[i].q))), scene.tolerance) << "angle of part " << i;
            EXPECT_LT(distance(outcome.velocities[i], reference.velocities[i]), 10 * scene.tolerance) << "velocity of part " << i;
            EXPECT_NEAR(outcome.spins[i], reference.spins[i], 10 * scene.tolerance) << "spin of part " << i;
        }
    }
}

std::vector<Geometry> one_of_each_kind()
{
    const std::vector<Vec2> corners = {{-0.4f, -0.3f}, {0.5f, -0.3f}, {0.1f, 0.4f}};
    return {circle(0.3f), capsule({-0.3f, 0}, {0.3f, 0}, 0.2f), box(0.8f, 0.5f), rounded_box(0.8f, 0.5f, 0.1f), convex_hull(corners)};
}

/// Lets pass what shape the user data names, brakes others, and says how named materials mix.
class Rules final : public ContactHooks
{
public:
    World* world = nullptr;
    bool should_collide(ShapeId a, ShapeId b) override { return world->shape(a).user_data() + world->shape(b).user_data() != 9; }
    float mix_friction(const Material& a, const Material& b, float mixed) override { return a.id + b.id == 5 ? 0.9f : mixed; }
    float mix_restitution(const Material& a, const Material& b, float mixed) override { return a.id + b.id == 5 ? 0.5f : mixed; }
    void pre_solve(PreSolve& contact) override
    {
        if (world->shape(contact.shape_a).user_data() + world->shape(contact.shape_b).user_data() == 7) contact.is_enabled = false;
        contact.tangent_speed += 0.5f;
    }
};

} // namespace

TEST(OrderOfCreation, does_not_show_in_the_manifold_of_any_two_shapes)
{
    const std::vector<Geometry> shapes = one_of_each_kind();
    for (const Geometry& first : shapes)
        for (const Geometry& second : shapes)
            for (int turn = 0; turn < 5; ++turn)
            {
                const float angle = 0.7f * static_cast<float>(turn);
                const Part still = part({.position = {0.1f, 0.05f}, .angle = angle, .angular_velocity = 1}, first);
                const Part moving = part({.position = {1.2f, 0.2f}, .angle = 0.3f, .linear_velocity = {-3, 0}, .angular_velocity = -2},
                                         second, {.material = {.restitution = 0.3f, .rolling_resistance = 0.05f}});
                // Of two polygons that two faces separate equally well, A's face gives the normal, and the other one turns a bit differently.
                const bool are_polygons = first.index() == 3 && second.index() == 3;
                expect_no_order_shows({.name = std::to_string(first.index()) + " and " + std::to_string(second.index()),
                                       .parts = {still, moving},
                                       .def = {.gravity = {}},
                                       .steps = 20,
                                       .tolerance = are_polygons ? 0.1f : 1e-3f});
            }
}

TEST(OrderOfCreation, does_not_show_in_how_materials_mix)
{
    for (const Mix rule : {Mix::GeometricMean, Mix::Average, Mix::Minimum, Mix::Maximum, Mix::Product})
        expect_no_order_shows(
            {.name = "belt",
             .parts = {fixed(box(20, 1), {0, -0.5f}, {.material = {.friction = 0.9f, .restitution = 0.2f, .tangent_speed = 1}}),
                       part({.position = {0, 0.6f}, .linear_velocity = {1, -2}}, box(1, 1),
                            {.material = {.friction = 0.2f, .restitution = 0.6f, .tangent_speed = -0.3f}}),
                       part({.position = {3, 0.5f}, .linear_velocity = {2, 0}}, circle(0.5f),
                            {.material = {.friction = 0.4f, .rolling_resistance = 0.1f}})},
             .def = {.gravity = {0, -10}, .mixing = {.friction = rule, .restitution = rule}}});
}

TEST(OrderOfCreation, does_not_show_in_what_filters_let_meet)
{
    for (const Filter& filter : {Filter{.category = 2, .mask = 1}, Filter{.category = 1, .mask = 2}, Filter{.category = 4, .mask = ~0ull},
                                 Filter{.group = 3}, Filter{.group = -3}})
        expect_no_order_shows({.name = "filter",
                               .parts = {fixed(box(20, 1), {0, -0.5f}, {.filter = {.category = 1, .mask = 3, .group = filter.group}}),
                                         part({.position = {0, 1}}, box(1, 1), {.filter = filter}),
                                         part({.position = {0, 2.5f}}, circle(0.5f), {.filter = {.category = 2, .mask = 5}})}});
}

TEST(OrderOfCreation, does_not_show_in_what_sensors_see)
{
    const ShapeDef sensor = {.is_sensor = true};
    for (const float speed : {3.0f, 300.0f}) // slowly, and through within a step
        expect_no_order_shows(
            {.name = "sensors",
             .parts = {fixed(box(0.2f, 4), {2, 0}, sensor), part({.linear_velocity = {speed, 0}}, circle(0.3f)),
                       part({.type = BodyType::Kinematic, .position = {4, 0}, .linear_velocity = {-1, 0}}, box(1, 1), sensor)},
             .def = {.gravity = {}}});
}

TEST(OrderOfCreation, does_not_show_on_one_sided_chains)
{
    const Part chain = [](World& world)
    {
        const BodyId body = world.create_body({.type = BodyType::Static});
        const std::vector<Vec2> points = {{4, -2}, {4, 0}, {0, 0}, {-4, 1}};
        world.create_chain(body, {.points = points, .sides = ChainSides::OneSided});
        return body;
    };
    expect_no_order_shows({.name = "one-sided",
                           .parts = {chain, part({.position = {1, 1}, .linear_velocity = {1, 0}}, box(0.6f, 0.6f)),
                                     part({.position = {-1, -1.5f}, .linear_velocity = {0, 9}}, circle(0.3f)),
                                     part({.position = {3.9f, 0.3f}, .locks = {.rotation = true}}, box(0.5f, 0.5f))},
                           .steps = 40,
                           .tolerance = 5e-3f});
}

TEST(OrderOfCreation, does_not_show_at_internal_edges)
{
    const ShapeDef smooth = {.material = {.friction = 0}};
    expect_no_order_shows({.name = "tiles",
                           .parts = {fixed(box(1, 1), {0, -0.5f}), fixed(box(1, 1), {1, -0.5f}), fixed(segment({1.5f, 0}, {3, 0})),
                                     part({.position = {-0.3f, 0.2f}, .linear_velocity = {2, 0}}, box(0.4f, 0.4f), smooth)}});
    const Part sled = [](World& world)
    {
        const BodyId body = world.create_body({.position = {-0.2f, 0.1f}, .linear_velocity = {3, 0}});
        for (const float x : {-0.2f, 0.0f, 0.2f}) world.create_shape(body, offset_box(0.2f, 0.2f, {x, 0}), {.material = {.friction = 0}});
        return body;
    };
    expect_no_order_shows(
        {.name = "sled", .parts = {fixed(box(1, 1), {0, -0.5f}), fixed(box(9, 1), {5, -0.5f}), sled}, .times_count = false});
}

TEST(OrderOfCreation, does_not_show_in_what_hooks_decide)
{
    Rules rules;
    const auto tagged = [](std::uint64_t tag) { return ShapeDef{.material = {.id = tag}, .pre_solve = true, .user_data = tag}; };
    expect_no_order_shows({.name = "hooks",
                           .parts = {fixed(box(20, 1), {0, -0.5f}, tagged(1)), part({.position = {-3, 1}}, box(1, 1), tagged(4)),
                                     part({.position = {0, 1}}, box(1, 1), tagged(6)), part({.position = {3, 1}}, circle(0.5f), tagged(8))},
                           .def = {.gravity = {0, -10}, .hooks = &rules},
                           .finish = [&](World& world, const Bodies&) { rules.world = &world; }});
}

TEST(OrderOfCreation, does_not_show_in_the_joints_that_break)
{
    for (const bool is_swapped : {false, true})
    {
        const auto pin = [=](World& world, const Bodies& bodies)
        {
            JointDef def = world.joint_at(bodies[is_swapped ? 1 : 0], bodies[is_swapped ? 0 : 1], {1, 0});
            def.break_force = 60;
            world.create_joint(def, RevoluteJoint{});
        };
        expect_no_order_shows({.name = "break",
                               .parts = {fixed(box(1, 1)), part({.position = {2, 0}}, box(1, 1)), part({.position = {2, 6}}, circle(0.5f))},
                               .finish = pin});
    }
}

TEST(OrderOfCreation, does_not_show_in_continuous_collision)
{
    const std::vector<Geometry> shapes = one_of_each_kind();
    for (const bool is_bullet : {false, true})
        for (const Geometry& first : shapes)
            for (const Geometry& second : shapes)
            {
                // They meet in the fourth step. Later they roll over each other at 100 rad/s, and rounding grows.
                const std::string name = std::to_string(first.index()) + " meets " + std::to_string(second.index());
                const Part a = part({.position = {-7, 0.1f}, .angle = 0.4f, .linear_velocity = {150, 0}, .is_bullet = is_bullet}, first);
                const Part b = part({.position = {8, 0}, .linear_velocity = {-160, 0}}, second);
                expect_no_order_shows({.name = name, .parts = {a, b}, .def = {.gravity = {}}, .steps = 5, .tolerance = 0.005f});
            }
}

TEST(OrderOfCreation, does_not_show_in_how_deep_a_bullet_goes)
{
    // Both are fast; seen from each other they move by 4.5 cm a step, less than half of the thinner one's radius.
    const Part target = part({.linear_velocity = {60, 0}}, box(1, 1));
    const Part bullet = part({.position = {-0.63f, 0}, .linear_velocity = {62.7f, 0}, .is_bullet = true}, circle(0.1f));
    float apart[2]; // distance of their middles [m]
    for (int i = 0; i < 2; ++i)
    {
        World world({.gravity = {}});
        const BodyId first = i == 0 ? target(world) : bullet(world);
        const BodyId second = i == 0 ? bullet(world) : target(world);
        world.step(dt);
        apart[i] = std::abs(world.body(first).position().x - world.body(second).position().x);
    }
    EXPECT_NEAR(apart[0], apart[1], 1e-5f);
    EXPECT_GT(apart[0], 0.599f) << "stopped where they touch";
}

TEST(OrderOfCreation, does_not_show_in_what_a_kinematic_body_pushes)
{
    expect_no_order_shows({.name = "pushed",
                           .parts = {part({.type = BodyType::Kinematic, .position = {-9, 0}, .linear_velocity = {200, 0}}, box(0.2f, 4)),
                                     part({}, circle(0.3f)), part({.position = {5, 0.5f}, .linear_velocity = {-20, 0}}, box(0.5f, 0.5f))},
                           .def = {.gravity = {}},
                           .steps = 10,
                           .tolerance = 0.01f});
}

} // namespace carom::order_of_creation_test
