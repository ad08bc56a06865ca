//! Vehicles: a body, wheels that roll and steer, lamps.

use super::model::{SourceModel, SourcePart};
use super::source_material::SourceMaterial;
use super::static_model::{SIZE_TOLERANCE, stand};
use super::texture_bake::TextureBaker;
use super::{AssetEntry, ImportError, lamp};
use crate::vehicle::{HelmetKind, RiderFit, VehicleModel, VehicleParts, Wheel};
use endless_scene::{LightSlot, Mesh, Surface};
use endless_world::{ObjectClass, Outfit, VehicleSpec, fnv1a};
use glam::Vec3;
use std::collections::BTreeMap;

/// Mirrors stand out: the model may be this much wider than the entry says.
const MIRRORS: f32 = 1.4;
/// Wheels that differ by more than this from the first do not roll.
const ALIKE: f32 = 0.04;
/// Wheels this near to the foremost steer with it, metres.
const SAME_AXLE_M: f32 = 0.25;

/// Parts of one wheel.
struct WheelParts<'a> {
    parts: Vec<&'a SourcePart>,
    low: Vec3,
    high: Vec3,
}

impl WheelParts<'_> {
    fn centre(&self) -> Vec3 {
        0.5 * (self.low + self.high)
    }

    /// Half of width, and radius.
    fn half(&self) -> Vec3 {
        0.5 * (self.high - self.low)
    }

    fn is_round(&self) -> bool {
        let half = self.half();
        half.z > 0.05 && half.z < 1.2 && (half.x - half.z).abs() < 0.08 * half.z && half.y < half.z
    }
}

pub(super) fn make(
    entry: &AssetEntry,
    class: ObjectClass,
    mut model: SourceModel,
) -> Result<VehicleModel, ImportError> {
    let found = stand(&mut model, entry.size[0])?;
    let [_, width, height] = entry.size;
    let narrow = found.y < (1.0 - SIZE_TOLERANCE) * width || found.y > MIRRORS * width;
    if narrow || (found.z - height).abs() > SIZE_TOLERANCE * height {
        return Err(ImportError::Size { found: found.to_array(), stated: entry.size });
    }
    dress(entry, &mut model.materials)?;
    let tag = class.tag();
    let wheels = wheels(entry, &model.parts);
    let rolling = RollingWheels::of(&wheels);
    let mut baker = TextureBaker::new(&model.materials, tag, false);
    let rolls = |part: &SourcePart| rolling.parts.iter().any(|&p| std::ptr::eq(p, part));
    model.parts.iter().filter(|part| !rolls(part)).for_each(|part| baker.add(part, Vec3::ZERO));
    let mut body = baker.finish();
    if body.triangles.is_empty() {
        return Err(ImportError::Empty);
    }
    lamp::at_places(entry, &mut body, tag)?;
    let mut baker = TextureBaker::new(&model.materials, tag, false);
    if let Some(reference) = rolling.reference {
        reference.parts.iter().for_each(|part| baker.add(part, -reference.centre()));
    }
    let wheel_mesh = baker.finish();
    let [front, rear] = match (entry.axles, rolling.span()) {
        (Some(axles), _) => axles,
        (None, Some(span)) => span,
        (None, None) => return Err(ImportError::NoAxles { wheels: entry.wheels.chars().take(40).collect() }),
    };
    let radius = entry.wheel_radius.or(rolling.reference.map(|p| p.half().z)).unwrap_or(0.33);
    // Lenses may stand out by millimetres: what is written down is what is there.
    let parts = VehicleParts {
        headlights: headlights(&body),
        body: body.into(),
        wheels: rolling.wheels,
        wheel_mesh: wheel_mesh.into(),
        trailer: None,
        fit: entry.rider.map(|r| RiderFit {
            seat: Vec3::from_array(r.seat),
            grip: Vec3::from_array(r.grip),
            foot: Vec3::from_array(r.foot),
            right_foot: Vec3::ZERO,
            lean_rad: r.lean,
            helmet: r.helmet,
            helmets: if class == ObjectClass::Bicycle { HelmetKind::Cycle } else { HelmetKind::Full },
            outfit: Outfit::Fair,
            standing: false,
            pillion: None,
        }),
    };
    let (low, high) = parts.whole().bounds();
    let (cruise_mps, acceleration_mps2) = habits(class);
    let spec = VehicleSpec {
        name: "imported",
        draw: fnv1a(entry.asset_name().bytes()),
        class,
        length_m: high.x - low.x,
        width_m: width.min(high.y - low.y),
        height_m: high.z,
        front_axle_m: front,
        rear_axle_m: rear,
        wheel_radius_m: radius,
        cruise_mps,
        acceleration_mps2,
        frequency: entry.frequency,
        parks: entry.parks.unwrap_or(matches!(class, ObjectClass::Car | ObjectClass::Van)),
        ridden: parts.fit.is_some(),
        trailer: None,
    };
    let paints = !entry.paint.is_empty();
    Ok(VehicleModel::imported(entry.asset_name(), spec, parts, paints))
}

