//! Ends of indirect rays that later videos of a map need again, kept in memory.

use super::bake_key::BakeKey;
use endless_render::IndirectHits;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What is kept, within a bound: what is needed soonest (Belády 1966).
pub(super) struct KeptHits {
    most_bytes: usize,
    /// Cameras of the videos to come, in order of work: the video's number, and the key of each.
    coming: Vec<(u32, Vec<BakeKey>)>,
    kept: Mutex<BTreeMap<BakeKey, Arc<IndirectHits>>>,
}

impl KeptHits {
    /// Nothing yet.
    pub(super) fn new(most_bytes: usize, coming: Vec<(u32, Vec<BakeKey>)>) -> Self {
        Self { most_bytes, coming, kept: Mutex::default() }
    }

    /// What an earlier video kept.
    pub(super) fn get(&self, key: &BakeKey) -> Option<Arc<IndirectHits>> {
        self.lock().get(key).cloned()
    }

    /// Whether a video after this one needs it.
    pub(super) fn is_needed_after(&self, video: u32, key: &BakeKey) -> bool {
        self.most_bytes > 0 && self.next_use(video, key).is_some()
    }

    /// Keeps what later videos need, if there is room; lets go of what none needs, and of what is needed last.
    pub(super) fn keep(&self, video: u32, key: BakeKey, hits: Arc<IndirectHits>) {
        let mut kept = self.lock();
        kept.insert(key, hits);
        kept.retain(|key, _| self.next_use(video, key).is_some());
        while kept.values().map(|hits| hits.memory_bytes()).sum::<usize>() > self.most_bytes {
            let last = kept.keys().max_by_key(|key| self.next_use(video, key)).copied();
            let Some(last) = last else { break };
            kept.remove(&last);
        }
    }

    /// How far from now the first video is, among those after this one, that needs it.
    fn next_use(&self, video: u32, key: &BakeKey) -> Option<usize> {
        let now = self.coming.iter().position(|(number, _)| *number == video)?;
        self.coming[now + 1..].iter().position(|(_, keys)| keys.contains(key))
    }

    fn lock(&self) -> MutexGuard<'_, BTreeMap<BakeKey, Arc<IndirectHits>>> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_render::{CameraBake, Gathering, RenderSettings, StaticScene};
    use endless_world::{CameraSite, ImageSize, LensModel, Mount, TimeOfDay, Weather};

    fn key(camera: u8) -> BakeKey {
        [camera; 32]
    }

    /// What a camera of nothing but sky keeps.
    fn hits() -> Arc<IndirectHits> {
        let size = ImageSize { width: 16, height: 9 };
        let settings = RenderSettings {
            gathering: Gathering::Interpolated { rays: 2 },
            ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Morning, 0, size)
        };
        let site = CameraSite {
            name: "pole".into(),
            position: [0.0, 0.0, 6.0],
            yaw_rad: 0.0,
            down_tilt_rad: 0.4,
            horizontal_fov_rad: 1.2,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        Arc::new(CameraBake::bake_keeping(&StaticScene::new(vec![], &[]), &settings, &site).1)
    }

    #[test]
    fn what_is_needed_soonest_is_kept_and_what_no_video_needs_is_not() {
        let hits = hits();
        let coming = [(7, [1, 2]), (3, [1, 3]), (5, [2, 3]), (4, [1, 4])];
        let coming = coming.map(|(video, cameras)| (video, cameras.map(key).to_vec())).to_vec();
        let kept = KeptHits::new(2 * hits.memory_bytes(), coming);
        let there = || (1..5).filter(|&camera| kept.get(&key(camera)).is_some()).collect::<Vec<_>>();
        let keep = |video, camera| kept.keep(video, key(camera), Arc::clone(&hits));
        keep(7, 1);
        keep(7, 2);
        assert_eq!(there(), [1, 2]);
        // Camera 1 is needed again, but last of the three.
        keep(3, 1);
        keep(3, 3);
        assert_eq!(there(), [2, 3]);
        assert!(kept.is_needed_after(5, &key(1)) && !kept.is_needed_after(5, &key(3)));
        keep(5, 3);
        assert_eq!(there(), [] as [u8; 0]);
        keep(4, 4);
        assert_eq!(there(), [] as [u8; 0]);
    }

    #[test]
    fn without_memory_nothing_is_kept() {
        let kept = KeptHits::new(0, vec![(0, vec![key(1)]), (1, vec![key(1)])]);
        assert!(!kept.is_needed_after(0, &key(1)));
        kept.keep(0, key(1), hits());
        assert!(kept.get(&key(1)).is_none());
    }
}
