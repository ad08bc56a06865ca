//! Draws who walks with whom.

use crate::company::{ABREAST_M, Company};
use crate::roads::Roads;
use crate::walk_strip::DirectedEdge;
use crate::walker::Walker;
use endless_road::WalkGraph;
use endless_world::walking::PedestrianSpec;
use endless_world::{LookPool, Stream};
use glam::DVec2;

/// Relative frequencies of groups of two, three and four: Poisson's, without single people (Moussaïd et al. 2010, figure 2),
/// with a mean of 0.83.
const SIZES: [f64; 3] = [0.75, 0.21, 0.04];
/// Mean of those sizes.
const MEAN_SIZE: f64 = 2.29;
/// Smaller people are children, who go with a grown-up, metres; the share of those in groups, and looks tried for one.
const CHILD_M: f32 = 1.4;
const CHILDREN: f64 = 0.15;
const LOOKS: u32 = 24;

/// Makes groups of people as they are spawned one after another.
#[derive(Debug)]
pub(crate) struct CompanyDraw {
    seed: u64,
    share: f64,
    /// The first of the group that is being made, and how many are to come.
    first: usize,
    wanted: usize,
}

impl CompanyDraw {
    /// A share of people is in groups.
    pub(crate) fn new(seed: u64, share: f64) -> Self {
        Self { seed, share, first: 0, wanted: 0 }
    }

    /// Whether the next one joins those that were placed last.
    pub(crate) fn joins(&self) -> bool {
        self.wanted > 0
    }

    /// Begins a group with the one who was just placed, or leaves them alone.
    pub(crate) fn begin(&mut self, placed: &[Walker]) {
        if self.share <= 0.0 {
            return;
        }
        self.first = placed.len() - 1;
        let mut own = Stream::named(self.seed, "traffic.company", &[self.first as u64]);
        // Of so many groups among all groups and single people, the share of people follows.
        let groups = self.share / (MEAN_SIZE - self.share * (MEAN_SIZE - 1.0));
        self.wanted = if own.chance(groups) { 1 + own.weighted(&SIZES) } else { 0 };
    }

    /// The first of the group that is being made.
    pub(crate) fn first<'a>(&self, placed: &'a [Walker]) -> &'a Walker {
        &placed[self.first]
    }

    /// Where the next one would stand beside the first of the group.
    pub(crate) fn place(&self, roads: &Roads, placed: &[Walker], apart_m: f64) -> Option<DVec2> {
        let first = &placed[self.first];
        let (edge, to) = first.way[0];
        let strip = DirectedEdge::new(roads, first.from, edge, to);
        let (along, left) = strip.local(first.position);
        let free =
            |at: &DVec2| strip.outside(*at) <= 0.0 && placed.iter().all(|other| other.position.distance(*at) > apart_m);
        let rows =
            [[0.0, 1.0], [0.0, -1.0], [0.0, 2.0], [0.0, -2.0], [-1.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [-1.0, -1.0]];
        let places = rows.map(|[back, side]| strip.point(along + back * ABREAST_M, left + side * ABREAST_M));
        places.into_iter().find(free)
    }

    /// One has joined, or found no room.
    pub(crate) fn joined(&mut self) {
        self.wanted -= 1;
    }

    /// Makes those who were placed together a company, once nobody is to come any more.
    pub(crate) fn finish(&mut self, roads: &Roads, graph: &WalkGraph, placed: &mut [Walker]) {
        let members = self.first..placed.len();
        if self.wanted > 0 || members.len() < 2 || placed[self.first].company.is_some() {
            return;
        }
        let goals = Stream::named(self.seed, "traffic.company.goals", &[self.first as u64]);
        let pace = placed[members.clone()].iter().map(|walker| walker.pace).fold(f64::INFINITY, f64::min);
        let middle = 0.5 * (members.len() as f64 - 1.0);
        // From the left to the right as they stand.
        let strip =
            DirectedEdge::new(roads, placed[self.first].from, placed[self.first].way[0].0, placed[self.first].way[0].1);
        let mut order: Vec<usize> = members.clone().collect();
        order.sort_by(|&a, &b| strip.local(placed[a].position).1.total_cmp(&strip.local(placed[b].position).1));
        let company = Company { members: members.clone(), slot: 0.0, goals, talk: None, waited_s: 0.0 };
        let first = &mut placed[self.first];
        first.company = Some(Box::new(company));
        first.way.truncate(1);
        first.plan(roads, graph);
        let (way, side) = (first.way.clone(), first.side);
        let company = first.company.clone();
        for (slot, number) in order.into_iter().enumerate() {
            let walker = &mut placed[number];
            walker.company =
                company.clone().map(|company| Box::new(Company { slot: slot as f64 - middle, ..*company }));
            (walker.way, walker.side, walker.pace, walker.jaywalks) = (way.clone(), side, pace, false);
        }
    }
}

/// A look for somebody who comes alone, or with others: children come with a grown-up.
pub(crate) fn look_for(
    first: Option<&Walker>,
    pedestrian: &dyn Fn(u64) -> PedestrianSpec,
    placed: &[Walker],
    own: &mut Stream,
) -> u64 {
    let child = |variant: u64| pedestrian(variant).height_m < CHILD_M;
    let wants_child = first.is_some_and(|first| !child(first.variant)) && own.chance(CHILDREN);
    let mut look = || LookPool::people().draw(own.next_u64(), |seed| placed.iter().any(|w| w.variant == seed));
    let looks: Vec<u64> = (0..LOOKS).map(|_| look()).collect();
    looks.iter().copied().find(|variant| child(*variant) == wants_child).unwrap_or(looks[0])
}
