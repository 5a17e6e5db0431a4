//! Shapes and chains of a scene file.

use super::{Vec2, one, the_one, yes};
use serde::Deserialize;

#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ChainSides {
    TwoSided,
    OneSided,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    #[serde(default)]
    pub center: Vec2,
    pub radius: f32,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Capsule {
    pub p1: Vec2,
    pub p2: Vec2,
    pub radius: f32,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Segment {
    pub p1: Vec2,
    pub p2: Vec2,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    pub vertices: Vec<Vec2>,
    #[serde(default)]
    pub radius: f32,
    #[serde(default, rename = "normals")]
    _normals: Vec<Vec2>, // for Carom alone
    #[serde(default, rename = "centroid")]
    _centroid: Option<Vec2>, // for Carom alone
}

impl Polygon {
    /// Areas without and with the rounding [m^2].
    pub fn areas(&self) -> (f32, f32) {
        let (mut area, mut outline) = (0.0, 0.0);
        for (i, v) in self.vertices.iter().enumerate() {
            let w = self.vertices[(i + 1) % self.vertices.len()];
            area += (v[0] * w[1] - v[1] * w[0]) / 2.0;
            outline += (w[0] - v[0]).hypot(w[1] - v[1]);
        }
        (area, area + outline * self.radius + std::f32::consts::PI * self.radius * self.radius)
    }
}

#[derive(Clone, Debug)]
pub enum Geometry {
    Circle(Circle),
    Capsule(Capsule),
    Segment(Segment),
    Polygon(Polygon),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    pub friction: f32,
    pub restitution: f32,
    pub rolling_resistance: f32,
    pub tangent_speed: f32,
    pub id: u64,
}

impl Default for Material {
    fn default() -> Self {
        Self { friction: 0.6, restitution: 0.0, rolling_resistance: 0.0, tangent_speed: 0.0, id: 0 }
    }
}

#[derive(Clone, Copy, PartialEq, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Filter {
    pub category: u64,
    pub mask: u64,
    pub group: i32,
}

impl Default for Filter {
    fn default() -> Self {
        Self { category: 1, mask: u64::MAX, group: 0 }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "ShapeFields")]
pub struct Shape {
    pub geometry: Geometry,
    pub density: f32,
    pub material: Material,
    pub filter: Filter,
    pub is_sensor: bool,
    pub contact_events: bool,
    pub persist_events: bool,
    pub sensor_events: bool,
    pub hit_events: bool,
    pub pre_solve: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ShapeFields {
    #[serde(default, rename = "name")]
    _name: String,
    circle: Option<Circle>,
    capsule: Option<Capsule>,
    segment: Option<Segment>,
    polygon: Option<Polygon>,
    #[serde(default = "one")]
    density: f32,
    #[serde(default)]
    material: Material,
    #[serde(default)]
    filter: Filter,
    #[serde(default)]
    is_sensor: bool,
    #[serde(default = "yes")]
    contact_events: bool,
    #[serde(default)]
    persist_events: bool,
    #[serde(default = "yes")]
    sensor_events: bool,
    #[serde(default)]
    hit_events: bool,
    #[serde(default)]
    pre_solve: bool,
    #[serde(default, rename = "user_data")]
    _user_data: u64,
}

impl TryFrom<ShapeFields> for Shape {
    type Error = String;

    fn try_from(f: ShapeFields) -> Result<Self, String> {
        let kinds = [
            f.circle.map(Geometry::Circle),
            f.capsule.map(Geometry::Capsule),
            f.segment.map(Geometry::Segment),
            f.polygon.map(Geometry::Polygon),
        ];
        let geometry = the_one(kinds, "a shape is one of circle, capsule, segment, polygon")?;
        check_geometry(&geometry)?;
        Ok(Shape {
            geometry,
            density: f.density,
            material: f.material,
            filter: f.filter,
            is_sensor: f.is_sensor,
            contact_events: f.contact_events,
            persist_events: f.persist_events,
            sensor_events: f.sensor_events,
            hit_events: f.hit_events,
            pre_solve: f.pre_solve,
        })
    }
}

fn check_geometry(geometry: &Geometry) -> Result<(), String> {
    let radius = match geometry {
        Geometry::Circle(c) => c.radius,
        Geometry::Capsule(c) => c.radius,
        Geometry::Polygon(p) if !(3..=8).contains(&p.vertices.len()) => {
            return Err(format!("a polygon has {} vertices; give 3 to 8", p.vertices.len()));
        }
        Geometry::Polygon(p) if p.radius < 0.0 => return Err(format!("radius is {}; give a number >= 0 [m]", p.radius)),
        _ => return Ok(()),
    };
    if radius > 0.0 { Ok(()) } else { Err(format!("radius is {radius}; give a number > 0 [m]")) }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chain {
    #[serde(default, rename = "name")]
    _name: String,
    pub points: Vec<Vec2>,
    #[serde(default)]
    pub materials: Vec<Material>,
    #[serde(default)]
    pub is_loop: bool,
    #[serde(default = "two_sided")]
    pub sides: ChainSides,
    #[serde(default)]
    pub filter: Filter,
    #[serde(default = "yes")]
    pub contact_events: bool,
    #[serde(default)]
    pub persist_events: bool,
    #[serde(default = "yes")]
    pub sensor_events: bool,
    #[serde(default)]
    pub hit_events: bool,
    #[serde(default)]
    pub pre_solve: bool,
    #[serde(default, rename = "user_data")]
    _user_data: u64,
}

impl Chain {
    pub fn segment_count(&self) -> usize {
        if self.is_loop { self.points.len() } else { self.points.len() - 1 }
    }
    /// The ends of a segment, in the order of the points.
    pub fn segment(&self, index: usize) -> (Vec2, Vec2) {
        (self.points[index], self.points[(index + 1) % self.points.len()])
    }
    pub fn material(&self, segment: usize) -> Material {
        let index = if self.materials.len() > 1 { segment } else { 0 };
        self.materials.get(index).cloned().unwrap_or_default()
    }
}

fn two_sided() -> ChainSides {
    ChainSides::TwoSided
}
