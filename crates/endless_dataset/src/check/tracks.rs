//! One id is one object: the same class in all frames of all cameras.

use super::report::Finding;
use endless_world::{InstanceId, ObjectClass};
use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
};

/// The classes that each id was seen as.
#[derive(Debug, Clone, Default)]
pub(super) struct Tracks(BTreeMap<InstanceId, BTreeSet<ObjectClass>>);

impl Tracks {
    pub(super) fn add(&mut self, id: InstanceId, class: ObjectClass) {
        self.0.entry(id).or_default().insert(class);
    }

    /// Ids with each class that they were seen as.
    pub(super) fn seen(&self) -> impl Iterator<Item = (InstanceId, ObjectClass)> {
        self.0.iter().flat_map(|(id, classes)| classes.iter().map(|class| (*id, *class)))
    }
}

/// Ids that are more than one class.
pub(super) fn disagreements(video: &Path, cameras: &[&Tracks]) -> Vec<Finding> {
    let mut all = Tracks::default();
    for (id, classes) in cameras.iter().flat_map(|t| &t.0) {
        all.0.entry(*id).or_default().extend(classes);
    }
    let several = all.0.into_iter().filter(|(_, classes)| classes.len() > 1);
    several
        .map(|(id, classes)| {
            let names: Vec<&str> = classes.iter().map(|c| c.name()).collect();
            Finding::new(video, format!("object {id} is {} in different frames", names.join(" and ")))
        })
        .collect()
}
