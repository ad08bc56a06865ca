//! What people wear together.

use super::appearance::{Appearance, Carried, Hat};
use super::choice::choose;
use super::climate::{against_cold, against_heat};
use super::clothes::{Collar, FabricPattern, Garment, GarmentTop, Legs, ShoeKind, Shoes};
use super::garments::{cloth, leather, light_top, outer, shorts, stockings, trousers};
use super::palette::{self, BRIGHT, JEWEL, PALE, SOBER, TRAINERS, WEATHER, dyed};
use crate::color_key::color_key;
use endless_scene::Surface;
use endless_world::{Outfit, Stream, fnv1a};

fn trainers(s: &mut Stream) -> Shoes {
    Shoes::new(ShoeKind::Trainers, dyed(s, Surface::Leather, TRAINERS))
}

fn shoes(s: &mut Stream, kinds: &[(ShoeKind, f64)]) -> Shoes {
    match choose(s, kinds) {
        ShoeKind::Trainers => trainers(s),
        kind => leather(s, kind),
    }
}

/// Dresses somebody.
pub(crate) fn dress(appearance: &mut Appearance, s: &mut Stream, outfit: Outfit) {
    let rain = outfit == Outfit::Rain;
    appearance.bag_color = dyed(s, Surface::Leather, BRIGHT);
    appearance.hat_color = dyed(s, Surface::Cloth, BRIGHT);
    let grown = appearance.age >= 17.0;
    let work = if grown && appearance.age < 66.0 { 1.0 } else { 0.0 };
    // How warm people dress differs as much as people do.
    let warm = s.f32()
        < match outfit {
            Outfit::Fair => 0.34,
            Outfit::Rain => 0.85,
            Outfit::Hot => 0.04,
            Outfit::Cold => 0.98,
        };
    let outfits = [
        ("casual", 62.0),
        ("office", 14.0 * work),
        ("sports", 5.0),
        ("high_visibility", 3.5 * work),
        ("uniform", 1.2 * work),
        ("regional", 9.0),
    ];
    match choose(s, &outfits) {
        "casual" => casual(appearance, s, warm),
        "office" => office(appearance, s, warm),
        "sports" => sporty(appearance, s),
        "high_visibility" => worker(appearance, s),
        "uniform" => police(appearance, s),
        _ => regional(appearance, s, warm),
    }
    carry(appearance, s, rain);
    if rain && !matches!(appearance.carried, Carried::Umbrella) {
        against_rain(appearance, s);
    }
    match outfit {
        Outfit::Hot => against_heat(appearance, s),
        Outfit::Cold => against_cold(appearance, s),
        Outfit::Fair | Outfit::Rain => {}
    }
}

fn warm_top(s: &mut Stream) -> Garment {
    let material = cloth(s, BRIGHT);
    match choose(s, &[("sweater", 1.0), ("hoodie", 1.0), ("long_sleeve", 1.0)]) {
        "sweater" => Garment::new("sweater", 0.500, 0.98, 0.013, material).neck(0.10, 0.004),
        "hoodie" => Garment::new("hoodie", 0.495, 0.98, 0.016, material).neck(0.15, 0.006).collar(Collar::Hood),
        _ => Garment::new("long_sleeve", 0.500, 0.97, 0.009, material).neck(0.14, 0.006),
    }
}

