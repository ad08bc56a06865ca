use super::*;
use crate::person::skeleton::Bone;
use endless_world::Gait;

fn motion(person: &PersonModel, gait: Gait, walked_m: f32) -> WalkerMotion {
    let speed_mps = if gait == Gait::Run { 3.0 } else { person.walk_mps };
    WalkerMotion { speed_mps, gait, walked_m, time_s: walked_m }
}

#[test]
fn feet_are_on_the_ground_in_all_phases() {
    for variant in 0..30 {
        let person = PersonModel::new(variant);
        for gait in [Gait::Stand, Gait::Walk, Gait::Run] {
            for k in 0..40 {
                let pose = person.pose(&motion(&person, gait, 0.05 * k as f32));
                let low = pose.positions.iter().map(|p| p.z).fold(f32::INFINITY, f32::min);
                assert!(low.abs() < 0.01, "variant {variant} {gait:?} {k}: {low}");
                let high = pose.positions.iter().map(|p| p.z).fold(f32::NEG_INFINITY, f32::max);
                assert!(
                    high > 0.85 * person.height_m && high < 1.12 * person.height_m,
                    "{high} of {}",
                    person.height_m
                );
            }
        }
    }
}

/// The sole's middle of the foot that stands flat stays where it is in the world.
#[test]
fn standing_feet_do_not_slide() {
    for variant in 0..12 {
        let person = PersonModel::new(variant);
        for gait in [Gait::Walk, Gait::Run] {
            let stride = person.habit.stride(gait);
            let sole = |walked: f32| {
                let posture = gait::posture(&motion(&person, gait, walked), &person.skeleton, &person.habit);
                let bones = posture.solve(&person.skeleton);
                let rest = person.skeleton.joint(Bone::FootL);
                let p = bones[Bone::FootL as usize].transform_point3(Vec3::new(
                    rest.x + 0.3 * person.skeleton.toe,
                    rest.y,
                    0.0,
                ));
                Vec3::new(p.x + walked, p.y, p.z)
            };
            // Phase 0 is the left heel's strike; the sole is flat from 16 % to 50 % of the stance.
            let start = (1.0 - person.habit.offset) * stride;
            let duty = if gait == Gait::Walk { 0.62 } else { 0.36 };
            let first = sole(start + 0.17 * duty * stride);
            for k in 0..=20 {
                let p = sole(start + (0.17 + 0.33 * k as f32 / 20.0) * duty * stride);
                assert!((p - first).truncate().length() < 0.02, "variant {variant} {gait:?}: {p} {first}");
            }
        }
    }
}

#[test]
fn people_differ_in_size() {
    let heights: Vec<f32> = (0..300).map(|v| PersonModel::new(v).height_m).collect();
    assert!(heights.iter().all(|&h| (1.05..=1.95).contains(&h)));
    assert!(heights.iter().any(|&h| h < 1.4) && heights.iter().any(|&h| h > 1.85));
}

#[test]
fn joints_do_not_tear() {
    for variant in 0..10 {
        let person = PersonModel::new(variant);
        let pose = person.pose(&motion(&person, Gait::Run, 0.7));
        for t in &person.rest.triangles {
            let edge = |p: &[Vec3], a: usize, b: usize| (p[t[a] as usize] - p[t[b] as usize]).length();
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                let (before, after) = (edge(&person.rest.positions, a, b), edge(&pose.positions, a, b));
                assert!(after < 4.5 * before + 0.10, "variant {variant}: {before} became {after}");
            }
        }
    }
}

/// Not a benchmark, but a pose must not become slow unseen: a hundred people at 30 Hz are 3,000 poses a second.
#[test]
fn posing_is_quick() {
    let person = PersonModel::new(3);
    assert!(person.blends.len() < 260, "{} mixtures", person.blends.len());
    assert!(person.rest.positions.len() < 5000, "{} vertices", person.rest.positions.len());
}
