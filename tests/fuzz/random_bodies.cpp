// Random calls that make, change and destroy bodies, shapes and chains.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace carom::fuzz
{

/// Empty when the maker of a shape refused, as it should have.
std::optional<Geometry> RandomApi::made_geometry()
{
    ++tally_.calls;
    draw_.forget();
    try
    {
        const Geometry made = draw_.geometry();
        if (draw_.is_by_hand()) return made; // and judged by the call that gets it
        EXPECT_NE(draw_.verdict(), Verdict::Refuse) << "a maker accepted a bad argument";
        draw_.forget(); // what a maker made, everyone takes
        return made;
    }
    catch (const UsageError& error)
    {
        ++tally_.refused;
        expect_complete(error, error.function().c_str());
        EXPECT_NE(draw_.verdict(), Verdict::Accept) << "a maker refused good arguments: " << error.what();
        return std::nullopt;
    }
}

void RandomApi::create()
{
    const std::optional<Geometry> geometry = made_geometry();
    if (!geometry) return;
    if (world_.body_count() >= 150 || draw_.random.one_in(3))
        create_shape(*geometry);
    else
        create_body(*geometry);
    tally_.most_bodies = std::max(tally_.most_bodies, world_.body_count());
}

void RandomApi::create_shape(const Geometry& geometry)
{
    try_call("create_shape", [&]
    {
        const BodyId body = body_id();
        shapes_.push_back(world_.create_shape(body, geometry, draw_.shape_def(geometry)));
        if (draw_.random.one_in(4)) shape_views_.push_back(world_.shape(shapes_.back()));
    });
}

void RandomApi::create_body(const Geometry& geometry)
{
    const bool is_bare = draw_.random.one_in(10);
    if (is_bare) draw_.forget(); // the geometry does not matter
    try_call("create_body", [&]
    {
        const BodyDef def = draw_.body_def();
        bodies_.push_back(is_bare ? world_.create_body(def) : world_.create_body(def, geometry, draw_.shape_def(geometry)));
        const Body body = world_.body(bodies_.back());
        for (const ShapeId id : body.shapes()) shapes_.push_back(id);
        if (draw_.random.one_in(4)) body_views_.push_back(body);
    });
}

void RandomApi::destroy()
{
    if (draw_.random.one_in(2))
        try_call("destroy_shape", [&]
        {
            const ShapeId id = shape_id();
            if (const std::optional<Shape> shape = world_.find_shape(id)) draw_.expect(!shape->chain());
            world_.destroy_shape(id);
        });
    else
        try_call("destroy_body", [&] { world_.destroy_body(body_id()); });
}

void RandomApi::edit_body()
{
    const std::optional<Body> found = world_.find_body(any_body());
    if (!found) return;
    Body body = *found;
    const bool is_static = body.type() == BodyType::Static;
    switch (draw_.random.below(12))
    {
    case 0:
        try_call("set_type", [&]
        {
            const BodyType type = draw_.one_of<BodyType>(3, 20);
            draw_.doubt(type == BodyType::Dynamic && with_own_mass_.contains(body.id())); // a dynamic body needs some mass
            body.set_type(type);
        });
        return;
    case 1: try_call("set_transform", [&] { body.set_transform(draw_.vector(15), draw_.number(-10, 10, finite)); }); return;
    case 2:
        try_call("set_linear_velocity", [&]
        {
            const Vec2 velocity = draw_.vector(20, speed);
            draw_.expect(!is_static || velocity == Vec2{});
            body.set_linear_velocity(velocity);
        });
        return;
    case 3:
        try_call("set_angular_velocity", [&]
        {
            const float spin = draw_.number(-20, 20, speed);
            draw_.expect(!is_static || spin == 0);
            body.set_angular_velocity(spin);
        });
        return;
    case 4: try_call("set_linear_damping", [&] { body.set_linear_damping(draw_.number(0, 1, rate)); }); return;
    case 5: try_call("set_angular_damping", [&] { body.set_angular_damping(draw_.number(0, 1, rate)); }); return;
    case 6: try_call("set_gravity_scale", [&] { body.set_gravity_scale(draw_.number(-1, 1, factor)); }); return;
    case 7:
        try_call("set_mass_data", [&]
        {
            const bool is_dynamic = body.type() == BodyType::Dynamic;
            const float mass = draw_.number(0, 10, {is_dynamic ? 1e-12f : 0, 1e20f});
            const float inertia = draw_.number(0, 10, {is_dynamic ? 1e-24f : 0, 1e20f});
            body.set_mass_data({mass, draw_.vector(1), inertia});
            with_own_mass_.insert(body.id());
        });
        return;
    case 8: try_call("reset_mass_data", [&] { body.reset_mass_data(); }); return;
    default: edit_flags(body); return;
    }
}

void RandomApi::edit_flags(Body body)
{
    const bool flag = draw_.random.one_in(2);
    switch (draw_.random.below(9))
    {
    case 8:
        try_call("move_to", [&]
        {
            const Transform target = draw_.frame();
            const float dt = draw_.number(0.002f, 0.05f, {1e-6f, 1});
            draw_.expect(body.type() == BodyType::Kinematic);
            draw_.doubt(dt < 1e-5f || !(distance(target.p, body.position()) < 5e5f * dt)); // perhaps too fast
            body.move_to(target, dt);
        });
        return;
    case 0: try_call("set_locks", [&] { body.set_locks({flag, draw_.random.one_in(2), draw_.random.one_in(2)}); }); return;
    case 1: try_call("set_is_attractor", [&] { body.set_is_attractor(flag); }); return;
    case 2: try_call("set_enabled", [&] { body.set_enabled(!draw_.random.one_in(3)); }); return;
    case 3: try_call("set_awake", [&] { body.set_awake(flag); }); return;
    case 4: try_call("set_can_sleep", [&] { body.set_can_sleep(flag); }); return;
    case 5: try_call("set_is_bullet", [&] { body.set_is_bullet(flag); }); return;
    case 6: try_call("set_name", [&] { body.set_name("another name that is too long for a short string"); }); return;
    default: try_call("set_user_data", [&] { body.set_user_data(draw_.random.bits()); }); return;
    }
}

void RandomApi::push_body()
{
    const std::optional<Body> found = world_.find_body(any_body());
    if (!found) return;
    Body body = *found;
    switch (draw_.random.below(6))
    {
    case 0: try_call("apply_force", [&] { body.apply_force(draw_.vector(100, finite), draw_.vector(10)); }); return;
    case 1: try_call("apply_force_to_center", [&] { body.apply_force_to_center(draw_.vector(100, finite)); }); return;
    case 2: try_call("apply_torque", [&] { body.apply_torque(draw_.number(-50, 50, finite)); }); return;
    case 3: try_call("apply_impulse", [&] { body.apply_impulse(draw_.vector(10, finite), draw_.vector(10)); }); return;
    case 4: try_call("apply_impulse_to_center", [&] { body.apply_impulse_to_center(draw_.vector(10, finite)); }); return;
    default: try_call("apply_angular_impulse", [&] { body.apply_angular_impulse(draw_.number(-5, 5, finite)); }); return;
    }
}

void RandomApi::edit_shape()
{
    std::optional<Shape> found = world_.find_shape(shape_id());
    draw_.forget();
    if (!found) return;
    Shape shape = *found;
    switch (draw_.random.below(7))
    {
    case 0: try_call("set_material", [&] { shape.set_material(draw_.material()); }); return;
    case 1: try_call("set_filter", [&] { shape.set_filter({draw_.random.bits() & 3, draw_.random.bits() & 3, 0}); }); return;
    case 2:
        try_call("set_geometry", [&]
        {
            const Geometry geometry = draw_.circle_by_hand();
            draw_.expect(!shape.chain());
            draw_.judge_density(geometry, shape.density());
            shape.set_geometry(geometry);
        });
        return;
    case 3:
        try_call("set_density", [&]
        {
            const float density = draw_.unjudged(0, 5);
            draw_.judge_density(shape.geometry(), density);
            shape.set_density(density);
        });
        return;
    case 4: try_call("set_hit_events", [&] { shape.set_hit_events(draw_.random.one_in(2)); }); return;
    case 5: try_call("set_pre_solve", [&] { shape.set_pre_solve(draw_.random.one_in(2)); }); return;
    default: try_call("set_user_data", [&] { shape.set_user_data(draw_.random.bits()); }); return;
    }
}

void RandomApi::make_chain()
{
    try_call("create_chain", [&]
    {
        const int count = draw_.random.one_in(20) ? draw_.random.below(3) : 2 + draw_.random.below(12);
        const bool is_loop = draw_.random.one_in(3);
        draw_.expect(count >= (is_loop ? 3 : 2));
        std::vector<Vec2> points;
        Vec2 point = draw_.vector(5);
        for (int i = 0; i < count; ++i)
        {
            draw_.expect(std::abs(point.x) <= max_coordinate && std::abs(point.y) <= max_coordinate);
            points.push_back(point);
            point += Vec2{draw_.unjudged(0.1f, 2), draw_.unjudged(-1, 1)};
        }
        const int segments = is_loop ? count : count - 1;
        for (std::size_t i = 0; static_cast<int>(i) < segments; ++i)
        {
            const Vec2 next = points[i + 1 < points.size() ? i + 1 : 0];
            const double apart = std::hypot(double{next.x} - double{points[i].x}, double{next.y} - double{points[i].y});
            draw_.expect(!(apart < 0.99e-3));
            draw_.doubt(apart < 1.01e-3);
        }
        const int materials = draw_.random.one_in(2) ? 0 : draw_.random.one_in(2) ? 1 : draw_.random.below(count + 1);
        draw_.expect(materials <= 1 || materials == segments);
        std::vector<Material> surfaces;
        for (int i = 0; i < materials; ++i) surfaces.push_back(draw_.material());
        const BodyId body = body_id();
        chains_.push_back(world_.create_chain(body, {.points = points,
                                                     .is_loop = is_loop,
                                                     .sides = draw_.one_of<ChainSides>(2, 40),
                                                     .materials = surfaces,
                                                     .hit_events = draw_.random.one_in(3),
                                                     .pre_solve = draw_.random.one_in(3),
                                                     .user_data = draw_.random.bits()}));
        const Chain chain = world_.chain(chains_.back());
        shapes_.push_back(chain.segments().front()); // to be edited, and refused, as shapes
        shapes_.push_back(chain.segments().back());
        chain_views_.push_back(chain);
        const auto is_live = [&](ChainId id) { return world_.find_chain(id).has_value(); };
        tally_.most_chains = std::max(tally_.most_chains, static_cast<int>(std::ranges::count_if(chains_, is_live)));
    });
}

void RandomApi::edit_chain()
{
    if (draw_.random.one_in(4))
    {
        try_call("destroy_chain", [&] { world_.destroy_chain(chain_id()); });
        return;
    }
    const std::optional<Chain> found = world_.find_chain(chain_id());
    draw_.forget();
    if (!found) return;
    Chain chain = *found;
    EXPECT_EQ(chain.segments().size(), static_cast<std::size_t>(chain.segment_count()));
    for (const ShapeId id : chain.segments())
    {
        EXPECT_EQ(world_.shape(id).chain(), chain.id());
        EXPECT_EQ(world_.shape(id).body(), chain.body());
    }
    switch (draw_.random.below(4))
    {
    case 0: try_call("set_material", [&] { chain.set_material(draw_.material()); }); return;
    case 1:
        try_call("set_material", [&]
        {
            const int segment = draw_.random.below(16) - 1;
            draw_.expect(segment >= 0 && segment < chain.segment_count());
            chain.set_material(segment, draw_.material());
        });
        return;
    case 2: try_call("set_filter", [&] { chain.set_filter({draw_.random.bits() & 3, draw_.random.bits() & 3, 0}); }); return;
    default: try_call("set_user_data", [&] { chain.set_user_data(draw_.random.bits()); }); return;
    }
}

} // namespace carom::fuzz
