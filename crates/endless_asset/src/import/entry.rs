//! The manifest of a folder of models.

use super::error::ImportError;
use crate::Prop;
use endless_scene::LightSlot;
use endless_world::ObjectClass;
use serde::Deserialize;
use std::collections::BTreeMap;

/// What an entry's class stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AssetClass {
    Vehicle(ObjectClass),
    Prop(Prop),
    Building,
}

/// Longest name of an asset.
const LONGEST_NAME: usize = 60;

/// A whole manifest.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AssetManifest {
    /// One a file, in the manifest's order.
    #[serde(default, rename = "asset")]
    pub assets: Vec<AssetEntry>,
}

/// A manifest's entry: one file and what it holds.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AssetEntry {
    /// Name of the file beside the manifest.
    pub file: String,
    /// Name in the catalogue, behind `imported.`; the file's if left out.
    pub name: Option<String>,
    /// `car`, `van`, `truck`, `bus`, `motorcycle`, `bicycle`, `building`, or the name of a prop of the catalogue.
    pub class: String,
    /// Length, width (of vehicles without mirrors) and height, metres. The model is scaled to the length; width and
    /// height must agree with it.
    pub size: [f32; 3],
    /// Where the model's front looks in the file.
    #[serde(default)]
    pub forward: ForwardAxis,
    /// How the names of wheels' nodes begin.
    #[serde(default = "wheel")]
    pub wheels: String,
    /// Front and rear axle, metres ahead of the middle; as the wheels are if left out.
    pub axles: Option<[f32; 2]>,
    /// Metres; as the wheels are if left out.
    pub wheel_radius: Option<f32>,
    /// Materials that are painted anew in the colours of real traffic.
    #[serde(default)]
    pub paint: Vec<String>,
    /// What shines.
    #[serde(default)]
    pub lights: BTreeMap<LightSlot, LampPlaces>,
    /// Where a two-wheeler's rider touches it; two-wheelers need it.
    pub rider: Option<RiderEntry>,
    /// How often it is met: all vehicles of the catalogue together have 103, all cars 78.
    #[serde(default = "ten")]
    pub frequency: f64,
    /// Whether it may stand parked at a kerb.
    pub parks: Option<bool>,
    /// Of things that towns place: the share of the places of its class that it takes.
    #[serde(default = "half")]
    pub share: f64,
}

fn wheel() -> String {
    "wheel".to_owned()
}

fn ten() -> f64 {
    10.0
}

fn half() -> f64 {
    0.5
}

/// An axis of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum ForwardAxis {
    /// As glTF has it.
    #[default]
    #[serde(rename = "+z")]
    PlusZ,
    /// The other way.
    #[serde(rename = "-z")]
    MinusZ,
    /// As `endless assets export` writes.
    #[serde(rename = "+x")]
    PlusX,
    /// The other way.
    #[serde(rename = "-x")]
    MinusX,
}

/// Where lamps are.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum LampPlaces {
    /// All surfaces of these materials.
    Materials(Vec<String>),
    /// Small round lenses here: metres ahead of the middle, to the left of it, above the ground. They are laid on the
    /// surface.
    Places(Vec<[f32; 3]>),
}

/// Where a rider touches a two-wheeler, left side: metres ahead of the middle, to the left of it, above the ground.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RiderEntry {
    /// Top of the seat.
    pub seat: [f32; 3],
    /// Middle of the left grip.
    pub grip: [f32; 3],
    /// Under the ball of the left foot.
    pub foot: [f32; 3],
    /// How far the trunk leans ahead, radians.
    #[serde(default)]
    pub lean: f32,
    /// How likely a helmet is worn, 0 to 1.
    #[serde(default = "half")]
    pub helmet: f64,
}

impl AssetManifest {
    /// Reads a manifest.
    ///
    /// # Errors
    /// [`ImportError::Manifest`] with the place of the first mistake.
    pub fn parse(text: &str) -> Result<Self, ImportError> {
        toml::from_str(text).map_err(|e: toml::de::Error| {
            let before: Vec<u8> = text.bytes().take(e.span().map_or(0, |s| s.start)).collect();
            ImportError::Manifest {
                line: 1 + before.iter().filter(|&&b| b == b'\n').count(),
                column: 1 + before.iter().rev().take_while(|&&b| b != b'\n').count(),
                message: e.message().lines().collect::<Vec<_>>().join(", "),
            }
        })
    }
}

fn refuse(field: &'static str, given: &dyn ToString, rule: impl Into<String>) -> ImportError {
    ImportError::Entry { field, given: given.to_string(), rule: rule.into() }
}

