//! What labels need to know of traffic lights and signs: where their heads, lenses and plates are in the object frame.

use super::sign::FRONT;
use super::signal_look::SignalLook;
use super::{signal, signal_look};
use crate::Prop;
use endless_scene::{LensAspect, Mesh};
use glam::Vec3;

/// A head of a traffic light that faces +x.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalHead {
    /// Least corner of its housing and back-plate.
    pub low: Vec3,
    /// Greatest corner.
    pub high: Vec3,
    /// Middles of its lenses.
    pub lenses: Vec<(LensAspect, Vec3)>,
    /// Radius of its lenses, metres.
    pub lens_radius_m: f32,
}

/// What heads of one kind have in common, about their middle.
struct HeadDesign {
    low: Vec3,
    high: Vec3,
    /// Height of the lenses above the middle.
    lenses: Vec<(LensAspect, f32)>,
    lens_radius_m: f32,
}

/// A vehicle's head of a look.
fn vehicle(look: &SignalLook) -> HeadDesign {
    let ([y, z], pitch) = (look.outline(), look.head.pitch);
    HeadDesign {
        low: Vec3::new(-0.17, -y, -z),
        high: Vec3::new(0.0, y, z),
        lenses: vec![(LensAspect::Red, pitch), (LensAspect::Yellow, 0.0), (LensAspect::Green, -pitch)],
        lens_radius_m: look.head.lens_radius,
    }
}

fn bicycle() -> HeadDesign {
    HeadDesign {
        low: Vec3::new(-0.10, -0.075, -0.25),
        high: Vec3::new(0.0, 0.075, 0.25),
        lenses: vec![(LensAspect::Red, 0.155), (LensAspect::Yellow, 0.0), (LensAspect::Green, -0.155)],
        lens_radius_m: 0.055,
    }
}

fn pedestrian() -> HeadDesign {
    HeadDesign {
        low: Vec3::new(-0.14, -0.13, -0.27),
        high: Vec3::new(0.0, 0.13, 0.27),
        lenses: vec![(LensAspect::Red, 0.125), (LensAspect::Green, -0.125)],
        lens_radius_m: 0.095,
    }
}

impl HeadDesign {
    fn at(&self, middle: Vec3) -> SignalHead {
        let lens = |&(aspect, z): &(LensAspect, f32)| (aspect, middle + Vec3::new(0.002, 0.0, z));
        SignalHead {
            low: middle + self.low,
            high: middle + self.high,
            lenses: self.lenses.iter().map(lens).collect(),
            lens_radius_m: self.lens_radius_m,
        }
    }
}

/// The heads of a prop; none of what is no traffic light.
pub(crate) fn signal_heads(prop: Prop, variant: u32) -> Vec<SignalHead> {
    let look = signal_look::of(variant);
    let (design, middles): (_, Vec<Vec3>) = match prop {
        Prop::SignalPole => (vehicle(look), signal::heads_on_pole(look)),
        Prop::SignalMast => (vehicle(look), signal::heads_on_mast(look).concat()),
        Prop::SignalCurvedMast => (vehicle(look), signal::heads_on_curved_mast(look).concat()),
        // Under the lower wire, which sags by 0.85 m.
        Prop::SpanSignal => {
            const Z: f32 = 7.4 - 0.85 * (1.0 - 1.9 * 1.9 / 49.0) - 0.72;
            (vehicle(look), vec![Vec3::new(0.10, -1.9, Z), Vec3::new(0.10, 1.9, Z)])
        }
        Prop::CycleSignal => (bicycle(), vec![Vec3::new(0.16, 0.0, 2.35)]),
        Prop::WalkSignal => (pedestrian(), vec![Vec3::new(0.22, 0.0, 2.4)]),
        _ => return Vec::new(),
    };
    middles.into_iter().map(|middle| design.at(middle)).collect()
}

/// Height below which posts may be as thick as plates lie before them, metres.
const FOOT_M: f32 = 1.0;