/// Materials that are painted anew, and materials that shine.
fn dress(entry: &AssetEntry, materials: &mut [SourceMaterial]) -> Result<(), ImportError> {
    for name in &entry.paint {
        for k in lamp::named(materials, name, "paint")? {
            materials[k].surface = Surface::CarPaint;
            materials[k].color = glam::Vec4::ONE;
            materials[k].texture = None;
        }
    }
    lamp::of_materials(entry, materials)
}

/// The wheels: what lies under nodes whose names begin as the entry says.
fn wheels<'a>(entry: &AssetEntry, parts: &'a [SourcePart]) -> Vec<WheelParts<'a>> {
    let begins = entry.wheels.to_lowercase();
    let mut of_node: BTreeMap<usize, WheelParts<'a>> = BTreeMap::new();
    for part in parts {
        let wheel = part.path.iter().find(|(_, name)| !begins.is_empty() && name.to_lowercase().starts_with(&begins));
        let Some(&(node, _)) = wheel else { continue };
        let empty = || WheelParts { parts: vec![], low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };
        let round = of_node.entry(node).or_insert_with(empty);
        round.parts.push(part);
        for &i in part.triangles.iter().flatten() {
            let p = part.positions[i as usize];
            (round.low, round.high) = (round.low.min(p), round.high.max(p));
        }
    }
    of_node.into_values().collect()
}

/// The wheels that roll: the first on the left side is the reference for all.
struct RollingWheels<'a> {
    reference: Option<&'a WheelParts<'a>>,
    parts: Vec<&'a SourcePart>,
    wheels: Vec<Wheel>,
}

impl<'a> RollingWheels<'a> {
    fn of(wheels: &'a [WheelParts<'a>]) -> Self {
        let left = |w: &&WheelParts<'_>| w.is_round() && w.centre().y > -0.05;
        let Some(reference) = wheels.iter().find(left) else {
            return Self { reference: None, parts: vec![], wheels: vec![] };
        };
        let alike = |w: &&WheelParts<'_>| {
            w.is_round()
                && (w.half().z / reference.half().z - 1.0).abs() < ALIKE
                && (w.half().y / reference.half().y.max(1e-3) - 1.0).abs() < 3.0 * ALIKE
        };
        let rolling: Vec<&WheelParts<'_>> = wheels.iter().filter(alike).collect();
        let foremost = rolling.iter().map(|w| w.centre().x).fold(f32::NEG_INFINITY, f32::max);
        let wheel = |w: &&WheelParts<'_>| Wheel {
            position: w.centre(),
            steered: w.centre().x > foremost - SAME_AXLE_M,
            mirrored: w.centre().y < -0.05,
        };
        Self {
            reference: Some(reference),
            wheels: rolling.iter().map(wheel).collect(),
            parts: rolling.iter().flat_map(|w| w.parts.iter().copied()).collect(),
        }
    }

    /// Front and rear axle.
    fn span(&self) -> Option<[f32; 2]> {
        let xs = || self.wheels.iter().map(|w| w.position.x);
        let (front, rear) = (xs().fold(f32::NEG_INFINITY, f32::max), xs().fold(f32::INFINITY, f32::min));
        (front > rear).then_some([front, rear])
    }
}

/// The middles of the headlights' lenses on each side.
fn headlights(body: &Mesh) -> Vec<Vec3> {
    let shines = |m: u16| body.materials[usize::from(m)].surface == Surface::VehicleLight(LightSlot::Head);
    let lit = body.triangles.iter().zip(&body.triangle_materials).filter(|t| shines(*t.1));
    let lenses: Vec<(Vec3, f32)> = lit
        .map(|(t, _)| {
            let [a, b, c] = t.map(|i| body.positions[i as usize]);
            ((a + b + c) / 3.0, (b - a).cross(c - a).length())
        })
        .collect();
    let middle = |side: fn(f32) -> bool| {
        let there = lenses.iter().filter(|l| side(l.0.y));
        let (sum, area) = there.fold((Vec3::ZERO, 0.0), |(sum, area), l| (sum + l.0 * l.1, area + l.1));
        (area > 0.0).then(|| sum / area)
    };
    [middle(|y| y > 0.1), middle(|y| y.abs() <= 0.1), middle(|y| y < -0.1)].into_iter().flatten().collect()
}

/// Cruising speed, m/s, and acceleration, m/s², of a class.
fn habits(class: ObjectClass) -> (f32, f32) {
    match class {
        ObjectClass::Van => (34.0, 1.5),
        ObjectClass::Truck => (23.0, 1.0),
        ObjectClass::Bus => (22.0, 1.1),
        ObjectClass::Motorcycle => (34.0, 2.4),
        ObjectClass::Bicycle => (4.8, 0.9),
        _ => (38.0, 2.0),
    }
}
