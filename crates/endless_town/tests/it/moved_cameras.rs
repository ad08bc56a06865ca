//! Moved cameras are judged by what they see.

use crate::towns;
use endless_asset::Catalogue;
use endless_town::ViewCheck;
use endless_world::CameraSite;
use std::f32::consts::PI;

#[test]
fn cameras_see_as_well_as_themselves_and_not_as_well_from_elsewhere() {
    let catalogue = Catalogue::builtin();
    let (mut cameras, mut good, mut pairs) = (0, 0, 0);
    for town in towns() {
        let check = ViewCheck::new(town, &catalogue);
        let seen = check.places_seen(&town.cameras);
        let both_see = |a: &[u32], b: &[u32]| a.iter().any(|place| b.binary_search(place).is_ok());
        for (i, site) in town.cameras.iter().enumerate() {
            assert!(seen[i].len() > 5 && seen[i].is_sorted_by(|a, b| a < b), "{}: {}", town.name, site.name);
            let about = CameraSite { yaw_rad: site.yaw_rad + PI, ..site.clone() };
            assert!(!both_see(&check.places_seen(&[about])[0], &seen[i]), "{}: {}", town.name, site.name);
            pairs += seen[..i].iter().filter(|other| both_see(other, &seen[i])).count();
            cameras += 1;
            good += usize::from(check.sees_as_well(site, site));
            let [x, y, z] = site.position;
            for (what, spoiled) in [
                ("looks up", CameraSite { down_tilt_rad: -0.6, ..site.clone() }),
                ("hangs in the sky", CameraSite { position: [x, y, z + 300.0], ..site.clone() }),
                ("lies in the ground", CameraSite { position: [x, y, z - 30.0], ..site.clone() }),
                ("is far away", CameraSite { position: [x + 9000.0, y, z], ..site.clone() }),
            ] {
                assert!(!check.sees_as_well(site, &spoiled), "{}: {} {what}", town.name, site.name);
            }
        }
    }
    assert!(good * 20 >= cameras * 17, "{good} of {cameras} cameras see what they see");
    assert!(pairs >= 15, "{pairs} pairs of cameras see the same place");
}
