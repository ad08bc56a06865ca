//! Objects in the colours that their video gives them.

use endless_annotate::ActorRecord;
use endless_world::{ColorVariation, ColoredPiece, ColoredThing, PersonAttributes, Reid, SceneSettings};

/// These objects with the colours that a video draws, if it randomises colours.
pub(super) fn repainted(records: Vec<ActorRecord>, settings: &SceneSettings) -> Vec<ActorRecord> {
    let randomised = settings.randomised.as_ref();
    let Some((seed, colors)) = randomised.and_then(|r| Some((r.seed, r.colors()?))) else { return records };
    records.into_iter().map(|record| repaint(record, seed, &colors)).collect()
}

/// The record with the colours that are drawn. Skin and hair keep theirs, a dog's coat too. Whoever looks otherwise is
/// another for re-identification, however alike they walk.
fn repaint(mut record: ActorRecord, seed: u64, colors: &ColorVariation) -> ActorRecord {
    let owner = u64::from(record.id.0);
    if let Some(color) = record.vehicle.as_mut().and_then(|vehicle| vehicle.color.as_mut()) {
        *color = colors.named(owner, ColoredThing::Paint, *color);
    }
    if let Some(person) = &mut record.person {
        pieces(person).for_each(|piece| {
            piece.color = colors.named(owner, ColoredThing::Fabric, piece.color);
            piece.second_color = piece.second_color.map(|color| colors.named(owner, ColoredThing::Fabric, color));
        });
    }
    record.reid = record.reid.map(|look| Reid::new("repainted", &[look.key(), seed, owner]));
    record
}

/// What a person wears and carries that is dyed.
fn pieces(person: &mut PersonAttributes) -> impl Iterator<Item = &mut ColoredPiece> {
    let carries = person.carries.iter_mut().filter(|piece| piece.piece != "dog");
    let worn = person.garments.iter_mut().chain(&mut person.legs).chain(&mut person.hat);
    worn.chain([&mut person.shoes]).chain(carries)
}
