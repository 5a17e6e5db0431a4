//! What an engine must have to run a scene: the counterpart of needs_of() in scene_file/check.cpp.

use crate::file::{ChainSides, Field, Geometry, Locks, Material, MixingRules, SceneFile};

pub const WORDS: [&str; 27] = [
    "capsules",
    "segments",
    "rounded_polygons",
    "chains",
    "one_sided_chains",
    "sensors",
    "rolling_resistance",
    "tangent_speed",
    "locks",
    "mass_data",
    "sleeping_bodies",
    "mixing",
    "uniform_fields",
    "point_fields",
    "n_body_fields",
    "events",
    "rays",
    "breakable_joints",
    "revolute_joints",
    "prismatic_joints",
    "distance_joints",
    "weld_joints",
    "wheel_joints",
    "motor_joints",
    "mouse_joints",
    "gear_joints",
    "pulley_joints",
];

/// What the scene holds and what its own list names, in the order of WORDS.
pub fn of(scene: &SceneFile) -> Result<Vec<&'static str>, String> {
    if let Some(unknown) = scene.needs.iter().find(|need| !WORDS.contains(&need.as_str())) {
        return Err(format!("needs names \"{unknown}\", which is no feature"));
    }
    let joints: Vec<String> = scene.all_specs().map(|spec| format!("{}_joints", spec.name())).collect();
    let is_needed = |word: &&str| holds(scene, word) || scene.needs.iter().chain(&joints).any(|need| need == word);
    Ok(WORDS.into_iter().filter(is_needed).collect())
}

fn holds(scene: &SceneFile, word: &str) -> bool {
    let shape = |test: fn(&Geometry) -> bool| scene.all_shapes().any(|shape| test(&shape.geometry));
    let sets = || scene.events.iter().flat_map(|event| &event.set_bodies);
    match word {
        "capsules" => shape(|g| matches!(g, Geometry::Capsule(_))),
        "segments" => shape(|g| matches!(g, Geometry::Segment(_))),
        "rounded_polygons" => shape(|g| matches!(g, Geometry::Polygon(p) if p.radius > 0.0)),
        "chains" => scene.all_chains().any(|chain| chain.sides == ChainSides::TwoSided),
        "one_sided_chains" => scene.all_chains().any(|chain| chain.sides == ChainSides::OneSided),
        "sensors" => scene.all_shapes().any(|shape| shape.is_sensor),
        "rolling_resistance" => any_material(scene, |m| m.rolling_resistance != 0.0),
        "tangent_speed" => any_material(scene, |m| m.tangent_speed != 0.0),
        "locks" => {
            let has = |locks: Locks| locks != Locks::default();
            scene.all_bodies().any(|body| has(body.locks)) || sets().any(|set| set.locks.is_some_and(has))
        }
        "mass_data" => scene.all_bodies().any(|body| body.mass_data.is_some()),
        "sleeping_bodies" => scene.all_bodies().any(|body| !body.is_awake) || sets().any(|set| set.is_awake == Some(false)),
        "mixing" => scene.world.mixing != MixingRules::default(),
        "uniform_fields" => scene.world.fields.iter().any(|field| matches!(field, Field::Uniform(_))),
        "point_fields" => scene.world.fields.iter().any(|field| matches!(field, Field::Point(_))),
        "n_body_fields" => scene.world.fields.iter().any(|field| matches!(field, Field::NBody(_))),
        "events" => !scene.events.is_empty(),
        "rays" => !scene.rays.is_empty(),
        "breakable_joints" => scene.all_joints().any(|joint| joint.break_force.is_some() || joint.break_torque.is_some()),
        _ => false, // joints: seen by their types
    }
}

fn any_material(scene: &SceneFile, test: fn(&Material) -> bool) -> bool {
    let of_chains = scene.all_chains().flat_map(|chain| &chain.materials);
    scene.all_shapes().map(|shape| &shape.material).chain(of_chains).any(test)
}
