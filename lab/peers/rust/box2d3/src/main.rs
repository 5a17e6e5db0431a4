//! Runs a scene file with Box2D 3, of a crate or of a checkout (box2d.rs): see lab/engine_run.hpp for the protocol. The world and its bodies; joints are in joints.rs.

mod box2d;
mod joints;

use box2d::ffi::*;
use carom_peer_scene::file::{Body, BodyType, Chain, ChainSides, Filter, Frame, Geometry, Joint, JointChange, Locks, Material};
use carom_peer_scene::file::{Mixing, Polygon, Ray, SceneFile, SetBody, Shape, Vec2};
use carom_peer_scene::run::{Engine, State, Stop};
use std::ffi::c_void;
use std::process::ExitCode;

fn main() -> ExitCode {
    carom_peer_scene::run::main::<Box2d3>(std::env::args().skip(1).collect())
}

pub struct Box2d3 {
    world: b2WorldId,
    time_step: f32,
    substeps: i32,
    sleep_speed: f32,
    ground: Option<b2BodyId>, // what joints to the world hold to
    has_sensors: bool,
    differences: Vec<String>,
}

impl Engine for Box2d3 {
    const NAME: &'static str = box2d::NAME;
    type Body = b2BodyId;
    type Joint = b2JointId;

    fn version() -> String {
        let version = unsafe { b2GetVersion() };
        let simd = if cfg!(feature = "avx2") { "AVX2" } else { "SSE2" };
        format!("{}.{}.{} ({}), {simd}", version.major, version.minor, version.revision, box2d::revision())
    }

