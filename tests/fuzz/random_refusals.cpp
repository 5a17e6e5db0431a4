// Calls that must always be refused: through views and ids of what is gone, with mistakes beyond doubt, and from inside a step.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <string>

namespace carom::fuzz
{

namespace
{

/// A call of a view, and the name under which it must be refused.
template <class View>
struct ViewCall
{
    const char* function;
    void (*make)(View&);
};

constexpr ViewCall<Body> body_calls[] = {
    {"type", [](Body& b) { b.type(); }},
    {"transform", [](Body& b) { b.transform(); }},
    {"position", [](Body& b) { b.position(); }},
    {"angle", [](Body& b) { b.angle(); }},
    {"center_of_mass", [](Body& b) { b.center_of_mass(); }},
    {"linear_velocity", [](Body& b) { b.linear_velocity(); }},
    {"angular_velocity", [](Body& b) { b.angular_velocity(); }},
    {"velocity_at", [](Body& b) { b.velocity_at({}); }},
    {"mass_data", [](Body& b) { b.mass_data(); }},
    {"linear_damping", [](Body& b) { b.linear_damping(); }},
    {"angular_damping", [](Body& b) { b.angular_damping(); }},
    {"gravity_scale", [](Body& b) { b.gravity_scale(); }},
    {"locks", [](Body& b) { b.locks(); }},
    {"is_attractor", [](Body& b) { b.is_attractor(); }},
    {"is_awake", [](Body& b) { b.is_awake(); }},
    {"can_sleep", [](Body& b) { b.can_sleep(); }},
    {"is_bullet", [](Body& b) { b.is_bullet(); }},
    {"is_enabled", [](Body& b) { b.is_enabled(); }},
    {"force", [](Body& b) { b.force(); }},
    {"torque", [](Body& b) { b.torque(); }},
    {"shape_count", [](Body& b) { b.shape_count(); }},
    {"shapes", [](Body& b) { b.shapes(); }},
    {"name", [](Body& b) { b.name(); }},
    {"user_data", [](Body& b) { b.user_data(); }},
    {"bounds", [](Body& b) { b.bounds(); }},
    {"set_type", [](Body& b) { b.set_type(BodyType::Static); }},
    {"set_transform", [](Body& b) { b.set_transform({}, 0); }},
    {"move_to", [](Body& b) { b.move_to({}, 0.01f); }},
    {"set_linear_velocity", [](Body& b) { b.set_linear_velocity({}); }},
    {"set_angular_velocity", [](Body& b) { b.set_angular_velocity(0); }},
    {"set_linear_damping", [](Body& b) { b.set_linear_damping(0); }},
    {"set_angular_damping", [](Body& b) { b.set_angular_damping(0); }},
    {"set_gravity_scale", [](Body& b) { b.set_gravity_scale(0); }},
    {"set_locks", [](Body& b) { b.set_locks({}); }},
    {"set_is_attractor", [](Body& b) { b.set_is_attractor(true); }},
    {"set_awake", [](Body& b) { b.set_awake(true); }},
    {"set_can_sleep", [](Body& b) { b.set_can_sleep(false); }},
    {"set_is_bullet", [](Body& b) { b.set_is_bullet(true); }},
    {"set_enabled", [](Body& b) { b.set_enabled(false); }},
    {"set_mass_data", [](Body& b) { b.set_mass_data({1, {}, 1}); }},
    {"reset_mass_data", [](Body& b) { b.reset_mass_data(); }},
    {"set_name", [](Body& b) { b.set_name("a name for nobody"); }},
    {"set_user_data", [](Body& b) { b.set_user_data(1); }},
    {"apply_force", [](Body& b) { b.apply_force({1, 0}, {}); }},
    {"apply_force_to_center", [](Body& b) { b.apply_force_to_center({1, 0}); }},
    {"apply_torque", [](Body& b) { b.apply_torque(1); }},
    {"apply_impulse", [](Body& b) { b.apply_impulse({1, 0}, {}); }},
    {"apply_impulse_to_center", [](Body& b) { b.apply_impulse_to_center({1, 0}); }},
    {"apply_angular_impulse", [](Body& b) { b.apply_angular_impulse(1); }},
};

constexpr ViewCall<Shape> shape_calls[] = {
    {"body", [](Shape& s) { s.body(); }},
    {"chain", [](Shape& s) { s.chain(); }},
    {"geometry", [](Shape& s) { s.geometry(); }},
    {"density", [](Shape& s) { s.density(); }},
    {"material", [](Shape& s) { s.material(); }},
    {"filter", [](Shape& s) { s.filter(); }},
    {"is_sensor", [](Shape& s) { s.is_sensor(); }},
    {"hit_events", [](Shape& s) { s.hit_events(); }},
    {"pre_solve", [](Shape& s) { s.pre_solve(); }},
    {"bounds", [](Shape& s) { s.bounds(); }},
    {"user_data", [](Shape& s) { s.user_data(); }},
    {"contains", [](Shape& s) { s.contains({}); }},
    {"touching", [](Shape& s) { s.touching(); }},
    {"set_material", [](Shape& s) { s.set_material({}); }},
    {"set_filter", [](Shape& s) { s.set_filter({}); }},
    {"set_geometry", [](Shape& s) { s.set_geometry(circle(1)); }},
    {"set_density", [](Shape& s) { s.set_density(1); }},
    {"set_hit_events", [](Shape& s) { s.set_hit_events(true); }},
    {"set_pre_solve", [](Shape& s) { s.set_pre_solve(true); }},
    {"set_user_data", [](Shape& s) { s.set_user_data(1); }},
};

constexpr ViewCall<Chain> chain_calls[] = {
    {"body", [](Chain& c) { c.body(); }},
    {"segment_count", [](Chain& c) { c.segment_count(); }},
    {"segments", [](Chain& c) { c.segments(); }},
    {"is_loop", [](Chain& c) { c.is_loop(); }},
    {"sides", [](Chain& c) { c.sides(); }},
    {"material", [](Chain& c) { c.material(0); }},
    {"user_data", [](Chain& c) { c.user_data(); }},
    {"set_material", [](Chain& c) { c.set_material({}); }},
    {"set_material", [](Chain& c) { c.set_material(0, {}); }},
    {"set_filter", [](Chain& c) { c.set_filter({}); }},
    {"set_user_data", [](Chain& c) { c.set_user_data(1); }},
};

constexpr ViewCall<Joint> joint_calls[] = {
    {"type", [](Joint& j) { j.type(); }},
    {"spec", [](Joint& j) { j.spec(); }},
    {"body_a", [](Joint& j) { j.body_a(); }},
    {"body_b", [](Joint& j) { j.body_b(); }},
    {"frame_a", [](Joint& j) { j.frame_a(); }},
    {"frame_b", [](Joint& j) { j.frame_b(); }},
    {"collide_connected", [](Joint& j) { j.collide_connected(); }},
    {"break_force", [](Joint& j) { j.break_force(); }},
    {"break_torque", [](Joint& j) { j.break_torque(); }},
    {"user_data", [](Joint& j) { j.user_data(); }},
    {"force", [](Joint& j) { j.force(); }},
    {"torque", [](Joint& j) { j.torque(); }},
    {"angle", [](Joint& j) { j.angle(); }},
    {"offset", [](Joint& j) { j.offset(); }},
    {"error", [](Joint& j) { j.error(); }},
    {"set_spec", [](Joint& j) { j.set_spec(RevoluteJoint{}); }},
    {"set_frames", [](Joint& j) { j.set_frames({}, {}); }},
    {"set_collide_connected", [](Joint& j) { j.set_collide_connected(true); }},
    {"set_break_limits", [](Joint& j) { j.set_break_limits(1, 1); }},
    {"set_user_data", [](Joint& j) { j.set_user_data(1); }},
};

/// A view of something that is gone; empty when none is found soon.
template <class View, class IsLive>
std::optional<View> stale_view(const std::vector<View>& views, Random& random, const IsLive& is_live)
{
    for (int tries = 0; tries < 10 && !views.empty(); ++tries)
    {
        const View& view = views[static_cast<std::size_t>(random.below(static_cast<int>(views.size())))];
        if (!is_live(view.id())) return view;
    }
    return std::nullopt;
}

template <class View, std::size_t N>
const ViewCall<View>& any_call(const ViewCall<View> (&calls)[N], Random& random)
{
    return calls[static_cast<std::size_t>(random.below(static_cast<int>(N)))];
}

} // namespace

void RandomApi::call_stale_view()
{
    const auto try_view = [&](const auto& views, const auto& calls, const auto& is_live)
    {
        auto view = stale_view(views, draw_.random, is_live);
        if (!view) return;
        const auto& call = any_call(calls, draw_.random);
        must_refuse(call.function, [&] { call.make(*view); });
        ++tally_.stale;
    };
    switch (draw_.random.below(4))
    {
    case 0: return try_view(body_views_, body_calls, [&](BodyId id) { return world_.find_body(id).has_value(); });
    case 1: return try_view(shape_views_, shape_calls, [&](ShapeId id) { return world_.find_shape(id).has_value(); });
    case 2: return try_view(chain_views_, chain_calls, [&](ChainId id) { return world_.find_chain(id).has_value(); });
    default: return try_view(joint_views_, joint_calls, [&](JointId id) { return world_.find_joint(id).has_value(); });
    }
}

void RandomApi::call_stale_id()
{
    const BodyId body = gone_body();
    const ShapeId shape = gone_shape();
    const ChainId chain = gone_chain();
    const JointId joint = gone_joint();
    const FieldId field = gone_fields_.empty() ? FieldId{} : gone_fields_.back();
    const World& reading = world_;
    tally_.stale += body && shape && chain && joint;
    switch (draw_.random.below(20))
    {
    case 0: return must_refuse("body", [&] { world_.body(body); });
    case 1: return must_refuse("body", [&] { reading.body(body); });
    case 2: return must_refuse("destroy_body", [&] { world_.destroy_body(body); });
    case 3: return must_refuse("create_shape", [&] { world_.create_shape(body, circle(1)); });
    case 4: return must_refuse("create_chain", [&] { world_.create_chain(body, {.points = std::vector<Vec2>{{0, 0}, {1, 0}}}); });
    case 5: return must_refuse("joints_of", [&] { world_.joints_of(body); });
    case 6:
        if (body) must_refuse("joint_at", [&] { world_.joint_at({}, body, {}); }); // null would be the world
        return;
    case 7: return must_refuse("create_joint", [&] { world_.create_joint({.body_b = body}, RevoluteJoint{}); });
    case 8: return must_refuse("shape", [&] { world_.shape(shape); });
    case 9: return must_refuse("shape", [&] { reading.shape(shape); });
    case 10: return must_refuse("destroy_shape", [&] { world_.destroy_shape(shape); });
    case 11: return must_refuse("manifold", [&] { world_.manifold(shape, shape); });
    case 12: return must_refuse("chain", [&] { world_.chain(chain); });
    case 13: return must_refuse("chain", [&] { reading.chain(chain); });
    case 14: return must_refuse("destroy_chain", [&] { world_.destroy_chain(chain); });
    case 15: return must_refuse("joint", [&] { world_.joint(joint); });
    case 16: return must_refuse("joint", [&] { reading.joint(joint); });
    case 17: return must_refuse("destroy_joint", [&] { world_.destroy_joint(joint); });
    case 18: return must_refuse("set_field", [&] { world_.set_field(field, UniformField{}); });
    default: return must_refuse("remove_field", [&] { world_.remove_field(field); });
    }
}

void RandomApi::make_mistake()
{
    switch (draw_.random.below(16))
    {
    case 0: return must_refuse("body", [&] { world_.body(foreign_); });
    case 1: return must_refuse("create_body", [&] { world_.create_body({.position = {nan, 0}}); });
    case 2: return must_refuse("create_body", [&] { world_.create_body({.type = BodyType::Static, .linear_velocity = {1, 0}}); });
    case 3: return must_refuse("circle", [&] { circle(-1); });
    case 4: return must_refuse("create_body", [&] { world_.create_body({}, Circle{{}, 0}); });
    case 5: return must_refuse("create_body", [&] { world_.create_body({}, circle(1), {.density = -1}); });
    case 6: return must_refuse("step", [&] { world_.step(-1); });
    case 7: return must_refuse("step", [&] { world_.step(0.01f, 0); });
    case 8: return must_refuse("chain", [&] { world_.chain({1u << 30, 1, world_.number()}); });
    case 9: return must_refuse("set_hit_speed", [&] { world_.set_hit_speed(nan); });
    case 10: return must_refuse("mass_of", [&] { mass_of(circle(1), nan); });
    case 11: return must_refuse("joint_at", [&] { world_.joint_at({}, foreign_, {}); });
    case 12: return must_refuse("World", [&] { World({.length_unit = 0}); });
    case 13: return must_refuse("box", [&] { box(1, 1, nan); });
    case 14: return must_refuse("set_max_pairs", [&] { world_.set_max_pairs(-1); });
    default: return must_refuse("set_gravity", [&] { world_.set_gravity({0, inf}); });
    }
}

void RandomApi::edit_during_step()
{
    // Many bodies at one place make more pairs than ever before, so that the step has to allocate.
    std::vector<BodyId> crowd;
    for (int i = 0; i < 40; ++i) crowd.push_back(world_.create_body({.position = {30, 30}}, circle(1)));

    hook_.argument = this;
    hook_.action = [](void* self)
    {
        RandomApi& api = *static_cast<RandomApi*>(self);
        api.hook_.action = nullptr; // once
        api.refuse_during_step();
    };
    world_.step(0.01f);
    hook_.action = nullptr;
    for (const BodyId id : crowd) world_.destroy_body(id);
    forget_state();
}

void RandomApi::refuse_during_step()
{
    const auto refuse = [&](const char* function, auto&& call)
    {
        ++tally_.calls;
        try
        {
            call();
            ADD_FAILURE() << function << " was allowed during a step";
        }
        catch (const UsageError& error)
        {
            ++tally_.refused;
            ++tally_.during_step;
            expect_complete(error, function);
            EXPECT_EQ(error.value(), "stepping");
        }
    };
    refuse("step", [&] { world_.step(0.01f); });
    refuse("create_body", [&] { world_.create_body({}, circle(1)); });
    refuse("cast_ray", [&] { world_.cast_ray({0, 0}, {1, 0}); });
    refuse("overlapping", [&] { world_.overlapping(circle(1), {}); });
    refuse("closest_point", [&] { world_.closest_point({0, 0}, 1); });
    refuse("explode", [&] { world_.explode({}); });
    refuse("move", [&] { character_.move(world_, {}, 0.01f); });
    refuse("create_joint", [&] { world_.create_joint({}, RevoluteJoint{}); });
    refuse("destroy_joint", [&] { world_.destroy_joint({}); });
    if (world_.joint_count() > 0) refuse("set_break_limits", [&] { world_.joint(world_.joints().front()).set_break_limits(1, 1); });
    refuse("set_gravity", [&] { world_.set_gravity({}); });
    refuse("set_broad_phase", [&] { world_.set_broad_phase(BroadPhaseType::BruteForce); });
    refuse("copy", [&] { World copied = world_.copy(); });
    refuse("restore", [&] { world_.restore(other_); });
    for (const BodyId id : bodies_)
    {
        const std::optional<Body> body = world_.find_body(id);
        if (!body) continue;
        refuse("destroy_body", [&] { world_.destroy_body(id); });
        refuse("set_transform", [&] { Body(*body).set_transform({}, 0); });
        refuse("apply_force_to_center", [&] { Body(*body).apply_force_to_center({1, 1}); });
        break;
    }
}

} // namespace carom::fuzz
