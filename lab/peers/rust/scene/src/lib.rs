//! What the Rust peers share: scene files, and the program around an engine.

pub mod file;
pub mod needs;
pub mod run;

#[cfg(test)]
mod tests {
    use crate::{file, needs};

    fn parse(text: &str) -> Result<file::SceneFile, serde_json::Error> {
        serde_json::from_str(text)
    }

    #[test]
    fn what_is_left_out_has_its_default() {
        let scene =
            parse(r#"{"carom_scene": 1, "joints": [{"body_b": 0, "wheel": {}}, {"body_b": 0, "wheel": {"suspension": null}}]}"#).unwrap();
        assert_eq!((scene.steps, scene.substeps, scene.world.gravity), (600, 4, [0.0, -9.81]));
        let suspended = |joint: &file::Joint| matches!(&joint.spec, file::Spec::Wheel(wheel) if wheel.suspension.is_some());
        assert!(suspended(&scene.joints[0]));
        assert!(!suspended(&scene.joints[1]));
    }

    #[test]
    fn names_and_settings_of_carom_alone_are_read() {
        let scene = parse(
            r#"{"carom_scene": 1, "world": {"length_unit": 0.5, "max_pairs": 1000}, "bodies": [{"name": "a",
                "shapes": [{"name": "b", "circle": {"radius": 1}}], "chains": [{"name": "c", "points": [[0, 0], [1, 0]]}]}],
                "joints": [{"name": "d", "body_b": 0, "weld": {}}]}"#,
        )
        .unwrap();
        assert_eq!(scene.world.length_unit, 0.5);
        assert_eq!(scene.bodies[0].name, "a");
    }

    #[test]
    fn unknown_fields_are_refused() {
        assert!(parse(r#"{"carom_scene": 1, "bodys": []}"#).unwrap_err().to_string().contains("bodys"));
        assert!(parse(r#"{"carom_scene": 1, "bodies": [{"shapes": [{"circle": {"radius": 1}, "polygon": {"vertices": []}}]}]}"#).is_err());
    }

    #[test]
    fn needs_follow_from_what_is_there() {
        let scene = parse(
            r#"{"carom_scene": 1, "needs": ["rays"],
            "bodies": [{"locks": {"x": true}, "shapes": [{"polygon": {"vertices": [[0,0],[1,0],[0,1]], "radius": 0.1}, "is_sensor": true}]}],
            "events": [{"step": 3, "create_joints": [{"body_b": 0, "break_force": 3, "gear": {"ratio": 2}}]}],
            "world": {"fields": [{"n_body": {}}], "mixing": {"friction": "average"}}}"#,
        )
        .unwrap();
        let expected =
            ["rounded_polygons", "sensors", "locks", "mixing", "n_body_fields", "events", "rays", "breakable_joints", "gear_joints"];
        assert_eq!(needs::of(&scene).unwrap(), expected);
        let unknown = parse(r#"{"carom_scene": 1, "needs": ["wings"]}"#).unwrap();
        assert!(needs::of(&unknown).unwrap_err().contains("wings"));
    }

    #[test]
    fn a_frame_moves_and_turns_as_seen_from_itself() {
        let frame = file::Frame { p: [1.0, 2.0], q: [0.0, 1.0] }.then([3.0, 0.0], std::f32::consts::FRAC_PI_2);
        assert!((frame.p[0] - 1.0).abs() < 1e-6 && (frame.p[1] - 5.0).abs() < 1e-6);
        assert!((frame.angle().abs() - std::f32::consts::PI).abs() < 1e-6);
    }

    #[test]
    fn what_is_not_a_number_becomes_null() {
        let state: crate::run::State = [f64::NAN, 1.0, f64::INFINITY, 0.0, 0.0, 0.0];
        assert_eq!(serde_json::to_string(&Some(state)).unwrap(), "[null,1.0,null,0.0,0.0,0.0]");
    }

    #[test]
    fn a_polygon_has_the_area_of_its_rounding_too() {
        let polygon: file::Polygon = serde_json::from_str(r#"{"vertices": [[0,0],[2,0],[2,1],[0,1]], "radius": 0.5}"#).unwrap();
        let (core, whole) = polygon.areas();
        assert!((core - 2.0).abs() < 1e-6);
        assert!((whole - (2.0 + 3.0 + std::f32::consts::PI * 0.25)).abs() < 1e-5);
    }
}
