//! Bodies and colliders of Rapier.

use crate::{filters, vector};
use carom_peer_scene::file::{Body, BodyType, Chain, ChainSides, Geometry, Locks, Material, Mixing, Polygon, SetBody, Shape, Vec2, World};
use carom_peer_scene::run::Stop;
use rapier2d::prelude::*;

/// What the file says of the world and the engine keeps in each body or collider.
pub struct Settings {
    can_sleep: bool,
    sleep_speed: f32,
    sleep_time: f32,
    friction: CoefficientCombineRule,
    restitution: CoefficientCombineRule,
}

impl Settings {
    pub fn of(world: &World) -> Self {
        Settings {
            can_sleep: world.sleep.is_enabled,
            sleep_speed: world.sleep.speed,
            sleep_time: world.sleep.time,
            friction: rule(world.mixing.friction),
            restitution: rule(world.mixing.restitution),
        }
    }
}

fn rule(mixing: Mixing) -> CoefficientCombineRule {
    match mixing {
        Mixing::GeometricMean => CoefficientCombineRule::GeometricMean,
        Mixing::Average => CoefficientCombineRule::Average,
        Mixing::Minimum => CoefficientCombineRule::Min,
        Mixing::Maximum => CoefficientCombineRule::Max,
        Mixing::Product => CoefficientCombineRule::Multiply,
    }
}

fn type_of(kind: BodyType) -> RigidBodyType {
    match kind {
        BodyType::Static => RigidBodyType::Fixed,
        BodyType::Kinematic => RigidBodyType::KinematicVelocityBased,
        BodyType::Dynamic => RigidBodyType::Dynamic,
    }
}

fn locks_of(locks: Locks) -> LockedAxes {
    let mut axes = LockedAxes::empty();
    axes.set(LockedAxes::TRANSLATION_LOCKED_X, locks.x);
    axes.set(LockedAxes::TRANSLATION_LOCKED_Y, locks.y);
    axes.set(LockedAxes::ROTATION_LOCKED, locks.rotation);
    axes
}

pub fn body_of(body: &Body, settings: &Settings) -> RigidBody {
    let mut builder = RigidBodyBuilder::new(type_of(body.kind))
        .pose(Pose::new(vector(body.position), body.angle))
        .linvel(vector(body.linear_velocity))
        .angvel(body.angular_velocity)
        .linear_damping(body.linear_damping)
        .angular_damping(body.angular_damping)
        .gravity_scale(body.gravity_scale)
        .locked_axes(locks_of(body.locks))
        .ccd_enabled(body.is_bullet)
        .enabled(body.is_enabled)
        .sleeping(!body.is_awake);
    if let Some(mass) = &body.mass_data {
        builder = builder.additional_mass_properties(MassProperties::new(vector(mass.center), mass.mass, mass.inertia));
    }
    let mut made = builder.build();
    set_sleep(&mut made, body.can_sleep, settings);
    made
}

fn set_sleep(body: &mut RigidBody, can_sleep: bool, settings: &Settings) {
    let sleeps = can_sleep && settings.can_sleep;
    let activation = body.activation_mut();
    activation.normalized_linear_threshold = if sleeps { settings.sleep_speed } else { -1.0 };
    activation.angular_threshold = if sleeps { RigidBodyActivation::default_angular_threshold() } else { -1.0 };
    activation.time_until_sleep = settings.sleep_time;
}

pub fn change(body: &mut RigidBody, set: &SetBody, settings: &Settings) {
    if let Some(kind) = set.kind {
        body.set_body_type(type_of(kind), true);
    }
    if let Some(place) = set.position {
        body.set_translation(vector(place), true);
    }
    if let Some(angle) = set.angle {
        body.set_rotation(Rotation::new(angle), true);
    }
    if let Some(velocity) = set.linear_velocity {
        body.set_linvel(vector(velocity), true);
    }
    if let Some(spin) = set.angular_velocity {
        body.set_angvel(spin, true);
    }
    if let Some(damping) = set.linear_damping {
        body.set_linear_damping(damping);
    }
    if let Some(damping) = set.angular_damping {
        body.set_angular_damping(damping);
    }
    if let Some(scale) = set.gravity_scale {
        body.set_gravity_scale(scale, true);
    }
    if let Some(locks) = set.locks {
        body.set_locked_axes(locks_of(locks), true);
    }
    if let Some(can_sleep) = set.can_sleep {
        set_sleep(body, can_sleep, settings);
    }
    if let Some(is_bullet) = set.is_bullet {
        body.enable_ccd(is_bullet);
    }
    if let Some(is_enabled) = set.is_enabled {
        body.set_enabled(is_enabled);
    }
    match set.is_awake {
        Some(true) => body.wake_up(true),
        Some(false) => body.sleep(),
        None => {}
    }
}

