//! A person in words and colours, as they are drawn.

use super::appearance::{Appearance, Hair, Hat};
use super::carried;
use super::clothes::{Collar, Garment};
use super::figure::visible_garments;
use endless_scene::{Material, Surface};
use endless_world::{AgeGroup, ColoredPiece, ColoredThing, Hairdo, NamedColor, PersonAttributes, Reid, Sex, Word};

/// Describes an appearance; `identity` is that of the person, whatever they wear.
pub(crate) fn describe(appearance: &Appearance, identity: Reid) -> PersonAttributes {
    let years = appearance.age as u32;
    // The visor of a full helmet hides the face.
    let face = appearance.hat != Hat::FullHelmet;
    PersonAttributes {
        identity,
        age_years: years,
        age_group: AgeGroup::of(years),
        sex: if appearance.female { Sex::Female } else { Sex::Male },
        height_m: (f64::from(appearance.height) * 1e3).round() / 1e3,
        skin_tone: appearance.tone as u8 + 1,
        outfit: appearance.outfit.into(),
        hair: hair(appearance),
        beard: appearance.beard.word().filter(|_| face).map(Word::from),
        glasses: appearance.glasses.word().filter(|_| face).map(Word::from),
        hat: appearance.hat.word().map(|word| piece(word, &appearance.hat_color)),
        garments: visible_garments(&appearance.garments).iter().flat_map(garment).collect(),
        legs: legs(appearance),
        shoes: piece(appearance.shoes.kind.word(), &appearance.shoes.material),
        carries: carries(appearance).into_iter().collect(),
    }
}

fn color(material: &Material) -> NamedColor {
    let thing = if material.surface == Surface::Hair { ColoredThing::Hair } else { ColoredThing::Fabric };
    NamedColor::of(thing, material.base_color)
}

fn piece(word: &'static str, material: &Material) -> ColoredPiece {
    ColoredPiece::plain(word, color(material))
}

fn patterned(piece: ColoredPiece, pattern: Option<&'static str>, second: &Material) -> ColoredPiece {
    let second_color = pattern.is_some().then(|| color(second));
    ColoredPiece { pattern: pattern.map(Word::from), second_color, ..piece }
}

/// A garment, and the scarf or tie over it.
fn garment(garment: &Garment) -> Vec<ColoredPiece> {
    let mut pieces = vec![patterned(piece(garment.name, &garment.material), garment.pattern.word(), &garment.accent)];
    pieces.extend(match garment.collar {
        Collar::Scarf => Some(piece("scarf", &garment.accent)),
        Collar::Lapels { tie: true } => Some(piece("tie", &garment.accent)),
        _ => None,
    });
    pieces
}

fn hair(appearance: &Appearance) -> Option<Hairdo> {
    let covered = matches!(appearance.hat, Hat::Headscarf | Hat::FullHelmet | Hat::OpenHelmet | Hat::Turban);
    let color = (appearance.hair != Hair::Bald).then(|| color(&appearance.hair_color));
    (!covered).then(|| Hairdo { style: appearance.hair.word().into(), color })
}

fn legs(appearance: &Appearance) -> Option<ColoredPiece> {
    let legs = &appearance.legs;
    if legs.end > 1.9 {
        let stockings = legs.below.surface != Surface::Skin;
        return stockings.then(|| piece("stockings", &legs.below));
    }
    Some(patterned(piece(legs.name, &legs.material), legs.stripe.then_some("side_stripe"), &legs.accent))
}

