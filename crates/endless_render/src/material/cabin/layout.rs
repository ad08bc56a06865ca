//! Where people sit in a vehicle, and who does.

use crate::material::noise;
use endless_world::{ClassTag, InstanceId};
use glam::Vec3A;

/// Where people sit in a vehicle.
pub(super) struct Cabin {
    /// Backs of the foremost seats: x in the object frame.
    pub(super) front: f32,
    /// Distance between rows.
    pub(super) pitch: f32,
    pub(super) rows: u32,
    /// Height of the cushions.
    pub(super) cushion: f32,
    /// Half the inner width, and height of the lining.
    pub(super) half_width: f32,
    pub(super) roof: f32,
    /// Lower edge of the windows.
    pub(super) sill: f32,
    /// The ends of the cabin.
    pub(super) x: [f32; 2],
    /// Whether passengers stand, too: one sees the floor, and poles to hold on to.
    pub(super) standing: bool,
}

impl Cabin {
    /// Behind a pane at `pane` that looks in the direction `outwards`; object frame.
    pub(super) fn of(tag: ClassTag, low: Vec3A, high: Vec3A, pane: Vec3A, outwards: Vec3A) -> Option<Self> {
        let (length, middle, height) = (high.x - low.x, 0.5 * (low.x + high.x), high.z);
        let half_width = 0.5 * (high.y - low.y).min(2.6) - 0.12;
        let roof = height - 0.10;
        match tag {
            ClassTag::Bus => Some(Self {
                front: high.x - 2.3,
                pitch: 0.85,
                rows: ((length - 3.2) / 0.85) as u32,
                cushion: 0.32 * height + 0.15,
                half_width,
                roof,
                sill: 0.32 * height,
                x: [low.x + 0.2, high.x - 0.15],
                standing: true,
            }),
            // Windows along the sides of a van: rows as far as it goes.
            _ if height > 1.95 && pane.x < high.x - 0.42 * length && outwards.y.abs() > 0.7 => Some(Self {
                front: high.x - (0.25 * length).min(1.7),
                pitch: 0.88,
                rows: ((0.75 * length).max(length - 1.7) / 0.88) as u32,
                cushion: 0.36 * height,
                half_width,
                roof,
                sill: 0.5 * height,
                x: [low.x + 0.1, high.x - 0.3],
                standing: false,
            }),
            // Lorries and vans: one row behind the windscreen.
            _ if height > 1.95 => Some(Self {
                front: high.x - (0.25 * length).min(1.7),
                pitch: 1.0,
                rows: 1,
                cushion: 0.42 * height,
                half_width,
                roof,
                sill: 0.5 * height,
                x: [high.x - (0.4 * length).min(2.3), high.x - 0.3],
                standing: false,
            }),
            ClassTag::Car | ClassTag::Truck => Some(Self {
                front: middle + 0.02 * length - 0.25,
                pitch: 0.86,
                rows: 2,
                cushion: 0.32 * height,
                half_width,
                roof,
                sill: 0.60 * height,
                x: [middle - 0.48 * length, middle + 0.42 * length],
                standing: false,
            }),
            _ => None,
        }
    }

    /// Seats of a row, from the left: their y as shares of a half width, which is [`Self::half_width`] divided by this.
    fn places(&self) -> (&'static [f32], f32) {
        if self.half_width > 1.0 { (&[0.82, 0.36, -0.36, -0.82], 1.0) } else { (&[0.42, -0.42], 0.75) }
    }

    /// All seats, those of the foremost row first, the driver's before all others.
    pub(super) fn seats(&self) -> impl Iterator<Item = Seat> {
        let (places, share) = self.places();
        (0..self.rows).flat_map(move |row| {
            let x = self.front - row as f32 * self.pitch;
            (0u32..).zip(places).map(move |(place, y)| Seat { row, place, x, y: y * self.half_width / share })
        })
    }

    /// Whether somebody sits there in the vehicle of this key, if it is driven: a driver always, passengers by chance.
    pub(super) fn is_taken(&self, seat: &Seat, key: u32) -> bool {
        let often = if self.places().0.len() > 2 { 0.4 } else { 0.12 };
        match (seat.row, seat.place) {
            (0, 0) => true,
            (0, place) => noise::cell1(key, 20 + place) < 0.3,
            (row, place) => noise::cell1(key, 40 + row * 8 + place) < often,
        }
    }
}

/// One seat.
pub(super) struct Seat {
    /// 0 is the foremost.
    pub(super) row: u32,
    /// 0 is the leftmost: with row 0 the driver's.
    pub(super) place: u32,
    /// The foot of its back, in the object frame.
    pub(super) x: f32,
    pub(super) y: f32,
}

/// What decides who sits in a vehicle.
pub(super) fn occupant_key(id: InstanceId) -> u32 {
    u32::from(id.0).wrapping_mul(0x9e37_79b1)
}
