// A scene file for tests in which every field appears.
#pragma once

#include "scene_file/model.hpp"

#include <array>

namespace carom::scene_file
{

inline FileBody body_with_all_shapes()
{
    FileBody body;
    body.name = "all shapes";
    body.def = {.type = BodyType::Dynamic,
                .position = {0.1f, -0.2f},
                .angle = 0.3f,
                .linear_velocity = {1, -2},
                .angular_velocity = 0.5f,
                .linear_damping = 0.01f,
                .angular_damping = 0.02f,
                .gravity_scale = 0.5f,
                .locks = {true, true, true},
                .can_sleep = false,
                .is_bullet = true,
                .is_attractor = true,
                .is_enabled = true,
                .user_data = 7};
    body.mass_data = MassData{3, {0.1f, 0}, 2};
    const ShapeDef def{.density = 2,
                       .material = {0.1f, 0.2f, 0.3f, 0.4f, 5},
                       .filter = {.category = 6, .mask = 0xfffffffffffffff7u, .group = -8},
                       .is_sensor = true,
                       .contact_events = false,
                       .persist_events = true,
                       .sensor_events = false,
                       .hit_events = true,
                       .pre_solve = true,
                       .user_data = 9};
    Polygon odd = convex_hull(std::array{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.3f, 0.7f}}, 0.1f);
    odd.normals[1].x += 1e-7f; // so that it has to be written
    odd.centroid.x += 1e-6f;
    body.shapes = {{circle(0.5f, {0.1f, 0.2f}), def, "disc"}, {capsule({0, 0}, {1, 0}, 0.25f)}, {segment({0, 0}, {2, 0})}, {odd}};
    FileChain chain;
    chain.points = {{0, 0}, {1, 0}, {1, 1}};
    chain.def = {.points = {},
                 .is_loop = true,
                 .sides = ChainSides::OneSided,
                 .filter = {.group = 4},
                 .contact_events = false,
                 .persist_events = true,
                 .sensor_events = false,
                 .hit_events = true,
                 .pre_solve = true,
                 .user_data = 11};
    chain.materials = {def.material};
    chain.name = "ramp";
    body.chains = {chain};
    return body;
}

inline std::vector<FileJoint> joints_of_all_types()
{
    const Spring spring{3, 0.4f, 0.1f};
    const Range limit{-0.5f, 0.5f};
    const Motor motor{2, 30};
    const std::vector<JointSpec> specs = {RevoluteJoint{limit, motor, spring},   PrismaticJoint{limit, motor, spring},
                                          DistanceJoint{2, Range{1, 3}, spring}, WeldJoint{spring, spring},
                                          WheelJoint{{}, limit, motor},          MotorJoint{{1, 2}, 0.5f, spring, 3, 4},
                                          MouseJoint{{1, 2}, spring, 3},         GearJoint{2, GearMotion::Slide, GearMotion::Slide},
                                          PulleyJoint{{-1, 5}, {1, 5}, 2, 20}};
    std::vector<FileJoint> joints;
    for (const JointSpec& spec : specs)
    {
        FileJoint joint{.body_b = 2, .spec = spec, .name = "joint"};
        if (!std::holds_alternative<MouseJoint>(spec)) joint.body_a = 1;
        joint.def.frame_a = {{0.5f, 0}, {0, 1}};
        joint.def.frame_b = {{-0.5f, 0}, {0, -1}};
        joint.def.collide_connected = true;
        joint.def.break_force = 1e6f;
        joint.def.break_torque = 2e6f;
        joint.def.user_data = 3;
        joints.push_back(joint);
    }
    return joints;
}

inline SceneFile everything()
{
    SceneFile file;
    file.name = "everything";
    file.description = "has \"every\" field";
    file.notes = {"a note"};
    file.time_step = 0.01f;
    file.substeps = 3;
    file.steps = 40;
    file.view = FileView{{1, 2}, 30};
    file.world = {.gravity = {0.5f, -9},
                  .continuous = false,
                  .sleep = {.is_enabled = false, .speed = 0.1f, .time = 0.2f},
                  .solver = {20, 5, 2, 0.5f, 40, 3, false},
                  .mixing = {Mix::Minimum, Mix::Average},
                  .hit_speed = 2,
                  .length_unit = 0.5f,
                  .max_pairs = 1000,
                  .fields = {UniformField{{0.1f, 0.2f}}, PointField{{1, 2}, 3, 0.5f},
                             NBodyField{0.1f, 0.2f, NBodyMethod::Direct, NBodySources::Attractors, 0.7f}}};
    FileBody still{.def = {.type = BodyType::Kinematic, .position = {5, 5}, .is_enabled = false}};
    FileBody asleep{.def = {.position = {8, 1}}, .is_awake = false};
    asleep.shapes = {{box(1, 1)}};
    file.bodies = {body_with_all_shapes(),
                   {.def = {.position = {1, 1}}, .shapes = {{box(1, 1)}}},
                   {.def = {.position = {4, 1}}, .shapes = {{circle(0.4f)}}},
                   still,
                   asleep};
    file.joints = joints_of_all_types();
    FileEvent first{.step = 2};
    first.destroy_joints = {5};
    first.create_bodies = {{.def = {.position = {-4, 3}}, .shapes = {{circle(0.5f)}}}};
    first.create_joints = {{.body_b = 5, .spec = WeldJoint{}}};
    first.set_world = SetWorld{Vec2{0, -5}};
    SetBody set{.body = 2};
    set.type = BodyType::Dynamic;
    set.position = Vec2{4, 2};
    set.angle = 0.5f;
    set.linear_velocity = Vec2{1, 1};
    set.angular_velocity = 2.0f;
    set.linear_damping = 0.1f;
    set.angular_damping = 0.2f;
    set.gravity_scale = 0.9f;
    set.locks = MotionLocks{};
    set.can_sleep = true;
    set.is_bullet = true;
    set.is_attractor = false;
    set.is_enabled = true;
    set.is_awake = true;
    first.set_bodies = {set};
    SetJoint respec{.joint = 8};
    respec.spec = PulleyJoint{{-1, 6}, {1, 6}, 2, 21};
    first.set_joints = {{.joint = 0, .motor_speed = -1.0f}, respec};
    FileEvent second{.step = 9};
    second.destroy_bodies = {5};
    file.events = {first, second};
    file.rays = {{{-10, 1}, {20, 0}}, {{0, -10}, {0, 1}}};
    return file;
}

} // namespace carom::scene_file
