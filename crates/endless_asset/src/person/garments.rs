//! Garments that people put on in more than one sort of weather.

use super::appearance::Appearance;
use super::choice::choose;
use super::clothes::{Collar, FabricPattern, Garment, Legs, ShoeKind, Shoes};
use super::palette::{self, BRIGHT, CHINO, DENIM, JEWEL, LEATHERS, SOBER, WEATHER, dyed};
use endless_scene::{Material, Surface};
use endless_world::Stream;

pub(super) fn leather(s: &mut Stream, kind: ShoeKind) -> Shoes {
    Shoes::new(kind, dyed(s, Surface::Leather, LEATHERS))
}

pub(super) fn cloth(s: &mut Stream, palette: &[[u8; 3]]) -> Material {
    dyed(s, Surface::Cloth, palette)
}

pub(super) fn light_top(appearance: &Appearance, s: &mut Stream) -> Garment {
    let material = cloth(s, BRIGHT);
    let accent = cloth(s, BRIGHT);
    let long = s.chance(0.3);
    let [t_shirt, polo, shirt, blouse, tank] =
        if appearance.female { [34.0, 8.0, 14.0, 22.0, 14.0] } else { [46.0, 16.0, 24.0, 0.0, 4.0] };
    let tops = [("t_shirt", t_shirt), ("polo_shirt", polo), ("shirt", shirt), ("blouse", blouse), ("tank_top", tank)];
    let garment = match choose(s, &tops) {
        "t_shirt" => Garment::new("t_shirt", 0.505, 0.34, 0.010, material).neck(0.16, 0.008),
        "polo_shirt" => {
            Garment::new("polo_shirt", 0.505, 0.34, 0.010, material).neck(0.30, 0.006).collar(Collar::Shirt)
        }
        "shirt" => Garment::new("shirt", 0.495, if long { 0.97 } else { 0.42 }, 0.012, material)
            .neck(0.32, 0.006)
            .collar(Collar::Shirt),
        "blouse" => Garment::new("blouse", 0.510, if long { 0.92 } else { 0.36 }, 0.010, material)
            .neck(0.50, 0.012)
            .flare(0.016),
        _ => Garment::new("tank_top", 0.530, 0.0, 0.005, material).neck(0.55, 0.022),
    };
    let patterns = [
        (FabricPattern::Plain, 64.0),
        (FabricPattern::Stripes, 12.0),
        (FabricPattern::Block, 10.0),
        (FabricPattern::Checks, 9.0),
    ];
    match choose(s, &patterns) {
        FabricPattern::Plain => garment,
        pattern => garment.pattern(pattern, accent),
    }
}

pub(super) fn outer(appearance: &Appearance, s: &mut Stream) -> Garment {
    let material = cloth(s, WEATHER);
    let open = s.chance(0.45);
    let scarf = s.chance(0.2);
    let coats = [("jacket", 34.0), ("puffer_jacket", 18.0), ("coat", 20.0), ("parka", 14.0), ("denim_jacket", 14.0)];
    let garment = match choose(s, &coats) {
        "jacket" => Garment::new("jacket", 0.485, 1.0, 0.019, material).collar(Collar::Stand),
        "puffer_jacket" => {
            Garment { folds: 2.2, ..Garment::new("puffer_jacket", 0.480, 1.0, 0.030, material).collar(Collar::Hood) }
        }
        "coat" => Garment::new("coat", if appearance.female { 0.30 } else { 0.33 }, 1.0, 0.021, material)
            .flare(0.018)
            .collar(Collar::Lapels { tie: false }),
        "parka" => Garment::new("parka", 0.40, 1.0, 0.024, material).flare(0.008).collar(Collar::Hood),
        _ => Garment::new("denim_jacket", 0.53, 0.99, 0.014, cloth(s, DENIM)).collar(Collar::Shirt),
    };
    let garment = if open { garment.neck(0.45, 0.012).open(0.024, 0.018) } else { garment.neck(0.10, 0.008) };
    if scarf && !open { garment.collar(Collar::Scarf).pattern(FabricPattern::Plain, cloth(s, JEWEL)) } else { garment }
}

pub(super) fn trousers(appearance: &Appearance, s: &mut Stream) -> Legs {
    let skin = appearance.skin;
    let [jeans, trousers, leggings, wide] =
        if appearance.female { [40.0, 26.0, 18.0, 16.0] } else { [52.0, 40.0, 0.0, 8.0] };
    match choose(s, &[("jeans", jeans), ("trousers", trousers), ("leggings", leggings), ("wide_trousers", wide)]) {
        "jeans" => {
            let tight = appearance.female || s.chance(0.35);
            let (ease, cuff) = if tight { (0.0035, 0.003) } else { (0.006, 0.011) };
            Legs::new("jeans", 0.02, ease, cuff, cloth(s, DENIM), skin)
        }
        "trousers" => Legs::new("trousers", 0.0, 0.006, 0.012, cloth(s, CHINO), skin),
        "leggings" => Legs::new("leggings", 0.06, 0.0015, 0.0, cloth(s, SOBER), skin),
        _ => Legs::new("wide_trousers", 0.0, 0.009, 0.028, cloth(s, CHINO), skin),
    }
}

pub(super) fn shorts(appearance: &Appearance, s: &mut Stream) -> Legs {
    let end = if appearance.female { s.range_f32(1.1, 1.6) } else { s.range_f32(0.98, 1.2) };
    Legs::new("shorts", end, 0.007, 0.012, cloth(s, CHINO), appearance.skin)
}

pub(super) fn stockings(appearance: &Appearance, s: &mut Stream, warm: bool) -> Material {
    if warm || s.chance(0.2) { palette::linear(Surface::Cloth, [0.018, 0.018, 0.02]) } else { appearance.skin }
}
