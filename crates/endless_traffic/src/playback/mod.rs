//! Road users who move as recorded tracks say.
//!
//! Where they are and which way they look comes from the track alone; heights come from the ground under them, and lamps,
//! wheels, lean and steps from their motion. Who is simulated sees them, but they see nobody.

mod body;
mod cast;
mod fit;
mod ground;
mod path;
mod presence;

use crate::lights::side_of;
use body::{Moment, PersonBody, VehicleBody};
use endless_road::RoadNetwork;
use endless_world::{
    Actor, AssetRef, Behaviour, InstanceId, InstanceIdAllocator, LanePlace, Motion, ObjectClass, Outfit, Pose,
    TooManyInstances, Track, TrackPlayback, VehicleSpec, walking::PedestrianSpec,
};
use glam::{DVec2, Vec3};
use ground::{GroundIndex, OnCrossing, OnLane};
use path::{PathPlace, TrackPath, heading};

pub use fit::TrackFit;
pub(crate) use presence::Presence;

/// Slower than this people stand, m/s.
const STANDS_MPS: f64 = 0.1;

/// Recorded tracks, and how a scene plays them.
#[derive(Debug, Clone, Copy)]
pub struct PlayedTracks<'a> {
    /// The tracks of the file.
    pub tracks: &'a [Track],
    /// How they are played.
    pub playback: TrackPlayback,
    /// Length of the video, seconds.
    pub duration_s: f64,
}

/// All who play a track in one scene.
#[derive(Debug, Clone)]
pub(crate) struct Playback {
    ground: GroundIndex,
    begin_s: f64,
    actors: Vec<Played>,
}

/// One who plays a track.
#[derive(Debug, Clone)]
struct Played {
    name: String,
    id: InstanceId,
    rider_id: Option<InstanceId>,
    class: ObjectClass,
    asset: AssetRef,
    path: TrackPath,
    body: Body,
    here: Option<Here>,
}

#[derive(Debug, Clone)]
enum Body {
    Vehicle(VehicleBody),
    Person(PersonBody),
}

/// Where somebody is at the instant.
#[derive(Debug, Clone, Copy)]
struct Here {
    place: PathPlace,
    pose: Pose,
    lane: Option<OnLane>,
    crossing: Option<OnCrossing>,
}

impl Playback {
    /// Of the tracks that somebody is on during the video. Ids go on after those that are given out: vehicles, then
    /// riders, then people on foot.
    ///
    /// # Errors
    /// When there are not so many ids.
    pub(crate) fn new(
        network: &RoadNetwork,
        played: &PlayedTracks<'_>,
        specs: &[VehicleSpec],
        pedestrian: &dyn Fn(u64) -> PedestrianSpec,
        outfit: Outfit,
        ids: &mut InstanceIdAllocator,
    ) -> Result<Self, TooManyInstances> {
        let TrackPlayback { begin_s, offset_m, seed } = played.playback;
        let (offset, end_s) = (DVec2::from_array(offset_m), begin_s + played.duration_s);
        let there = |track: &&Track| {
            let spans = track.pieces.iter().filter_map(|piece| Some((piece.first()?.time_s, piece.last()?.time_s)));
            spans.into_iter().any(|(first, last)| first <= end_s && last >= begin_s)
        };
        let actor = |track: &Track, class, asset: AssetRef, length_m: f64, body| Played {
            name: track.name.clone(),
            id: InstanceId::STUFF,
            rider_id: None,
            class,
            asset,
            path: TrackPath::new(track, offset, length_m),
            body,
            here: None,
        };
        let (mut vehicles, mut people): (Vec<Played>, Vec<Played>) = (Vec::new(), Vec::new());
        for track in played.tracks.iter().filter(there) {
            if cast::on_foot(track) {
                let taken = |seed| people.iter().any(|other| other.asset.person().is_some_and(|p| p.seed == seed));
                let person = cast::dressed(cast::person(track, seed, taken), outfit);
                let body = Body::Person(PersonBody::new(pedestrian(person.seed)));
                people.push(actor(track, ObjectClass::Pedestrian, person.into(), 0.0, body));
                continue;
            }
            let taken = |vehicle| vehicles.iter().any(|other| other.asset.vehicle() == Some(vehicle));
            let Some(vehicle) = cast::vehicle(track, specs, seed, taken) else { continue };
            let spec = &specs[vehicle.model.index()];
            let body = Body::Vehicle(VehicleBody::new(spec, vehicle.variant));
            vehicles.push(actor(track, spec.class, vehicle.into(), f64::from(spec.length_m), body));
        }
        let give = |actors: &mut [Played], ids: &mut InstanceIdAllocator| {
            actors.iter_mut().try_for_each(|actor| ids.allocate().map(|id| actor.id = id))
        };
        give(&mut vehicles, ids)?;
        for actor in &mut vehicles {
            let ridden = actor.asset.vehicle().is_some_and(|vehicle| specs[vehicle.model.index()].ridden);
            actor.rider_id = ridden.then(|| ids.allocate()).transpose()?;
        }
        give(&mut people, ids)?;
        vehicles.append(&mut people);
        Ok(Self { ground: GroundIndex::new(network), begin_s, actors: vehicles })
    }

