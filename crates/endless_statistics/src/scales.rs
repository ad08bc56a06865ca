//! The bins of all histograms.

use crate::Scale;

/// 0, 1/divisor, 2/divisor, …: each the number nearest to its decimal fraction.
const fn steps<const N: usize>(divisor: f64) -> [f64; N] {
    let mut edges = [0.0; N];
    let mut i = 0;
    while i < N {
        edges[i] = i as f64 / divisor;
        i += 1;
    }
    edges
}

/// Side of the square as large as a box: COCO's limits of small and medium boxes, 32 and 96 pixels, are edges.
pub(crate) static BOX_SIDE_PX: Scale = Scale {
    unit: "px",
    edges: &[
        0.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 96.0, 128.0, 192.0, 256.0, 384.0, 512.0, 768.0, 1024.0, 2048.0,
    ],
    open: true,
};

/// The same as a share of the side of the square as large as the picture.
pub(crate) static BOX_SIDE_PERCENT: Scale = Scale {
    unit: "%",
    edges: &[0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 100.0],
    open: false,
};

/// Width over height.
pub(crate) static ASPECT_RATIO: Scale = Scale { unit: "", edges: &steps::<21>(5.0), open: true };

/// From 0 to 1.
pub(crate) static SHARE: Scale = Scale { unit: "", edges: &steps::<21>(20.0), open: false };

/// Up to 200 m in steps of 10 m.
pub(crate) static DISTANCE_M: Scale = Scale { unit: "m", edges: &steps::<21>(0.1), open: true };

/// Of vehicles: up to 144 km/h in steps of 7.2 km/h.
pub(crate) static VEHICLE_SPEED_MPS: Scale = Scale { unit: "m/s", edges: &steps::<21>(0.5), open: true };

/// Of people on foot: up to 5 m/s in steps of a quarter.
pub(crate) static WALKING_SPEED_MPS: Scale = Scale { unit: "m/s", edges: &steps::<21>(4.0), open: true };

/// How long something is seen.
pub(crate) static SEEN_S: Scale = Scale {
    unit: "s",
    edges: &[0.0, 0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 64.0, 128.0, 256.0, 1024.0],
    open: true,
};

/// Ages in steps of ten years.
pub(crate) static AGE_YEARS: Scale = Scale { unit: "years", edges: &steps::<11>(0.1), open: true };

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_plain_numbers() {
        let all = [
            &BOX_SIDE_PX,
            &BOX_SIDE_PERCENT,
            &ASPECT_RATIO,
            &SHARE,
            &DISTANCE_M,
            &VEHICLE_SPEED_MPS,
            &WALKING_SPEED_MPS,
            &SEEN_S,
            &AGE_YEARS,
        ];
        for scale in all {
            assert!(scale.edges.len() >= 2 && scale.edges.is_sorted_by(|a, b| a < b));
            assert!(scale.edges.iter().all(|edge| edge.to_string().len() <= 5), "{:?}", scale.edges);
        }
        assert_eq!((SHARE.edges[20], DISTANCE_M.edges[20], AGE_YEARS.edges[10]), (1.0, 200.0, 100.0));
    }
}
