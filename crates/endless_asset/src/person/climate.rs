//! What people change when it is hot or cold: the same persons, in other clothes.

use super::appearance::{Appearance, Carried, Hat};
use super::choice::choose;
use super::clothes::{Collar, Garment, GarmentTop, ShoeKind};
use super::garments::{cloth, leather, light_top, outer, shorts, stockings, trousers};
use super::palette::{self, BRIGHT, JEWEL};
use endless_scene::Surface;
use endless_world::Stream;

/// What is left at home in the heat.
const COATS: [&str; 6] = ["jacket", "puffer_jacket", "coat", "parka", "denim_jacket", "suit_jacket"];
/// What is changed for something with short sleeves.
const WARM_TOPS: [&str; 3] = ["sweater", "hoodie", "long_sleeve"];

/// Arms and often legs are bare; hats and parasols against the sun.
pub(super) fn against_heat(appearance: &mut Appearance, s: &mut Stream) {
    let covered = appearance.garments.len();
    appearance.garments.retain(|g| !COATS.contains(&g.name));
    if appearance.garments.len() < covered && appearance.outfit == "suit" {
        appearance.outfit = "office";
    }
    let cool = light_top(appearance, s);
    for garment in &mut appearance.garments {
        if WARM_TOPS.contains(&garment.name) && s.chance(0.85) {
            // Over a skirt a top ends where the other one did.
            *garment = Garment { hem: garment.hem.max(cool.hem), ..cool.clone() };
        } else if ["shirt", "blouse", "track_jacket"].contains(&garment.name) && s.chance(0.75) {
            garment.sleeve = garment.sleeve.min(0.42);
        }
    }
    if matches!(appearance.outfit, "casual" | "sports") {
        if appearance.legs.end < 0.5 && s.chance(0.45) {
            appearance.legs = shorts(appearance, s);
        }
        if s.chance(0.45) {
            appearance.shoes = leather(s, ShoeKind::Sandals);
        }
    }
    if appearance.legs.end > 1.9 {
        appearance.legs.below = appearance.skin;
    }
    if matches!(appearance.hat, Hat::None | Hat::Beanie) {
        let straw = palette::material(Surface::Cloth, [206, 178, 122], 1.0);
        let conical = if appearance.age > 25.0 { 4.0 } else { 0.0 };
        appearance.hat = choose(
            s,
            &[(Hat::None, 66.0), (Hat::Cap, 16.0), (Hat::Brimmed, 10.0), (Hat::Fedora, 2.0), (Hat::Conical, conical)],
        );
        appearance.hat_color = match appearance.hat {
            Hat::Conical => straw,
            Hat::Brimmed if s.chance(0.5) => straw,
            _ => cloth(s, BRIGHT),
        };
    }
    let free = appearance.carried == Carried::Nothing && appearance.age >= 16.0;
    if free && s.chance(if appearance.female { 0.14 } else { 0.02 }) {
        appearance.carried = Carried::Umbrella;
        appearance.bag_color = cloth(s, JEWEL);
    }
}

/// Everybody has a coat, closed as often as not, and something on the head.
pub(super) fn against_cold(appearance: &mut Appearance, s: &mut Stream) {
    if appearance.legs.end > 0.5 && appearance.legs.end < 1.9 {
        appearance.legs = trousers(appearance, s);
    }
    if appearance.legs.end > 1.9 {
        appearance.legs.below = stockings(appearance, s, true);
    }
    if matches!(appearance.shoes.kind, ShoeKind::Sandals) {
        appearance.shoes = leather(s, ShoeKind::Boots);
    }
    let coated = appearance.garments.last().is_some_and(|g| g.sleeve > 0.99 && g.ease > 0.015);
    let own = matches!(appearance.outfit, "high_visibility" | "uniform" | "regional");
    if own && appearance.outfit != "regional" {
        // Long sleeves under the vest.
        if let Some(under) = appearance.garments.first_mut() {
            under.sleeve = under.sleeve.max(0.97);
        }
    }
    if !coated && !own {
        let coat = outer(appearance, s);
        appearance.garments.push(coat);
    }
    if let Some(coat) = appearance.garments.last_mut().filter(|g| g.gap.is_some() && g.name != "suit_jacket")
        && s.chance(0.7)
    {
        coat.gap = None;
        coat.upper = GarmentTop::Neck { dip: 0.1, wide: 0.008 };
    }
    if !matches!(appearance.hat, Hat::None | Hat::Cap | Hat::Brimmed) {
        return;
    }
    let hooded = appearance.garments.last().is_some_and(|g| g.collar == Collar::Hood && g.gap.is_none());
    let hood = if hooded && appearance.carried != Carried::Backpack { 40.0 } else { 0.0 };
    appearance.hat = choose(s, &[(Hat::None, 38.0), (Hat::Beanie, 52.0), (Hat::Hood, hood)]);
    appearance.hat_color = match (appearance.hat, appearance.garments.last()) {
        (Hat::Hood, Some(coat)) => coat.material,
        _ => cloth(s, BRIGHT),
    };
}
