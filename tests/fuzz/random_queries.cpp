// Random calls that read a world, ask it questions, and walk through it.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace carom::fuzz
{

namespace
{

constexpr Limits sweep_limits = {-2 * max_coordinate, 2 * max_coordinate};

void expect_sound(const World& world, const CastHit& hit)
{
    EXPECT_EQ(world.shape(hit.shape).body(), hit.body);
    EXPECT_TRUE(hit.fraction >= 0 && hit.fraction <= 1) << hit.fraction;
    EXPECT_TRUE(is_finite(hit.point) && is_finite(hit.normal));
    EXPECT_NEAR(length(hit.normal), hit.starts_inside ? 0 : 1, 1e-3f);
    EXPECT_TRUE(world.body(hit.body).is_enabled());
}

} // namespace

void RandomApi::read()
{
    const std::optional<BodyView> body = std::as_const(world_).find_body(any_body());
    if (body)
    {
        EXPECT_TRUE(is_finite(body->position()));
        EXPECT_TRUE(is_finite(body->center_of_mass()));
        EXPECT_TRUE(std::isfinite(body->angle()));
        EXPECT_LE(body->bounds().min.x, body->bounds().max.x);
        try_call("velocity_at", [&] { body->velocity_at(draw_.vector(20, finite)); });
        for (const ShapeId id : body->shapes())
        {
            EXPECT_EQ(world_.shape(id).body(), body->id());
            for (const ShapeId other : world_.shape(id).touching()) EXPECT_TRUE(world_.find_shape(other));
            try_call("contains", [&] { world_.shape(id).contains(draw_.vector(20, finite)); });
        }
    }
    for (const JointId id : world_.joints())
    {
        const JointView joint = std::as_const(world_).joint(id);
        EXPECT_TRUE(is_finite(joint.force()) && std::isfinite(joint.torque()));
        EXPECT_TRUE(is_finite(joint.offset()) && std::isfinite(joint.angle()) && joint.error() >= 0);
        EXPECT_TRUE(world_.find_body(joint.body_b()));
        EXPECT_TRUE(!joint.body_a() || world_.find_body(joint.body_a()));
    }
    try_call("gravity_at", [&] { world_.gravity_at(draw_.vector(20)); });
    try_call("manifold", [&]
    {
        const ShapeId a = shape_id();
        world_.manifold(a, shape_id());
    });
    CuriousVisitor visitor(world_);
    if (draw_.random.one_in(20))
        try_call("debug_draw", [&]
        {
            const auto parts = static_cast<unsigned>(draw_.random.below(130)); // any of the seven, and two that are none
            draw_.expect(parts <= static_cast<unsigned>(DrawPart::All));
            std::as_const(world_).debug_draw(visitor, static_cast<DrawPart>(parts));
        });
}

void RandomApi::cast()
{
    const World& world = world_;
    const QueryFilter filter = draw_.query_filter(any_body());
    const auto start = [&] { return draw_.vector(20); };
    const auto sweep = [&] { return draw_.vector(draw_.random.one_in(4) ? 1000.0f : 20.0f, sweep_limits); };
    switch (draw_.random.below(6))
    {
    case 0:
        try_call("cast_ray", [&]
        {
            const Ray ray = {start(), sweep()};
            const auto hit = world.cast_ray(ray.start, ray.sweep, filter);
            if (hit) expect_sound(world, *hit);
            EXPECT_EQ(world.is_ray_blocked(ray.start, ray.sweep, filter), hit.has_value());
            const std::vector<RayHit> all = world.cast_ray_all(ray.start, ray.sweep, filter);
            ASSERT_EQ(all.empty(), !hit);
            EXPECT_TRUE(!hit || all.front().shape == hit->shape);
        });
        return;
    case 1: try_call("is_ray_blocked", [&] { world.is_ray_blocked(start(), sweep(), filter); }); return;
    case 2:
        try_call("cast_ray_all", [&]
        {
            for (const RayHit& hit : world.cast_ray_all(start(), sweep(), filter)) expect_sound(world, hit);
        });
        return;
    case 3:
        try_call("cast_rays", [&]
        {
            const std::array rays = {Ray{start(), sweep()}, Ray{start(), sweep()}};
            std::array<std::optional<RayHit>, 2> hits;
            const bool is_short = draw_.random.one_in(20);
            draw_.expect(!is_short);
            world.cast_rays(rays, std::span(hits).first(is_short ? 1 : 2), filter);
        });
        return;
    case 4:
        try_call("cast_circle", [&]
        {
            const float size = draw_.number(0.01f, 3, {0.001f, max_coordinate});
            if (const auto hit = world.cast_circle(start(), size, sweep(), filter)) expect_sound(world, *hit);
        });
        return;
    default:
        try_call("cast_shape", [&]
        {
            const Geometry geometry = draw_.random.one_in(2) ? draw_.circle_by_hand() : draw_.capsule_by_hand();
            const Transform at = draw_.transform();
            const Vec2 way = sweep();
            const auto hit = world.cast_shape(geometry, at, way, filter);
            if (hit) expect_sound(world, *hit);
            const std::vector<CastHit> all = world.cast_shape_all(geometry, at, way, filter);
            ASSERT_EQ(all.empty(), !hit);
            EXPECT_TRUE(!hit || all.front().shape == hit->shape);
        });
        return;
    }
}

void RandomApi::query()
{
    const World& world = world_;
    const QueryFilter filter = draw_.query_filter(any_body());
    int visits = 0;
    const auto count = [&visits](ShapeId) { return ++visits < 20; };
    switch (draw_.random.below(7))
    {
    case 0:
        try_call("overlapping", [&]
        {
            const Vec2 min = draw_.vector(10);
            const Vec2 max = draw_.vector(10) + Vec2{20, 20};
            draw_.expect(min.x <= max.x && min.y <= max.y && max.x <= max_coordinate && max.y <= max_coordinate);
            world.overlapping(Aabb{min, max}, filter);
        });
        return;
    case 1:
        try_call("overlapping", [&]
        {
            const Geometry geometry = draw_.capsule_by_hand();
            world.overlapping(geometry, draw_.transform(), filter);
        });
        return;
    case 2: try_call("shapes_at", [&] { world.shapes_at(draw_.vector(10), filter); }); return;
    case 3:
        try_call("visit_overlapping", [&]
        {
            const Geometry geometry = draw_.capsule_by_hand();
            world.visit_overlapping(geometry, draw_.transform(), count, filter);
        });
        return;
    case 4: try_call("visit_shapes_at", [&] { world.visit_shapes_at(draw_.vector(10), count, filter); }); return;
    case 5:
        try_call("closest_point", [&]
        {
            const float reach = draw_.number(0, 30, {0, 4 * max_coordinate});
            const auto nearest = world.closest_point(draw_.vector(20), reach, filter);
            EXPECT_TRUE(!nearest || (nearest->distance >= 0 && nearest->distance <= reach));
        });
        return;
    default:
        try_call("explode", [&]
        {
            const Limits lengths = {0, max_coordinate};
            world_.explode({.center = draw_.vector(15),
                            .radius = draw_.number(0, 3, lengths),
                            .falloff = draw_.number(0, 3, lengths),
                            .impulse_per_metre = draw_.number(-5, 5, strength),
                            .filter = filter});
        });
        return;
    }
}

/// Of two shapes, without a world; and of one.
void RandomApi::measure()
{
    const auto motion = [&]
    { return ShapeMotion{draw_.transform(), draw_.vector(20, sweep_limits), draw_.number(-4, 4, {-1000, 1000}), draw_.vector(1)}; };
    switch (draw_.random.below(4))
    {
    case 0:
        try_call("distance", [&]
        {
            const Geometry geometry = draw_.capsule_by_hand();
            const Transform at = draw_.transform();
            EXPECT_GE(distance(geometry, at, circle(1), draw_.transform()).distance, 0);
        });
        return;
    case 1:
        try_call("time_of_impact", [&]
        {
            const Geometry geometry = draw_.capsule_by_hand();
            const ShapeMotion a = motion();
            const ShapeMotion b = motion();
            const auto time = time_of_impact(geometry, a, box(1, 2), b, draw_.number(0.001f, 0.1f, {1e-4f, max_coordinate}));
            EXPECT_TRUE(!time || (*time >= 0 && *time <= 1));
        });
        return;
    case 2:
        try_call("aabb_of", [&]
        {
            const Geometry geometry = draw_.capsule_by_hand();
            const Aabb box = aabb_of(geometry, {draw_.vector(20, finite), rotation(draw_.random.from(-4, 4))});
            EXPECT_TRUE(box.min.x <= box.max.x && box.min.y <= box.max.y);
        });
        return;
    default:
        try_call("contains", [&]
        {
            const Geometry geometry = draw_.circle_by_hand();
            contains(geometry, draw_.vector(2, finite));
        });
        return;
    }
}

void RandomApi::walk()
{
    if (draw_.random.one_in(20))
        try_call("Character", [&]
        {
            const float height = draw_.number(0.1f, 1, coordinate);
            const float width = draw_.capsule_radius(0.1f, 0.5f);
            draw_.doubt(std::abs(height + 0.5f) < 0.01f || width > 1e5f); // too short, or no room for the skin
            character_ = Character({.geometry = Capsule{{0, -0.5f}, {0, height}, width},
                                    .position = draw_.vector(15),
                                    .max_slope = draw_.number(0, 1.5f, {0, 1.5f}),
                                    .step_height = draw_.number(0, 0.5f, {0, max_coordinate}),
                                    .snap_distance = draw_.number(0, 0.5f, {0, max_coordinate}),
                                    .skin = draw_.number(0.002f, 0.05f, {0.001f, 0.1f}),
                                    .push_force = draw_.number(0, 100, force),
                                    .filter = draw_.query_filter(any_body())});
        });
    if (draw_.random.one_in(20)) try_call("set_position", [&] { character_.set_position(draw_.vector(15)); });
    for (int i = 0; i < 5; ++i)
    {
        const Character before = character_;
        const bool has_moved = try_call("move", [&]
        {
            const Vec2 wanted = draw_.vector(10, speed);
            const Vec2 velocity = character_.move(world_, wanted, draw_.number(0.005f, 0.03f, {1e-6f, 1}));
            EXPECT_TRUE(is_finite(velocity) && is_finite(character_.position()));
        });
        if (has_moved) continue;
        EXPECT_EQ(character_.position(), before.position());
        EXPECT_EQ(character_.ground().state, before.ground().state);
    }
}

} // namespace carom::fuzz