pub fn collider_of(shape: &Shape, body: &Body, settings: &Settings) -> Result<Collider, Stop> {
    let builder = match &shape.geometry {
        Geometry::Circle(c) => ColliderBuilder::ball(c.radius).translation(vector(c.center)),
        Geometry::Capsule(c) => ColliderBuilder::capsule_from_endpoints(vector(c.p1), vector(c.p2), c.radius),
        Geometry::Segment(s) => ColliderBuilder::segment(vector(s.p1), vector(s.p2)),
        Geometry::Polygon(p) => polygon(p)?,
    };
    // Mass that the body is given replaces that of its shapes.
    let density = if body.mass_data.is_some() { 0.0 } else { shape.density * mass_factor(&shape.geometry) };
    let reports = if shape.is_sensor { shape.sensor_events } else { shape.contact_events };
    let mut collider = surfaced(builder, &shape.material, settings).density(density).sensor(shape.is_sensor).build();
    collider.set_active_events(if reports { ActiveEvents::COLLISION_EVENTS } else { ActiveEvents::empty() });
    filters::set(&mut collider, shape.filter);
    Ok(collider)
}

fn surfaced(builder: ColliderBuilder, material: &Material, settings: &Settings) -> ColliderBuilder {
    builder
        .friction(material.friction)
        .friction_combine_rule(settings.friction)
        .restitution(material.restitution)
        .restitution_combine_rule(settings.restitution)
}

/// One polyline, or, when its segments have materials of their own, one for each.
pub fn colliders_of(chain: &Chain, settings: &Settings) -> Vec<Collider> {
    let points: Vec<Vector> = chain.points.iter().copied().map(vector).collect();
    let count = points.len() as u32;
    let segments: Vec<[u32; 2]> = (0..chain.segment_count() as u32).map(|i| [i, (i + 1) % count]).collect();
    let parts: Vec<Vec<[u32; 2]>> = if chain.materials.len() > 1 { segments.iter().map(|s| vec![*s]).collect() } else { vec![segments] };
    let make = |(index, part): (usize, Vec<[u32; 2]>)| {
        let builder = match chain.sides {
            ChainSides::TwoSided => ColliderBuilder::polyline(points.clone(), Some(part)),
            ChainSides::OneSided => ColliderBuilder::oriented_polyline(points.clone(), Some(part)),
        };
        let mut collider = surfaced(builder, &chain.material(index), settings).build();
        collider.set_active_events(if chain.contact_events { ActiveEvents::COLLISION_EVENTS } else { ActiveEvents::empty() });
        filters::set(&mut collider, chain.filter);
        collider
    };
    parts.into_iter().enumerate().map(make).collect()
}

/// Boxes are made as the engine's own boxes, which are quicker than its polygons.
fn polygon(polygon: &Polygon) -> Result<ColliderBuilder, Stop> {
    let radius = polygon.radius;
    if let Some((half, pose)) = as_box(&polygon.vertices) {
        let builder = match radius > 0.0 {
            true => ColliderBuilder::round_cuboid(half[0], half[1], radius),
            false => ColliderBuilder::cuboid(half[0], half[1]),
        };
        return Ok(builder.position(pose));
    }
    let points: Vec<Vector> = polygon.vertices.iter().copied().map(vector).collect();
    let builder = match radius > 0.0 {
        true => ColliderBuilder::round_convex_polyline(points, radius),
        false => ColliderBuilder::convex_polyline(points),
    };
    builder.ok_or_else(|| Stop::Lacks(format!("the engine can't make a polygon of {:?}", polygon.vertices)))
}

/// Half extents and pose of a rectangle.
fn as_box(corners: &[Vec2]) -> Option<(Vec2, Pose)> {
    let [a, b, c, d] = *corners else { return None };
    let (side, up) = ([b[0] - a[0], b[1] - a[1]], [d[0] - a[0], d[1] - a[1]]);
    let (width, height) = (side[0].hypot(side[1]), up[0].hypot(up[1]));
    let error = 1e-5 * (width + height);
    let is_square_there = (side[0] * up[0] + side[1] * up[1]).abs() <= error * width.min(height);
    let is_closed = (b[0] + up[0] - c[0]).abs() <= error && (b[1] + up[1] - c[1]).abs() <= error;
    let center = Vector::new((a[0] + c[0]) / 2.0, (a[1] + c[1]) / 2.0);
    let turn = Rotation::from_cos_sin_unchecked(side[0] / width, side[1] / width);
    (is_square_there && is_closed).then(|| ([width / 2.0, height / 2.0], Pose::from_parts(center, turn)))
}

pub fn is_rounded(geometry: &Geometry) -> bool {
    matches!(geometry, Geometry::Polygon(p) if p.radius > 0.0)
}

/// The engine weighs a rounded polygon without its rounding: by how much its density must grow for the mass to come out.
fn mass_factor(geometry: &Geometry) -> f32 {
    match geometry {
        Geometry::Polygon(p) if p.radius > 0.0 => {
            let (core, whole) = p.areas();
            whole / core
        }
        _ => 1.0,
    }
}
