//! Statistics of a map.

use endless_town::Town;
use glam::DVec2;

/// Facts on a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapStatistics {
    /// Its name.
    pub name: String,
    /// One sentence on its character.
    pub summary: String,
    /// Area that its roads span, km².
    pub area_km2: f64,
    /// Lanes for driving outside junctions, and their length together, km.
    pub lanes: usize,
    /// Kilometres of these lanes.
    pub lane_km: f64,
    /// Number of camera sites.
    pub cameras: usize,
    /// What it has: signals, crossings, slopes, fast roads.
    pub features: Vec<String>,
}

impl MapStatistics {
    /// Of a town.
    pub fn of(town: &Town) -> Self {
        let network = &town.network;
        let points = network.lanes.iter().flat_map(|l| l.centerline.points());
        let (low, high) = points
            .clone()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p.truncate()), h.max(p.truncate())));
        let heights = points.map(|p| p.z).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
        let size = if low.x <= high.x { high - low } else { DVec2::ZERO };
        let outside = || network.lanes.iter().filter(|l| l.junction.is_none());
        let signals = network.junctions.iter().filter(|j| j.program.is_some()).count();
        let fastest = outside().map(|l| l.speed_limit_mps).fold(0.0, f64::max) * 3.6;
        let mut features = vec![format!("{} junctions ({signals} with signals)", network.junctions.len())];
        if !network.crossings.is_empty() {
            features.push(format!("{} crossings", network.crossings.len()));
        }
        if network.walk.edges.is_empty() {
            features.push("no sidewalks".into());
        }
        if heights.1 - heights.0 > 2.0 {
            features.push(format!("{:.0} m of relief", heights.1 - heights.0));
        }
        features.push(format!("up to {fastest:.0} km/h"));
        Self {
            name: town.name.clone(),
            summary: town.summary.clone(),
            area_km2: size.x * size.y * 1e-6,
            lanes: outside().count(),
            lane_km: outside().map(|l| l.centerline.length()).sum::<f64>() / 1000.0,
            cameras: town.cameras.len(),
            features,
        }
    }
}
