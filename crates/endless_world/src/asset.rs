//! The catalogue entry of an actor.

use std::fmt;

/// Index into the catalogue's list of vehicle models.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct VehicleModelId(pub u32);

impl VehicleModelId {
    /// The model at an index of the catalogue's list.
    ///
    /// # Panics
    /// If the index is 2³² or more.
    pub fn from_index(index: usize) -> Self {
        Self(u32::try_from(index).expect("a catalogue has fewer than 2³² vehicle models"))
    }

    /// Index into the catalogue's list.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for VehicleModelId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// A vehicle of the catalogue in one of its endless variants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VehicleRef {
    /// Its model.
    pub model: VehicleModelId,
    /// Seed of paint and of the rider.
    pub variant: u64,
}

/// The weather that a person is dressed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Outfit {
    /// Dry weather.
    #[default]
    Fair,
    /// Coats closed, hoods up, umbrellas open.
    Rain,
    /// Arms and often legs bare, hats and parasols.
    Hot,
    /// Coats, caps of wool, boots.
    Cold,
}

/// A person of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PersonRef {
    /// The weather they are dressed for.
    pub outfit: Outfit,
    /// Seed of body, clothes and gait.
    pub seed: u64,
}

/// The catalogue entry of an actor.
///
/// ```
/// use endless_world::{AssetRef, Outfit, PersonRef, VehicleModelId, VehicleRef};
///
/// let car = AssetRef::from(VehicleRef { model: VehicleModelId(3), variant: 7 });
/// let person = AssetRef::from(PersonRef { outfit: Outfit::Rain, seed: 42 });
/// assert_eq!(car.vehicle().map(|v| v.model.index()), Some(3));
/// assert_eq!(person.vehicle(), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AssetRef {
    /// A vehicle, with its rider if it has one.
    Vehicle(VehicleRef),
    /// A person on foot.
    Person(PersonRef),
}

impl AssetRef {
    /// The vehicle that it names.
    pub const fn vehicle(self) -> Option<VehicleRef> {
        match self {
            Self::Vehicle(vehicle) => Some(vehicle),
            Self::Person(_) => None,
        }
    }

    /// The person that it names.
    pub const fn person(self) -> Option<PersonRef> {
        match self {
            Self::Person(person) => Some(person),
            Self::Vehicle(_) => None,
        }
    }
}

impl From<VehicleRef> for AssetRef {
    fn from(vehicle: VehicleRef) -> Self {
        Self::Vehicle(vehicle)
    }
}

impl From<PersonRef> for AssetRef {
    fn from(person: PersonRef) -> Self {
        Self::Person(person)
    }
}
