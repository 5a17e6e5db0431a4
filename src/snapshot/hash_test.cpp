// World::hash() tells apart worlds that differ in one setting only: what it left out could drift between two computers unseen.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace carom
{

namespace
{

struct HashTest : testing::Test
{
    using Change = std::function<void(World&, BodyId)>;

    /// The hash of a small world after a change to it.
    std::uint64_t hash_with(const Change& change) const
    {
        World world;
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(20, 2));
        const BodyId body = world.create_body({.position = {0, 3}}, box(1, 1));
        change(world, body);
        return world.hash();
    }

    /// No two of the changes give the same hash, nor does one give that of the unchanged world.
    void expect_all_differ(const std::map<std::string, Change>& changes) const
    {
        std::map<std::uint64_t, std::string> seen = {{hash_with([](World&, BodyId) {}), "nothing"}};
        for (const auto& [name, change] : changes)
        {
            const auto [other, is_new] = seen.emplace(hash_with(change), name);
            EXPECT_TRUE(is_new) << name << " is like " << other->second;
        }
    }

    static Change shape(const ShapeDef& def)
    {
        return [def](World& world, BodyId body) { world.create_shape(body, circle(0.3f), def); };
    }
    static Change chain(const ChainDef& def)
    {
        return [def](World& world, BodyId)
        {
            const std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 1}, {0, 2}};
            ChainDef with_points = def;
            with_points.points = points;
            world.create_chain(world.create_body({.type = BodyType::Static}), with_points);
        };
    }
    static Change joint(const JointSpec& spec, const JointDef& def = {})
    {
        return [spec, def](World& world, BodyId body)
        {
            JointDef between = world.joint_at(world.create_body({.position = {2, 3}}, box(1, 1)), body, {1, 3});
            if (std::holds_alternative<MouseJoint>(spec)) between = {.body_b = body};
            between.collide_connected = def.collide_connected;
            between.break_force = def.break_force;
            between.break_torque = def.break_torque;
            world.create_joint(between, spec);
        };
    }
    static Change field(const Field& field)
    {
        return [field](World& world, BodyId) { world.add_field(field); };
    }
};

} // namespace

TEST_F(HashTest, tells_settings_of_bodies_apart)
{
    expect_all_differ({
        {"position", [](World& w, BodyId b) { w.body(b).set_transform({0, 4}, 0); }},
        {"angle", [](World& w, BodyId b) { w.body(b).set_transform({0, 3}, 1); }},
        {"velocity", [](World& w, BodyId b) { w.body(b).set_linear_velocity({1, 0}); }},
        {"spin", [](World& w, BodyId b) { w.body(b).set_angular_velocity(1); }},
        {"force", [](World& w, BodyId b) { w.body(b).apply_force_to_center({1, 0}); }},
        {"torque", [](World& w, BodyId b) { w.body(b).apply_torque(1); }},
        {"linear damping", [](World& w, BodyId b) { w.body(b).set_linear_damping(1); }},
        {"angular damping", [](World& w, BodyId b) { w.body(b).set_angular_damping(1); }},
        {"gravity scale", [](World& w, BodyId b) { w.body(b).set_gravity_scale(0); }},
        {"lock of x", [](World& w, BodyId b) { w.body(b).set_locks({.x = true}); }},
        {"lock of y", [](World& w, BodyId b) { w.body(b).set_locks({.y = true}); }},
        {"lock of rotation", [](World& w, BodyId b) { w.body(b).set_locks({.rotation = true}); }},
        {"static", [](World& w, BodyId b) { w.body(b).set_type(BodyType::Static); }},
        {"kinematic", [](World& w, BodyId b) { w.body(b).set_type(BodyType::Kinematic); }},
        {"disabled", [](World& w, BodyId b) { w.body(b).set_enabled(false); }},
        {"asleep", [](World& w, BodyId b) { w.body(b).set_awake(false); }},
        {"may not sleep", [](World& w, BodyId b) { w.body(b).set_can_sleep(false); }},
        {"bullet", [](World& w, BodyId b) { w.body(b).set_is_bullet(true); }},
        {"attractor", [](World& w, BodyId b) { w.body(b).set_is_attractor(!w.body(b).is_attractor()); }},
        {"mass", [](World& w, BodyId b) { w.body(b).set_mass_data({.mass = 3, .inertia = 1}); }},
        {"another body", [](World& w, BodyId) { w.create_body({.position = {9, 9}}); }},
        {"a place that is free again", [](World& w, BodyId) { w.destroy_body(w.create_body({.position = {9, 9}})); }},
    });
}

