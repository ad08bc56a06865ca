//! Which rays of a bundle can go together in a packet.

use super::packet_ray::main_axis8;
use super::stream::RayStream;
use wide::f32x8;

/// Signs and main axis of each lane's direction.
pub(super) struct Octants {
    /// For each axis, the lanes that go down along it; then those whose main axis is x, and y.
    bits: [u32; 5],
}

impl Octants {
    pub(super) fn of<const N: usize>(rays: &RayStream<N>) -> Self {
        let mut bits = [0; 5];
        for row in 0..N {
            let direction = rays.direction.map(|axis| axis[row]);
            let [x_main, y_main] = main_axis8(&direction);
            let [x, y, z] = direction.map(f32x8::to_bitmask);
            for (all, own) in bits.iter_mut().zip([x, y, z, x_main, y_main & !x_main]) {
                *all |= own << (8 * row);
            }
        }
        Self { bits }
    }

    /// Those of some lanes that are as the first of them.
    pub(super) fn like_first(&self, lanes: u32) -> u32 {
        let first = lanes.trailing_zeros();
        self.bits.iter().fold(lanes, |alike, bits| {
            let first_has_it = bits.unbounded_shr(first) & 1 == 1;
            alike & if first_has_it { *bits } else { !bits }
        })
    }
}
