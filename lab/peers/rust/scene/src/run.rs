//! Plays a scene on an engine, times its steps, and writes the result: the protocol of lab/engine_run.hpp.

use crate::file::{self, Body, Event, Joint, JointChange, Ray, SceneFile, SetBody, Vec2};
use crate::needs;
use serde::Serialize;
use std::process::ExitCode;
use std::time::Instant;

/// Why a scene was not run.
pub enum Stop {
    /// The engine lacks something that the scene needs.
    Lacks(String),
    /// The file is wrong, or the result can't be written.
    Wrong(String),
}

/// Where a body's origin is, its angle, and the velocities of its centre of mass: x, y, angle, vx, vy, w.
pub type State = [f64; 6];

/// An engine with a world in it. Bodies and joints have the numbers that the file gives them; the player checks that they are there.
pub trait Engine: Sized {
    const NAME: &'static str;
    type Body: Copy;
    type Joint: Copy;

    fn version() -> String;
    /// Why the engine can't do what a word of `needs` says; none when it can.
    fn lacks(need: &str) -> Option<&'static str>;
    fn new(scene: &SceneFile, threads: usize) -> Result<Self, Stop>;

    fn create_body(&mut self, body: &Body) -> Result<Self::Body, Stop>;
    /// With its joints.
    fn destroy_body(&mut self, body: Self::Body);
    /// `a` is none when the joint holds to the world.
    fn create_joint(&mut self, number: usize, joint: &Joint, a: Option<Self::Body>, b: Self::Body) -> Result<Self::Joint, Stop>;
    fn destroy_joint(&mut self, joint: Self::Joint);
    fn set_gravity(&mut self, acceleration: Vec2);
    fn set_body(&mut self, body: Self::Body, set: &SetBody);
    fn set_joint(&mut self, joint: Self::Joint, made_as: &Joint, change: &JointChange) -> Result<(), Stop>;

    /// This alone is timed as a step.
    fn step(&mut self);
    /// Numbers of joints that the step overstrained. The player destroys them.
    fn broken_joints(&mut self) -> Vec<usize> {
        Vec::new()
    }
    /// How many rays meet something. Timed by itself.
    fn cast(&mut self, rays: &[Ray]) -> usize;
    fn state(&self, body: Self::Body) -> State;
    /// What is not as the file asks, in plain words.
    fn differences(&self) -> Vec<String>;
}

#[derive(Serialize)]
struct Sample {
    step: usize,
    bodies: Vec<Option<State>>,
}

#[derive(Serialize)]
struct RunResult {
    engine: String,
    /// The file, as the command line named it.
    scene: String,
    version: String,
    differences: Vec<String>,
    step_ms: Vec<f64>,
    /// What creating, destroying and changing took before each step; there only when the file has events.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    event_ms: Vec<f64>,
    /// What all rays of a step took; there only when the file has some.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    ray_ms: Vec<f64>,
    /// Rays that met something, after the last step.
    #[serde(skip_serializing_if = "Option::is_none")]
    ray_hits: Option<usize>,
    samples: Vec<Sample>,
}

struct Arguments {
    scene: String,
    threads: usize,
    samples: usize,
    out: String,
}

/// The whole program, for the arguments after its name.
pub fn main<E: Engine>(arguments: Vec<String>) -> ExitCode {
    let program = format!("carom-peer-{}", E::NAME);
    let outcome = parse(&arguments)
        .map_err(|problem| Stop::Wrong(format!("{problem}\nusage: {program} SCENE.json --threads N --samples K --out RESULT.json")));
    match outcome.and_then(|arguments| run::<E>(&arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Stop::Lacks(what)) => {
            eprintln!("{program}: {what}");
            ExitCode::from(3)
        }
        Err(Stop::Wrong(what)) => {
            eprintln!("{program}: {what}");
            ExitCode::FAILURE
        }
    }
}