TEST_F(HashTest, tells_settings_of_shapes_and_chains_apart)
{
    expect_all_differ({
        {"shape", shape({})},
        {"density", shape({.density = 2})},
        {"friction", shape({.material = {.friction = 0.1f}})},
        {"restitution", shape({.material = {.restitution = 0.1f}})},
        {"rolling resistance", shape({.material = {.rolling_resistance = 0.1f}})},
        {"tangent speed", shape({.material = {.tangent_speed = 0.1f}})},
        {"category", shape({.filter = {.category = 2}})},
        {"mask", shape({.filter = {.mask = 2}})},
        {"group", shape({.filter = {.group = 2}})},
        {"sensor", shape({.is_sensor = true})},
        {"contact events", shape({.contact_events = false})},
        {"persist events", shape({.persist_events = true})},
        {"sensor events", shape({.sensor_events = false})},
        {"hit events", shape({.hit_events = true})},
        {"pre-solve", shape({.pre_solve = true})},
        {"hit events and pre-solve", shape({.hit_events = true, .pre_solve = true})},
        {"circle", [](World& w, BodyId b) { w.create_shape(b, circle(0.31f)); }},
        {"circle beside", [](World& w, BodyId b) { w.create_shape(b, circle(0.3f, {0.1f, 0})); }},
        {"capsule", [](World& w, BodyId b) { w.create_shape(b, capsule({0, 0}, {0.1f, 0}, 0.3f)); }},
        {"segment", [](World& w, BodyId b) { w.create_shape(b, segment({0, 0}, {0.1f, 0})); }},
        {"box", [](World& w, BodyId b) { w.create_shape(b, box(0.6f, 0.6f)); }},
        {"rounded box", [](World& w, BodyId b) { w.create_shape(b, rounded_box(0.6f, 0.6f, 0.1f)); }},
        {"chain", chain({})},
        {"loop", chain({.points = {}, .is_loop = true})},
        {"one-sided chain", chain({.points = {}, .sides = ChainSides::OneSided})},
        {"chain that asks for hits", chain({.points = {}, .hit_events = true})},
    });
}

TEST_F(HashTest, tells_settings_of_joints_apart)
{
    expect_all_differ({
        {"revolute", joint(RevoluteJoint{})},
        {"colliding", joint(RevoluteJoint{}, {.collide_connected = true})},
        {"that breaks by force", joint(RevoluteJoint{}, {.break_force = 1000})},
        {"that breaks by torque", joint(RevoluteJoint{}, {.break_torque = 1000})},
        {"revolute, limit", joint(RevoluteJoint{.limit = Range{-1, 1}})},
        {"revolute, lower limit", joint(RevoluteJoint{.limit = Range{-2, 1}})},
        {"revolute, motor", joint(RevoluteJoint{.motor = Motor{1, 5}})},
        {"revolute, stronger motor", joint(RevoluteJoint{.motor = Motor{1, 6}})},
        {"revolute, spring", joint(RevoluteJoint{.spring = Spring{2, 1, 0}})},
        {"revolute, damped spring", joint(RevoluteJoint{.spring = Spring{2, 2, 0}})},
        {"revolute, spring elsewhere", joint(RevoluteJoint{.spring = Spring{2, 1, 0.5f}})},
        {"prismatic", joint(PrismaticJoint{})},
        {"prismatic, limit", joint(PrismaticJoint{.limit = Range{-1, 1}})},
        {"prismatic, motor", joint(PrismaticJoint{.motor = Motor{1, 5}})},
        {"prismatic, spring", joint(PrismaticJoint{.spring = Spring{2, 1, 0}})},
        {"distance", joint(DistanceJoint{.length = 2})},
        {"distance, longer", joint(DistanceJoint{.length = 3})},
        {"distance, limit", joint(DistanceJoint{.length = 2, .limit = Range{1, 3}})},
        {"distance, spring", joint(DistanceJoint{.length = 2, .spring = Spring{2, 1, 0}})},
        {"weld", joint(WeldJoint{})},
        {"weld, linear", joint(WeldJoint{.linear = Spring{2, 1, 0}})},
        {"weld, angular", joint(WeldJoint{.angular = Spring{2, 1, 0}})},
        {"wheel", joint(WheelJoint{})},
        {"wheel, rigid", joint(WheelJoint{.suspension = std::nullopt})},
        {"wheel, limit", joint(WheelJoint{.limit = Range{-1, 1}})},
        {"wheel, motor", joint(WheelJoint{.motor = Motor{1, 5}})},
        {"motor", joint(MotorJoint{.max_force = 1, .max_torque = 1})},
        {"motor, offset", joint(MotorJoint{.offset = {1, 0}, .max_force = 1, .max_torque = 1})},
        {"motor, angle", joint(MotorJoint{.angle = 1, .max_force = 1, .max_torque = 1})},
        {"motor, force", joint(MotorJoint{.max_force = 2, .max_torque = 1})},
        {"motor, torque", joint(MotorJoint{.max_force = 1, .max_torque = 2})},
        {"mouse", joint(MouseJoint{.target = {1, 1}, .max_force = 1})},
        {"mouse, target", joint(MouseJoint{.target = {2, 1}, .max_force = 1})},
        {"mouse, force", joint(MouseJoint{.target = {1, 1}, .max_force = 2})},
        {"gear", joint(GearJoint{})},
        {"gear, ratio", joint(GearJoint{.ratio = 2})},
        {"gear, sliding A", joint(GearJoint{.motion_a = GearMotion::Slide})},
        {"gear, sliding B", joint(GearJoint{.motion_b = GearMotion::Slide})},
        {"pulley", joint(PulleyJoint{.ground_a = {0, 9}, .ground_b = {2, 9}, .length = 12})},
        {"pulley, ratio", joint(PulleyJoint{.ground_a = {0, 9}, .ground_b = {2, 9}, .ratio = 2, .length = 12})},
        {"pulley, length", joint(PulleyJoint{.ground_a = {0, 9}, .ground_b = {2, 9}, .length = 13})},
        {"pulley, ground A", joint(PulleyJoint{.ground_a = {0, 8}, .ground_b = {2, 9}, .length = 12})},
        {"pulley, ground B", joint(PulleyJoint{.ground_a = {0, 9}, .ground_b = {2, 8}, .length = 12})},
    });
}

