//! Runs a scene file with Rapier: see lab/engine_run.hpp for the protocol.
//!
//! How many lanes Rapier's SIMD has and whether it knows threads is settled when it is built. So there are four programs of this source, with and
//! without the features `simd8` and `parallel`, side by side in one folder, and each hands over to the one that the arguments ask for: `--threads`
//! above 1 takes `parallel`, `--lanes 4` or `--lanes 8` the width. `carom-peer-rapier` is a copy of one of them.

mod bodies;
mod filters;
mod joints;

use carom_peer_scene::file::{Body, ChainSides, Joint, JointChange, Ray, SceneFile, SetBody, Spec, Vec2};
use carom_peer_scene::run::{Engine, State, Stop};
use rapier2d::prelude::*;
use std::process::ExitCode;
use std::sync::Mutex;

const LANES: usize = if cfg!(feature = "simd8") { 8 } else { 4 };
/// The width that measures better over a pile of boxes, mixed bodies and ragdolls.
const BETTER_LANES: usize = 8;

fn main() -> ExitCode {
    match hand_over() {
        Ok(arguments) => carom_peer_scene::run::main::<Rapier>(arguments),
        Err(problem) => {
            eprintln!("carom-peer-rapier: {problem}");
            ExitCode::FAILURE
        }
    }
}

/// Returns the arguments of the protocol when this is the program for them; else becomes the one that is.
fn hand_over() -> Result<Vec<String>, String> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let value = |arguments: &[String], name: &str| {
        let at = arguments.iter().position(|argument| argument == name)?;
        arguments.get(at + 1).cloned()
    };
    let lanes = match value(&arguments, "--lanes").as_deref() {
        None => BETTER_LANES,
        Some("4") => 4,
        Some("8") => 8,
        Some(other) => return Err(format!("--lanes is {other}; give 4 or 8")),
    };
    let is_parallel = value(&arguments, "--threads").is_some_and(|threads| threads.parse().is_ok_and(|n: usize| n > 1));
    if lanes == LANES && is_parallel == cfg!(feature = "parallel") {
        if let Some(at) = arguments.iter().position(|argument| argument == "--lanes") {
            arguments.drain(at..at + 2);
        }
        return Ok(arguments);
    }
    become_variant(lanes, is_parallel, &arguments)
}

fn become_variant(lanes: usize, is_parallel: bool, arguments: &[String]) -> Result<Vec<String>, String> {
    use std::os::unix::process::CommandExt;
    let this = std::env::current_exe().map_err(|error| format!("can't find itself: {error}"))?;
    let other = this.with_file_name(format!("carom-peer-rapier-{lanes}{}", if is_parallel { "-parallel" } else { "" }));
    let error = std::process::Command::new(&other).args(arguments).exec();
    Err(format!("{}: can't be started: {error}; build it with ./dev peers", other.display()))
}

pub struct Rapier {
    world: PhysicsWorld,
    events: Events,
    has_filters: bool, // some pair is not decided by 32 bits of category and mask
    settings: bodies::Settings,
    ground: Option<RigidBodyHandle>, // what joints to the world hold to
    differences: Vec<String>,
}

impl Engine for Rapier {
    const NAME: &'static str = "rapier";
    type Body = RigidBodyHandle;
    type Joint = ImpulseJointHandle;

    fn version() -> String {
        let threads = if cfg!(feature = "parallel") { ", parallel" } else { "" };
        format!("{}, {LANES} lanes{threads}", rapier2d::VERSION)
    }

