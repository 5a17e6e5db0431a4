// Random calls that join bodies, set rules, and step the world.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace carom::fuzz
{

namespace
{

constexpr int most_joints = 120;

bool is_within_reach(Vec2 p) { return std::abs(p.x) < max_coordinate && std::abs(p.y) < max_coordinate; }

} // namespace

JointDef RandomApi::joint_def()
{
    JointDef def;
    if (!draw_.random.one_in(3)) def.body_a = any_body();
    def.body_b = any_body();
    const std::optional<Body> end = world_.find_body(def.body_b);
    const bool exist = end && (!def.body_a || world_.find_body(def.body_a));
    draw_.expect(exist && def.body_a != def.body_b);
    // As often as not the two meet where the bodies are.
    if (exist && draw_.random.one_in(2) && is_within_reach(end->position()))
    {
        def = world_.joint_at(def.body_a, def.body_b, end->position(), draw_.random.from(-3, 3));
        draw_.judge_frame(def.frame_a);
        draw_.judge_frame(def.frame_b);
    }
    else
        def.frame_a = draw_.frame(), def.frame_b = draw_.frame();
    def.collide_connected = draw_.random.one_in(2);
    if (draw_.random.one_in(4)) def.break_force = draw_.break_limit(0.01f, 2000);
    if (draw_.random.one_in(4)) def.break_torque = draw_.break_limit(0.01f, 2000);
    def.user_data = draw_.random.bits();
    return def;
}

void RandomApi::create_joint()
{
    if (world_.joint_count() >= most_joints)
    {
        try_call("destroy_joint", [&] { world_.destroy_joint(joint_id()); });
        return;
    }
    try_call("create_joint", [&]
    {
        const JointDef def = joint_def();
        const JointSpec spec = draw_.joint_spec();
        if (std::holds_alternative<MouseJoint>(spec)) draw_.expect(!def.body_a);
        if (std::holds_alternative<GearJoint>(spec) || std::holds_alternative<PulleyJoint>(spec)) draw_.expect(bool(def.body_a));
        joints_.push_back(world_.create_joint(def, spec));
        if (draw_.random.one_in(3)) joint_views_.push_back(world_.joint(joints_.back()));
    });
    tally_.most_joints = std::max(tally_.most_joints, world_.joint_count());
}

void RandomApi::edit_joint()
{
    if (draw_.random.one_in(8))
    {
        try_call("destroy_joint", [&] { world_.destroy_joint(joint_id()); });
        return;
    }
    const std::optional<Joint> found = world_.find_joint(joint_id());
    draw_.forget();
    if (!found) return;
    Joint joint = *found;
    switch (draw_.random.below(6))
    {
    case 0:
    case 1:
        try_call("set_spec", [&]
        {
            // Of the joint's own type, or not.
            JointSpec spec = draw_.joint_spec();
            for (int i = 0; i < 30 && spec.index() != joint.spec().index(); ++i)
            {
                draw_.forget();
                spec = draw_.joint_spec();
            }
            draw_.expect(spec.index() == joint.spec().index());
            joint.set_spec(spec);
        });
        return;
    case 2:
        try_call("set_frames", [&]
        {
            const Transform frame = draw_.frame();
            joint.set_frames(frame, draw_.frame());
        });
        return;
    case 3: try_call("set_collide_connected", [&] { joint.set_collide_connected(draw_.random.one_in(2)); }); return;
    case 4:
        try_call("set_break_limits", [&]
        {
            const float limit = draw_.break_limit(100, 1e5f);
            joint.set_break_limits(limit, draw_.break_limit(100, 1e5f));
        });
        return;
    default: try_call("set_user_data", [&] { joint.set_user_data(draw_.random.bits()); }); return;
    }
}

void RandomApi::edit_rules()
{
    const bool flag = draw_.random.one_in(2);
    switch (draw_.random.below(8))
    {
    case 7: try_call("shrink", [&] { world_.shrink(); }); return;
    case 0: try_call("set_mixing", [&] { world_.set_mixing({draw_.one_of<Mix>(5, 8), draw_.one_of<Mix>(5, 8)}); }); return;
    case 1: try_call("set_hit_speed", [&] { world_.set_hit_speed(draw_.number(0, 5, rate)); }); return;
    case 2: try_call("set_hooks", [&] { world_.set_hooks(flag ? &hooks_ : nullptr); }); return;
    case 3: try_call("set_continuous", [&] { world_.set_continuous(flag); }); return;
    case 4: try_call("wake_all", [&] { world_.wake_all(); }); return;
    case 5:
        try_call("set_sleep_tuning", [&] { world_.set_sleep_tuning({flag, draw_.number(0, 0.5f, rate), draw_.number(0, 1, rate)}); });
        return;
    default:
        try_call("set_solver_tuning", [&]
        {
            world_.set_solver_tuning({draw_.number(10, 60, {0.01f, 1e6f}), draw_.number(1, 20, rate), draw_.number(1, 5, {0.0001f, 1e6f}),
                                      draw_.number(0, 2, rate), draw_.number(20, 90, {0.01f, 1e6f}), draw_.number(0, 5, rate), flag});
        });
        return;
    }
}

void RandomApi::edit_world()
{
    switch (draw_.random.below(5))
    {
    case 0: try_call("set_gravity", [&] { world_.set_gravity(draw_.vector(20, factor)); }); return;
    case 1:
        if (fields_.size() < 6) try_call("add_field", [&] { fields_.push_back(world_.add_field(draw_.field())); });
        return;
    case 2:
        try_call("set_field", [&]
        {
            const FieldId id = field_id();
            world_.set_field(id, draw_.field());
        });
        return;
    case 3:
        try_call("remove_field", [&]
        {
            const FieldId id = field_id();
            world_.remove_field(id);
            std::erase(fields_, id);
            gone_fields_.push_back(id);
        });
        return;
    default:
        try_call("set_broad_phase", [&]
        {
            const std::uint64_t before = world_.hash();
            const int depth = draw_.random.one_in(10) ? 99 : draw_.random.below(7);
            const int capacity = draw_.random.one_in(10) ? 0 : 1 + draw_.random.below(20);
            draw_.expect(depth <= 10 && capacity >= 1);
            world_.set_broad_phase(draw_.one_of<BroadPhaseType>(static_cast<int>(all_broad_phases.size()), 10), {depth, capacity});
            EXPECT_EQ(world_.hash(), before);
        });
        return;
    }
}

void RandomApi::step()
{
    // Bodies to which a huge impulse has just given a speed beyond what float holds. The next step that takes time puts them aside.
    std::set<BodyId> endless;
    for (const BodyId id : world_.bodies())
    {
        const Body body = world_.body(id);
        if (!is_finite(body.linear_velocity()) || !std::isfinite(body.angular_velocity())) endless.insert(id);
    }
    try_call("step", [&]
    {
        const float dt = draw_.random.one_in(10) ? 0.0f : draw_.unjudged(0.002f, 0.03f);
        draw_.expect(dt == 0 || (dt >= 1e-6f && dt <= 1));
        const int substeps = draw_.random.one_in(30) ? draw_.random.below(80) - 5 : 1 + draw_.random.below(6);
        draw_.expect(substeps >= 1 && substeps <= 64);
        RandomProbe probe(world_, draw_.random.bits());
        check_step(world_.step(dt, substeps, draw_.random.one_in(8) ? &probe : nullptr), dt, endless);
        tally_.probe_refused += probe.refused;
    });
}

/// @param endless bodies whose speed was not finite before; a step of no time moves nothing and leaves them
void RandomApi::check_step(const StepReport& report, float dt, const std::set<BodyId>& endless)
{
    tally_.quarantined += static_cast<int>(report.quarantined.size());
    for (const BodyId id : report.quarantined)
    {
        EXPECT_FALSE(world_.body(id).is_enabled());
        const Vec2 place = world_.body(id).position();
        EXPECT_TRUE(std::abs(place.x) <= max_coordinate && std::abs(place.y) <= max_coordinate);
        EXPECT_EQ(world_.body(id).linear_velocity(), Vec2{});
    }
    for (const JointBreak& event : world_.events().joint_break)
    {
        ++tally_.breaks;
        EXPECT_FALSE(world_.find_joint(event.joint));
        EXPECT_GE(event.force, 0);
        EXPECT_GE(event.torque, 0);
    }
    for (const BodyId id : world_.bodies())
    {
        const Body body = world_.body(id);
        EXPECT_TRUE(is_finite(body.position()) && std::isfinite(body.angle()) && is_finite(body.center_of_mass()));
        const bool may_be_endless = endless.contains(id) && (dt == 0 || !body.is_enabled());
        EXPECT_TRUE(may_be_endless || (is_finite(body.linear_velocity()) && std::isfinite(body.angular_velocity()))) << dt;
    }
}

} // namespace carom::fuzz
