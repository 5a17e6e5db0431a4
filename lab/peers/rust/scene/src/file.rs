//! A scene file as plain data: the counterpart of scene_file/model.hpp. docs/scene-files.md and docs/scene.schema.json say what the fields mean.

mod joints;
mod shapes;

pub use joints::*;
use serde::Deserialize;
pub use shapes::*;

pub type Vec2 = [f32; 2];

#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyType {
    Static,
    Kinematic,
    Dynamic,
}

#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mixing {
    GeometricMean,
    Average,
    Minimum,
    Maximum,
    Product,
}

#[derive(Clone, Copy, Default, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Locks {
    pub x: bool,
    pub y: bool,
    pub rotation: bool,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MassData {
    pub mass: f32,
    #[serde(default)]
    pub center: Vec2,
    /// About the centre of mass.
    pub inertia: f32,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Body {
    pub name: String,
    #[serde(rename = "type")]
    pub kind: BodyType,
    pub position: Vec2,
    pub angle: f32,
    pub linear_velocity: Vec2,
    pub angular_velocity: f32,
    pub linear_damping: f32,
    pub angular_damping: f32,
    pub gravity_scale: f32,
    pub locks: Locks,
    pub can_sleep: bool,
    pub is_bullet: bool,
    pub is_attractor: bool,
    pub is_enabled: bool,
    pub user_data: u64,
    pub is_awake: bool,
    pub mass_data: Option<MassData>,
    pub shapes: Vec<Shape>,
    pub chains: Vec<Chain>,
}

impl Default for Body {
    fn default() -> Self {
        Self {
            name: String::new(),
            kind: BodyType::Dynamic,
            position: [0.0; 2],
            angle: 0.0,
            linear_velocity: [0.0; 2],
            angular_velocity: 0.0,
            linear_damping: 0.0,
            angular_damping: 0.0,
            gravity_scale: 1.0,
            locks: Locks::default(),
            can_sleep: true,
            is_bullet: false,
            is_attractor: false,
            is_enabled: true,
            user_data: 0,
            is_awake: true,
            mass_data: None,
            shapes: Vec::new(),
            chains: Vec::new(),
        }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetBody {
    pub body: usize,
    #[serde(rename = "type")]
    pub kind: Option<BodyType>,
    pub position: Option<Vec2>,
    pub angle: Option<f32>,
    pub linear_velocity: Option<Vec2>,
    pub angular_velocity: Option<f32>,
    pub linear_damping: Option<f32>,
    pub angular_damping: Option<f32>,
    pub gravity_scale: Option<f32>,
    pub locks: Option<Locks>,
    pub can_sleep: Option<bool>,
    pub is_bullet: Option<bool>,
    #[serde(rename = "is_attractor")]
    _is_attractor: Option<bool>, // no peer has fields between bodies
    pub is_enabled: Option<bool>,
    pub is_awake: Option<bool>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SetWorld {
    pub gravity: Option<Vec2>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Event {
    pub step: usize,
    #[serde(default)]
    pub destroy_joints: Vec<usize>,
    #[serde(default)]
    pub destroy_bodies: Vec<usize>,
    #[serde(default)]
    pub create_bodies: Vec<Body>,
    #[serde(default)]
    pub create_joints: Vec<Joint>,
    #[serde(default)]
    pub set_world: Option<SetWorld>,
    #[serde(default)]
    pub set_bodies: Vec<SetBody>,
    #[serde(default)]
    pub set_joints: Vec<SetJoint>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sleep {
    pub is_enabled: bool,
    pub speed: f32,
    pub time: f32,
}

impl Default for Sleep {
    fn default() -> Self {
        Self { is_enabled: true, speed: 0.05, time: 0.5 }
    }
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Solver {
    pub contact_hertz: f32,
    pub contact_damping_ratio: f32,
    pub push_out_speed: f32,
    pub restitution_threshold: f32,
    pub joint_hertz: f32,
    pub joint_damping_ratio: f32,
    pub warm_starting: bool,
}

impl Default for Solver {
    fn default() -> Self {
        Self {
            contact_hertz: 30.0,
            contact_damping_ratio: 10.0,
            push_out_speed: 3.0,
            restitution_threshold: 1.0,
            joint_hertz: 60.0,
            joint_damping_ratio: 2.0,
            warm_starting: true,
        }
    }
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MixingRules {
    pub friction: Mixing,
    pub restitution: Mixing,
}

impl Default for MixingRules {
    fn default() -> Self {
        Self { friction: Mixing::GeometricMean, restitution: Mixing::Maximum }
    }
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Uniform {
    pub acceleration: Vec2,
}

/// Of the kinds that no Rust peer has, only that they are there.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Field {
    Uniform(Uniform),
    Point(serde::de::IgnoredAny),
    NBody(serde::de::IgnoredAny),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct World {
    pub gravity: Vec2,
    pub continuous: bool,
    pub sleep: Sleep,
    pub solver: Solver,
    pub mixing: MixingRules,
    pub hit_speed: f32,
    pub length_unit: f32,
    #[serde(rename = "max_pairs")]
    _max_pairs: u32, // a guard of Carom's own
    pub fields: Vec<Field>,
}

impl Default for World {
    fn default() -> Self {
        Self {
            gravity: [0.0, -9.81],
            continuous: true,
            sleep: Sleep::default(),
            solver: Solver::default(),
            mixing: MixingRules::default(),
            hit_speed: 1.0,
            length_unit: 1.0,
            _max_pairs: 0,
            fields: Vec::new(),
        }
    }
}

impl World {
    /// What gravity and the uniform fields give together, which is all the same to an engine.
    pub fn acceleration(&self, gravity: Vec2) -> Vec2 {
        let mut sum = gravity;
        for field in &self.fields {
            if let Field::Uniform(uniform) = field {
                sum = [sum[0] + uniform.acceleration[0], sum[1] + uniform.acceleration[1]];
            }
        }
        sum
    }
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ray {
    pub start: Vec2,
    pub sweep: Vec2,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    pub carom_scene: u32,
    #[serde(default)]
    pub name: String,
    #[serde(default, rename = "description")]
    _description: String,
    #[serde(default, rename = "notes")]
    _notes: Vec<String>,
    #[serde(default)]
    pub needs: Vec<String>,
    #[serde(default = "a_sixtieth")]
    pub time_step: f32,
    #[serde(default = "four")]
    pub substeps: usize,
    #[serde(default = "six_hundred")]
    pub steps: usize,
    #[serde(default, rename = "view")]
    _view: Option<serde::de::IgnoredAny>,
    #[serde(default)]
    pub world: World,
    #[serde(default)]
    pub bodies: Vec<Body>,
    #[serde(default)]
    pub joints: Vec<Joint>,
    #[serde(default)]
    pub events: Vec<Event>,
    #[serde(default)]
    pub rays: Vec<Ray>,
}

impl SceneFile {
    /// All bodies of the file, those of events included, by their numbers.
    pub fn all_bodies(&self) -> impl Iterator<Item = &Body> {
        self.bodies.iter().chain(self.events.iter().flat_map(|event| &event.create_bodies))
    }
    pub fn all_joints(&self) -> impl Iterator<Item = &Joint> {
        self.joints.iter().chain(self.events.iter().flat_map(|event| &event.create_joints))
    }
    /// All that joints are or become.
    pub fn all_specs(&self) -> impl Iterator<Item = &Spec> {
        let later = self.events.iter().flat_map(|event| &event.set_joints).filter_map(|set| match &set.change {
            JointChange::Spec(spec) => Some(spec),
            JointChange::MotorSpeed(_) => None,
        });
        self.all_joints().map(|joint| &joint.spec).chain(later)
    }
    pub fn all_shapes(&self) -> impl Iterator<Item = &Shape> {
        self.all_bodies().flat_map(|body| &body.shapes)
    }
    pub fn all_chains(&self) -> impl Iterator<Item = &Chain> {
        self.all_bodies().flat_map(|body| &body.chains)
    }
}

/// Reads a scene file; the error names the file and the place in it.
pub fn read(path: &str) -> Result<SceneFile, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: can't be read: {error}"))?;
    let mut reader = serde_json::Deserializer::from_str(&text);
    let scene: SceneFile = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let place = error.path().to_string();
        if place == "." { format!("{path}: {}", error.inner()) } else { format!("{path}: {place}: {}", error.inner()) }
    })?;
    reader.end().map_err(|error| format!("{path}: {error}"))?;
    check(&scene).map_err(|problem| format!("{path}: {problem}"))?;
    Ok(scene)
}

fn check(scene: &SceneFile) -> Result<(), String> {
    if scene.carom_scene != 1 {
        return Err(format!("carom_scene is {}; this program reads version 1", scene.carom_scene));
    }
    if scene.steps == 0 || scene.substeps == 0 || scene.time_step.is_nan() || scene.time_step <= 0.0 {
        return Err("steps, substeps and time_step must be more than 0".to_string());
    }
    for chain in scene.all_chains() {
        if chain.points.len() < if chain.is_loop { 3 } else { 2 } {
            return Err("a chain has 2 points or more, a loop 3 or more".to_string());
        }
        if chain.materials.len() > 1 && chain.materials.len() != chain.segment_count() {
            return Err(format!("a chain has {} materials; give none, one, or one a segment", chain.materials.len()));
        }
    }
    if scene.events.windows(2).any(|pair| pair[1].step < pair[0].step) {
        return Err("events are out of order; give them by step".to_string());
    }
    Ok(())
}

fn the_one<T, const N: usize>(kinds: [Option<T>; N], rule: &str) -> Result<T, String> {
    let mut given = kinds.into_iter().flatten();
    match (given.next(), given.next()) {
        (Some(kind), None) => Ok(kind),
        (None, _) => Err(format!("{rule}; none is given")),
        _ => Err(format!("{rule}; several are given")),
    }
}

fn yes() -> bool {
    true
}
fn one() -> f32 {
    1.0
}
fn a_sixtieth() -> f32 {
    1.0 / 60.0
}
fn four() -> usize {
    4
}
fn six_hundred() -> usize {
    600
}
