//! Which models play the tracks.

use endless_world::{LookPool, ObjectClass, PersonRef, Stream, Track, VehicleRef, VehicleSpec, choose_vehicle};

/// Lengths that differ by less are alike, metres.
const ALIKE_M: f64 = 0.3;

/// The vehicle that plays a track, which another does not play already, if possible; `None` if the fleet has none of its
/// class.
///
/// Models are preferred whose names share most words with the track's kind (`taxi` with `car.taxi`), then those of its
/// length, then such as draw nothing.
pub(super) fn vehicle(
    track: &Track,
    specs: &[VehicleSpec],
    seed: u64,
    taken: impl Fn(VehicleRef) -> bool,
) -> Option<VehicleRef> {
    let mut own = Stream::named(seed, &track.name, &[0]);
    let words = words(&track.kind);
    let alike = |spec: &VehicleSpec| {
        spec.name.split(['.', '_']).skip(1).filter(|word| words.iter().any(|other| other == word)).count()
    };
    let of_class = || specs.iter().filter(|spec| spec.class == track.class && spec.frequency > 0.0);
    let most = of_class().map(alike).max()?;
    let named = || of_class().filter(|spec| alike(spec) == most);
    let off = |spec: &VehicleSpec| track.length_m.map_or(0.0, |length| (f64::from(spec.length_m) - length).abs());
    let least = named().map(off).fold(f64::INFINITY, f64::min);
    let draws = |spec: &VehicleSpec| spec.trailer.is_some() && track.length_m.is_none();
    let alone = named().any(|spec| !draws(spec));
    let frequency = |spec: &VehicleSpec| {
        let fits = spec.class == track.class && alike(spec) == most && off(spec) <= least + ALIKE_M;
        if fits && !(alone && draws(spec)) { spec.frequency } else { 0.0 }
    };
    let model = choose_vehicle(&mut own, specs.iter().map(|spec| (spec, frequency(spec))))?;
    let pool = LookPool::vehicles(&specs[model.index()]);
    let variant = pool.draw(own.next_u64(), |variant| taken(VehicleRef { model, variant }));
    Some(VehicleRef { model, variant })
}

/// The seed of the person who plays a track.
pub(super) fn person(track: &Track, seed: u64, taken: impl Fn(u64) -> bool) -> u64 {
    let mut own = Stream::named(seed, &track.name, &[1]);
    LookPool::people().draw(own.next_u64(), taken)
}

/// Who walks, rides or drives.
pub(super) fn on_foot(track: &Track) -> bool {
    matches!(track.class, ObjectClass::Pedestrian | ObjectClass::Rider)
}

/// The same person in the weather's clothes.
pub(super) fn dressed(seed: u64, outfit: endless_world::Outfit) -> PersonRef {
    PersonRef { outfit, seed }
}

/// The words of a name, in lower case and without figures at their ends.
fn words(name: &str) -> Vec<String> {
    let parts = name.split(|c: char| !c.is_alphanumeric());
    parts.map(|word| word.trim_end_matches(|c: char| c.is_ascii_digit()).to_lowercase()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;
    use endless_world::TrackPoint;

    fn track(kind: &str, class: ObjectClass, length_m: Option<f64>) -> Track {
        Track { name: "a".into(), kind: kind.into(), class, length_m, point: TrackPoint::Centre, pieces: Vec::new() }
    }

    #[test]
    fn models_are_chosen_by_name_and_by_length() {
        let specs = Catalogue::builtin().vehicle_specs();
        let chosen = |track: &Track, seed| {
            let vehicle = vehicle(track, &specs, seed, |_| false).expect("of every class there is one");
            specs[vehicle.model.index()].clone()
        };
        for seed in 0..40 {
            assert!(chosen(&track("taxi", ObjectClass::Car, None), seed).name.starts_with("car.taxi"));
            assert_eq!(chosen(&track("truck_semi", ObjectClass::Truck, None), seed).name, "truck.semi");
            assert!(chosen(&track("passenger", ObjectClass::Car, None), seed).trailer.is_none());
            let long = chosen(&track("bus", ObjectClass::Bus, Some(18.0)), seed).length_m;
            assert!((16.0..20.0).contains(&long), "{long} m");
            let of = |length_m| f64::from(chosen(&track("car", ObjectClass::Car, Some(length_m)), seed).length_m);
            assert!((of(4.4) - 4.4).abs() < 0.35 && of(3.0) < of(5.2));
        }
    }
}
