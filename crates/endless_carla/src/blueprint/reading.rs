//! What a client asks for: values of attributes, checked.

use super::entry::Blueprint;
use crate::wire::{ActorAttribute, ActorAttributeValue, ActorDescription, AttributeType, Color};

/// Longest text of an attribute, bytes.
const MAX_TEXT: usize = 4096;
/// Most pixels of an image.
const MAX_PIXELS: u64 = 1 << 27;

/// A value that a client gave is not one that its attribute can have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AttributeError {
    /// The blueprint has no such attribute.
    #[error("{blueprint} has no attribute {attribute}")]
    Unknown {
        /// Which was asked for.
        attribute: String,
        /// Of which blueprint.
        blueprint: String,
    },
    /// The text says something else than it must.
    #[error("attribute {attribute}: expected {expected}, got {actual}")]
    Malformed {
        /// Whose.
        attribute: String,
        /// What it must be.
        expected: &'static str,
        /// What it is, shortened.
        actual: String,
    },
    /// A number is too small or too large.
    #[error("attribute {attribute}: expected {low} to {high}, got {actual}")]
    OutOfRange {
        /// Whose.
        attribute: String,
        /// Least allowed.
        low: f64,
        /// Most allowed.
        high: f64,
        /// What it is.
        actual: f64,
    },
    /// An image has too many pixels in all.
    #[error("an image of {width} x {height} pixels is larger than {MAX_PIXELS} pixels")]
    TooManyPixels {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
}

impl AttributeError {
    fn malformed(attribute: &str, expected: &'static str, text: &str) -> Self {
        let mut actual: String = text.chars().take(40).flat_map(char::escape_debug).collect();
        if text.chars().nth(40).is_some() {
            actual.push_str("...");
        }
        Self::Malformed { attribute: attribute.to_owned(), expected, actual: format!("\"{actual}\"") }
    }
}

/// Values of a description, with the blueprint's where the description has none or may have none of its own.
#[derive(Debug, Clone, Copy)]
pub struct Attributes<'a> {
    blueprint: &'a Blueprint,
    description: &'a ActorDescription,
}

impl Blueprint {
    /// Values of a client's description, or this blueprint's where that has none.
    pub fn attributes<'a>(&'a self, description: &'a ActorDescription) -> Attributes<'a> {
        Attributes::new(self, description)
    }
}

impl<'a> Attributes<'a> {
    fn new(blueprint: &'a Blueprint, description: &'a ActorDescription) -> Self {
        Self { blueprint, description }
    }

    /// Whether the blueprint has it.
    pub fn has(&self, id: &str) -> bool {
        self.definition(id).is_ok()
    }

    /// The text itself.
    ///
    /// # Errors
    /// When the blueprint has no such attribute.
    pub fn text(&self, id: &str) -> Result<&'a str, AttributeError> {
        Ok(self.value(self.definition(id)?))
    }

    /// A number, of an attribute that is an integer or a number.
    ///
    /// # Errors
    /// When it is none, not finite, or out of range.
    pub fn number(&self, id: &str) -> Result<f64, AttributeError> {
        number(id, self.text(id)?)
    }

    /// An integer. `800.0` counts as one.
    ///
    /// # Errors
    /// When it is none, or out of range.
    pub fn integer(&self, id: &str) -> Result<i64, AttributeError> {
        integer(id, self.text(id)?)
    }

    /// A switch. `True`, `yes`, `on` and `1` are true, as for CARLA.
    ///
    /// # Errors
    /// When it is none.
    pub fn flag(&self, id: &str) -> Result<bool, AttributeError> {
        flag(id, self.text(id)?)
    }

    /// A colour: `r,g,b` of 0 to 255.
    ///
    /// # Errors
    /// When it is none.
    pub fn color(&self, id: &str) -> Result<Color, AttributeError> {
        color(id, self.text(id)?)
    }

    /// Width and height of a camera's images, pixels.
    ///
    /// # Errors
    /// When one is malformed or out of range, or both are large: then an image would take more than half a gigabyte.
    pub fn image_size(&self) -> Result<[u32; 2], AttributeError> {
        let side = |id: &str| {
            let text = self.text(id)?;
            let side = integer(id, text)?;
            u32::try_from(side).or(Err(AttributeError::malformed(id, "a number of pixels", text)))
        };
        let [width, height] = [side("image_size_x")?, side("image_size_y")?];
        if u64::from(width) * u64::from(height) > MAX_PIXELS {
            return Err(AttributeError::TooManyPixels { width, height });
        }
        Ok([width, height])
    }

    /// Horizontal field of view of a camera, degrees.
    ///
    /// # Errors
    /// When it is no number, or not between 0 and 179.
    pub fn fov_degrees(&self) -> Result<f64, AttributeError> {
        self.number("fov")
    }

    /// Simulated seconds between measurements; 0 for sensors that measure in every frame, or have no such attribute.
    ///
    /// # Errors
    /// When it is no number, or negative.
    pub fn sensor_tick_secs(&self) -> Result<f64, AttributeError> {
        if self.has("sensor_tick") { self.number("sensor_tick") } else { Ok(0.0) }
    }

    /// All values, as an actor keeps them.
    ///
    /// # Errors
    /// At the first value that its attribute cannot have.
    pub fn complete(&self) -> Result<ActorDescription, AttributeError> {
        let definition = &self.blueprint.definition;
        let attributes = definition.attributes.iter().map(|attribute| {
            let text = self.value(attribute);
            check(attribute, text)?;
            Ok(ActorAttributeValue { id: attribute.id.clone(), kind: attribute.kind, value: text.to_owned() })
        });
        let attributes = attributes.collect::<Result<_, AttributeError>>()?;
        Ok(ActorDescription { uid: definition.uid, id: definition.id.clone(), attributes })
    }

    fn definition(&self, id: &str) -> Result<&'a ActorAttribute, AttributeError> {
        let definition = &self.blueprint.definition;
        definition
            .attributes
            .iter()
            .find(|attribute| attribute.id == id)
            .ok_or_else(|| AttributeError::Unknown { attribute: id.to_owned(), blueprint: definition.id.clone() })
    }

    fn value(&self, attribute: &'a ActorAttribute) -> &'a str {
        let given = if attribute.is_modifiable { self.description.attribute(&attribute.id) } else { None };
        given.unwrap_or(&attribute.value)
    }
}

