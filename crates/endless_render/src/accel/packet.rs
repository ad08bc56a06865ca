//! Traversal by rays that run side by side, eight or four times eight: nodes are entered by the interval of all rays,
//! boxes and triangles tested by eight rays at once (after Boulos et al.: Packet-based Whitted and distribution ray
//! tracing, GI 2007), while the next eight are on their way.
//!
//! Each lane does the very arithmetic of a single ray, and the interval enters every box that one of its rays
//! enters, so results are those of single rays to the bit.

use wide::f32x8;

use super::node::{BvhNode, NodeLink, Slab, SlabRay};
use super::octants::Octants;
use super::packet_ray::PacketRay;
use super::packet_traversal::PacketTraversal;
use super::ray::{Hit, LocalRay, Ray};
use super::stack::{NearestChildren, PendingNode, Stack};
use super::stream::{RayStream, RowMask, StreamHits, lanes};
use super::tlas::{Tlas, TlasEntry};

/// With no more lanes than this, single rays are faster.
const FEW: u32 = 2;

impl Tlas {
    /// [`Tlas::closest`] for those of eight rays whose bit is set in `active`; faster when they run side by side.
    pub fn closest8(&self, rays: &[Ray; 8], active: u8) -> [Option<Hit>; 8] {
        let rays = RayStream::of(std::array::from_ref(rays));
        let hits = self.trace_together::<false, 1>(&rays, u32::from(active)).hits(u32::from(active));
        std::array::from_fn(|lane| hits.get(lane))
    }

    /// [`Tlas::occluded`] for those of eight rays whose bit is set in `active`, one bit each.
    pub fn occluded8(&self, rays: &[Ray; 8], active: u8) -> u8 {
        let rays = RayStream::of(std::array::from_ref(rays));
        active & !(self.trace_together::<true, 1>(&rays, u32::from(active)).live as u8)
    }

    /// [`Tlas::closest`] for those of a bundle's rays whose bit is set in `active`.
    pub fn closest32(&self, rays: &RayStream<4>, active: u32) -> StreamHits<4> {
        self.trace_together::<false, 4>(rays, active).hits(active)
    }

    /// The same for rays of which only eight neighbours have much in common.
    pub fn closest_by_rows(&self, rays: &RayStream<4>, active: u32) -> StreamHits<4> {
        let mut trip = PacketTraversal::new(rays, active);
        self.trace_rows::<false, 4>(rays, active, &mut trip, &mut Stack::new());
        trip.hits(active)
    }

    /// [`Tlas::occluded`] for those of a bundle's rays whose bit is set in `active`, one bit each.
    pub fn occluded32(&self, rays: &RayStream<4>, active: u32) -> u32 {
        active & !self.trace_together::<true, 4>(rays, active).live
    }

    #[inline(always)]
    fn trace_together<const ANY: bool, const N: usize>(&self, rays: &RayStream<N>, active: u32) -> PacketTraversal<N> {
        let mut trip = PacketTraversal::new(rays, active);
        let mut stack = Stack::new();
        match packet_of(rays, active) {
            Some(packet) => {
                let rows = RowMask::of(active);
                walk::<ANY, N>(
                    self.nodes(),
                    self.root(),
                    rows,
                    &packet,
                    &mut trip,
                    &mut stack,
                    |link, rows, trip, stack| {
                        self.entry(link).trace_packet::<ANY, N>(rays, &packet, rows, trip, stack);
                    },
                );
            }
            None if N > 1 => self.trace_octants::<ANY, N>(rays, active, &mut trip, &mut stack),
            None => self.trace_singly::<ANY, N>(rays, &mut trip),
        }
        trip
    }

    /// Rays of which some point to other octants than others, as those to a sun that stands in the south: those of each octant
    /// and main axis go together. Where these are too many, eight neighbours do.
    #[inline(never)]
    fn trace_octants<const ANY: bool, const N: usize>(
        &self,
        rays: &RayStream<N>,
        active: u32,
        trip: &mut PacketTraversal<N>,
        stack: &mut Stack,
    ) {
        /// With fewer lanes to each, rows of neighbours are faster.
        const MANY: u32 = 8;
        let octants = Octants::of(rays);
        let mut left = active;
        while left != 0 {
            let alike = octants.like_first(left);
            left &= !alike;
            let packet = if alike.count_ones() < MANY { None } else { packet_of(rays, alike) };
            let others = trip.live & !alike;
            trip.live &= alike;
            trip.update_reach();
            match packet {
                Some(packet) => {
                    let rows = RowMask::of(alike);
                    walk::<ANY, N>(self.nodes(), self.root(), rows, &packet, trip, stack, |link, rows, trip, stack| {
                        self.entry(link).trace_packet::<ANY, N>(rays, &packet, rows, trip, stack);
                    });
                }
                None => self.trace_rows::<ANY, N>(rays, alike, trip, stack),
            }
            trip.live |= others;
        }
    }