    fn lacks(need: &str) -> Option<&'static str> {
        match need {
            "point_fields" | "n_body_fields" => Some("it has one gravity for all"),
            "gear_joints" | "pulley_joints" => Some("not among its joints"),
            _ => None,
        }
    }

    fn new(scene: &SceneFile, threads: usize) -> Result<Self, Stop> {
        let settings = &scene.world;
        let unit = settings.length_unit;
        unsafe { b2SetLengthUnitsPerMeter(unit) };
        let mut def = unsafe { b2DefaultWorldDef() };
        def.gravity = vec2(settings.acceleration(settings.gravity));
        def.restitutionThreshold = settings.solver.restitution_threshold * unit;
        def.hitEventThreshold = settings.hit_speed * unit;
        def.contactHertz = settings.solver.contact_hertz;
        def.contactDampingRatio = settings.solver.contact_damping_ratio;
        def.contactSpeed = settings.solver.push_out_speed * unit;
        def.frictionCallback = mixing(settings.mixing.friction, Mixing::GeometricMean);
        def.restitutionCallback = mixing(settings.mixing.restitution, Mixing::Maximum);
        def.enableSleep = settings.sleep.is_enabled;
        def.enableContinuous = settings.continuous;
        def.workerCount = threads as i32;
        Ok(Box2d3 {
            world: unsafe { b2CreateWorld(&def) },
            time_step: scene.time_step,
            substeps: scene.substeps as i32,
            sleep_speed: settings.sleep.speed * unit,
            ground: None,
            has_sensors: scene.all_shapes().any(|shape| shape.is_sensor),
            differences: differences_of(scene),
        })
    }

    fn create_body(&mut self, body: &Body) -> Result<b2BodyId, Stop> {
        let mut def = unsafe { b2DefaultBodyDef() };
        def.type_ = type_of(body.kind);
        def.position = vec2(body.position);
        def.rotation = rotation(body.angle);
        def.linearDamping = body.linear_damping;
        def.angularDamping = body.angular_damping;
        def.gravityScale = body.gravity_scale;
        def.sleepThreshold = self.sleep_speed;
        def.motionLocks = locks_of(body.locks);
        def.enableSleep = body.can_sleep;
        def.isAwake = body.is_awake;
        def.isBullet = body.is_bullet;
        def.isEnabled = body.is_enabled;
        let id = unsafe { b2CreateBody(self.world, &def) };
        for shape in &body.shapes {
            create_shape(id, shape)?;
        }
        for chain in &body.chains {
            create_chain(id, chain);
        }
        if let Some(mass) = &body.mass_data {
            let data = b2MassData { mass: mass.mass, center: vec2(mass.center), rotationalInertia: mass.inertia };
            unsafe { b2Body_SetMassData(id, data) };
        }
        // After the shapes, since each of them moves the centre of mass, whose velocity this is.
        if body.is_awake && body.kind != BodyType::Static {
            unsafe {
                b2Body_SetLinearVelocity(id, vec2(body.linear_velocity));
                b2Body_SetAngularVelocity(id, body.angular_velocity);
            }
        }
        Ok(id)
    }

    fn destroy_body(&mut self, body: b2BodyId) {
        unsafe { b2DestroyBody(body) };
    }

    fn create_joint(&mut self, number: usize, joint: &Joint, a: Option<b2BodyId>, b: b2BodyId) -> Result<b2JointId, Stop> {
        let a = a.unwrap_or_else(|| self.ground());
        joints::create(self.world, number, joint, a, b)
    }

    fn destroy_joint(&mut self, joint: b2JointId) {
        unsafe { box2d::destroy_joint(joint) };
    }

    fn set_gravity(&mut self, acceleration: Vec2) {
        unsafe { b2World_SetGravity(self.world, vec2(acceleration)) };
    }

    fn set_body(&mut self, body: b2BodyId, set: &SetBody) {
        unsafe {
            if let Some(kind) = set.kind {
                b2Body_SetType(body, type_of(kind));
            }
            if set.position.is_some() || set.angle.is_some() {
                let place = set.position.map_or_else(|| b2Body_GetPosition(body), vec2);
                let turn = set.angle.map_or_else(|| b2Body_GetRotation(body), rotation);
                b2Body_SetTransform(body, place, turn);
            }
            if let Some(velocity) = set.linear_velocity {
                b2Body_SetLinearVelocity(body, vec2(velocity));
            }
            if let Some(spin) = set.angular_velocity {
                b2Body_SetAngularVelocity(body, spin);
            }
            if let Some(damping) = set.linear_damping {
                b2Body_SetLinearDamping(body, damping);
            }
            if let Some(damping) = set.angular_damping {
                b2Body_SetAngularDamping(body, damping);
            }
            if let Some(scale) = set.gravity_scale {
                b2Body_SetGravityScale(body, scale);
            }
            if let Some(locks) = set.locks {
                b2Body_SetMotionLocks(body, locks_of(locks));
            }
            if let Some(can_sleep) = set.can_sleep {
                b2Body_EnableSleep(body, can_sleep);
            }
            if let Some(is_bullet) = set.is_bullet {
                b2Body_SetBullet(body, is_bullet);
            }
            match set.is_enabled {
                Some(true) => b2Body_Enable(body),
                Some(false) => b2Body_Disable(body),
                None => {}
            }
            if let Some(is_awake) = set.is_awake {
                b2Body_SetAwake(body, is_awake);
            }
        }
    }

    fn set_joint(&mut self, id: b2JointId, made_as: &Joint, change: &JointChange) -> Result<(), Stop> {
        match change {
            JointChange::MotorSpeed(speed) => joints::set_motor_speed(id, &made_as.spec, *speed),
            JointChange::Spec(spec) => joints::apply(id, made_as, spec)?,
        }
        unsafe { b2Joint_WakeBodies(id) };
        Ok(())
    }

    fn step(&mut self) {
        unsafe { b2World_Step(self.world, self.time_step, self.substeps) };
    }

    fn broken_joints(&mut self) -> Vec<usize> {
        let events = unsafe { b2World_GetJointEvents(self.world) };
        (0..events.count as usize).map(|i| unsafe { (*events.jointEvents.add(i)).userData as usize }).collect()
    }

    fn cast(&mut self, rays: &[Ray]) -> usize {
        let filter = unsafe { b2DefaultQueryFilter() };
        let meets = |ray: &&Ray| unsafe {
            if self.has_sensors {
                let mut hit = false;
                let context: *mut bool = &mut hit;
                b2World_CastRay(self.world, vec2(ray.start), vec2(ray.sweep), filter, Some(nearest_solid), context.cast());
                hit
            } else {
                b2World_CastRayClosest(self.world, vec2(ray.start), vec2(ray.sweep), filter).hit
            }
        };
        rays.iter().filter(meets).count()
    }

    fn state(&self, body: b2BodyId) -> State {
        let (place, rotation, velocity, spin) = unsafe {
            (b2Body_GetPosition(body), b2Body_GetRotation(body), b2Body_GetLinearVelocity(body), b2Body_GetAngularVelocity(body))
        };
        let angle = f64::from(rotation.s).atan2(f64::from(rotation.c));
        [place.x.into(), place.y.into(), angle, velocity.x.into(), velocity.y.into(), spin.into()]
    }

    fn differences(&self) -> Vec<String> {
        self.differences.clone()
    }
}

impl Box2d3 {
    fn ground(&mut self) -> b2BodyId {
        let world = self.world;
        *self.ground.get_or_insert_with(|| unsafe { b2CreateBody(world, &b2DefaultBodyDef()) })
    }
}