/// Whether an attribute can have this value.
pub(super) fn check(attribute: &ActorAttribute, text: &str) -> Result<(), AttributeError> {
    let id = attribute.id.as_str();
    match attribute.kind {
        AttributeType::Bool => flag(id, text).map(drop),
        AttributeType::Int => integer(id, text).map(drop),
        AttributeType::Float => number(id, text).map(drop),
        AttributeType::RgbColor => color(id, text).map(drop),
        AttributeType::String if text.len() > MAX_TEXT => {
            Err(AttributeError::malformed(id, "a text of at most 4096 bytes", text))
        }
        AttributeType::String => Ok(()),
    }
}

fn number(id: &str, text: &str) -> Result<f64, AttributeError> {
    let number: f64 = text.trim().parse().or(Err(AttributeError::malformed(id, "a number", text)))?;
    if !number.is_finite() {
        return Err(AttributeError::malformed(id, "a finite number", text));
    }
    within_bounds(id, number)
}

fn integer(id: &str, text: &str) -> Result<i64, AttributeError> {
    if let Ok(integer) = text.trim().parse::<i64>() {
        within_bounds(id, integer as f64)?;
        return Ok(integer);
    }
    let number = number(id, text)?;
    if number.fract() == 0.0 { Ok(number as i64) } else { Err(AttributeError::malformed(id, "an integer", text)) }
}

fn flag(id: &str, text: &str) -> Result<bool, AttributeError> {
    match text.trim().to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" | "1" => Ok(true),
        "false" | "no" | "off" | "0" => Ok(false),
        _ => Err(AttributeError::malformed(id, "true or false", text)),
    }
}

fn color(id: &str, text: &str) -> Result<Color, AttributeError> {
    let channels: Option<Vec<u8>> = text.split(',').map(|channel| channel.trim().parse().ok()).collect();
    match channels.as_deref() {
        Some(&[r, g, b]) => Ok(Color { r, g, b }),
        _ => Err(AttributeError::malformed(id, "a colour (r,g,b of 0 to 255)", text)),
    }
}

fn within_bounds(id: &str, number: f64) -> Result<f64, AttributeError> {
    let (low, high) = bounds(id);
    if (low..=high).contains(&number) {
        Ok(number)
    } else {
        Err(AttributeError::OutOfRange { attribute: id.to_owned(), low, high, actual: number })
    }
}

/// Least and most that a number may be: what has no meaning beyond, and what would take all memory.
fn bounds(id: &str) -> (f64, f64) {
    match id {
        "image_size_x" | "image_size_y" => (1.0, 16384.0),
        "fov" => (0.001, 179.0),
        "upper_fov" | "lower_fov" => (-90.0, 90.0),
        "horizontal_fov" => (0.0, 360.0),
        "vertical_fov" => (0.0, 180.0),
        "channels" => (1.0, 4096.0),
        "points_per_second" => (0.0, 1e8),
        "range" | "distance" | "hit_radius" | "extent_x" | "extent_y" | "extent_z" => (0.0, 1e6),
        "sensor_tick" | "rotation_frequency" | "atmosphere_attenuation_rate" => (0.0, 1e6),
        "dropoff_general_rate" | "dropoff_intensity_limit" | "dropoff_zero_intensity" => (0.0, 1.0),
        "shutter_speed" | "iso" | "fstop" | "gamma" | "log_eps" => (1e-9, 1e9),
        "positive_threshold" | "negative_threshold" => (0.0, 1e3),
        "refractory_period_ns" => (0.0, 1e15),
        // Metres a second.
        "speed" => (0.0, 100.0),
        // Seeds of any width.
        "noise_seed" => (i64::MIN as f64, i64::MAX as f64),
        _ if id.contains("stddev") || id.starts_with("sigma_") => (0.0, 1e6),
        _ => (-1e12, 1e12),
    }
}