fn carries(appearance: &Appearance) -> Option<ColoredPiece> {
    Some(piece(appearance.carried.word()?, &carried::material(appearance)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::person::PersonModel;
    use crate::person::appearance::Carried;
    use endless_world::BodyPart;
    use endless_world::{ColorName, Outfit, PersonRef, srgb_from_linear};
    use rayon::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// sRGB colours of what is drawn, with the parts of the body that have them.
    fn drawn(person: &PersonModel) -> BTreeMap<[u8; 3], BTreeSet<BodyPart>> {
        let mesh = &person.rest;
        let mut worn: Vec<(u16, BodyPart)> =
            mesh.triangle_materials.iter().copied().zip(person.parts.iter().copied()).collect();
        worn.dedup();
        let mut colors: BTreeMap<[u8; 3], BTreeSet<BodyPart>> = BTreeMap::new();
        for (material, part) in worn {
            let rgb = srgb_from_linear(mesh.materials[usize::from(material)].base_color);
            colors.entry(rgb).or_default().insert(part);
        }
        colors
    }

    fn everybody() -> impl ParallelIterator<Item = PersonRef> {
        let outfits = [Outfit::Fair, Outfit::Rain, Outfit::Hot, Outfit::Cold];
        (0..400u64).into_par_iter().flat_map_iter(move |seed| outfits.map(|outfit| PersonRef { outfit, seed }))
    }

    #[test]
    fn what_is_described_is_drawn_in_its_color_and_nothing_else_is_carried() {
        // What hangs on the trunk or is held in a hand belongs to them in the mesh.
        let apart = |word: &str| !matches!(word, "backpack" | "shoulder_bag" | "phone");
        everybody().for_each(|who| {
            let person = PersonModel::new(who);
            let (colors, said) = (drawn(&person), crate::person::attributes(who));
            let pieces =
                said.garments.iter().chain(&said.legs).chain(&said.hat).chain([&said.shoes]).chain(&said.carries);
            for piece in pieces {
                assert!(colors.contains_key(&piece.color.rgb), "{who:?} has no {piece:?}");
                if let Some(second) = piece.second_color {
                    assert!(colors.contains_key(&second.rgb), "{who:?} has no second color of {piece:?}");
                }
            }
            if let Some(Hairdo { color: Some(color), .. }) = said.hair {
                assert!(colors.get(&color.rgb).is_some_and(|parts| parts.contains(&BodyPart::Head)), "{who:?}: hair");
            }
            let thing = said.carries.iter().find(|piece| apart(&piece.piece));
            assert_eq!(person.parts.contains(&BodyPart::Carried), thing.is_some(), "{who:?}: {thing:?}");
            if let Some(thing) = thing {
                let parts = &colors[&thing.color.rgb];
                assert!(parts.contains(&BodyPart::Carried), "{who:?}: {thing:?} has another color");
            }
        });
    }

    #[test]
    fn words_and_colors_vary() {
        let people: Vec<PersonAttributes> = (0..600)
            .map(|seed| {
                describe(
                    &Appearance::of(seed, [Outfit::Rain, Outfit::Fair][seed as usize % 2]),
                    Reid::new("person", &[seed]),
                )
            })
            .collect();
        let words = |of: &dyn Fn(&PersonAttributes) -> Option<Word>| {
            people.iter().filter_map(of).collect::<BTreeSet<Word>>().len()
        };
        assert!(words(&|p| Some(p.hair.as_ref()?.style.clone())) >= 9);
        assert!(words(&|p| Some(p.hat.as_ref()?.piece.clone())) >= 9);
        assert!(words(&|p| Some(p.carries.first()?.piece.clone())) >= 11);
        assert!(words(&|p| Some(p.garments.last()?.piece.clone())) >= 20);
        let tops: BTreeSet<ColorName> = people.iter().filter_map(|p| Some(p.garments.last()?.color.name)).collect();
        assert!(tops.len() >= 11, "{tops:?}");
        let women = people.iter().filter(|p| p.sex == Sex::Female).count();
        assert!((240..360).contains(&women), "{women} of 600");
        for group in [AgeGroup::Child, AgeGroup::Teenager, AgeGroup::Adult, AgeGroup::Senior] {
            assert!(people.iter().filter(|p| p.age_group == group).count() > 15, "{group:?}");
        }
        assert!(people.iter().all(|p| (1..=10).contains(&p.skin_tone) && (0.8..2.0).contains(&p.height_m)));
    }

    #[test]
    fn clothes_for_rain_leave_the_person() {
        for seed in 0..200 {
            let [fair, rain] = [Outfit::Fair, Outfit::Rain]
                .map(|outfit| describe(&Appearance::of(seed, outfit), Reid::new("person", &[seed])));
            let body = |p: &PersonAttributes| (p.age_years, p.sex, p.height_m, p.skin_tone, p.beard.clone());
            assert_eq!(body(&fair), body(&rain), "{seed}");
        }
    }

    #[test]
    fn umbrellas_are_for_rain() {
        let carried =
            |outfit| (0..300).filter(|&seed| Appearance::of(seed, outfit).carried == Carried::Umbrella).count();
        let [fair, rain] = [Outfit::Fair, Outfit::Rain].map(carried);
        assert!(rain > 8 * fair.max(1), "{rain} and {fair}");
    }
}
