//! Joints of a scene file, and how events change them.

use super::{Vec2, one, the_one};
use serde::Deserialize;

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    pub lower: f32,
    pub upper: f32,
}

/// As much as it takes: the default of what drives bodies [N] or [N m].
const MAX_JOINT_FORCE: f32 = 1e20;

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Motor {
    pub speed: f32,
    pub max_force: f32,
}

impl Default for Motor {
    fn default() -> Self {
        Self { speed: 0.0, max_force: MAX_JOINT_FORCE }
    }
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Spring {
    pub hertz: f32,
    pub damping_ratio: f32,
    pub target: f32,
}

impl Default for Spring {
    fn default() -> Self {
        Self { hertz: 5.0, damping_ratio: 0.7, target: 0.0 }
    }
}

/// A pose seen from a body's origin; q is [cosine, sine].
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Frame {
    pub p: Vec2,
    pub q: Vec2,
}

impl Default for Frame {
    fn default() -> Self {
        Self { p: [0.0; 2], q: [1.0, 0.0] }
    }
}

impl Frame {
    pub fn angle(&self) -> f32 {
        self.q[1].atan2(self.q[0])
    }
    /// This frame, then moved and turned as seen from it.
    pub fn then(&self, offset: Vec2, angle: f32) -> Frame {
        let [c, s] = self.q;
        let (sine, cosine) = angle.sin_cos();
        Frame {
            p: [self.p[0] + c * offset[0] - s * offset[1], self.p[1] + s * offset[0] + c * offset[1]],
            q: [c * cosine - s * sine, s * cosine + c * sine],
        }
    }
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Revolute {
    pub limit: Option<Range>,
    pub motor: Option<Motor>,
    pub spring: Option<Spring>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Prismatic {
    pub limit: Option<Range>,
    pub motor: Option<Motor>,
    pub spring: Option<Spring>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Distance {
    #[serde(default = "one")]
    pub length: f32,
    #[serde(default)]
    pub limit: Option<Range>,
    #[serde(default)]
    pub spring: Option<Spring>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Weld {
    pub linear: Option<Spring>,
    pub angular: Option<Spring>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wheel {
    #[serde(default = "a_spring")]
    pub suspension: Option<Spring>,
    #[serde(default)]
    pub limit: Option<Range>,
    #[serde(default)]
    pub motor: Option<Motor>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MotorJoint {
    pub offset: Vec2,
    pub angle: f32,
    pub spring: Spring,
    pub max_force: f32,
    pub max_torque: f32,
}

impl Default for MotorJoint {
    fn default() -> Self {
        Self {
            offset: Vec2::default(),
            angle: 0.0,
            spring: Spring::default(),
            max_force: MAX_JOINT_FORCE,
            max_torque: MAX_JOINT_FORCE,
        }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mouse {
    pub target: Vec2,
    pub spring: Spring,
    pub max_force: f32,
}

impl Default for Mouse {
    fn default() -> Self {
        Self { target: Vec2::default(), spring: Spring::default(), max_force: MAX_JOINT_FORCE }
    }
}

/// What a joint is. Of gears and pulleys, which no Rust peer has, only that they are there.
#[derive(Clone, Debug)]
pub enum Spec {
    Revolute(Revolute),
    Prismatic(Prismatic),
    Distance(Distance),
    Weld(Weld),
    Wheel(Wheel),
    Motor(MotorJoint),
    Mouse(Mouse),
    Gear,
    Pulley,
}

impl Spec {
    pub fn name(&self) -> &'static str {
        match self {
            Spec::Revolute(_) => "revolute",
            Spec::Prismatic(_) => "prismatic",
            Spec::Distance(_) => "distance",
            Spec::Weld(_) => "weld",
            Spec::Wheel(_) => "wheel",
            Spec::Motor(_) => "motor",
            Spec::Mouse(_) => "mouse",
            Spec::Gear => "gear",
            Spec::Pulley => "pulley",
        }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "JointFields")]
pub struct Joint {
    pub body_a: Option<usize>,
    pub body_b: usize,
    pub frame_a: Frame,
    pub frame_b: Frame,
    pub collide_connected: bool,
    pub break_force: Option<f32>,
    pub break_torque: Option<f32>,
    pub spec: Spec,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JointFields {
    #[serde(default, rename = "name")]
    _name: String,
    #[serde(default)]
    body_a: Option<usize>,
    body_b: usize,
    #[serde(default)]
    frame_a: Frame,
    #[serde(default)]
    frame_b: Frame,
    #[serde(default)]
    collide_connected: bool,
    #[serde(default)]
    break_force: Option<f32>,
    #[serde(default)]
    break_torque: Option<f32>,
    #[serde(default, rename = "user_data")]
    _user_data: u64,
    revolute: Option<Revolute>,
    prismatic: Option<Prismatic>,
    distance: Option<Distance>,
    weld: Option<Weld>,
    wheel: Option<Wheel>,
    motor: Option<MotorJoint>,
    mouse: Option<Mouse>,
    gear: Option<serde::de::IgnoredAny>,
    pulley: Option<serde::de::IgnoredAny>,
}

impl TryFrom<JointFields> for Joint {
    type Error = String;

    fn try_from(f: JointFields) -> Result<Self, String> {
        let kinds = [
            f.revolute.map(Spec::Revolute),
            f.prismatic.map(Spec::Prismatic),
            f.distance.map(Spec::Distance),
            f.weld.map(Spec::Weld),
            f.wheel.map(Spec::Wheel),
            f.motor.map(Spec::Motor),
            f.mouse.map(Spec::Mouse),
            f.gear.map(|_| Spec::Gear),
            f.pulley.map(|_| Spec::Pulley),
        ];
        Ok(Joint {
            body_a: f.body_a,
            body_b: f.body_b,
            frame_a: f.frame_a,
            frame_b: f.frame_b,
            collide_connected: f.collide_connected,
            break_force: f.break_force,
            break_torque: f.break_torque,
            spec: the_one(kinds, "a joint has one type, as revolute")?,
        })
    }
}

#[derive(Clone, Debug)]
pub enum JointChange {
    MotorSpeed(f32),
    Spec(Spec),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "SetJointFields")]
pub struct SetJoint {
    pub joint: usize,
    pub change: JointChange,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SetJointFields {
    joint: usize,
    motor_speed: Option<f32>,
    revolute: Option<Revolute>,
    prismatic: Option<Prismatic>,
    distance: Option<Distance>,
    weld: Option<Weld>,
    wheel: Option<Wheel>,
    motor: Option<MotorJoint>,
    mouse: Option<Mouse>,
    gear: Option<serde::de::IgnoredAny>,
    pulley: Option<serde::de::IgnoredAny>,
}

impl TryFrom<SetJointFields> for SetJoint {
    type Error = String;

    fn try_from(f: SetJointFields) -> Result<Self, String> {
        let changes = [
            f.motor_speed.map(JointChange::MotorSpeed),
            f.revolute.map(|j| JointChange::Spec(Spec::Revolute(j))),
            f.prismatic.map(|j| JointChange::Spec(Spec::Prismatic(j))),
            f.distance.map(|j| JointChange::Spec(Spec::Distance(j))),
            f.weld.map(|j| JointChange::Spec(Spec::Weld(j))),
            f.wheel.map(|j| JointChange::Spec(Spec::Wheel(j))),
            f.motor.map(|j| JointChange::Spec(Spec::Motor(j))),
            f.mouse.map(|j| JointChange::Spec(Spec::Mouse(j))),
            f.gear.map(|_| JointChange::Spec(Spec::Gear)),
            f.pulley.map(|_| JointChange::Spec(Spec::Pulley)),
        ];
        Ok(SetJoint { joint: f.joint, change: the_one(changes, "give motor_speed or the joint's type")? })
    }
}

fn a_spring() -> Option<Spring> {
    Some(Spring::default())
}
