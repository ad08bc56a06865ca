//! How weather slows drivers down and spaces them out.

use crate::settings::DrivingCondition;
use endless_world::math::smoothstep;

/// Shares of the usual speed on free roads by visibility, metres: with less than a mile, half and a quarter of one, 6, 7 and
/// 11.5 % slower, and capacities 9 to 11 % less, which is the same of headways (Agarwal, Maze and Souleyrette 2005, "Impacts of
/// weather on urban freeway traffic flow characteristics and facility capacity"). Each stands in the middle of its range.
const SHARES: [[f64; 2]; 4] = [[200.0, 0.885], [600.0, 0.93], [1200.0, 0.94], [1609.0, 1.0]];
/// Reaction time, s, and braking, m/s², of who stops for something in sight: AASHTO's stopping sight distance (2018, "A Policy
/// on Geometric Design of Highways and Streets", chapter 3).
const REACTION_S: f64 = 2.5;
const STOPPING_MPS2: f64 = 3.4;

/// Factor on speeds, and divisor of time headways. Rain also takes away sight, and its share has that in it: the stronger of
/// the two counts.
pub(crate) fn pace_in(condition: &DrivingCondition) -> f64 {
    pace_on(condition.wetness).min(pace_with_sight(f64::from(condition.visibility_m)))
}

/// The speed from which one can stop within the visibility, m/s.
pub(crate) fn sight_speed_mps(condition: &DrivingCondition) -> f64 {
    let lost = STOPPING_MPS2 * REACTION_S;
    (lost * lost + 2.0 * STOPPING_MPS2 * f64::from(condition.visibility_m)).sqrt() - lost
}

/// On a road of this wetness, 0 dry to 1 soaked.
fn pace_on(wetness: f32) -> f64 {
    1.0 - 0.12 * f64::from(smoothstep(0.2, 0.7, wetness))
}

fn pace_with_sight(visibility_m: f64) -> f64 {
    let [first, .., last] = SHARES;
    if visibility_m >= last[0] {
        return last[1];
    }
    let between = |pair: &[[f64; 2]]| {
        let [[low, slow], [high, fast]] = [pair[0], pair[1]];
        (visibility_m >= low && visibility_m < high).then(|| slow + (fast - slow) * (visibility_m - low) / (high - low))
    };
    SHARES.windows(2).find_map(between).unwrap_or(first[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn foggy(visibility_m: f32) -> DrivingCondition {
        DrivingCondition { visibility_m, ..DrivingCondition::default() }
    }

    #[test]
    fn the_thicker_the_fog_the_slower() {
        assert_eq!(pace_in(&DrivingCondition::default()), 1.0);
        assert_eq!(pace_in(&foggy(2000.0)), 1.0);
        assert_eq!(pace_in(&foggy(600.0)), 0.93);
        assert_eq!(pace_in(&foggy(50.0)), 0.885);
        let paces: Vec<f64> = (1..40).map(|k| pace_in(&foggy(50.0 * k as f32))).collect();
        assert!(paces.windows(2).all(|pair| pair[0] <= pair[1]), "{paces:?}");
        let rain = DrivingCondition { wetness: 1.0, visibility_m: 1200.0, ..DrivingCondition::default() };
        assert_eq!(pace_in(&rain), pace_on(1.0));
    }

    #[test]
    fn who_sees_no_further_than_they_stop_drives_no_faster() {
        assert_eq!(sight_speed_mps(&DrivingCondition::default()), f64::INFINITY);
        for visibility_m in [10.0, 30.0, 100.0] {
            let speed = sight_speed_mps(&foggy(visibility_m));
            let stop_m = speed * REACTION_S + speed * speed / (2.0 * STOPPING_MPS2);
            assert!((stop_m - f64::from(visibility_m)).abs() < 1e-6, "{speed}");
        }
    }
}
