//! Broadleaf trees, in leaf and in winter.

use super::grow::{BranchNode, grow, wood};
use super::leaf::{Clump, Leaves, bark, direction, shades};
use crate::shape::Sculpt;
use endless_scene::{Material, Mesh};
use endless_world::{Stream, math};
use glam::{Affine3A, Vec3};

/// A species: the outline of its crown, its boughs, its leaves.
struct Species {
    height: f32,
    /// Height where the crown begins, over the height.
    fork: f32,
    /// Largest radius of the crown, over the height.
    spread: f32,
    /// Radius over the largest one, at even steps from the crown's foot to its top.
    outline: [f32; 6],
    /// Boughs that bear a cluster of leaves each: many small ones are dense, few leave gaps.
    boughs: usize,
    /// Radius of such a cluster, over the crown's.
    cluster: f32,
    /// Young wood bends down, below zero up.
    droop: f32,
    /// Trunk radius at breast height.
    trunk: f32,
    leaf: f32,
    leaves: usize,
    green: [f32; 3],
    bark: [f32; 3],
}

const PLANE: Species = Species {
    height: 10.8,
    fork: 0.27,
    spread: 0.36,
    outline: [0.55, 0.92, 1.0, 0.93, 0.72, 0.30],
    boughs: 26,
    cluster: 0.36,
    droop: 0.0,
    trunk: 0.21,
    leaf: 0.21,
    leaves: 11_000,
    green: [0.078, 0.138, 0.030],
    bark: [0.30, 0.28, 0.21],
};

const SPECIES: [Species; 8] = [
    PLANE,
    // Lime: a dense heart.
    Species {
        height: 9.8,
        fork: 0.22,
        spread: 0.28,
        outline: [0.80, 1.0, 0.95, 0.80, 0.55, 0.18],
        boughs: 34,
        cluster: 0.36,
        leaf: 0.16,
        leaves: 13_000,
        trunk: 0.17,
        green: [0.060, 0.125, 0.030],
        bark: [0.14, 0.12, 0.10],
        ..PLANE
    },
    // Oak: wide boughs with much air between them.
    Species {
        height: 8.8,
        fork: 0.22,
        spread: 0.47,
        outline: [0.62, 0.95, 1.0, 0.92, 0.72, 0.40],
        boughs: 21,
        cluster: 0.33,
        droop: 0.02,
        leaf: 0.17,
        leaves: 12_500,
        trunk: 0.24,
        green: [0.058, 0.105, 0.024],
        bark: [0.15, 0.13, 0.11],
    },
    // Birch: slender, white, its twigs hang.
    Species {
        height: 10.5,
        fork: 0.20,
        spread: 0.20,
        outline: [0.55, 0.95, 1.0, 0.85, 0.60, 0.25],
        boughs: 24,
        cluster: 0.44,
        droop: 0.16,
        leaf: 0.105,
        leaves: 12_500,
        trunk: 0.12,
        green: [0.100, 0.155, 0.040],
        bark: [0.62, 0.61, 0.57],
    },
    // Maple: a full round crown.
    Species {
        height: 8.6,
        fork: 0.25,
        spread: 0.34,
        outline: [0.60, 0.95, 1.0, 0.95, 0.78, 0.42],
        boughs: 30,
        cluster: 0.34,
        leaf: 0.175,
        leaves: 12_500,
        trunk: 0.16,
        green: [0.082, 0.122, 0.024],
        bark: [0.17, 0.14, 0.11],
        ..PLANE
    },
    // Cherry: a low vase.
    Species {
        height: 6.8,
        fork: 0.24,
        spread: 0.42,
        outline: [0.35, 0.70, 0.95, 1.0, 0.85, 0.45],
        boughs: 24,
        cluster: 0.32,
        droop: -0.04,
        leaf: 0.115,
        leaves: 14_000,
        trunk: 0.13,
        green: [0.085, 0.100, 0.030],
        bark: [0.10, 0.06, 0.05],
    },
    // Poplar: a column.
    Species {
        height: 11.8,
        fork: 0.12,
        spread: 0.125,
        outline: [0.70, 0.95, 1.0, 0.92, 0.72, 0.30],
        boughs: 36,
        cluster: 0.60,
        droop: -0.25,
        leaf: 0.125,
        leaves: 12_500,
        trunk: 0.15,
        green: [0.052, 0.112, 0.028],
        bark: [0.20, 0.19, 0.16],
    },
    // Robinia: light tufts at the ends of crooked boughs.
    Species {
        height: 9.4,
        fork: 0.32,
        spread: 0.33,
        outline: [0.50, 0.80, 1.0, 0.95, 0.80, 0.45],
        boughs: 19,
        cluster: 0.30,
        leaf: 0.12,
        leaves: 11_500,
        trunk: 0.16,
        green: [0.095, 0.155, 0.042],
        bark: [0.13, 0.11, 0.09],
        ..PLANE
    },
];