    fn lacks(need: &str) -> Option<&'static str> {
        match need {
            "rolling_resistance" => Some("its materials have none"),
            "tangent_speed" => Some("its materials have none"),
            "point_fields" | "n_body_fields" => Some("it has one gravity for all"),
            "breakable_joints" => Some("its joints never break"),
            "gear_joints" | "pulley_joints" => Some("not among its joints"),
            _ => None,
        }
    }

    fn new(scene: &SceneFile, threads: usize) -> Result<Self, Stop> {
        filters::check(scene)?;
        let mut world = PhysicsWorld { gravity: vector(scene.world.acceleration(scene.world.gravity)), ..Default::default() };
        let parameters = &mut world.integration_parameters;
        let solver = &scene.world.solver;
        parameters.dt = scene.time_step;
        parameters.length_unit = scene.world.length_unit;
        parameters.num_solver_iterations = scene.substeps;
        parameters.max_ccd_substeps = usize::from(scene.world.continuous);
        parameters.contact_softness.natural_frequency = solver.contact_hertz;
        parameters.contact_softness.damping_ratio = solver.contact_damping_ratio;
        parameters.static_contact_softness.natural_frequency = 2.0 * solver.contact_hertz;
        parameters.static_contact_softness.damping_ratio = solver.contact_damping_ratio;
        parameters.normalized_max_corrective_velocity = solver.push_out_speed;
        use_threads(&mut world, threads)?;
        Ok(Rapier {
            world,
            events: Events::default(),
            has_filters: filters::needs_hook(scene),
            settings: bodies::Settings::of(&scene.world),
            ground: None,
            differences: differences_of(scene),
        })
    }

    fn create_body(&mut self, body: &Body) -> Result<RigidBodyHandle, Stop> {
        let handle = self.world.insert_body(bodies::body_of(body, &self.settings));
        for shape in &body.shapes {
            let collider = bodies::collider_of(shape, body, &self.settings)?;
            self.world.insert_collider(collider, Some(handle));
        }
        for collider in body.chains.iter().flat_map(|chain| bodies::colliders_of(chain, &self.settings)) {
            self.world.insert_collider(collider, Some(handle));
        }
        Ok(handle)
    }

    fn destroy_body(&mut self, body: RigidBodyHandle) {
        self.world.remove_body(body);
    }

    fn create_joint(
        &mut self,
        _: usize,
        joint: &Joint,
        a: Option<RigidBodyHandle>,
        b: RigidBodyHandle,
    ) -> Result<ImpulseJointHandle, Stop> {
        let a = a.unwrap_or_else(|| self.ground());
        let made = joints::joint_of(joint, &joint.spec)?;
        let world = &mut self.world;
        let wakes = [a, b].iter().any(|&body| world.bodies[body].is_dynamic() && !world.bodies[body].is_sleeping());
        Ok(world.impulse_joints.insert(a, b, made, wakes))
    }

    fn destroy_joint(&mut self, joint: ImpulseJointHandle) {
        self.world.remove_impulse_joint(joint);
    }

    fn set_gravity(&mut self, acceleration: Vec2) {
        self.world.gravity = vector(acceleration);
    }

    fn set_body(&mut self, body: RigidBodyHandle, set: &SetBody) {
        bodies::change(&mut self.world.bodies[body], set, &self.settings);
    }

    fn set_joint(&mut self, joint: ImpulseJointHandle, made_as: &Joint, change: &JointChange) -> Result<(), Stop> {
        let Some(joint) = self.world.impulse_joints.get_mut(joint, true) else { return Ok(()) };
        match change {
            JointChange::MotorSpeed(speed) => joints::set_motor_speed(&mut joint.data, &made_as.spec, *speed),
            JointChange::Spec(spec) => joint.data = joints::joint_of(made_as, spec)?,
        }
        Ok(())
    }

    fn step(&mut self) {
        if self.has_filters {
            self.world.step_with_events(&filters::Hook, &self.events);
        } else {
            self.world.step_with_events(&(), &self.events);
        }
        self.events.collisions.lock().unwrap().clear();
    }

    fn cast(&mut self, rays: &[Ray]) -> usize {
        let groups = InteractionGroups::new(Group::GROUP_1, Group::ALL, InteractionTestMode::And);
        let queries = self.world.query_pipeline_with_filter(QueryFilter::new().exclude_sensors().groups(groups));
        let meets = |ray: &&Ray| {
            let way = rapier2d::geometry::Ray::new(vector(ray.start), vector(ray.sweep));
            queries.cast_ray(&way, 1.0, true).is_some()
        };
        rays.iter().filter(meets).count()
    }

    fn state(&self, body: RigidBodyHandle) -> State {
        let body = &self.world.bodies[body];
        let (place, velocity) = (body.translation(), body.linvel());
        let angle = f64::from(body.rotation().im).atan2(f64::from(body.rotation().re));
        [place.x.into(), place.y.into(), angle, velocity.x.into(), velocity.y.into(), body.angvel().into()]
    }

    fn differences(&self) -> Vec<String> {
        self.differences.clone()
    }
}