impl Drop for Box2d3 {
    fn drop(&mut self) {
        unsafe { b2DestroyWorld(self.world) };
    }
}

/// For rays among sensors, which the engine's own nearest hit does not skip.
unsafe extern "C" fn nearest_solid(shape: b2ShapeId, _: b2Pos, _: b2Vec2, fraction: f32, context: *mut c_void) -> f32 {
    unsafe {
        if b2Shape_IsSensor(shape) {
            return -1.0;
        }
        *context.cast::<bool>() = true;
    }
    fraction
}

fn differences_of(scene: &SceneFile) -> Vec<String> {
    let mut list = Vec::new();
    let sleep = &scene.world.sleep;
    if sleep.is_enabled && sleep.time != 0.5 {
        list.push(format!("bodies sleep after 0.5 s at rest, which is fixed, not after {} s", sleep.time));
    }
    if scene.all_chains().any(|chain| chain.sides == ChainSides::TwoSided) {
        list.push("two-sided chains are made of segments that know nothing of each other, since its chains have one side".into());
    }
    if scene.all_shapes().any(|shape| shape.persist_events) || scene.all_chains().any(|chain| chain.persist_events) {
        list.push("contacts that go on are not reported".into());
    }
    let reports = |chain: &Chain| chain.contact_events || chain.hit_events || chain.pre_solve;
    if scene.all_chains().any(|chain| chain.sides == ChainSides::OneSided && reports(chain)) {
        list.push("a chain reports no contacts of itself, only those that the other shape reports".into());
    }
    if scene.all_shapes().any(|shape| matches!(&shape.geometry, Geometry::Polygon(p) if p.radius > 0.0)) {
        list.push("a rounded polygon has its exact mass, and the engine's approximate inertia scaled to that".into());
    }
    list.push("skips contacts whose bodies have barely moved: their points are moved along, without pre-solve, changed materials, begin or end".into());
    list.extend(joints::differences_of(scene));
    list
}

pub fn vec2(v: Vec2) -> b2Vec2 {
    b2Vec2 { x: v[0], y: v[1] }
}

fn rotation(angle: f32) -> b2Rot {
    let (s, c) = angle.sin_cos();
    b2Rot { c, s }
}

pub fn transform(frame: &Frame) -> b2Transform {
    b2Transform { p: vec2(frame.p), q: b2Rot { c: frame.q[0], s: frame.q[1] } }
}

fn type_of(kind: BodyType) -> b2BodyType {
    match kind {
        BodyType::Static => b2BodyType_b2_staticBody,
        BodyType::Kinematic => b2BodyType_b2_kinematicBody,
        BodyType::Dynamic => b2BodyType_b2_dynamicBody,
    }
}

fn locks_of(locks: Locks) -> b2MotionLocks {
    b2MotionLocks { linearX: locks.x, linearY: locks.y, angularZ: locks.rotation }
}

fn filter_of(filter: Filter) -> b2Filter {
    b2Filter { categoryBits: filter.category, maskBits: filter.mask, groupIndex: filter.group }
}

fn material_of(material: &Material) -> b2SurfaceMaterial {
    b2SurfaceMaterial {
        friction: material.friction,
        restitution: material.restitution,
        rollingResistance: material.rolling_resistance,
        tangentSpeed: material.tangent_speed,
        userMaterialId: material.id,
        customColor: 0,
    }
}

fn create_shape(body: b2BodyId, shape: &Shape) -> Result<(), Stop> {
    let mut def = unsafe { b2DefaultShapeDef() };
    def.material = material_of(&shape.material);
    def.density = shape.density;
    def.filter = filter_of(shape.filter);
    def.isSensor = shape.is_sensor;
    def.enableSensorEvents = shape.sensor_events || shape.is_sensor;
    def.enableContactEvents = shape.contact_events;
    def.enableHitEvents = shape.hit_events;
    def.enablePreSolveEvents = shape.pre_solve;
    unsafe {
        match &shape.geometry {
            Geometry::Circle(c) => {
                b2CreateCircleShape(body, &def, &b2Circle { center: vec2(c.center), radius: c.radius });
            }
            Geometry::Capsule(c) => {
                let capsule = b2Capsule { center1: vec2(c.p1), center2: vec2(c.p2), radius: c.radius };
                b2CreateCapsuleShape(body, &def, &capsule);
            }
            Geometry::Segment(s) => {
                b2CreateSegmentShape(body, &def, &b2Segment { point1: vec2(s.p1), point2: vec2(s.p2) });
            }
            Geometry::Polygon(p) => {
                let polygon = polygon_of(p)?;
                if p.radius > 0.0 {
                    def.density *= p.areas().1 / b2ComputePolygonMass(&polygon, 1.0).mass; // the engine takes the corners for larger than they are
                }
                b2CreatePolygonShape(body, &def, &polygon);
            }
        }
    }
    Ok(())
}

