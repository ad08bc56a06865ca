//! User cameras, which replace a map's own: a list in a recipe, or in a file of its own, TOML or JSON.

use crate::{MapSource, RecipeError, list_file};
use endless_dataset::{OptionError, UserCamera};
use endless_world::{CameraSite, Mount};
use serde::Deserialize;
use std::{collections::BTreeMap, path::Path};

/// A file: `[[cameras]]` of TOML, `{"cameras": [...]}` of JSON.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraFile {
    cameras: Vec<UserCamera>,
}

/// Furthest from the map's origin, metres.
const FAR_M: f64 = 20_000.0;
/// Horizontal field of view where none is given, degrees: a surveillance camera's.
const USUAL_FOV_DEG: f64 = 70.0;
/// Longest name.
const NAME: usize = 64;

/// Reads a list of cameras: JSON if the file's name ends so, else TOML.
///
/// # Errors
/// [`RecipeError::Unreadable`], or [`RecipeError::Malformed`] with the place.
pub fn read_cameras(path: &Path) -> Result<Vec<UserCamera>, RecipeError> {
    list_file::read(path, "cameras").map(|file: CameraFile| file.cameras)
}

/// Reads the text of a list of cameras that lies at a path: JSON if the file's name ends so, else TOML.
///
/// # Errors
/// [`RecipeError::Malformed`] with the place.
pub fn cameras_from_text(text: &str, path: &Path) -> Result<Vec<UserCamera>, RecipeError> {
    list_file::from_text(text, path).map(|file: CameraFile| file.cameras)
}

/// The cameras by map, checked.
///
/// # Errors
/// The first camera that cannot be.
pub(crate) fn resolve(
    cameras: &[UserCamera],
    maps: &[String],
    source: &dyn MapSource,
) -> Result<BTreeMap<String, Vec<CameraSite>>, RecipeError> {
    let mut by_map: BTreeMap<String, Vec<CameraSite>> = BTreeMap::new();
    for camera in cameras {
        let known: Vec<String> = source.maps().into_iter().chain(source.imported()).collect();
        let plain = camera.map.strip_suffix("_Opt").unwrap_or(&camera.map);
        let Some(map) = known.iter().find(|k| **k == camera.map || *k == plain) else {
            return Err(RecipeError::UnknownMap { given: camera.map.clone(), known });
        };
        let site = site(camera)?;
        let of_map = by_map.entry(map.clone()).or_default();
        if of_map.iter().any(|other| other.name == site.name) {
            return Err(wrong(camera, "name", &camera.name, "another camera of the map has it already"));
        }
        of_map.push(site);
    }
    by_map.retain(|map, _| maps.contains(map));
    Ok(by_map)
}

fn wrong(camera: &UserCamera, what: &str, given: &str, rule: &str) -> RecipeError {
    RecipeError::Option(OptionError::OutOfRange {
        field: "cameras",
        given: format!("{what} = {given} ({} in {})", camera.name, camera.map),
        rule: rule.to_owned(),
    })
}