    /// Each row of these lanes, which are those that are live.
    fn trace_rows<const ANY: bool, const N: usize>(
        &self,
        rays: &RayStream<N>,
        lanes: u32,
        trip: &mut PacketTraversal<N>,
        stack: &mut Stack,
    ) {
        for row in RowMask::of(lanes).each::<N>() {
            let mut part = trip.row(row);
            self.trace_row::<ANY>(&rays.row(row), &mut part, stack);
            trip.set_row(row, &part);
        }
    }

    #[inline(never)]
    fn trace_row<const ANY: bool>(&self, rays: &RayStream<1>, trip: &mut PacketTraversal<1>, stack: &mut Stack) {
        match packet_of(rays, trip.live) {
            Some(packet) => {
                let rows = RowMask::of(trip.live);
                walk::<ANY, 1>(self.nodes(), self.root(), rows, &packet, trip, stack, |link, rows, trip, stack| {
                    self.entry(link).trace_packet::<ANY, 1>(rays, &packet, rows, trip, stack);
                });
            }
            None => self.trace_singly::<ANY, 1>(rays, trip),
        }
    }

    fn trace_singly<const ANY: bool, const N: usize>(&self, rays: &RayStream<N>, trip: &mut PacketTraversal<N>) {
        for lane in lanes(trip.live) {
            let ray = rays.ray(lane);
            if ANY && self.occluded(&ray) {
                trip.live &= !(1 << lane);
            } else if !ANY && let Some(hit) = self.closest(&ray) {
                trip.improve(lane, hit);
            }
        }
    }
}

/// Whether these lanes are enough to go together, and lie in more than one row if there are rows.
fn is_packet_worthwhile<const N: usize>(lanes: u32) -> bool {
    lanes.count_ones() > FEW && (N == 1 || RowMask::of(lanes).several())
}

/// These lanes as a packet, if that is worth it and their directions agree.
#[inline(always)]
fn packet_of<const N: usize>(rays: &RayStream<N>, lanes: u32) -> Option<PacketRay<N>> {
    if is_packet_worthwhile::<N>(lanes) { PacketRay::in_world(rays, lanes) } else { None }
}

impl TlasEntry {
    #[inline(always)]
    fn trace_packet<const ANY: bool, const N: usize>(
        &self,
        rays: &RayStream<N>,
        world: &PacketRay<N>,
        rows: RowMask,
        trip: &mut PacketTraversal<N>,
        stack: &mut Stack,
    ) {
        let (min, max) = self.bounds;
        let slab = Slab::of(min.to_array(), max.to_array(), world.negative);
        let (entered, tnear) = world.enter(&slab, rows, trip);
        if entered == 0 {
            return;
        }
        let local;
        let packet = match &self.object_from_world {
            _ if !is_packet_worthwhile::<N>(entered) => None,
            None => Some(world),
            Some(transform) => {
                local = world.transformed(transform);
                local.as_ref()
            }
        };
        match packet {
            Some(packet) => self.trace_blas_by_packet::<ANY, N>(packet, &tnear, entered, trip, stack),
            None if N > 1 && entered.count_ones() > FEW => {
                for row in RowMask::of(entered).each::<N>() {
                    let mut part = trip.row(row);
                    let entered = entered >> (8 * row) & 255;
                    self.trace_row::<ANY>(&rays.row(row), &[tnear[row]], entered, &mut part, stack);
                    trip.set_row(row, &part);
                }
            }
            None => self.trace_lanes::<ANY, N>(rays, &tnear, entered, trip, stack),
        }
        trip.update_reach();
    }

    /// Those of eight rays that `entered`, when more are too many or too unlike to go together.
    #[inline(never)]
    fn trace_row<const ANY: bool>(
        &self,
        rays: &RayStream<1>,
        tnear: &[f32x8; 1],
        entered: u32,
        trip: &mut PacketTraversal<1>,
        stack: &mut Stack,
    ) {
        let local = packet_of(rays, entered).and_then(|world| match &self.object_from_world {
            Some(transform) => world.transformed(transform),
            None => Some(world),
        });
        match local {
            Some(packet) => self.trace_blas_by_packet::<ANY, 1>(&packet, tnear, entered, trip, stack),
            None => self.trace_lanes::<ANY, 1>(rays, tnear, entered, trip, stack),
        }
    }

