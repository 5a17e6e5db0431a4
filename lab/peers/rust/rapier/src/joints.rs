//! Joints of Rapier: one kind of joint, of which axes are locked, limited and driven. A spring is a motor towards a place.

use crate::vector;
use carom_peer_scene::file::{Frame, Joint, Motor, Range, Spec, Spring};
use carom_peer_scene::run::Stop;
use rapier2d::prelude::*;
use std::f32::consts::TAU;

/// What turns a velocity motor's pull into all the force that it has [1/s].
const HARD: f32 = 1e7;
/// A rod swings this often when it is a spring; its joints' locked axes swing as often as it can compute.
const ROD_HERTZ: f32 = 1e4;

pub fn joint_of(joint: &Joint, spec: &Spec) -> Result<GenericJoint, Stop> {
    let lin = JointAxesMask::LIN_AXES;
    let mut made = match spec {
        Spec::Revolute(_) => GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES),
        Spec::Prismatic(_) => GenericJoint::new(JointAxesMask::LOCKED_PRISMATIC_AXES),
        Spec::Wheel(_) => GenericJoint::new(JointAxesMask::LOCKED_PIN_SLOT_AXES),
        Spec::Weld(j) => {
            let held = if j.linear.is_some() { JointAxesMask::empty() } else { lin };
            GenericJoint::new(held | if j.angular.is_some() { JointAxesMask::empty() } else { JointAxesMask::ANG_AXES })
        }
        Spec::Distance(_) => GenericJoint { coupled_axes: lin, ..GenericJoint::new(JointAxesMask::empty()) },
        Spec::Motor(_) | Spec::Mouse(_) => GenericJoint::new(JointAxesMask::empty()),
        Spec::Gear | Spec::Pulley => return Err(Stop::Lacks(format!("the engine has no {} joints", spec.name()))),
    };
    made.local_frame1 = pose(&joint.frame_a);
    made.local_frame2 = pose(&joint.frame_b);
    made.contacts_enabled = joint.collide_connected;
    match spec {
        Spec::Revolute(j) => drive(&mut made, JointAxis::AngX, j.limit, j.motor, j.spring)?,
        Spec::Prismatic(j) => drive(&mut made, JointAxis::LinX, j.limit, j.motor, j.spring)?,
        Spec::Wheel(j) => {
            drive(&mut made, JointAxis::LinX, j.limit, None, j.suspension)?;
            drive(&mut made, JointAxis::AngX, None, j.motor, None)?;
        }
        Spec::Weld(j) => {
            for (axis, spring) in [(JointAxis::LinX, j.linear), (JointAxis::LinY, j.linear), (JointAxis::AngX, j.angular)] {
                drive(&mut made, axis, None, None, spring.map(|spring| Spring { target: 0.0, ..spring }))?;
            }
        }
        Spec::Distance(j) => keep_distance(&mut made, j.length, j.limit, j.spring)?,
        Spec::Motor(j) => {
            made.local_frame1 = pose(&joint.frame_a.then(j.offset, j.angle));
            pull(&mut made, &[JointAxis::LinX, JointAxis::LinY], j.spring, j.max_force);
            pull(&mut made, &[JointAxis::AngX], j.spring, j.max_torque);
        }
        Spec::Mouse(j) => {
            made.local_frame1 = Pose::from_translation(vector(j.target));
            pull(&mut made, &[JointAxis::LinX, JointAxis::LinY], j.spring, j.max_force);
        }
        Spec::Gear | Spec::Pulley => {}
    }
    Ok(made)
}

fn pose(frame: &Frame) -> Pose {
    Pose::from_parts(vector(frame.p), Rotation::from_cos_sin_unchecked(frame.q[0], frame.q[1]))
}

fn drive(
    joint: &mut GenericJoint,
    axis: JointAxis,
    limit: Option<Range>,
    motor: Option<Motor>,
    spring: Option<Spring>,
) -> Result<(), Stop> {
    if let Some(Range { lower, upper }) = limit {
        joint.set_limits(axis, [lower, upper]);
    }
    match (motor, spring.filter(|spring| spring.hertz > 0.0)) {
        (Some(_), Some(_)) => return Err(Stop::Lacks("the engine's joints have a motor or a spring on an axis, not both".into())),
        (Some(motor), None) => {
            joint.set_motor_velocity(axis, motor.speed, HARD).set_motor_max_force(axis, motor.max_force);
        }
        (None, Some(spring)) => spring_towards(joint, axis, spring.target, spring),
        (None, None) => {}
    }
    Ok(())
}

fn spring_towards(joint: &mut GenericJoint, axis: JointAxis, target: f32, spring: Spring) {
    let omega = TAU * spring.hertz;
    joint.set_motor_position(axis, target, omega * omega, 2.0 * spring.damping_ratio * omega);
}

fn pull(joint: &mut GenericJoint, axes: &[JointAxis], spring: Spring, most: f32) {
    if spring.hertz > 0.0 {
        for &axis in axes {
            spring_towards(joint, axis, 0.0, spring);
            joint.set_motor_max_force(axis, most);
        }
    }
}

fn keep_distance(joint: &mut GenericJoint, length: f32, limit: Option<Range>, spring: Option<Spring>) -> Result<(), Stop> {
    if limit.is_some_and(|limit| limit.lower > 0.0) {
        return Err(Stop::Lacks("the engine's joints keep no shortest distance".into()));
    }
    if let Some(limit) = limit {
        joint.set_limits(JointAxis::LinX, [0.0, limit.upper]);
    }
    match (spring, limit) {
        (Some(spring), _) if spring.hertz > 0.0 => spring_towards(joint, JointAxis::LinX, length, spring),
        (None, None) => {
            let rod = Spring { hertz: ROD_HERTZ, damping_ratio: 1.0, target: 0.0 };
            spring_towards(joint, JointAxis::LinX, length, rod);
        }
        _ => {}
    }
    Ok(())
}

pub fn set_motor_speed(joint: &mut GenericJoint, spec: &Spec, speed: f32) {
    let axis = if matches!(spec, Spec::Prismatic(_)) { JointAxis::LinX } else { JointAxis::AngX };
    joint.motors[axis as usize].target_vel = speed;
}

pub fn differences_of(specs: &[&Spec]) -> Vec<String> {
    let mut list = Vec::new();
    let mut say = |is_so: bool, what: &str| {
        if is_so {
            list.push(what.to_string());
        }
    };
    let is_rod = |spec: &&Spec| matches!(spec, Spec::Distance(j) if j.spring.is_none() && j.limit.is_none());
    say(specs.iter().any(is_rod), "a rod is a very stiff spring, for lack of a joint that keeps a distance");
    let is_wide = |spec: &&Spec| matches!(spec, Spec::Revolute(j) if j.limit.is_some_and(|l| l.upper - l.lower >= TAU));
    say(specs.iter().any(is_wide), "limits wider than a full turn are none");
    let is_pulled = |spec: &&Spec| matches!(spec, Spec::Motor(_) | Spec::Mouse(_));
    say(specs.iter().any(is_pulled), "the greatest force of motor and mouse joints holds for each axis by itself");
    list
}
