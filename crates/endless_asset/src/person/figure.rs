//! The whole figure in its rest pose: body, clothes, head, things.

use super::appearance::{Appearance, Carried};
use super::body::Body;
use super::carried;
use super::clothes::{FabricPattern, Garment, GarmentTop, ShoeKind};
use super::collar;
use super::garment_mesh::{BodyRegion, GarmentShape};
use super::hair;
use super::head::Head;
use super::limbs;
use super::skeleton::{Side, Skeleton};
use super::skin::Skin;
use endless_scene::Material;
use endless_world::math::smoothstep;

/// Everything in the rest pose.
pub(crate) fn build(appearance: &Appearance, skeleton: &Skeleton) -> Skin {
    let mut skin = Skin::default();
    let body = Body::new(appearance, skeleton);
    let garments = &appearance.garments;
    for (i, garment) in garments.iter().enumerate() {
        if let Some(seen) = visible_under(garment, &garments[i + 1..]) {
            let front = seen.sleeve == 0.0 && garments[i + 1..].iter().any(|g| g.gap.is_some() && g.sleeve > 0.0);
            sew(&mut skin, &body, &seen, front);
            collar::add(&mut skin, &body, &seen);
        }
    }
    below(&mut skin, &body);
    body.neck(&mut skin, appearance.skin);
    let reach = garments.iter().map(|g| g.sleeve).fold(0.0, f32::max);
    if reach == 0.0 {
        body.bare_shoulders(&mut skin, appearance.skin);
    } else if reach < 0.9 {
        body.bare_arms(&mut skin, reach - 0.10, appearance.skin);
    }
    for side in Side::BOTH {
        limbs::shoe(&mut skin, &body, side);
        limbs::hand(&mut skin, &body, side, holds(appearance.carried, side));
    }
    let head = Head::new(appearance, skeleton);
    head.add(&mut skin);
    hair::add(&mut skin, &body, &head);
    carried::add(&mut skin, &body);
    skin
}

/// Whether a hand is closed around something.
fn holds(carried: Carried, side: Side) -> bool {
    match carried {
        Carried::Nothing | Carried::Backpack | Carried::ShoulderBag => false,
        Carried::Handbag | Carried::ShoppingBag | Carried::Briefcase | Carried::Dog => side == Side::Left,
        Carried::Phone | Carried::Call | Carried::Umbrella | Carried::Cane | Carried::Suitcase => side == Side::Right,
        Carried::Pram | Carried::Wheelchair => true,
    }
}

/// What can be seen of garments that are worn over one another, from the inside out.
pub(crate) fn visible_garments(garments: &[Garment]) -> Vec<Garment> {
    garments.iter().enumerate().filter_map(|(i, garment)| visible_under(garment, &garments[i + 1..])).collect()
}

/// What of a garment the ones over it leave to be seen.
fn visible_under(garment: &Garment, over: &[Garment]) -> Option<Garment> {
    let mut seen = garment.clone();
    for other in over.iter().filter(|o| matches!(o.upper, GarmentTop::Neck { .. })) {
        if matches!(garment.upper, GarmentTop::Waist(_)) {
            if other.gap.is_none() && other.hem < garment.hem {
                return None;
            }
            continue;
        }
        if other.sleeve > seen.sleeve - 0.03 {
            seen.sleeve = 0.0;
        }
        if other.gap.is_none() && other.hem < seen.hem + 0.01 && seen.sleeve == 0.0 && !deep(other) {
            return None;
        }
        if other.gap.is_some() {
            seen.hem = seen.hem.max(other.hem - 0.005).max(if seen.hem < 0.53 { 0.535 } else { seen.hem });
        }
    }
    Some(seen)
}

fn deep(garment: &Garment) -> bool {
    matches!(garment.upper, GarmentTop::Neck { dip, .. } if dip > 0.3)
}