fn polygon_of(polygon: &Polygon) -> Result<b2Polygon, Stop> {
    let points: Vec<b2Vec2> = polygon.vertices.iter().copied().map(vec2).collect();
    let hull = unsafe { b2ComputeHull(points.as_ptr(), points.len() as i32) };
    if hull.count as usize != points.len() {
        let corners = &polygon.vertices;
        return Err(Stop::Lacks(format!("the engine can't keep all corners of the polygon {corners:?}: too near or in line")));
    }
    Ok(unsafe { b2MakePolygon(&hull, polygon.radius) })
}

fn create_chain(body: b2BodyId, chain: &Chain) {
    match chain.sides {
        ChainSides::TwoSided => create_segments(body, chain),
        ChainSides::OneSided => create_one_sided_chain(body, chain),
    }
}

fn create_segments(body: b2BodyId, chain: &Chain) {
    for index in 0..chain.segment_count() {
        let (p1, p2) = chain.segment(index);
        let mut def = unsafe { b2DefaultShapeDef() };
        def.material = material_of(&chain.material(index));
        def.filter = filter_of(chain.filter);
        def.enableSensorEvents = chain.sensor_events;
        def.enableContactEvents = chain.contact_events;
        def.enableHitEvents = chain.hit_events;
        def.enablePreSolveEvents = chain.pre_solve;
        unsafe { b2CreateSegmentShape(body, &def, &b2Segment { point1: vec2(p1), point2: vec2(p2) }) };
    }
}

/// The first and the last segment of an open chain of Box2D are ghosts that nothing collides with, so one is added at each end, in line. A loop of
/// three points is one short of what it takes: the middle of its first segment becomes a point too.
fn create_one_sided_chain(body: b2BodyId, chain: &Chain) {
    let mut points: Vec<b2Vec2> = chain.points.iter().copied().map(vec2).collect();
    let mut materials: Vec<b2SurfaceMaterial> = (0..chain.segment_count()).map(|i| material_of(&chain.material(i))).collect();
    if chain.is_loop && points.len() == 3 {
        points.insert(1, b2Vec2 { x: (points[0].x + points[1].x) / 2.0, y: (points[0].y + points[1].y) / 2.0 });
        materials.insert(0, materials[0]);
    }
    if !chain.is_loop {
        let last = points.len() - 1;
        let before = b2Vec2 { x: 2.0 * points[0].x - points[1].x, y: 2.0 * points[0].y - points[1].y };
        let after = b2Vec2 { x: 2.0 * points[last].x - points[last - 1].x, y: 2.0 * points[last].y - points[last - 1].y };
        points.insert(0, before);
        points.push(after);
        materials.insert(0, materials[0]);
        materials.push(materials[last]);
        materials.push(materials[last]);
    }
    let mut def = unsafe { b2DefaultChainDef() };
    def.points = points.as_ptr();
    def.count = points.len() as i32;
    def.materials = materials.as_ptr();
    def.materialCount = materials.len() as i32;
    def.filter = filter_of(chain.filter);
    def.isLoop = chain.is_loop;
    def.enableSensorEvents = chain.sensor_events;
    unsafe { b2CreateChain(body, &def) };
}

type MixingCallback = Option<unsafe extern "C" fn(f32, u64, f32, u64) -> f32>;

/// None for the rule that the engine has anyway.
fn mixing(rule: Mixing, default: Mixing) -> MixingCallback {
    unsafe extern "C" fn geometric_mean(a: f32, _: u64, b: f32, _: u64) -> f32 {
        (a * b).sqrt()
    }
    unsafe extern "C" fn average(a: f32, _: u64, b: f32, _: u64) -> f32 {
        (a + b) / 2.0
    }
    unsafe extern "C" fn minimum(a: f32, _: u64, b: f32, _: u64) -> f32 {
        a.min(b)
    }
    unsafe extern "C" fn maximum(a: f32, _: u64, b: f32, _: u64) -> f32 {
        a.max(b)
    }
    unsafe extern "C" fn product(a: f32, _: u64, b: f32, _: u64) -> f32 {
        a * b
    }
    match rule {
        _ if rule == default => None,
        Mixing::GeometricMean => Some(geometric_mean),
        Mixing::Average => Some(average),
        Mixing::Minimum => Some(minimum),
        Mixing::Maximum => Some(maximum),
        Mixing::Product => Some(product),
    }
}
