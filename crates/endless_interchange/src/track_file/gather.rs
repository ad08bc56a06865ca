//! From rows in any order to tracks without gaps.

use super::TrackFault;
use super::kind::{Kind, class_of_length, kind_of};
use super::row::Row;
use endless_world::{ObjectClass, Track, TrackPoint, TrackSample};
use std::collections::BTreeMap;

/// Somebody who is missing for longer is gone meanwhile, seconds, unless the file's own steps are longer.
const GAP_S: f64 = 2.0;
/// The same in steps of the file.
const GAP_STEPS: f64 = 1.5;
/// Nobody drives faster: who seems to has been put elsewhere, m/s.
const FASTEST_MPS: f64 = 80.0;
/// Shorter ways may be noise, metres.
const JUMP_M: f64 = 5.0;
/// Names that a note lists.
const LISTED: usize = 3;

/// Collects the rows of a file.
#[derive(Debug, Default)]
pub(super) struct Gatherer {
    by_id: BTreeMap<String, usize>,
    users: Vec<RoadUser>,
    /// Instants that the file tells of, in its order, some more than once.
    instants_s: Vec<f64>,
}

/// All rows of one id.
#[derive(Debug)]
struct RoadUser {
    name: String,
    kind: String,
    on_foot: bool,
    length_m: Option<f64>,
    point: TrackPoint,
    samples: Vec<TrackSample>,
}

/// Things of one kind that a note tells of.
#[derive(Debug, Default)]
struct Noted {
    count: usize,
    names: Vec<String>,
}

impl Noted {
    fn add(&mut self, name: &str) {
        self.count += 1;
        let name: String = name.chars().filter(|c| !c.is_control()).take(40).collect();
        if self.names.len() <= LISTED && !self.names.contains(&name) {
            self.names.push(name);
        }
    }

    /// One line, if there is anything to tell: how many there are, and the names of some.
    fn line(&self, told: impl Fn(&str, &str) -> String) -> Option<String> {
        let listed: Vec<String> = self.names.iter().take(LISTED).map(|name| format!("'{name}'")).collect();
        let more = if self.names.len() > LISTED { ", …" } else { "" };
        let count = format!("{} track{}", self.count, if self.count == 1 { "" } else { "s" });
        (self.count > 0).then(|| told(&count, &format!("{}{more}", listed.join(", "))))
    }
}

impl Gatherer {
    /// Notes that the file tells of an instant, whoever is there.
    pub(super) fn instant(&mut self, time_s: f64) {
        if self.instants_s.last() != Some(&time_s) {
            self.instants_s.push(time_s);
        }
    }

    /// Adds a row. What stays the same of a road user is what the first row says.
    pub(super) fn add(&mut self, row: &Row<'_>) {
        let known = self.by_id.get(row.id).copied();
        let place = known.unwrap_or_else(|| {
            self.by_id.insert(row.id.to_owned(), self.users.len());
            self.users.push(RoadUser {
                name: row.id.to_owned(),
                kind: row.kind.to_owned(),
                on_foot: row.on_foot,
                length_m: row.length_m,
                point: row.point,
                samples: Vec::new(),
            });
            self.users.len() - 1
        });
        self.users[place].samples.push(row.sample);
    }

    /// The tracks, and what had to be guessed or left out.
    ///
    /// # Errors
    /// When there are none, or they are not in metres.
    pub(super) fn finish(self) -> Result<(Vec<Track>, Vec<String>), TrackFault> {
        let gap_s = (GAP_STEPS * usual_step_s(self.instants_s)).max(GAP_S);
        let [mut guessed, mut left_out, mut repeated, mut gaps, mut jumps] = std::array::from_fn(|_| Noted::default());
        let mut tracks = Vec::new();
        for mut user in self.users {
            let Some(class) = user.class(&mut guessed, &mut left_out) else { continue };
            user.samples.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
            let told = user.samples.len();
            user.samples.dedup_by(|later, kept| later.time_s == kept.time_s);
            if user.samples.len() < told {
                repeated.add(&user.name);
            }
            let pieces = user.pieces(gap_s, &mut gaps, &mut jumps);
            let RoadUser { name, kind, length_m, point, .. } = user;
            tracks.push(Track { name, kind, class, length_m, point, pieces });
        }
        if tracks.is_empty() {
            return Err(TrackFault::Empty);
        }
        if geographic(&tracks) {
            return Err(TrackFault::Geographic);
        }
        let notes = [
            guessed.line(|count, names| {
                format!("{count} of a type that is not known ({names}): played as what has their length, else as cars")
            }),
            left_out.line(|count, names| format!("{count} of which there are no models ({names}): left out")),
            repeated.line(|count, names| {
                format!("{count} with several rows of one instant ({names}): the first of these counts")
            }),
            gaps.line(|count, names| {
                format!("{count} with gaps of more than {gap_s:.1} s ({names}): absent meanwhile")
            }),
            jumps.line(|count, names| {
                format!("{count} with jumps faster than {FASTEST_MPS} m/s ({names}): they vanish, and appear elsewhere")
            }),
        ];
        Ok((tracks, notes.into_iter().flatten().collect()))
    }
}

impl RoadUser {
    /// The class, by the name of its type, else by the length; `None` of what there are no models.
    fn class(&self, guessed: &mut Noted, left_out: &mut Noted) -> Option<ObjectClass> {
        match kind_of(&self.kind) {
            // Who walks is no vehicle, whatever the type is called.
            _ if self.on_foot => Some(ObjectClass::Pedestrian),
            Kind::Known(class) => Some(class),
            Kind::NoModels => {
                left_out.add(&self.kind);
                None
            }
            Kind::Unknown => {
                guessed.add(&self.kind);
                Some(self.length_m.map_or(ObjectClass::Car, class_of_length))
            }
        }
    }

    /// The samples, cut where somebody is gone for long or is put elsewhere.
    fn pieces(&self, gap_s: f64, gaps: &mut Noted, jumps: &mut Noted) -> Vec<Vec<TrackSample>> {
        let gap = |a: &TrackSample, b: &TrackSample| b.time_s - a.time_s > gap_s;
        let jump = |a: &TrackSample, b: &TrackSample| {
            let way_m = a.position.distance(b.position);
            way_m > JUMP_M && way_m > FASTEST_MPS * (b.time_s - a.time_s)
        };
        let pairs = || self.samples.windows(2);
        if pairs().any(|pair| gap(&pair[0], &pair[1])) {
            gaps.add(&self.name);
        }
        if pairs().any(|pair| jump(&pair[0], &pair[1])) {
            jumps.add(&self.name);
        }
        self.samples.chunk_by(|a, b| !gap(a, b) && !jump(a, b)).map(<[_]>::to_vec).collect()
    }
}

/// The median of the steps from one instant to the next, seconds.
fn usual_step_s(mut instants_s: Vec<f64>) -> f64 {
    instants_s.sort_by(f64::total_cmp);
    instants_s.dedup();
    let mut steps: Vec<f64> = instants_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// Whether positions are degrees: nobody gets on, although speeds say so.
fn geographic(tracks: &[Track]) -> bool {
    let pairs = || tracks.iter().flat_map(|track| &track.pieces).flat_map(|piece| piece.windows(2));
    let driven = |pair: &[TrackSample]| pair[0].speed_mps.unwrap_or(0.0).abs() * (pair[1].time_s - pair[0].time_s);
    let told_m: f64 = pairs().map(driven).sum();
    let moved: f64 = pairs().map(|pair| pair[0].position.distance(pair[1].position)).sum();
    told_m > 5.0 && moved < 0.01 * told_m
}
