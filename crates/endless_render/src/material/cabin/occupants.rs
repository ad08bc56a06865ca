//! Who sits in a vehicle, told and not drawn.

use super::layout::{Cabin, occupant_key};
use endless_scene::{Mesh, Surface};
use endless_world::{ClassTag, InstanceId, Occupants};

/// Who is drawn on the seats of a vehicle that drives, behind all of its panes; `None` if no pane shows a cabin.
///
/// `body` is the mesh of its body, `trailer` that of the hind part of an articulated bus; faces look outwards, x is forward.
pub fn occupants(body: &Mesh, trailer: Option<&Mesh>, tag: ClassTag, id: InstanceId) -> Option<Occupants> {
    let key = occupant_key(id);
    let taken = |cabin: Cabin| cabin.seats().filter(|seat| cabin.is_taken(seat, key)).count() as u32;
    let ahead = cabin(body, tag).map(taken)?;
    let behind = trailer.and_then(|body| cabin(body, tag)).map_or(0, taken);
    Some(Occupants { driver: true, passengers: ahead + behind - 1 })
}

/// The cabin behind the panes of a body. Side windows may show more rows than the windscreen does: the foremost are the
/// same.
fn cabin(body: &Mesh, tag: ClassTag) -> Option<Cabin> {
    let (low, high) = body.bounds();
    let triangles = body.triangles.iter().zip(&body.triangle_materials);
    let panes = triangles.filter(|(_, m)| body.materials[usize::from(**m)].surface == Surface::CarGlass);
    let cabins = panes.filter_map(|(corners, _)| {
        let [a, b, c] = corners.map(|i| body.positions[i as usize]);
        let outwards = (b - a).cross(c - a).normalize_or_zero();
        Cabin::of(tag, low.into(), high.into(), ((a + b + c) / 3.0).into(), outwards.into())
    });
    cabins.max_by_key(|cabin| cabin.rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_scene::{Material, MeshBuilder};
    use glam::Vec3;

    /// A box of glass as large as a vehicle, or as its hind part.
    fn glasshouse(size: [f32; 3], surface: Surface) -> Mesh {
        let size = Vec3::from_array(size);
        let half = (0.5 * size).with_z(0.0);
        let mut builder = MeshBuilder::new();
        builder.cuboid(-half, half.with_z(size.z), Material::new(surface, [0.1; 3], ClassTag::Car));
        builder.finish()
    }

    #[test]
    fn somebody_always_drives_and_passengers_are_fewer_than_seats() {
        let car = glasshouse([4.4, 1.8, 1.45], Surface::CarGlass);
        let all: Vec<u32> = (1..400)
            .map(|id| occupants(&car, None, ClassTag::Car, InstanceId(id)).expect("a cabin"))
            .inspect(|of| assert!(of.driver && of.passengers <= 3))
            .map(|of| of.passengers)
            .collect();
        // 0.3 beside the driver, 0.12 on each of two seats behind.
        let mean = f64::from(all.iter().sum::<u32>()) / all.len() as f64;
        assert!((0.4..0.7).contains(&mean), "{mean}");
    }

    #[test]
    fn both_parts_of_an_articulated_bus_have_passengers() {
        let (bus, hind) =
            (glasshouse([10.0, 2.5, 3.1], Surface::CarGlass), glasshouse([7.0, 2.5, 3.1], Surface::CarGlass));
        let count = |hind| occupants(&bus, hind, ClassTag::Bus, InstanceId(7)).expect("a cabin").passengers;
        assert!(count(Some(&hind)) > count(None) && count(None) > 3);
    }

    #[test]
    fn what_has_no_pane_shows_nobody() {
        let closed = glasshouse([4.4, 1.8, 1.45], Surface::CarPaint);
        assert_eq!(occupants(&closed, None, ClassTag::Car, InstanceId(1)), None);
        let bicycle = glasshouse([1.8, 0.5, 1.1], Surface::CarGlass);
        assert_eq!(occupants(&bicycle, None, ClassTag::Bicycle, InstanceId(1)), None);
    }
}