fn casual(appearance: &mut Appearance, s: &mut Stream, warm: bool) {
    let dressed = appearance.female && s.chance(0.24);
    if dressed {
        let material = cloth(s, BRIGHT);
        let long = s.chance(0.3);
        let hem = if long { s.range_f32(0.10, 0.2) } else { s.range_f32(0.28, 0.36) };
        let sleeve = *s.pick(&[0.0, 0.22, 0.34, 0.95]);
        let mut dress = Garment::new("dress", hem, sleeve, 0.006, material)
            .neck(s.range_f32(0.3, 0.7), 0.016)
            .flare(s.range_f32(0.02, 0.06));
        if s.chance(0.4) {
            let patterns = [(FabricPattern::Checks, 1.0), (FabricPattern::Border, 1.0), (FabricPattern::Stripes, 1.0)];
            dress = dress.pattern(choose(s, &patterns), cloth(s, BRIGHT));
        }
        appearance.garments.push(dress);
        appearance.legs.below = stockings(appearance, s, warm);
        const SHOES: [(ShoeKind, f64); 4] =
            [(ShoeKind::Trainers, 1.0), (ShoeKind::Boots, 1.0), (ShoeKind::Heels, 1.0), (ShoeKind::Sandals, 1.0)];
        appearance.shoes = shoes(s, &SHOES);
    } else {
        let top = if warm && s.chance(0.6) { warm_top(s) } else { light_top(appearance, s) };
        appearance.garments.push(top);
        if appearance.female && s.chance(0.2) {
            let (hem, flare, name) = if s.chance(0.4) {
                (s.range_f32(0.08, 0.2), 0.05, "long_skirt")
            } else {
                (s.range_f32(0.29, 0.38), s.range_f32(0.008, 0.05), "skirt")
            };
            appearance.garments.insert(0, Garment::skirt(name, hem, flare, cloth(s, BRIGHT)));
            if let Some(top) = appearance.garments.last_mut() {
                top.hem = top.hem.max(0.535);
            }
            appearance.legs.below = stockings(appearance, s, warm);
        } else if !warm && s.chance(0.28) {
            appearance.legs = shorts(appearance, s);
        } else {
            appearance.legs = trousers(appearance, s);
        }
        let sandals = if warm { 0.0 } else { 8.0 };
        let kinds = [
            (ShoeKind::Trainers, 60.0),
            (ShoeKind::Leather, 22.0),
            (ShoeKind::Boots, 10.0),
            (ShoeKind::Sandals, sandals),
        ];
        appearance.shoes = shoes(s, &kinds);
    }
    if warm && s.chance(0.75) {
        appearance.garments.push(outer(appearance, s));
    }
    let hats = [
        (Hat::None, 74.0),
        (Hat::Cap, if appearance.female { 4.0 } else { 12.0 }),
        (Hat::Beanie, if warm { 14.0 } else { 0.0 }),
        (Hat::Brimmed, if warm { 0.0 } else { 5.0 }),
        (Hat::Fedora, if appearance.age > 25.0 { 2.0 } else { 0.0 }),
    ];
    appearance.hat = choose(s, &hats);
}

fn office(appearance: &mut Appearance, s: &mut Stream, warm: bool) {
    appearance.outfit = "office";
    let suit = cloth(s, SOBER);
    let shirt = cloth(s, PALE);
    let shirt = Garment::new("shirt", 0.560, 0.97, 0.007, shirt).neck(0.28, 0.006).collar(Collar::Shirt);
    if appearance.female && s.chance(0.4) {
        appearance.garments.push(Garment::skirt("skirt", s.range_f32(0.28, 0.33), 0.004, suit));
        appearance.legs.below = stockings(appearance, s, true);
        appearance.shoes = leather(s, ShoeKind::Heels);
    } else {
        appearance.legs = Legs::new("suit_trousers", 0.0, 0.006, 0.010, suit, appearance.skin);
        appearance.shoes = leather(s, ShoeKind::Leather);
    }
    appearance.garments.push(shirt);
    if s.chance(0.66) {
        let tie = !appearance.female && s.chance(0.6);
        let tie_color = cloth(s, JEWEL);
        appearance.garments.push(
            Garment { accent: tie_color, ..Garment::new("suit_jacket", 0.445, 0.98, 0.016, suit) }
                .neck(0.55, 0.010)
                .open(0.012, 0.024)
                .collar(Collar::Lapels { tie }),
        );
        appearance.outfit = "suit";
    }
    if warm && s.chance(0.6) {
        appearance.garments.push(
            Garment::new("coat", 0.31, 1.0, 0.026, cloth(s, SOBER))
                .flare(0.014)
                .neck(0.40, 0.012)
                .open(0.03, 0.03)
                .collar(Collar::Lapels { tie: false }),
        );
    }
}

fn sporty(appearance: &mut Appearance, s: &mut Stream) {
    appearance.outfit = "sports";
    let (a, b) = (cloth(s, BRIGHT), cloth(s, BRIGHT));
    if s.chance(0.5) {
        appearance.garments.push(
            Garment::new("track_jacket", 0.495, 0.99, 0.013, a)
                .pattern(FabricPattern::Block, b)
                .neck(0.1, 0.006)
                .collar(Collar::Stand),
        );
        appearance.legs =
            Legs { stripe: true, accent: b, ..Legs::new("track_trousers", 0.0, 0.007, 0.008, a, appearance.skin) };
    } else {
        let sleeve = *s.pick(&[0.0, 0.3]);
        appearance.garments.push(
            Garment::new("sports_shirt", 0.505, sleeve, 0.007, a).neck(0.25, 0.010).pattern(FabricPattern::Block, b),
        );
        appearance.legs =
            Legs { stripe: true, accent: a, ..Legs::new("running_shorts", 1.35, 0.008, 0.012, b, appearance.skin) };
    }
    appearance.shoes = trainers(s);
    appearance.hat = if s.chance(0.3) { Hat::Cap } else { Hat::None };
}

