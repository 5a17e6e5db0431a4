//! Joints of Box2D 3. Each is made bare; what its type holds is set by apply(), then and later.

use crate::box2d::ffi::*;
use crate::{transform, vec2};
use carom_peer_scene::file::{Joint, Motor, Range, SceneFile, Solver, Spec, Spring};
use carom_peer_scene::run::Stop;

/// The engine clamps the limits of revolute joints to this.
const MOST_ANGLE: f32 = 0.99 * std::f32::consts::PI;

pub fn create(world: b2WorldId, number: usize, joint: &Joint, a: b2BodyId, b: b2BodyId) -> Result<b2JointId, Stop> {
    macro_rules! make {
        ($default:ident, $create:ident) => {{
            let mut def = $default();
            fill(&mut def.base, number, joint, a, b);
            $create(world, &def)
        }};
    }
    let id = unsafe {
        match &joint.spec {
            Spec::Revolute(_) => make!(b2DefaultRevoluteJointDef, b2CreateRevoluteJoint),
            Spec::Prismatic(_) => make!(b2DefaultPrismaticJointDef, b2CreatePrismaticJoint),
            Spec::Distance(_) => make!(b2DefaultDistanceJointDef, b2CreateDistanceJoint),
            Spec::Weld(_) => make!(b2DefaultWeldJointDef, b2CreateWeldJoint),
            Spec::Wheel(_) => make!(b2DefaultWheelJointDef, b2CreateWheelJoint),
            Spec::Motor(_) | Spec::Mouse(_) => make!(b2DefaultMotorJointDef, b2CreateMotorJoint),
            Spec::Gear | Spec::Pulley => return Err(Stop::Lacks(format!("the engine has no {} joints", joint.spec.name()))),
        }
    };
    apply(id, joint, &joint.spec)?;
    Ok(id)
}

fn fill(base: &mut b2JointDef, number: usize, joint: &Joint, a: b2BodyId, b: b2BodyId) {
    base.userData = number as *mut std::ffi::c_void;
    base.bodyIdA = a;
    base.bodyIdB = b;
    base.localFrameA = transform(&joint.frame_a);
    base.localFrameB = transform(&joint.frame_b);
    base.forceThreshold = joint.break_force.unwrap_or(f32::MAX);
    base.torqueThreshold = joint.break_torque.unwrap_or(f32::MAX);
    base.collideConnected = joint.collide_connected;
}