impl AssetEntry {
    /// Name in the catalogue.
    pub fn asset_name(&self) -> String {
        let stem = self.file.strip_suffix(".glb").unwrap_or(&self.file);
        format!("imported.{}", self.name.as_deref().unwrap_or(stem))
    }

    pub(super) fn kind(&self) -> Result<AssetClass, ImportError> {
        const VEHICLES: [ObjectClass; 6] = [
            ObjectClass::Car,
            ObjectClass::Van,
            ObjectClass::Truck,
            ObjectClass::Bus,
            ObjectClass::Motorcycle,
            ObjectClass::Bicycle,
        ];
        if let Some(class) = VEHICLES.into_iter().find(|c| c.to_string() == self.class) {
            return Ok(AssetClass::Vehicle(class));
        }
        if self.class == "building" {
            return Ok(AssetClass::Building);
        }
        // Lamps of signals follow programs, faces of signs mean something: those of the catalogue stay.
        let placed = |p: &Prop| !p.is_signal() && *p != Prop::TrafficSign;
        self.class.parse().ok().filter(placed).map(AssetClass::Prop).ok_or_else(|| {
            let rule = "write car, van, truck, bus, motorcycle, bicycle, building, or the name of a plant or a piece of \
                        furniture of `endless assets list` (no signals, no signs)";
            refuse("class", &self.class, rule)
        })
    }

    pub(super) fn validate(&self, kind: AssetClass) -> Result<(), ImportError> {
        if self.file.contains(['/', '\\']) || !self.file.ends_with(".glb") || self.file.len() > 200 {
            return Err(refuse("file", &self.file, "write the name of a .glb file in the manifest's folder"));
        }
        let name = self.asset_name();
        let plain = |c: char| c.is_ascii_alphanumeric() || "._- ".contains(c);
        if name.len() > LONGEST_NAME || !name.chars().all(plain) {
            return Err(refuse("name", &name, "write at most 50 letters, digits, points, hyphens or underscores"));
        }
        let most = match kind {
            AssetClass::Vehicle(_) => [30.0, 4.0, 5.5],
            AssetClass::Prop(_) => [30.0, 30.0, 40.0],
            AssetClass::Building => [200.0, 200.0, 400.0],
        };
        if !self.size.iter().zip(most).all(|(s, m)| (0.02..=m).contains(s)) {
            let [l, w, h] = most;
            let rule = format!("write length, width and height in metres, at most {l}, {w} and {h}");
            return Err(refuse("size", &format!("{:?}", self.size), rule));
        }
        let half = 0.5 * self.size[0];
        if let Some([front, rear]) = self.axles
            && !(rear >= -half && front <= half && front > rear)
        {
            let rule = "write the front and the rear axle, metres ahead of the vehicle's middle";
            return Err(refuse("axles", &format!("{:?}", [front, rear]), rule));
        }
        if let Some(radius) = self.wheel_radius
            && !(0.05..=1.0).contains(&radius)
        {
            return Err(refuse("wheel_radius", &radius, "write metres, 0.05 to 1"));
        }
        if !(0.0..=1e6).contains(&self.frequency) {
            return Err(refuse("frequency", &self.frequency, "write a number from 0 to 1000000"));
        }
        if !(0.0..=1.0).contains(&self.share) {
            return Err(refuse("share", &self.share, "write a number from 0 to 1"));
        }
        self.validate_rider(kind)
    }

    fn validate_rider(&self, kind: AssetClass) -> Result<(), ImportError> {
        let two_wheeled = matches!(kind, AssetClass::Vehicle(class) if class.two_wheeled());
        let rule = "a two-wheeler needs { seat, grip, foot }, each metres ahead of the middle, to the left, up; lean from -1 \
                    to 1.5, helmet from 0 to 1; other things have no rider";
        match &self.rider {
            None if !two_wheeled => Ok(()),
            Some(r) if two_wheeled => {
                let near = |p: [f32; 3]| p.iter().all(|x| x.abs() < 2.5);
                let real = near(r.seat)
                    && near(r.grip)
                    && near(r.foot)
                    && (-1.0..=1.5).contains(&r.lean)
                    && (0.0..=1.0).contains(&r.helmet);
                if real { Ok(()) } else { Err(refuse("rider", &format!("{r:?}"), rule)) }
            }
            Some(_) => Err(refuse("rider", &"{ ... }", rule)),
            None => Err(refuse("rider", &"nothing", rule)),
        }
    }
}