/// Of site helmets.
const SHELLS: [[f32; 3]; 4] = [[0.75, 0.75, 0.73], [0.80, 0.50, 0.02], [0.75, 0.12, 0.02], [0.05, 0.16, 0.45]];
const UNIFORMS: [[u8; 3]; 4] = [[28, 34, 54], [34, 38, 44], [96, 120, 150], [84, 80, 56]];
const VISIBLE: [[f32; 3]; 2] = [[0.62, 0.70, 0.03], [0.80, 0.16, 0.015]];

fn worker(appearance: &mut Appearance, s: &mut Stream) {
    appearance.outfit = "high_visibility";
    let bright = palette::linear(Surface::Cloth, *s.pick_by_key(&VISIBLE, color_key));
    let silver = palette::linear(Surface::Plate, [0.62, 0.63, 0.64]);
    let dark = cloth(s, SOBER);
    if s.chance(0.45) {
        let jacket =
            Garment::new("high_visibility_jacket", 0.48, 1.0, 0.020, bright).neck(0.1, 0.008).collar(Collar::Stand);
        appearance.garments.push(jacket.pattern(FabricPattern::HighVisibility, silver));
        appearance.legs = Legs {
            accent: silver,
            stripe: false,
            ..Legs::new("work_trousers", 0.0, 0.009, 0.014, bright, appearance.skin)
        };
    } else {
        let under = if s.chance(0.5) { light_top(appearance, s) } else { warm_top(s) };
        appearance.garments.push(Garment { hem: 0.52, collar: Collar::None, ..under });
        let vest = Garment::new("high_visibility_vest", 0.50, 0.0, 0.021, bright).neck(0.55, 0.016).open(0.004, 0.010);
        appearance.garments.push(vest.pattern(FabricPattern::HighVisibility, silver));
        appearance.legs = Legs::new("work_trousers", 0.0, 0.008, 0.013, dark, appearance.skin);
    }
    appearance.shoes = leather(s, ShoeKind::Boots);
    appearance.hat = if s.chance(0.6) { Hat::SiteHelmet } else { Hat::Cap };
    let shell = *s.pick_by_key(&SHELLS, color_key);
    appearance.hat_color = palette::linear(Surface::Plastic, shell);
}

fn police(appearance: &mut Appearance, s: &mut Stream) {
    appearance.outfit = "uniform";
    let navy = palette::material(Surface::Cloth, *s.pick_by_key(&UNIFORMS, |color| fnv1a(*color)), 1.0);
    let dark = palette::material(Surface::Cloth, [26, 29, 42], 1.0);
    let sleeve = *s.pick(&[0.42, 0.97]);
    appearance
        .garments
        .push(Garment::new("uniform_shirt", 0.575, sleeve, 0.008, navy).neck(0.2, 0.006).collar(Collar::Shirt));
    let vest = Garment { folds: 0.3, ..Garment::new("protective_vest", 0.585, 0.0, 0.022, dark) };
    appearance.garments.push(vest.neck(0.35, 0.014));
    appearance.legs = Legs::new("uniform_trousers", 0.0, 0.007, 0.010, dark, appearance.skin);
    appearance.shoes = leather(s, ShoeKind::Boots);
    appearance.shoes.material = palette::material(Surface::Leather, [22, 22, 22], 1.0);
    appearance.hat = Hat::PeakedCap;
    appearance.hat_color = dark;
}