fn parse(arguments: &[String]) -> Result<Arguments, String> {
    let mut parsed = Arguments { scene: String::new(), threads: 1, samples: 1, out: String::new() };
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        if !argument.starts_with("--") {
            if !parsed.scene.is_empty() {
                return Err(format!("two scenes are given: {} and {argument}", parsed.scene));
            }
            parsed.scene = argument.clone();
            continue;
        }
        let value = rest.next().ok_or(format!("{argument} needs a value"))?;
        match argument.as_str() {
            "--threads" => parsed.threads = number(argument, value, 64)?,
            "--samples" => parsed.samples = number(argument, value, 1_000_000)?,
            "--out" => parsed.out = value.clone(),
            _ => return Err(format!("{argument} is no option")),
        }
    }
    if parsed.scene.is_empty() || parsed.out.is_empty() {
        return Err("give a scene and --out".to_string());
    }
    Ok(parsed)
}

fn number(option: &str, value: &str, most: usize) -> Result<usize, String> {
    let number = value.parse().ok().filter(|n| (1..=most).contains(n));
    number.ok_or(format!("{option} is {value}; give a number from 1 to {most}"))
}

fn run<E: Engine>(arguments: &Arguments) -> Result<(), Stop> {
    let scene = file::read(&arguments.scene).map_err(Stop::Wrong)?;
    let needs = needs::of(&scene).map_err(|problem| Stop::Wrong(format!("{}: {problem}", arguments.scene)))?;
    let lacking: Vec<String> = needs.iter().filter_map(|need| E::lacks(need).map(|why| format!("{need} ({why})"))).collect();
    if !lacking.is_empty() {
        return Err(Stop::Lacks(format!("{}: the engine lacks {}", arguments.scene, lacking.join(", "))));
    }
    let mut result = Player::<E>::new(&scene, arguments.threads).and_then(|player| player.play(arguments.samples)).map_err(|stop| {
        let name = |what: String| format!("{}: {what}", arguments.scene);
        match stop {
            Stop::Lacks(what) => Stop::Lacks(name(what)),
            Stop::Wrong(what) => Stop::Wrong(name(what)),
        }
    })?;
    result.scene.clone_from(&arguments.scene);
    let text = serde_json::to_string(&result).expect("a result is JSON");
    std::fs::write(&arguments.out, text + "\n").map_err(|error| Stop::Wrong(format!("{}: can't be written: {error}", arguments.out)))
}

struct PlayedJoint<'a, E: Engine> {
    handle: E::Joint,
    made_as: &'a Joint,
}

enum Place<T> {
    There(T),
    Broken,
    Gone,
}

struct Player<'a, E: Engine> {
    scene: &'a SceneFile,
    engine: E,
    bodies: Vec<Option<E::Body>>,
    joints: Vec<Place<PlayedJoint<'a, E>>>,
    joints_of: Vec<Vec<usize>>, // by body
}

impl<'a, E: Engine> Player<'a, E> {
    fn new(scene: &'a SceneFile, threads: usize) -> Result<Self, Stop> {
        let engine = E::new(scene, threads)?;
        let mut player = Player { scene, engine, bodies: Vec::new(), joints: Vec::new(), joints_of: Vec::new() };
        player.create(&scene.bodies, &scene.joints)?;
        Ok(player)
    }

    fn play(mut self, samples: usize) -> Result<RunResult, Stop> {
        let steps = self.scene.steps;
        let samples = samples.min(steps);
        let mut result = RunResult {
            engine: E::NAME.to_string(),
            scene: String::new(),
            version: E::version(),
            differences: Vec::new(),
            step_ms: Vec::with_capacity(steps),
            event_ms: Vec::new(),
            ray_ms: Vec::new(),
            ray_hits: None,
            samples: Vec::with_capacity(samples),
        };
        let mut events = self.scene.events.iter().peekable();
        for step in 0..steps {
            let (broken, event_ms) = timed(|| -> Result<(), Stop> {
                while let Some(event) = events.next_if(|event| event.step == step) {
                    self.apply(event)?;
                }
                Ok(())
            });
            broken?;
            let ((), step_ms) = timed(|| self.engine.step());
            result.step_ms.push(step_ms);
            let ((), break_ms) = timed(|| self.destroy_broken());
            if !self.scene.events.is_empty() {
                result.event_ms.push(event_ms + break_ms);
            }
            if !self.scene.rays.is_empty() {
                let (hits, ray_ms) = timed(|| self.engine.cast(&self.scene.rays));
                result.ray_ms.push(ray_ms);
                result.ray_hits = Some(hits);
            }
            let done = step + 1;
            if done * samples / steps > step * samples / steps {
                result.samples.push(self.sample(done));
            }
        }
        result.differences = self.engine.differences();
        Ok(result)
    }

