//! Geometry of a catalogue's models, made when it is first needed and kept for all towns and videos.

use crate::{moving_vehicle::MovingVehicle, vehicle::VehicleGeometry};
use endless_asset::Catalogue;
use endless_render::Geometry;
use endless_town::PlacedObject;
use endless_world::VehicleModelId;
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Mutex, PoisonError},
};

/// Geometry of one catalogue's models. Towns that share it, and their videos, make none twice.
#[derive(Debug, Default)]
pub struct SharedModels {
    parked: MadeOnce<VehicleModelId, VehicleGeometry>,
    moving: MadeOnce<VehicleModelId, MovingVehicle>,
    props: MadeOnce<PlacedObject, Geometry>,
}

impl SharedModels {
    /// Vehicles as they stand.
    pub(crate) fn parked(
        &self,
        models: BTreeSet<VehicleModelId>,
        catalogue: &Catalogue,
    ) -> BTreeMap<VehicleModelId, VehicleGeometry> {
        self.parked.get(models, |model| Some(VehicleGeometry::new(catalogue.vehicle(model)?)))
    }

    /// Vehicles as they move.
    pub(crate) fn moving(
        &self,
        models: BTreeSet<VehicleModelId>,
        catalogue: &Catalogue,
    ) -> BTreeMap<VehicleModelId, MovingVehicle> {
        let parked = self.parked(models.clone(), catalogue);
        self.moving.get(models, |model| MovingVehicle::new(catalogue, model, parked.get(&model)?.clone()))
    }

    /// Props.
    pub(crate) fn props(
        &self,
        props: BTreeSet<PlacedObject>,
        catalogue: &Catalogue,
    ) -> BTreeMap<PlacedObject, Geometry> {
        self.props.get(props, |what| match what {
            PlacedObject::Prop(prop, variant) => Some(Geometry::new(catalogue.prop(prop, variant))),
            PlacedObject::TownMesh(_) => None,
        })
    }
}

/// What is made by key, and kept.
#[derive(Debug)]
struct MadeOnce<K, V>(Mutex<BTreeMap<K, V>>);

impl<K, V> Default for MadeOnce<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Ord + Copy + Send + Sync, V: Clone + Send> MadeOnce<K, V> {
    /// Those of these keys for which there is anything; what is missing is made by all threads.
    fn get(&self, keys: BTreeSet<K>, make: impl Fn(K) -> Option<V> + Sync) -> BTreeMap<K, V> {
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let missing: Vec<K> = {
            let known = known();
            keys.iter().copied().filter(|key| !known.contains_key(key)).collect()
        };
        let made: Vec<(K, V)> = missing.into_par_iter().filter_map(|key| Some((key, make(key)?))).collect();
        let mut known = known();
        for (key, value) in made {
            known.entry(key).or_insert(value);
        }
        keys.into_iter().filter_map(|key| Some((key, known.get(&key)?.clone()))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn nothing_is_made_twice_and_what_there_is_not_is_left_out() {
        let (made, shared) = (AtomicUsize::new(0), MadeOnce::default());
        let square = |n: u32| {
            made.fetch_add(1, Ordering::Relaxed);
            (n < 10).then_some(n * n)
        };
        assert_eq!(shared.get([2, 3, 12].into(), square), [(2, 4), (3, 9)].into());
        assert_eq!(shared.get([3, 4].into(), square), [(3, 9), (4, 16)].into());
        assert_eq!(made.into_inner(), 4);
    }
}
