//! Traversal by eight rays that run side by side: nodes are entered by the interval of all rays, triangles tested
//! by all rays at once (after Boulos et al.: Packet-based Whitted and distribution ray tracing, GI 2007).
//!
//! Each lane does the very arithmetic of a single ray, and the interval enters every box that one of its rays
//! enters, so results are those of single rays to the bit.

use super::node::{Beam, Link, Node};
use super::packet_ray::PacketRay;
use super::ray::{Hit, LocalRay, Ray};
use super::single::trace_blas;
use super::stack::Stack;
use super::tlas::{Accel, Entry};
use wide::f32x8;

/// With this few lanes left single rays are faster.
const FEW: u32 = 2;

impl Accel {
    /// [`Accel::closest`] for those of eight rays whose bit is set in `active`; faster when they run side by side.
    pub fn closest8(&self, rays: &[Ray; 8], active: u8) -> [Option<Hit>; 8] {
        let trip = self.trace8::<false>(rays, active);
        std::array::from_fn(|lane| if active >> lane & 1 != 0 { trip.best[lane].found() } else { None })
    }

    /// [`Accel::occluded`] for those of eight rays whose bit is set in `active`, one bit each.
    pub fn occluded8(&self, rays: &[Ray; 8], active: u8) -> u8 {
        active & !(self.trace8::<true>(rays, active).live as u8)
    }

    #[inline(always)]
    fn trace8<const ANY: bool>(&self, rays: &[Ray; 8], active: u8) -> Trip {
        let mut trip = Trip::new(rays, active);
        let packet = if active.count_ones() > FEW { PacketRay::in_world(rays, active) } else { None };
        let Some(packet) = packet else {
            for lane in lanes(trip.live) {
                if ANY && self.occluded(&rays[lane]) {
                    trip.live &= !(1 << lane);
                } else if !ANY && let Some(hit) = self.closest(&rays[lane]) {
                    trip.improve(lane, hit);
                }
            }
            return trip;
        };
        let mut stack = Stack::new();
        walk::<ANY>(self.nodes(), self.root(), &packet, &mut trip, &mut stack, |link, trip, stack| {
            self.entry(link).trace8::<ANY>(rays, &packet, trip, stack);
        });
        trip
    }
}

/// How far eight rays have come.
pub(super) struct Trip {
    /// Lanes still to trace, one bit each.
    pub(super) live: u32,
    best: [Hit; 8],
    /// `t` of each `best`, side by side: boxes are tested against it.
    pub(super) ends: f32x8,
    /// Largest of those of the live lanes.
    pub(super) reach: f32,
}

impl Trip {
    fn new(rays: &[Ray; 8], active: u8) -> Self {
        let best = rays.map(|ray| Hit::none(ray.tmax));
        let ends = f32x8::new(best.map(|hit| hit.t));
        let mut trip = Trip { live: u32::from(active), best, ends, reach: 0.0 };
        trip.update_reach();
        trip
    }

    pub(super) fn update_reach(&mut self) {
        let ends = self.ends.as_array();
        self.reach = lanes(self.live).map(|lane| ends[lane]).fold(0.0, f32::max);
    }

    /// The best hit of a lane so far.
    #[inline]
    pub(super) fn best(&self, lane: usize) -> &Hit {
        &self.best[lane]
    }

    /// A better one.
    #[inline]
    pub(super) fn improve(&mut self, lane: usize, hit: Hit) {
        self.best[lane] = hit;
        self.ends.as_mut_array()[lane] = hit.t;
    }
}

/// The lanes of a mask.
pub(super) fn lanes(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < 8).then_some(lane)
    })
}

impl Entry {
    #[inline(always)]
    fn trace8<const ANY: bool>(&self, rays: &[Ray; 8], world: &PacketRay, trip: &mut Trip, stack: &mut Stack) {
        let (min, max) = self.bounds;
        let (entered, tnear) = world.enter(min.to_array(), max.to_array(), trip);
        if entered == 0 {
            return;
        }
        let (tmin, local) = match &self.object_from_world {
            None => (None, None),
            Some(transform) => (Some(tnear), world.transformed(transform)),
        };
        let packet = match (&self.object_from_world, &local) {
            (None, _) => Some(world),
            (Some(_), local) => local.as_ref(),
        };
        match packet {
            Some(packet) if entered.count_ones() > FEW => {
                let outside = trip.live & !entered;
                trip.live = entered;
                trip.update_reach();
                let groups = self.blas.groups();
                walk::<ANY>(self.blas.nodes(), self.root, packet, trip, stack, |link, trip, _| {
                    for group in &groups[link.range()] {
                        packet.intersect::<ANY>(group, tmin.as_ref(), trip, self.instance);
                    }
                });
                trip.live |= outside;
            }
            _ => {
                for lane in lanes(entered) {
                    let tmin = tmin.map_or(0.0, |t| t[lane]);
                    let mut best = *trip.best(lane);
                    let found = self.trace_lane::<ANY>(&rays[lane], tmin, &mut best, stack);
                    trip.improve(lane, best);
                    if found && ANY {
                        trip.live &= !(1 << lane);
                    }
                }
            }
        }
        trip.update_reach();
    }

    #[inline(never)]
    fn trace_lane<const ANY: bool>(&self, ray: &Ray, tmin: f32, best: &mut Hit, stack: &mut Stack) -> bool {
        let local = match &self.object_from_world {
            None => LocalRay::new(ray.origin, ray.direction),
            Some(transform) => LocalRay::new(transform.point(ray.origin), transform.vector(ray.direction)),
        };
        let beam = Beam::of_ray(&local);
        trace_blas::<ANY>(&self.blas, self.root, self.instance, &local, &beam, tmin, best, stack)
    }
}

/// Visits the leaves that the beam may enter before `trip.reach`, until no lane is live.
#[inline(always)]
fn walk<const ANY: bool>(
    nodes: &[Node],
    root: Link,
    packet: &PacketRay,
    trip: &mut Trip,
    stack: &mut Stack,
    mut leaf: impl FnMut(Link, &mut Trip, &mut Stack),
) {
    if root == Link::EMPTY {
        return;
    }
    let base = stack.len();
    let mut next = Some((root, 0.0));
    while let Some((mut link, tnear)) = next {
        if tnear <= trip.reach {
            loop {
                if link.is_leaf() {
                    leaf(link, trip, stack);
                    if ANY && trip.live == 0 {
                        stack.truncate(base);
                        return;
                    }
                    break;
                }
                // Only rays that are not finite enter empty slots.
                let Some(node) = nodes.get(link.node()) else { break };
                let (mut hits, tnears) = node.enter(&packet.beam, trip.reach);
                if hits == 0 {
                    break;
                }
                let tnears = tnears.as_array();
                let from = stack.len();
                while hits != 0 {
                    let slot = hits.trailing_zeros() as usize & 7;
                    hits &= hits - 1;
                    let (min, max) = node.child_box(slot);
                    if packet.enter(min.to_array(), max.to_array(), trip).0 != 0 {
                        stack.push(node.links[slot], tnears[slot]);
                    }
                }
                if !ANY {
                    stack.sort_from(from);
                }
                match stack.pop(from) {
                    Some((nearest, _)) => link = nearest,
                    None => break,
                }
            }
        }
        next = stack.pop(base);
    }
}