    fn sample(&self, step: usize) -> Sample {
        Sample { step, bodies: self.bodies.iter().map(|body| body.map(|body| self.engine.state(body))).collect() }
    }

    fn apply(&mut self, event: &'a Event) -> Result<(), Stop> {
        for &number in &event.destroy_joints {
            if let Place::There(joint) = self.joint(number)? {
                let handle = joint.handle;
                self.engine.destroy_joint(handle);
            }
            self.joints[number] = Place::Gone;
        }
        for &number in &event.destroy_bodies {
            let body = self.body(number)?;
            self.engine.destroy_body(body);
            self.bodies[number] = None;
            for joint in std::mem::take(&mut self.joints_of[number]) {
                self.joints[joint] = Place::Gone;
            }
        }
        self.create(&event.create_bodies, &event.create_joints)?;
        if let Some(gravity) = event.set_world.as_ref().and_then(|set| set.gravity) {
            self.engine.set_gravity(self.scene.world.acceleration(gravity));
        }
        for set in &event.set_bodies {
            let body = self.body(set.body)?;
            self.engine.set_body(body, set);
        }
        for set in &event.set_joints {
            if let Place::There(joint) = self.joint(set.joint)? {
                let (handle, made_as) = (joint.handle, joint.made_as);
                check_change(set.joint, made_as, &set.change)?;
                self.engine.set_joint(handle, made_as, &set.change)?;
            }
        }
        Ok(())
    }

    fn create(&mut self, bodies: &'a [Body], joints: &'a [Joint]) -> Result<(), Stop> {
        for body in bodies {
            self.bodies.push(Some(self.engine.create_body(body)?));
            self.joints_of.push(Vec::new());
        }
        for joint in joints {
            let a = joint.body_a.map(|number| self.body(number)).transpose()?;
            let b = self.body(joint.body_b)?;
            let number = self.joints.len();
            if joint.body_a == Some(joint.body_b) {
                return Err(Stop::Wrong(format!("joint {number} holds body {} to itself; give two bodies", joint.body_b)));
            }
            let handle = self.engine.create_joint(number, joint, a, b)?;
            self.joints.push(Place::There(PlayedJoint { handle, made_as: joint }));
            for body in joint.body_a.into_iter().chain([joint.body_b]) {
                self.joints_of[body].push(number);
            }
        }
        Ok(())
    }

    fn destroy_broken(&mut self) {
        for number in self.engine.broken_joints() {
            if let Place::There(joint) = &self.joints[number] {
                let handle = joint.handle;
                self.engine.destroy_joint(handle);
                self.joints[number] = Place::Broken;
            }
        }
    }

    fn body(&self, number: usize) -> Result<E::Body, Stop> {
        match self.bodies.get(number) {
            Some(Some(body)) => Ok(*body),
            Some(None) => Err(Stop::Wrong(format!("body {number} is named after it was destroyed"))),
            None => Err(Stop::Wrong(format!("body {number} is named, but there are {} at that point", self.bodies.len()))),
        }
    }

    /// There or broken; one that is gone must not be named.
    fn joint(&self, number: usize) -> Result<&Place<PlayedJoint<'a, E>>, Stop> {
        match self.joints.get(number) {
            Some(Place::Gone) => Err(Stop::Wrong(format!("joint {number} is named after it was destroyed"))),
            Some(place) => Ok(place),
            None => Err(Stop::Wrong(format!("joint {number} is named, but there are {} at that point", self.joints.len()))),
        }
    }
}

fn check_change(number: usize, made_as: &Joint, change: &JointChange) -> Result<(), Stop> {
    let is = made_as.spec.name();
    match change {
        JointChange::MotorSpeed(_) if !["revolute", "prismatic", "wheel"].contains(&is) => {
            Err(Stop::Wrong(format!("motor_speed is given for joint {number}, a {is} joint, which has no motor")))
        }
        JointChange::Spec(spec) if spec.name() != is => {
            Err(Stop::Wrong(format!("joint {number} is a {is} joint and can't become a {} joint", spec.name())))
        }
        _ => Ok(()),
    }
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let value = work();
    (value, start.elapsed().as_secs_f64() * 1000.0)
}