fn site(camera: &UserCamera) -> Result<CameraSite, RecipeError> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if camera.name.is_empty() || camera.name.len() > NAME || !camera.name.chars().all(plain) {
        let rule = "a name has 1 to 64 letters, digits, _ and -";
        return Err(wrong(camera, "name", &camera.name, rule));
    }
    let within = |what: &str, value: f64, least: f64, most: f64| {
        // NaN is in no range.
        let rule = format!("write a number from {least} to {most}");
        if (least..=most).contains(&value) { Ok(value) } else { Err(wrong(camera, what, &value.to_string(), &rule)) }
    };
    let fov_deg = camera.fov.or(camera.lens.usual_fov_deg()).unwrap_or(USUAL_FOV_DEG);
    camera.lens.check(fov_deg).map_err(|problem| {
        let camera = format!("{} in {}", camera.name, camera.map);
        RecipeError::UserCamera { camera, problem }
    })?;
    for value in camera.position {
        within("position", value, -FAR_M, FAR_M)?;
    }
    Ok(CameraSite {
        name: camera.name.clone(),
        position: camera.position.map(|x| x as f32),
        yaw_rad: within("yaw", camera.yaw, -360.0, 360.0)?.to_radians() as f32,
        down_tilt_rad: within("down", camera.down, -10.0, 90.0)?.to_radians() as f32,
        horizontal_fov_rad: fov_deg.to_radians() as f32,
        lens: camera.lens,
        mount: Mount::Pole,
        roll_rad: 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_catalog::ThreeTowns;
    use crate::{Plan, resolve_recipe};
    use endless_dataset::RecipeDraft;
    use endless_world::LensModel;
    use proptest::prelude::*;

    const TOML: &str = "[[cameras]]\nmap = \"Town01\"\nname = \"gate\"\nposition = [1.0, -2.5, 6]\nyaw = 90\ndown = 20\n\n\
                        [[cameras]]\nmap = \"Town01_Opt\"\nname = \"corner\"\nposition = [9, 2.5, 7]\nyaw = 180.0\ndown = 25\nfov = 80\n";
    const JSON: &str = r#"{"cameras": [
        {"map": "Town01", "name": "gate", "position": [1.0, -2.5, 6], "yaw": 90, "down": 20},
        {"map": "Town01_Opt", "name": "corner", "position": [9, 2.5, 7], "yaw": 180.0, "down": 25, "fov": 80}]}"#;

    #[test]
    fn both_formats_say_the_same_and_scenes_are_filmed_from_there() {
        let cameras = from_toml(TOML).expect("a list");
        assert_eq!(cameras, from_json(JSON).expect("a list"));
        let draft = RecipeDraft { cameras: Some(cameras), maps: Some(vec!["Town01".into()]), ..Default::default() };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let plan = Plan::new(&recipe, &ThreeTowns).expect("plannable");
        for scene in &plan.scenes {
            assert_eq!(scene.cameras.iter().map(|c| c.site.name.as_str()).collect::<Vec<_>>(), ["gate", "corner"]);
            assert!((scene.cameras[0].site.yaw_rad - std::f32::consts::FRAC_PI_2).abs() < 1e-6);
        }
        let text = serde_json::to_string(&recipe).expect("plain");
        assert_eq!(serde_json::from_str::<endless_dataset::Recipe>(&text).expect("the same"), recipe);
    }

    #[test]
    fn what_cannot_be_is_told() {
        let told = |change: &dyn Fn(&mut Vec<UserCamera>)| {
            let mut cameras = from_toml(TOML).expect("a list");
            change(&mut cameras);
            resolve(&cameras, &["Town01".to_owned()], &ThreeTowns).expect_err("wrong").to_string()
        };
        assert!(told(&|c| c[1].map = "Town77".into()).contains("unknown map 'Town77'"));
        assert!(told(&|c| c[1].name = "gate".into()).contains("already"));
        assert!(told(&|c| c[0].fov = Some(f64::NAN)).starts_with("camera gate in Town01: fov is NaN: write a number"));
        assert!(told(&|c| c[0].lens = LensModel::Orthographic { width_m: -1.0 }).contains("width is -1: write"));
        assert!(told(&|c| c[0].position[2] = 1e9).contains("position"));
        let (line, column, message) = from_toml(&TOML.replace("yaw = 90", "yow = 90")).expect_err("a misspelt key");
        assert_eq!((line, column), (5, 1), "{message}");
        let (line, _, message) = from_json(&JSON.replace("\"down\": 25,", "")).expect_err("a missing key");
        assert!(line == 3 && message.contains("down"), "{line} {message}");
    }

    fn from_toml(text: &str) -> Result<Vec<UserCamera>, list_file::ParseFailure> {
        list_file::parse(text, false).map(|file: CameraFile| file.cameras)
    }

    fn from_json(text: &str) -> Result<Vec<UserCamera>, list_file::ParseFailure> {
        list_file::parse(text, true).map(|file: CameraFile| file.cameras)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// Bytes changed at random: a list or an error with its place, never a panic.
        #[test]
        fn any_text_is_a_list_or_an_error_with_its_place(
            json: bool, edits in prop::collection::vec((0usize..420, any::<char>(), 0u8..3), 1..6),
        ) {
            let mut text: Vec<char> = if json { JSON } else { TOML }.chars().collect();
            for (at, c, kind) in edits {
                let at = at % (text.len() + 1);
                match kind {
                    0 => text.insert(at, c),
                    1 => text.truncate(at.max(1)),
                    _ => if at < text.len() { text[at] = c },
                }
            }
            let text: String = text.into_iter().collect();
            match if json { from_json(&text) } else { from_toml(&text) } {
                Ok(cameras) => drop(resolve(&cameras, &["Town01".to_owned()], &ThreeTowns)),
                Err((line, column, message)) => {
                    prop_assert!(line >= 1 && line <= text.lines().count() + 1 && column >= 1, "{line}:{column}");
                    prop_assert!(!message.is_empty() && !message.contains('\n'), "{message:?}");
                }
            }
        }
    }
}
