//! What of a frame is also in another one, where somebody may have come or gone.

use crate::scene::{FrameScene, Instance};
use endless_world::InstanceId;
use std::collections::BTreeMap;

/// Another instant, with the numbers that the instances of a frame have there.
pub(super) struct OtherInstant<'a> {
    pub(super) scene: &'a FrameScene,
    /// By their numbers in the frame; `None` where all are the same.
    numbers: Option<Vec<Option<u32>>>,
}

impl<'a> OtherInstant<'a> {
    /// Seen from a frame.
    pub(super) fn new(frame: &FrameScene, scene: &'a FrameScene) -> Self {
        let ids =
            |scene: &FrameScene| scene.instances.iter().map(|instance: &Instance| instance.id).collect::<Vec<_>>();
        let (now, then) = (ids(frame), ids(scene));
        Self { scene, numbers: (now != then).then(|| numbers(&now, &then)) }
    }

    /// The number that an instance of the frame has there; `None` if it is not there.
    pub(super) fn instance(&self, number: u32) -> Option<u32> {
        self.numbers.as_ref().map_or(Some(number), |numbers| numbers[number as usize])
    }
}

/// An object has the same instances, in the same order, wherever it is.
fn numbers(now: &[InstanceId], then: &[InstanceId]) -> Vec<Option<u32>> {
    let mut of_objects: BTreeMap<InstanceId, Vec<u32>> = BTreeMap::new();
    for (id, number) in then.iter().zip(0..) {
        of_objects.entry(*id).or_default().push(number);
    }
    let mut seen: BTreeMap<InstanceId, usize> = BTreeMap::new();
    let number = |id: &InstanceId| {
        let place = seen.entry(*id).or_default();
        *place += 1;
        of_objects.get(id)?.get(*place - 1).copied()
    };
    now.iter().map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_are_found_again_after_others_came_or_went() {
        let ids = |ids: &[u16]| ids.iter().copied().map(InstanceId).collect::<Vec<_>>();
        let found = numbers(&ids(&[3, 3, 5, 8, 8]), &ids(&[1, 3, 3, 8, 8, 9]));
        assert_eq!(found, [Some(1), Some(2), None, Some(3), Some(4)]);
    }
}