/// A traffic sign: the box of its plate, which faces +x, and what it says.
#[derive(Debug, Clone, PartialEq)]
pub struct SignPlate {
    /// Least corner.
    pub low: Vec3,
    /// Greatest corner.
    pub high: Vec3,
    /// Its code: of the Vienna Convention of 1968 (`C,14`) or of the MUTCD (`R2-1`).
    pub code: &'static str,
    /// The limit of a speed sign, with its unit.
    pub limit: Option<(u32, &'static str)>,
    /// The words on it.
    pub words: Option<&'static str>,
}

/// The plate of a sign, whose mesh is made if it is one; `None` for what is no traffic sign.
pub(crate) fn sign_plate(prop: Prop, variant: u32, mesh: impl FnOnce() -> Mesh) -> Option<SignPlate> {
    let code = match prop {
        Prop::StopSign => "B,2",
        Prop::YieldSign => "B,1",
        Prop::SpeedSign => "C,14",
        Prop::CrossingSign => "E,12",
        Prop::TrafficSign => super::CODES[variant as usize % super::CODES.len()],
        _ => return None,
    };
    let limit = match prop {
        Prop::SpeedSign => Some(([50, 30, 40][variant as usize % 3], "km/h")),
        _ => (code == "R2-1").then_some((25, "mph")),
    };
    let words = match code {
        "B,2" => Some("STOP"),
        "E,14" => Some("P"),
        "R1-2" => Some("YIELD"),
        "R2-1" => Some("SPEED LIMIT"),
        "R5-1" => Some("DO NOT ENTER"),
        "R6-1" => Some("ONE WAY"),
        "R7-1" => Some("NO PARKING ANY TIME"),
        "W20-1" => Some("ROAD WORK AHEAD"),
        _ => None,
    };
    // The plate is all that lies before the post, above its foot.
    let mesh = mesh();
    let front = mesh.positions.iter().filter(|p| p.x > FRONT - 0.001 && p.z > FOOT_M);
    let (low, high) = front.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
    low.is_finite().then_some(SignPlate { low, high, code, limit, words })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::furniture::{furniture, variants};
    use endless_scene::Surface;

    #[test]
    fn heads_are_where_the_meshes_have_lenses() {
        for (&prop, variant) in Prop::ALL.iter().flat_map(|prop| (0..variants(*prop)).map(move |v| (prop, v))) {
            let mesh = furniture(prop, variant);
            let heads = signal_heads(prop, variant);
            assert_eq!(heads.is_empty(), !prop.is_signal(), "{}", prop.name());
            let mut seen = vec![0; heads.len()];
            for (triangle, &material) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
                let Surface::SignalLens(aspect) = mesh.materials[usize::from(material)].surface else { continue };
                let middle = triangle.iter().map(|&v| mesh.positions[v as usize]).sum::<Vec3>() / 3.0;
                let here = |head: &SignalHead| {
                    let near = |lens: &&(LensAspect, Vec3)| lens.1.distance(middle) < head.lens_radius_m + 0.03;
                    head.lenses.iter().find(near).map(|lens| lens.0) == Some(aspect)
                };
                let head = heads.iter().position(here);
                seen[head.unwrap_or_else(|| panic!("{}: a lens at {middle}", prop.name()))] += 1;
            }
            assert!(seen.iter().all(|&lenses| lenses > 0), "{}: a head without lenses", prop.name());
            for head in &heads {
                let (low, high) = mesh.bounds();
                assert!(head.low.cmpge(low - 1e-4).all() && head.high.cmple(high + 1e-4).all(), "{}", prop.name());
            }
        }
    }

    #[test]
    fn plates_are_flat_and_stand_above_heads() {
        for prop in [Prop::StopSign, Prop::YieldSign, Prop::SpeedSign, Prop::CrossingSign, Prop::TrafficSign] {
            for variant in 0..variants(prop) {
                let plate = sign_plate(prop, variant, || furniture(prop, variant)).expect("a sign");
                let size = plate.high - plate.low;
                assert!(size.x < 0.06 && size.y > 0.25 && size.z > 0.25 && plate.low.z > 1.8, "{plate:?}");
            }
        }
        assert_eq!(sign_plate(Prop::Bench, 0, || furniture(Prop::Bench, 0)), None);
    }
}