fn sew(skin: &mut Skin, body: &Body<'_>, g: &Garment, front: bool) {
    let baggy = g.ease > 0.012;
    let cuff = g.sleeve < 0.6 && g.sleeve > 0.0;
    let ease = |zone: BodyRegion, t: f32| match zone {
        BodyRegion::Trunk => {
            let from = if matches!(g.upper, GarmentTop::Waist(_)) { 0.60 } else { 0.57 };
            let blouse = if baggy { 0.004 * smoothstep(g.hem + 0.08, g.hem + 0.03, t) } else { 0.0 };
            g.ease * (1.0 - 0.25 * smoothstep(0.72, 0.80, t)) + g.flare * smoothstep(from, 0.10_f32.max(g.hem), t)
                - blouse
        }
        BodyRegion::Arm => {
            let wide = if cuff { 0.007 * smoothstep(0.15, g.sleeve, t) } else { 0.0 };
            0.8 * g.ease.min(0.03) + 0.001 + wide
        }
        BodyRegion::Leg => 0.0,
    };
    let color = |zone: BodyRegion, t: f32, column: usize| pattern(g, zone, t, column);
    let cut = GarmentShape {
        hem: g.hem,
        upper: g.upper,
        sleeve: g.sleeve,
        legs: None,
        gap: g.gap,
        ease: &ease,
        color: &color,
        folds: g.folds,
        front,
        rim: 0.006,
    };
    body.sew(skin, &cut);
}

/// The colour of a place of a garment.
fn pattern(g: &Garment, zone: BodyRegion, t: f32, column: usize) -> Material {
    let other = match g.pattern {
        FabricPattern::Plain => false,
        FabricPattern::Stripes => zone == BodyRegion::Trunk && ((t - g.hem) / 0.054) as u32 % 2 == 1 && t < 0.76,
        FabricPattern::Block => zone == BodyRegion::Arm || t > 0.72,
        FabricPattern::Checks => (((t - g.hem) / 0.054) as usize + column) % 2 == 1,
        FabricPattern::Border => {
            zone == BodyRegion::Trunk && t < g.hem + 0.045 || zone == BodyRegion::Arm && t > g.sleeve - 0.08
        }
        FabricPattern::HighVisibility => match zone {
            BodyRegion::Trunk => {
                let band = (0.588..0.636).contains(&t) || (0.686..0.740).contains(&t);
                band || t > 0.70 && matches!(column, 1 | 14) || t > 0.70 && matches!(column, 6 | 9)
            }
            BodyRegion::Arm => (0.36..0.52).contains(&t) || (0.66..0.82).contains(&t),
            BodyRegion::Leg => false,
        },
    };
    if other { g.accent } else { g.material }
}

/// Legs, in trousers or bare, and boots.
fn below(skin: &mut Skin, body: &Body<'_>) {
    let appearance = body.appearance;
    let legs = &appearance.legs;
    let hem = appearance.garments.iter().map(|g| g.hem).fold(1.0, f32::min);
    let bare = |skin: &mut Skin, up_to: f32| {
        let boots = if appearance.shoes.kind == ShoeKind::Boots { 0.42 } else { -1.0 };
        let color = |_: BodyRegion, t: f32, _: usize| if t < boots { appearance.shoes.material } else { legs.below };
        body.bare_legs(skin, up_to, &color);
    };
    if legs.end > 1.9 {
        // As far up as a skirt lets one see.
        let at = if hem < 0.285 { (hem - 0.046) / 0.239 } else { 1.0 + (hem - 0.285) / 0.24 };
        return bare(skin, (at + 0.45).clamp(0.2, 1.66));
    }
    // Tops hide the waist of trousers unless they are tucked in.
    let top = appearance.garments.iter().filter(|g| g.gap.is_none()).map(|g| g.hem).fold(1.0, f32::min);
    let tucked = top > 0.545;
    let waist = if tucked { 0.602 } else { (top + 0.05).clamp(0.53, 0.60) };
    let within = if tucked {
        appearance.garments.iter().filter(|g| g.hem > 0.545).map(|g| g.ease).fold(0.0, f32::max).min(0.010) + 0.004
    } else {
        0.003
    };
    let ease = |zone: BodyRegion, t: f32| match zone {
        BodyRegion::Trunk => within.max(0.4 * legs.ease),
        _ => {
            legs.ease * smoothstep(2.0, 1.2, t).max(0.5)
                + legs.cuff * smoothstep((legs.end + 1.35).min(1.95), legs.end, t)
        }
    };
    let stripe = |column: usize| legs.stripe && matches!(column, 4 | 3);
    let color = |zone: BodyRegion, _: f32, column: usize| {
        if zone == BodyRegion::Leg && stripe(column) { legs.accent } else { legs.material }
    };
    let cut = GarmentShape {
        hem: 0.0,
        upper: GarmentTop::Waist(waist),
        sleeve: 0.0,
        legs: Some(legs.end),
        gap: None,
        ease: &ease,
        color: &color,
        folds: if legs.ease < 0.003 { 0.2 } else { 1.0 },
        front: false,
        rim: 0.004,
    };
    body.sew(skin, &cut);
    if tucked {
        collar::belt(skin, body, within);
    }
    bare(skin, legs.end + 0.16);
}
