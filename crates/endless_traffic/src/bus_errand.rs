//! What somebody on foot has to do with buses: they wait for one, get on, ride and get off.

use crate::stop_places::StopPlace;
use endless_world::VehicleRef;
use glam::DVec2;

/// Who is so near to their place has come to it, metres.
pub(crate) const THERE_M: f64 = 0.6;
/// Who has come along a stop makes up their mind again after so many pieces of their way.
const AGAIN: u32 = 8;

/// Somebody's ride on a bus.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Ride {
    GettingOn(Through),
    Inside(VehicleRef),
    GettingOff(Through),
}

/// The way through a door.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Through {
    pub(crate) bus: VehicleRef,
    pub(crate) points: [DVec2; 2],
    /// Inside of the bus, behind the door.
    pub(crate) inside: DVec2,
    pub(crate) next: usize,
    pub(crate) since_s: f64,
}

impl Ride {
    /// The bus at whose door somebody is.
    pub(crate) fn at_door_of(&self) -> Option<VehicleRef> {
        match self {
            Self::GettingOn(through) | Self::GettingOff(through) => Some(through.bus),
            Self::Inside(_) => None,
        }
    }
}

/// What somebody has to do with buses.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct BusErrand {
    pub(crate) ride: Option<Ride>,
    /// The stop at which they made up their mind last, and how many edges they had walked then.
    pub(crate) decided: Option<(usize, u32)>,
    pub(crate) wait: Option<Wait>,
}

/// A wait under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wait {
    pub(crate) place: StopPlace,
    pub(crate) left_s: f64,
    pub(crate) looked_s: f64,
}

impl BusErrand {
    /// Whether somebody waits, or is on the way to where they will.
    pub(crate) fn waits(&self) -> bool {
        self.wait.is_some()
    }

    /// The place at which somebody stands and waits.
    pub(crate) fn stands_at(&self, at: DVec2) -> Option<StopPlace> {
        let place = self.wait?.place;
        (place.at.distance(at) < THERE_M).then_some(place)
    }

    /// Whether they are inside of a bus, where nobody sees them.
    pub(crate) fn is_inside(&self) -> bool {
        matches!(self.ride, Some(Ride::Inside(_)))
    }

    /// Of somebody who gets on.
    pub(crate) fn riding(ride: Ride) -> Self {
        Self { ride: Some(ride), ..Self::default() }
    }

    /// Of somebody who comes out of a bus at a stop: they do not wait for the next one.
    pub(crate) fn after_ride(ride: Ride, stop: usize, passed: u32) -> Self {
        Self { ride: Some(ride), decided: Some((stop, passed)), wait: None }
    }

    /// Whether they have made up their mind about a stop, and are still near it.
    pub(crate) fn has_decided(&self, stop: usize, passed: u32) -> bool {
        self.decided.is_some_and(|(other, when)| other == stop && passed < when + AGAIN)
    }
}