    fn trace_lanes<const ANY: bool, const N: usize>(
        &self,
        rays: &RayStream<N>,
        tnear: &[f32x8; N],
        entered: u32,
        trip: &mut PacketTraversal<N>,
        stack: &mut Stack,
    ) {
        for lane in lanes(entered) {
            let tmin = self.object_from_world.as_ref().map_or(0.0, |_| tnear[lane / 8 % N].as_array()[lane % 8]);
            let mut best = *trip.best(lane);
            let found = self.trace_lane::<ANY>(&rays.ray(lane), tmin, &mut best, stack);
            trip.improve(lane, best);
            if found && ANY {
                trip.live &= !(1 << lane);
            }
        }
    }

    #[inline(always)]
    fn trace_blas_by_packet<const ANY: bool, const N: usize>(
        &self,
        packet: &PacketRay<N>,
        tnear: &[f32x8; N],
        entered: u32,
        trip: &mut PacketTraversal<N>,
        stack: &mut Stack,
    ) {
        // In the frame of an instance a hit may seem to lie before the box in the world that was entered.
        let tmin = self.object_from_world.as_ref().map(|_| tnear);
        let outside = trip.live & !entered;
        trip.live &= entered;
        trip.update_reach();
        let groups = self.blas.groups();
        let rows = RowMask::of(entered);
        walk::<ANY, N>(self.blas.nodes(), self.root, rows, packet, trip, stack, |link, rows, trip, _| {
            for group in &groups[link.range()] {
                packet.intersect::<ANY>(group, rows, tmin, trip, self.instance);
            }
        });
        trip.live |= outside;
    }

    #[inline(never)]
    fn trace_lane<const ANY: bool>(&self, ray: &Ray, tmin: f32, best: &mut Hit, stack: &mut Stack) -> bool {
        let local = match &self.object_from_world {
            None => LocalRay::new(ray.origin, ray.direction),
            Some(transform) => LocalRay::new(transform.point(ray.origin), transform.vector(ray.direction)),
        };
        let slab_ray = SlabRay::of_ray(&local);
        self.trace_mesh::<ANY>(&local, &slab_ray, tmin, best, stack)
    }
}

/// Visits the leaves that the rays may enter before `trip.reach`, until no lane is live, with the rows that enter them:
/// what passes by a box passes by all that is in it.
#[inline(always)]
fn walk<const ANY: bool, const N: usize>(
    nodes: &[BvhNode],
    root: NodeLink,
    rows: RowMask,
    packet: &PacketRay<N>,
    trip: &mut PacketTraversal<N>,
    stack: &mut Stack,
    mut leaf: impl FnMut(NodeLink, RowMask, &mut PacketTraversal<N>, &mut Stack),
) {
    if root == NodeLink::EMPTY {
        return;
    }
    let base = stack.len();
    let mut next = Some((root, rows.with_distance::<N>(0.0)));
    while let Some((mut link, marked)) = next {
        let (mut rows, tnear) = RowMask::and_distance::<N>(marked);
        if tnear <= trip.reach {
            loop {
                if link.is_leaf() {
                    leaf(link, rows, trip, stack);
                    if ANY && trip.live == 0 {
                        stack.truncate(base);
                        return;
                    }
                    break;
                }
                // Only rays that are not finite enter empty slots.
                let Some(node) = nodes.get(link.node()) else { break };
                let (mut hits, tnears) = node.enter(&packet.slab_ray, trip.reach);
                if hits == 0 {
                    break;
                }
                let tnears = tnears.as_array();
                let from = stack.len();
                let planes = node.facing(packet.negative);
                let mut nearest = NearestChildren::NONE;
                while hits != 0 {
                    let slot = hits.trailing_zeros() as usize & 7;
                    hits &= hits - 1;
                    let entered = packet.enters(&Slab::of_child(planes, slot), rows, trip);
                    if entered == RowMask::NONE {
                        continue;
                    }
                    let child = PendingNode::new(node.links[slot], entered.with_distance::<N>(tnears[slot]));
                    if ANY {
                        stack.push(child);
                    } else {
                        stack.push_any(nearest.keep(child));
                    }
                }
                let first = if ANY {
                    stack.pop(from)
                } else {
                    stack.push_any(nearest.second);
                    (nearest.first != PendingNode::NOTHING).then_some(nearest.first)
                };
                let Some(first) = first else { break };
                let (first, marked) = first.parts();
                (link, rows) = (first, RowMask::and_distance::<N>(marked).0);
            }
        }
        next = stack.pop(base).map(PendingNode::parts);
    }
}
