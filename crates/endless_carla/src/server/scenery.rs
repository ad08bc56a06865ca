//! Which things of a map are there: clients hide them one by one, or take whole layers away.

use super::loaded_map::LoadedMap;
use super::map_layer::MapLayer;
use super::map_objects::MapObject;
use endless_asset::Catalogue;
use endless_city::TownThing;
use endless_world::ClassTag;
use std::collections::BTreeSet;
use std::sync::Arc;

/// What an episode shows of its map.
pub(super) struct Scenery {
    /// With all things.
    whole: Arc<LoadedMap>,
    /// Bits of the layers that are loaded.
    layers: u16,
    /// Numbers of things that clients have hidden.
    hidden: BTreeSet<u64>,
    /// What is shown is not yet what it should be.
    is_stale: bool,
}

impl Scenery {
    /// Some layers of a map.
    pub(super) fn new(whole: Arc<LoadedMap>, layers: u16) -> Self {
        Self { whole, layers, hidden: BTreeSet::new(), is_stale: layers != MapLayer::ALL }
    }

    /// The map with all things.
    pub(super) fn whole(&self) -> &Arc<LoadedMap> {
        &self.whole
    }

    /// Hides things by their numbers, or shows them again; numbers of none are passed over.
    pub(super) fn enable(&mut self, numbers: &[u64], enabled: bool) {
        for number in numbers {
            self.is_stale |= if enabled { self.hidden.remove(number) } else { self.hidden.insert(*number) };
        }
    }

    /// Loads layers, named by their bits, or takes them away.
    pub(super) fn set_layers(&mut self, layers: u16, loaded: bool) {
        let now = if loaded { self.layers | layers } else { self.layers & !layers };
        self.is_stale |= now != self.layers;
        self.layers = now;
    }

    /// Whether a layer is loaded.
    pub(super) fn has(&self, layer: MapLayer) -> bool {
        layer.is_in(self.layers)
    }

    /// The things of all layers that are loaded, hidden or not.
    pub(super) fn things<'a>(&'a self, catalogue: &Catalogue) -> impl Iterator<Item = &'a MapObject> {
        self.whole.objects(catalogue).iter().filter(|thing| self.is_loaded(thing))
    }

    fn is_loaded(&self, thing: &MapObject) -> bool {
        thing.layer.is_none_or(|layer| self.has(layer))
    }

    /// Whether a thing is seen.
    pub(super) fn shows(&self, thing: &MapObject) -> bool {
        self.is_loaded(thing) && !self.hidden.contains(&thing.told.id)
    }

    /// The map as it is to be shown from now on; none if it is shown so already. To make it takes as long as a picture.
    pub(super) fn changed(&mut self, catalogue: &Catalogue) -> Option<Arc<LoadedMap>> {
        if !std::mem::take(&mut self.is_stale) {
            return None;
        }
        let hidden: BTreeSet<(TownThing, ClassTag)> = if self.layers == MapLayer::ALL && self.hidden.is_empty() {
            BTreeSet::new()
        } else {
            let objects = self.whole.objects(catalogue).iter().filter(|thing| !self.shows(thing));
            objects.map(|object| (object.thing, object.class)).collect()
        };
        Some(if hidden.is_empty() { Arc::clone(&self.whole) } else { Arc::new(self.whole.without(&hidden)) })
    }
}