fn regional(appearance: &mut Appearance, s: &mut Stream, warm: bool) {
    appearance.outfit = "regional";
    let jewel = cloth(s, JEWEL);
    let gold = palette::material(Surface::Cloth, [214, 172, 84], 1.0);
    let black = palette::material(Surface::Cloth, [22, 22, 25], 1.0);
    let white = palette::material(Surface::Cloth, [236, 234, 228], 1.0);
    let women = appearance.female && !appearance.child();
    let costumes: &[(&str, f64)] = match women {
        true => &[("sari", 1.0), ("abaya", 1.0), ("kameez", 1.0), ("tunic", 1.0)],
        false if appearance.age > 12.0 => &[("thobe", 1.0), ("kurta", 1.0)],
        false => &[("kurta", 1.0)],
    };
    match choose(s, costumes) {
        "sari" => {
            appearance.garments.push(Garment::new("choli", 0.592, 0.26, 0.003, cloth(s, JEWEL)).neck(0.4, 0.014));
            appearance.garments.push(Garment::skirt("sari", 0.062, 0.035, jewel).pattern(FabricPattern::Border, gold));
        }
        "abaya" => {
            let robe = if s.chance(0.6) { black } else { jewel };
            appearance.garments.push(Garment::new("abaya", 0.060, 1.0, 0.018, robe).neck(0.05, 0.002).flare(0.055));
            appearance.hat = Hat::Headscarf;
            appearance.hat_color = if s.chance(0.6) { robe } else { cloth(s, BRIGHT) };
        }
        "kameez" => {
            appearance.garments.push(
                Garment::new("kameez", 0.30, 0.7, 0.009, jewel)
                    .neck(0.3, 0.010)
                    .flare(0.03)
                    .pattern(FabricPattern::Border, gold),
            );
            appearance.legs = Legs::new("salwar", 0.03, 0.014, 0.0, cloth(s, JEWEL), appearance.skin);
            appearance.hat = if s.chance(0.4) { Hat::Headscarf } else { Hat::None };
            appearance.hat_color = jewel;
        }
        "tunic" => {
            // A headscarf over everyday clothes.
            appearance
                .garments
                .push(Garment::new("tunic", 0.36, 0.98, 0.012, cloth(s, BRIGHT)).neck(0.08, 0.004).flare(0.02));
            appearance.legs = trousers(appearance, s);
            appearance.hat = Hat::Headscarf;
            appearance.hat_color = cloth(s, BRIGHT);
        }
        "thobe" => {
            let robe = if s.chance(0.7) { white } else { cloth(s, PALE) };
            appearance.garments.push(
                Garment::new("thobe", 0.075, 0.99, 0.014, robe).neck(0.08, 0.004).flare(0.03).collar(Collar::Stand),
            );
            appearance.hat = choose(s, &[(Hat::None, 1.0), (Hat::Headscarf, 1.0), (Hat::Turban, 1.0)]);
            appearance.hat_color = white;
        }
        _ => {
            let kurta = cloth(s, PALE);
            appearance.garments.push(
                Garment::new("kurta", 0.34, 0.97, 0.011, kurta).neck(0.3, 0.006).flare(0.016).collar(Collar::Stand),
            );
            appearance.legs = Legs::new("pyjama_trousers", 0.03, 0.009, 0.004, white, appearance.skin);
            appearance.hat = if s.chance(0.35) { Hat::Turban } else { Hat::None };
            appearance.hat_color = jewel;
        }
    }
    appearance.shoes = if warm { leather(s, ShoeKind::Leather) } else { leather(s, ShoeKind::Sandals) };
}

fn carry(appearance: &mut Appearance, s: &mut Stream, rain: bool) {
    let (age, female) = (appearance.age, appearance.female);
    let grown = age >= 16.0;
    let parent = if (22.0..45.0).contains(&age) { if female { 5.0 } else { 2.0 } } else { 0.0 };
    let old = if age > 66.0 { 1.0 } else { 0.0 };
    let g = if grown { 1.0 } else { 0.0 };
    let office = if matches!(appearance.outfit, "office" | "suit") { 14.0 } else { 0.5 };
    let carried = [
        (Carried::Nothing, 40.0),
        (Carried::Backpack, if age < 18.0 { 30.0 } else { 13.0 }),
        (Carried::Handbag, if female { 12.0 * g } else { 0.0 }),
        (Carried::ShoulderBag, if female { 10.0 * g } else { 4.0 * g }),
        (Carried::ShoppingBag, 9.0 * g),
        (Carried::Briefcase, office * g),
        (Carried::Phone, 8.0 * g),
        (Carried::Call, 3.0 * g),
        (Carried::Umbrella, if rain { 60.0 * g } else { 0.6 * g }),
        (Carried::Pram, parent),
        (Carried::Suitcase, 3.0 * g),
        (Carried::Cane, 14.0 * old),
        (Carried::Dog, 3.0 * g),
        (Carried::Wheelchair, 0.8 + 2.5 * old),
    ];
    appearance.carried = choose(s, &carried);
    if matches!(appearance.carried, Carried::Umbrella) {
        let palette = if s.chance(0.5) { SOBER } else { JEWEL };
        appearance.bag_color = cloth(s, palette);
    }
    if matches!(appearance.outfit, "high_visibility" | "uniform") {
        appearance.carried = Carried::Nothing;
    }
}

/// Coats are closed and hoods go up.
fn against_rain(appearance: &mut Appearance, s: &mut Stream) {
    for garment in &mut appearance.garments {
        if garment.gap.is_some() && garment.name != "suit_jacket" {
            garment.gap = None;
            garment.upper = GarmentTop::Neck { dip: 0.1, wide: 0.008 };
        }
    }
    let covered = appearance.garments.last().is_some_and(|g| g.sleeve > 0.99 && g.ease > 0.018);
    if !covered && appearance.hat != Hat::Headscarf && appearance.carried != Carried::Backpack {
        let material = dyed(s, Surface::Plastic, WEATHER);
        appearance.garments.push(
            Garment::new("rain_jacket", 0.44, 1.0, 0.026, material).neck(0.1, 0.008).flare(0.01).collar(Collar::Hood),
        );
    }
    if let Some(garment) = appearance.garments.last().filter(|g| g.collar == Collar::Hood) {
        appearance.hat = Hat::Hood;
        appearance.hat_color = garment.material;
    }
}
