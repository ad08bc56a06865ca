//! The street lamps of a map, as clients switch them.

use crate::frames;
use crate::wire::{Color, LightState};
use endless_scene::StreetLamp;
use endless_town::Town;
use std::collections::{BTreeMap, BTreeSet};
use std::f32::consts::PI;

/// CARLA's group of street lamps.
const STREET: u8 = 2;

/// Street lamps: on by night and off by day, but for those that clients have switched. By day pictures have the light of none.
pub(super) struct Lamps {
    /// As they are by themselves, by day.
    all: Vec<LightState>,
    /// As clients have set them.
    set: BTreeMap<u32, LightState>,
    /// Those that clients have set since this was last asked.
    changed: BTreeSet<u32>,
    /// Clients are to be told to ask again.
    is_news: bool,
    is_night: bool,
    /// They stand in the map: clients can take them all away.
    is_standing: bool,
}

impl Lamps {
    pub(super) fn new(town: &Town) -> Self {
        let all = (1..).zip(&town.lamps).map(|(id, lamp)| state(id, lamp)).collect();
        Self { all, set: BTreeMap::new(), changed: BTreeSet::new(), is_news: false, is_night: false, is_standing: true }
    }

    /// All of them.
    pub(super) fn states(&self) -> Vec<LightState> {
        let now = |lamp: &LightState| {
            self.set.get(&lamp.id).cloned().unwrap_or_else(|| LightState { active: self.is_night, ..lamp.clone() })
        };
        self.standing().iter().map(now).collect()
    }

    /// One of them.
    pub(super) fn state(&self, id: u32) -> Option<LightState> {
        let lamp = self.standing().get((id as usize).checked_sub(1)?)?;
        let by_itself = || LightState { active: self.is_night, ..lamp.clone() };
        Some(self.set.get(&id).cloned().unwrap_or_else(by_itself))
    }

    fn standing(&self) -> &[LightState] {
        if self.is_standing { &self.all } else { &[] }
    }

    /// They come or go. Those that come again are as clients have set them.
    pub(super) fn set_standing(&mut self, is_standing: bool) {
        self.is_news |= self.is_standing != is_standing && !self.all.is_empty();
        self.is_standing = is_standing;
    }

    /// Sets lamps; numbers of none are passed over. Lamps stay where they are.
    pub(super) fn set(&mut self, states: &[LightState]) {
        for wanted in states {
            let Some(lamp) = self.state(wanted.id) else { continue };
            let intensity = if wanted.intensity.is_finite() { wanted.intensity.max(0.0) } else { lamp.intensity };
            let now = LightState { location: lamp.location.clone(), intensity, ..wanted.clone() };
            if now != lamp {
                self.changed.insert(now.id);
                self.set.insert(now.id, now);
                self.is_news = true;
            }
        }
    }

    /// What becomes of the light of those lamps that clients have set or taken away, by their places in the map's list, linear channels.
    pub(super) fn factors(&self) -> BTreeMap<usize, [f32; 3]> {
        let factor = |(id, now): (&u32, &LightState)| {
            let place = (*id as usize).checked_sub(1)?;
            let own = self.all.get(place)?;
            let brighter = if now.active { now.intensity / own.intensity.max(1.0) } else { 0.0 };
            let channel = |now: u8, own: u8| brighter * f32::from(now) / f32::from(own.max(1));
            let (n, o) = (&now.color, &own.color);
            let factors = [channel(n.r, o.r), channel(n.g, o.g), channel(n.b, o.b)];
            // Brighter than this is no lamp.
            Some((place, factors.map(|factor| factor.clamp(0.0, 1000.0))))
        };
        if !self.is_standing {
            return (0..self.all.len()).map(|place| (place, [0.0; 3])).collect();
        }
        // Those that were only switched on shine by night as all do.
        self.set.iter().filter_map(factor).filter(|(_, factors)| *factors != [1.0; 3]).collect()
    }

    /// Night begins or ends.
    pub(super) fn set_night(&mut self, is_night: bool) {
        self.is_news |= self.is_night != is_night && !self.all.is_empty();
        self.is_night = is_night;
    }

    /// Whether clients are to be told to ask again; asked once for a frame.
    pub(super) fn take_news(&mut self) -> bool {
        std::mem::take(&mut self.is_news)
    }

    /// Those that clients have set since this was last asked.
    pub(super) fn take_changed(&mut self) -> Vec<LightState> {
        std::mem::take(&mut self.changed).into_iter().filter_map(|id| self.state(id)).collect()
    }
}

/// A lamp by day. Its flux is about that of one that shines downwards evenly, lumens.
fn state(id: u32, lamp: &StreetLamp) -> LightState {
    let [r, g, b] = lamp.color.map(|linear| (255.0 * linear.clamp(0.0, 1.0)).round() as u8);
    LightState {
        id,
        location: frames::to_carla(lamp.position),
        intensity: PI * lamp.intensity_cd,
        group: STREET,
        color: Color { r, g, b },
        active: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn lamps_are_on_by_night_and_as_they_are_set() {
        let lamp = |x| StreetLamp { position: Vec3::new(x, 2.0, 8.0), color: [1.0, 0.8, 0.5], intensity_cd: 1000.0 };
        let mut lamps = Lamps::new(&Town { lamps: vec![lamp(1.0), lamp(5.0)], ..Town::default() });
        let active = |lamps: &Lamps| lamps.states().iter().map(|lamp| lamp.active).collect::<Vec<_>>();
        assert_eq!(active(&lamps), [false, false]);
        assert!(!lamps.take_news());
        lamps.set_night(true);
        assert_eq!((active(&lamps), lamps.take_news(), lamps.take_news()), (vec![true, true], true, false));
        let told = lamps.states();
        assert_eq!((told[1].id, told[1].group, told[1].location.y, told[1].color.g), (2, 2, -2.0, 204));
        let off =
            LightState { active: false, intensity: f32::NAN, location: told[0].location.clone(), ..told[1].clone() };
        lamps.set(&[
            off,
            LightState { id: 7, ..told[0].clone() },
            LightState { id: 0, ..told[0].clone() },
            told[0].clone(),
        ]);
        assert_eq!((active(&lamps), lamps.take_news()), (vec![true, false], true));
        assert_eq!(lamps.factors(), [(1, [0.0; 3])].into());
        let dim = LightState {
            intensity: 0.5 * told[0].intensity,
            color: Color { g: 102, ..told[0].color.clone() },
            ..told[0].clone()
        };
        let mut others = Lamps::new(&Town { lamps: vec![lamp(1.0)], ..Town::default() });
        assert!(others.factors().is_empty());
        others.set(&[LightState { active: true, ..dim }]);
        assert_eq!(others.factors(), [(0, [0.5, 0.25, 0.5])].into());
        assert_eq!(lamps.state(2), Some(LightState { active: false, ..told[1].clone() }));
        assert_eq!((lamps.take_changed().len(), lamps.take_changed().len()), (1, 0));
        lamps.set_night(false);
        assert_eq!(active(&lamps), [false, false]);
        let before = (lamps.factors(), lamps.take_news());
        lamps.set_standing(false);
        assert_eq!((lamps.states(), lamps.state(1), lamps.take_news()), (vec![], None, true));
        assert_eq!(lamps.factors(), [(0, [0.0; 3]), (1, [0.0; 3])].into());
        lamps.set_standing(true);
        assert_eq!((lamps.factors(), lamps.take_news()), before);
    }
}