    /// Numbers of vehicles and of people on foot who play a track during the video.
    pub(crate) fn counts(&self) -> [u32; 2] {
        let people = self.actors.iter().filter(|actor| actor.class == ObjectClass::Pedestrian).count() as u32;
        [self.actors.len() as u32 - people, people]
    }

    /// Everybody at a scene time, a step after the last.
    pub(crate) fn advance(&mut self, network: &RoadNetwork, time_s: f64, step_s: f64, headlights_on: f32) {
        let Self { ground, begin_s, actors } = self;
        let moment = Moment { network, ground, file_s: *begin_s + time_s, time_s, step_s, headlights_on };
        for actor in actors {
            actor.advance(&moment);
        }
    }

    /// Those who are there, by ascending id.
    pub(crate) fn state(&self, network: &RoadNetwork, time_s: f64) -> impl Iterator<Item = Actor> {
        self.actors.iter().filter_map(move |actor| Some(actor.at(network, actor.here.as_ref()?, time_s)))
    }

    /// Everybody who may appear, by ascending id: where they are is left open.
    pub(crate) fn everybody(&self) -> impl Iterator<Item = Actor> {
        self.actors.iter().map(|actor| match &actor.body {
            Body::Vehicle(_) => actor.somewhere(Motion::Vehicle(endless_world::VehicleMotion::default())),
            Body::Person(_) => actor.somewhere(Motion::Walker(endless_world::WalkerMotion::default())),
        })
    }

    /// The names of the tracks, by the ids of those who play them.
    pub(crate) fn names(&self) -> impl Iterator<Item = (InstanceId, &str)> {
        self.actors.iter().map(|actor| (actor.id, actor.name.as_str()))
    }
}

impl Played {
    fn advance(&mut self, moment: &Moment<'_>) {
        let before = self.here.take();
        let Some(place) = self.path.at(moment.file_s) else { return };
        let appears = before.is_none_or(|before| before.place.piece != place.piece);
        let height_m = before.map(|before| f64::from(before.pose.position.z));
        let pose = match &mut self.body {
            Body::Vehicle(body) => body.place(&self.path, &place, height_m, appears, moment),
            Body::Person(body) => body.place(&place, appears, moment),
        };
        let Some(pose) = pose else { return };
        let level = Some(f64::from(pose.position.z));
        let (mut lane, mut crossing) = (None, None);
        match self.body {
            Body::Vehicle(_) => lane = moment.ground.lane(moment.network, place.centre, place.yaw, level),
            Body::Person(_) => crossing = GroundIndex::crossing(moment.network, place.centre),
        }
        self.here = Some(Here { place, pose, lane, crossing });
    }

    fn somewhere(&self, motion: Motion) -> Actor {
        Actor {
            id: self.id,
            rider_id: self.rider_id,
            class: self.class,
            asset: self.asset,
            pose: Pose::default(),
            velocity_mps: Vec3::ZERO,
            motion,
            behaviour: Behaviour::default(),
            parked: false,
        }
    }

    fn at(&self, network: &RoadNetwork, here: &Here, time_s: f64) -> Actor {
        let Here { place, pose, lane, crossing } = here;
        let (motion, velocity_mps, behaviour) = match &self.body {
            Body::Vehicle(body) => {
                let along = heading(place.yaw) * place.speed;
                let climbs = endless_world::math::f64::tan(f64::from(pose.pitch_rad)) * place.speed;
                let behaviour = Behaviour {
                    lane: lane.map(|on| LanePlace { lane: on.lane.0, s_m: on.s as f32 }),
                    acceleration_mps2: place.acceleration as f32,
                    indicating: body.indicating,
                    turning: lane.and_then(|on| side_of(network.lane(on.lane).turn)),
                    ..Behaviour::default()
                };
                (body.motion(place), along.extend(climbs), behaviour)
            }
            Body::Person(body) => {
                let stands = place.velocity.length() < STANDS_MPS;
                let underfoot = crossing.filter(|on| on.beyond_m <= 0.0);
                let behaviour = Behaviour {
                    crossing: underfoot.map(|on| on.crossing.0),
                    waiting: stands && underfoot.is_none() && crossing.is_some(),
                    ..Behaviour::default()
                };
                (body.motion(place, time_s), place.velocity.extend(0.0), behaviour)
            }
        };
        Actor { pose: *pose, velocity_mps: velocity_mps.as_vec3(), behaviour, ..self.somewhere(motion) }
    }
}

#[cfg(test)]
mod tests;