/// How many broadleaf trees there are.
pub(crate) const BROADLEAF_VARIANTS: u32 = SPECIES.len() as u32;
/// How many trees in winter there are.
pub(crate) const BARE_VARIANTS: u32 = 3;
/// Points of light about each bough.
const LIGHT: usize = 17;

impl Species {
    /// Radius of the crown at a share of its height, metres.
    fn radius(&self, t: f32) -> f32 {
        let x = t.clamp(0.0, 1.0) * 5.0;
        let i = (x as usize).min(4);
        self.spread * self.height * math::lerp(self.outline[i], self.outline[i + 1], x - i as f32)
    }

    /// Centres of clusters: spread over the crown's outline, a few within.
    fn clusters(&self, s: &mut Stream) -> Vec<Vec3> {
        let foot = self.fork * self.height + 0.35;
        let reach = self.cluster * self.spread * self.height;
        let top = self.height - 0.75 * reach;
        (0..self.boughs)
            .map(|i| {
                // Golden angle; more of them where the crown is wide.
                let t = (i as f32 + 0.5 + s.range_f32(-0.4, 0.4)) / self.boughs as f32;
                let (sin, cos) = math::sin_cos(2.4 * i as f32 + s.range_f32(-0.35, 0.35));
                let out = if i % 5 == 4 { s.range_f32(0.1, 0.4) } else { s.range_f32(0.78, 1.02) };
                let r = (self.radius(t) - 0.8 * reach).max(0.12 * reach) * out;
                Vec3::new(cos * r, sin * r, foot + t * (top - foot))
            })
            .collect()
    }

    fn grown(&self, s: &mut Stream) -> (Vec<Vec3>, Vec<BranchNode>) {
        let clusters = self.clusters(s);
        let reach = self.cluster * self.spread * self.height;
        let mut light = Vec::with_capacity(clusters.len() * LIGHT);
        for &centre in &clusters {
            for _ in 0..LIGHT {
                light.push(centre + direction(s) * Vec3::new(1.0, 1.0, 0.72) * (reach * math::pow(s.f32(), 0.4)));
            }
        }
        let nodes = grow(self.fork * self.height, self.trunk, self.droop, light, s);
        (clusters, nodes)
    }
}

/// A broadleaf tree; the variant is its species.
pub(crate) fn broadleaf(variant: u32) -> Mesh {
    let species = &SPECIES[variant as usize % SPECIES.len()];
    let mut s = Stream::named(u64::from(variant), "broadleaf", &[]);
    let (clusters, nodes) = species.grown(&mut s);
    let trunk = wood(&nodes, bark(species.bark));
    let greens = shades(species.green);
    let thin: Vec<&BranchNode> = nodes.iter().filter(|n| n.radius < 0.022).collect();
    let mut leaves = Leaves::default();
    let each = (species.leaves / thin.len().max(1)).max(1);
    let middle = Vec3::Z * (0.5 * (1.0 + species.fork) * species.height);
    for node in &thin {
        let nearest =
            clusters.iter().copied().min_by(|a, b| a.distance_squared(node.at).total_cmp(&b.distance_squared(node.at)));
        // Lit as the cluster and the crown are round.
        let of_cluster = (node.at - nearest.unwrap_or(middle)).normalize_or(Vec3::Z);
        let out =
            (0.7 * of_cluster + 0.6 * (node.at - middle).normalize_or(Vec3::Z) + Vec3::Z * 0.2).normalize_or(Vec3::Z);
        let hang = Vec3::NEG_Z * species.droop * 0.9;
        let centre = node.at + hang + out * 0.06;
        leaves.clump(&Clump { centre, radius: 0.30, count: each, size: species.leaf, out }, &greens, &mut s);
    }
    let mut mesh = trunk.into_mesh();
    mesh.append(&leaves.finish(), Affine3A::IDENTITY);
    mesh
}

/// A tree without leaves, down to its twigs.
pub(crate) fn bare(variant: u32) -> Mesh {
    let species = &SPECIES[[2, 4, 3][variant as usize % 3]];
    let mut s = Stream::named(u64::from(variant), "bare tree", &[]);
    let (_, nodes) = species.grown(&mut s);
    let material = bark(species.bark.map(|c| 0.85 * c));
    let mut trunk = wood(&nodes, material);
    let twig = Material { base_color: [0.10, 0.075, 0.06], ..material };
    for node in nodes.iter().skip(1).filter(|n| n.radius < 0.03) {
        let along = (node.at - nodes[node.parent].at).normalize_or(Vec3::Z);
        for _ in 0..if node.children == 0 { 5 } else { 2 } {
            let way = (along + direction(&mut s) * 0.9 - Vec3::Z * (1.5 * species.droop)).normalize_or(along);
            let length = s.range_f32(0.28, 0.6);
            let bent = (way + Vec3::Z * 0.35).normalize_or(way);
            let elbow = node.at + way * length * 0.5;
            trunk.add(Sculpt::tube(&[(node.at, 0.008), (elbow, 0.006), (elbow + bent * length * 0.5, 0.003)], 3, twig));
        }
    }
    trunk.into_mesh()
}
