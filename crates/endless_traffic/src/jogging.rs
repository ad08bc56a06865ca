//! Who jogs: by day and while it does not rain, those who are dressed for it and have nothing in their hands.

use crate::settings::DrivingCondition;
use endless_world::Stream;
use endless_world::walking::PedestrianSpec;

/// Speeds, m/s: from 9 to 12 km/h, jogging in the Compendium of Physical Activities (Ainsworth et al. 2011).
const JOGS_MPS: [f64; 2] = [2.5, 3.3];

/// The pace of somebody who jogs, m/s; `None` for all others.
pub(crate) fn pace_mps(spec: &PedestrianSpec, condition: &DrivingCondition, own: &Stream) -> Option<f64> {
    const OWN: u64 = 0x6a_6f_67;
    let jogs = spec.dressed_to_run && condition.is_day_without_rain();
    jogs.then(|| own.fork(OWN).range_f64(JOGS_MPS[0], JOGS_MPS[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;

    #[test]
    fn few_people_jog_and_nobody_does_at_night_or_in_rain() {
        let (day, own) = (DrivingCondition::default(), Stream::named(1, "test.jogging", &[]));
        let night = DrivingCondition { headlights_on: 1.0, ..day };
        let rain = DrivingCondition { rain: 0.5, ..day };
        let people: Vec<PedestrianSpec> = (0..2000).map(Catalogue::pedestrian_spec).collect();
        let who = |condition: &DrivingCondition| {
            let paces = people.iter().zip(0..).filter_map(|(spec, seed)| pace_mps(spec, condition, &own.fork(seed)));
            paces.collect::<Vec<f64>>()
        };
        let joggers = who(&day);
        assert!((15..80).contains(&joggers.len()), "{} of 2000", joggers.len());
        assert!(joggers.iter().all(|pace| (2.5..3.3).contains(pace)));
        assert!(who(&night).is_empty() && who(&rain).is_empty());
        assert!(people.iter().all(|spec| spec.can_run() || !spec.dressed_to_run));
    }
}