/// @param made_as  for its frames
pub fn apply(id: b2JointId, made_as: &Joint, spec: &Spec) -> Result<(), Stop> {
    unsafe {
        match spec {
            Spec::Revolute(j) => {
                let spring = j.spring.unwrap_or(Spring { hertz: 0.0, damping_ratio: 0.0, target: 0.0 });
                b2RevoluteJoint_EnableSpring(id, j.spring.is_some());
                b2RevoluteJoint_SetSpringHertz(id, spring.hertz);
                b2RevoluteJoint_SetSpringDampingRatio(id, spring.damping_ratio);
                b2RevoluteJoint_SetTargetAngle(id, spring.target);
                b2RevoluteJoint_EnableLimit(id, j.limit.is_some());
                if let Some(Range { lower, upper }) = j.limit {
                    b2RevoluteJoint_SetLimits(id, lower.max(-MOST_ANGLE), upper.min(MOST_ANGLE));
                }
                let motor = j.motor.unwrap_or_default();
                b2RevoluteJoint_EnableMotor(id, j.motor.is_some());
                b2RevoluteJoint_SetMotorSpeed(id, motor.speed);
                b2RevoluteJoint_SetMaxMotorTorque(id, motor.max_force);
            }
            Spec::Prismatic(j) => {
                let spring = j.spring.unwrap_or(Spring { hertz: 0.0, damping_ratio: 0.0, target: 0.0 });
                b2PrismaticJoint_EnableSpring(id, j.spring.is_some());
                b2PrismaticJoint_SetSpringHertz(id, spring.hertz);
                b2PrismaticJoint_SetSpringDampingRatio(id, spring.damping_ratio);
                b2PrismaticJoint_SetTargetTranslation(id, spring.target);
                b2PrismaticJoint_EnableLimit(id, j.limit.is_some());
                if let Some(Range { lower, upper }) = j.limit {
                    b2PrismaticJoint_SetLimits(id, lower, upper);
                }
                let motor = j.motor.unwrap_or_default();
                b2PrismaticJoint_EnableMotor(id, j.motor.is_some());
                b2PrismaticJoint_SetMotorSpeed(id, motor.speed);
                b2PrismaticJoint_SetMaxMotorForce(id, motor.max_force);
            }
            Spec::Distance(j) => {
                // A rope: the engine minds the limits only of a joint that has a spring, and a spring of 0 hertz does nothing.
                let spring = j.spring.unwrap_or(Spring { hertz: 0.0, damping_ratio: 0.0, target: 0.0 });
                b2DistanceJoint_SetLength(id, j.length);
                b2DistanceJoint_EnableSpring(id, j.spring.is_some() || j.limit.is_some());
                b2DistanceJoint_SetSpringHertz(id, spring.hertz);
                b2DistanceJoint_SetSpringDampingRatio(id, spring.damping_ratio);
                b2DistanceJoint_EnableLimit(id, j.limit.is_some());
                if let Some(Range { lower, upper }) = j.limit {
                    b2DistanceJoint_SetLengthRange(id, lower, upper);
                }
            }
            Spec::Weld(j) => {
                let rigid = Spring { hertz: 0.0, damping_ratio: 0.0, target: 0.0 };
                let (linear, angular) = (j.linear.unwrap_or(rigid), j.angular.unwrap_or(rigid));
                b2WeldJoint_SetLinearHertz(id, linear.hertz);
                b2WeldJoint_SetLinearDampingRatio(id, linear.damping_ratio);
                b2WeldJoint_SetAngularHertz(id, angular.hertz);
                b2WeldJoint_SetAngularDampingRatio(id, angular.damping_ratio);
            }
            Spec::Wheel(j) => {
                let spring = j.suspension.unwrap_or(Spring { hertz: 0.0, damping_ratio: 0.0, target: 0.0 });
                b2WheelJoint_EnableSpring(id, j.suspension.is_some());
                b2WheelJoint_SetSpringHertz(id, spring.hertz);
                b2WheelJoint_SetSpringDampingRatio(id, spring.damping_ratio);
                b2WheelJoint_EnableLimit(id, j.limit.is_some());
                if let Some(Range { lower, upper }) = j.limit {
                    b2WheelJoint_SetLimits(id, lower, upper);
                }
                let motor: Motor = j.motor.unwrap_or_default();
                b2WheelJoint_EnableMotor(id, j.motor.is_some());
                b2WheelJoint_SetMotorSpeed(id, motor.speed);
                b2WheelJoint_SetMaxMotorTorque(id, motor.max_force);
            }
            Spec::Motor(j) => {
                b2Joint_SetLocalFrameA(id, transform(&made_as.frame_a.then(j.offset, j.angle)));
                b2MotorJoint_SetLinearHertz(id, j.spring.hertz);
                b2MotorJoint_SetLinearDampingRatio(id, j.spring.damping_ratio);
                b2MotorJoint_SetMaxSpringForce(id, j.max_force);
                b2MotorJoint_SetAngularHertz(id, j.spring.hertz);
                b2MotorJoint_SetAngularDampingRatio(id, j.spring.damping_ratio);
                b2MotorJoint_SetMaxSpringTorque(id, j.max_torque);
            }
            Spec::Mouse(j) => {
                let there = b2Transform { p: vec2(j.target), q: b2Rot { c: 1.0, s: 0.0 } };
                b2Joint_SetLocalFrameA(id, there);
                b2MotorJoint_SetLinearHertz(id, j.spring.hertz);
                b2MotorJoint_SetLinearDampingRatio(id, j.spring.damping_ratio);
                b2MotorJoint_SetMaxSpringForce(id, j.max_force);
            }
            Spec::Gear | Spec::Pulley => return Err(Stop::Lacks(format!("the engine has no {} joints", spec.name()))),
        }
    }
    Ok(())
}

pub fn set_motor_speed(id: b2JointId, spec: &Spec, speed: f32) {
    unsafe {
        match spec {
            Spec::Revolute(_) => b2RevoluteJoint_SetMotorSpeed(id, speed),
            Spec::Prismatic(_) => b2PrismaticJoint_SetMotorSpeed(id, speed),
            _ => b2WheelJoint_SetMotorSpeed(id, speed),
        }
    }
}

pub fn differences_of(scene: &SceneFile) -> Vec<String> {
    let mut list = Vec::new();
    let mut say = |is_so: bool, what: &str| {
        if is_so {
            list.push(what.to_string());
        }
    };
    let any = |test: fn(&Spec) -> bool| scene.all_specs().any(test);
    let is_far = |limit: Option<Range>| limit.is_some_and(|l| l.lower < -MOST_ANGLE || l.upper > MOST_ANGLE);
    let is_free = |spring: Option<Spring>| spring.is_some_and(|s| s.hertz == 0.0);
    let has_own_tuning = Solver { joint_hertz: 60.0, joint_damping_ratio: 2.0, ..scene.world.solver.clone() } == scene.world.solver;
    say(scene.all_specs().next().is_some() && !has_own_tuning, "joints have the engine's own stiffness and damping");
    say(
        scene.all_specs().any(|spec| matches!(spec, Spec::Revolute(j) if is_far(j.limit))),
        "limits of revolute joints are cut to 0.99 of a half turn",
    );
    say(
        scene.all_specs().any(|spec| matches!(spec, Spec::Weld(j) if is_free(j.linear) || is_free(j.angular))),
        "a weld's spring of 0 hertz is rigid, not free",
    );
    say(
        any(|spec| matches!(spec, Spec::Wheel(j) if j.suspension.is_some_and(|s| s.target != 0.0))),
        "the suspension of a wheel is at rest at 0, not at its target",
    );
    say(any(|spec| matches!(spec, Spec::Mouse(_))), "a mouse joint is its motor joint without a torque");
    list
}