TEST_F(HashTest, tells_settings_of_the_world_apart)
{
    expect_all_differ({
        {"gravity", [](World& w, BodyId) { w.set_gravity({0, -9}); }},
        {"continuous", [](World& w, BodyId) { w.set_continuous(false); }},
        {"hit speed", [](World& w, BodyId) { w.set_hit_speed(7); }},
        {"mixing of friction", [](World& w, BodyId) { w.set_mixing({.friction = Mix::Product}); }},
        {"mixing of restitution", [](World& w, BodyId) { w.set_mixing({.restitution = Mix::Product}); }},
        {"contact stiffness", [](World& w, BodyId) { w.set_solver_tuning({.contact_hertz = 20}); }},
        {"contact damping", [](World& w, BodyId) { w.set_solver_tuning({.contact_damping_ratio = 9}); }},
        {"push-out speed", [](World& w, BodyId) { w.set_solver_tuning({.push_out_speed = 2}); }},
        {"restitution threshold", [](World& w, BodyId) { w.set_solver_tuning({.restitution_threshold = 2}); }},
        {"joint stiffness", [](World& w, BodyId) { w.set_solver_tuning({.joint_hertz = 50}); }},
        {"joint damping", [](World& w, BodyId) { w.set_solver_tuning({.joint_damping_ratio = 1}); }},
        {"no sleep", [](World& w, BodyId) { w.set_sleep_tuning({.is_enabled = false}); }},
        {"sleep speed", [](World& w, BodyId) { w.set_sleep_tuning({.speed = 0.01f}); }},
        {"sleep time", [](World& w, BodyId) { w.set_sleep_tuning({.time = 1}); }},
        {"uniform field", field(UniformField{{1, 0}})},
        {"stronger field", field(UniformField{{2, 0}})},
        {"point field", field(PointField{.center = {0, 0}, .strength = 1, .softening = 1})},
        {"centre", field(PointField{.center = {1, 0}, .strength = 1, .softening = 1})},
        {"strength", field(PointField{.center = {0, 0}, .strength = 2, .softening = 1})},
        {"softening", field(PointField{.center = {0, 0}, .strength = 1, .softening = 2})},
        {"n-body field", field(NBodyField{.gravitational_constant = 1, .softening = 1})},
        {"constant", field(NBodyField{.gravitational_constant = 2, .softening = 1})},
        {"opening angle", field(NBodyField{.gravitational_constant = 1, .softening = 1, .opening_angle = 0.1f})},
        {"method", field(NBodyField{.gravitational_constant = 1, .softening = 1, .method = NBodyMethod::Direct})},
    });
}

} // namespace carom