impl Rapier {
    fn ground(&mut self) -> RigidBodyHandle {
        let world = &mut self.world;
        *self.ground.get_or_insert_with(|| world.insert_body(RigidBodyBuilder::fixed()))
    }
}

#[cfg(feature = "parallel")]
fn use_threads(world: &mut PhysicsWorld, threads: usize) -> Result<(), Stop> {
    world.configure_thread_pool(threads).map_err(|error| Stop::Wrong(format!("{threads} threads can't be had: {error}")))
}

#[cfg(not(feature = "parallel"))]
fn use_threads(_: &mut PhysicsWorld, _: usize) -> Result<(), Stop> {
    Ok(())
}

/// Keeps what the engine reports, as a game would.
#[derive(Default)]
struct Events {
    collisions: Mutex<Vec<CollisionEvent>>,
}

impl EventHandler for Events {
    fn handle_collision_event(&self, _: &RigidBodySet, _: &ColliderSet, event: CollisionEvent, _: Option<&ContactPair>) {
        self.collisions.lock().unwrap().push(event);
    }
    fn handle_contact_force_event(&self, _: Real, _: &RigidBodySet, _: &ColliderSet, _: &ContactPair, _: Real) {}
    fn handle_soft_body_tear_event(&self, _: &SoftBodySet, _: &SoftBodyTearEvent) {}
}

fn differences_of(scene: &SceneFile) -> Vec<String> {
    let mut list = Vec::new();
    let mut say = |is_so: bool, what: &str| {
        if is_so {
            list.push(what.to_string());
        }
    };
    let bounces = scene.all_shapes().any(|shape| shape.material.restitution > 0.0);
    say(bounces, "every new contact bounces, however slow it is: there is no restitution threshold");
    let is_rounded = |shape: &carom_peer_scene::file::Shape| bodies::is_rounded(&shape.geometry);
    say(scene.all_shapes().any(is_rounded), "a rounded polygon has its full mass, and the inertia of its unrounded core scaled to that");
    let differs = |chain: &carom_peer_scene::file::Chain| chain.materials.len() > 1;
    say(scene.all_chains().any(differs), "a chain of several materials is made of polylines that know nothing of each other");
    let two_sided = scene.all_chains().any(|chain| chain.sides == ChainSides::TwoSided);
    say(two_sided, "two-sided chains are polylines, on whose corners things can catch");
    say(filters::needs_hook(scene), "groups are minded by a hook, which keeps such pairs from being skipped");
    say(true, "skips contacts whose bodies have barely moved: their points, materials and filters are not computed anew");
    let asks = scene.all_shapes().any(|shape| shape.persist_events || shape.hit_events);
    say(asks, "contacts that go on and hits are not reported");
    say(scene.all_specs().next().is_some(), "joints have the engine's own stiffness and no warm start, as it comes");
    list.extend(joints::differences_of(&scene.all_specs().collect::<Vec<&Spec>>()));
    list
}

pub fn vector(v: Vec2) -> Vector {
    Vector::new(v[0], v[1])
}
