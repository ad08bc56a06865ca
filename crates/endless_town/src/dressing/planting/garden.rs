//! What lies around houses: ways to doors, drives with a car, forecourts, hedges and fences.

use crate::building::BuildingKind;
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::built_up::growth::FrontYard;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::surface::quad;
use crate::geometry::{OccupiedSpace, Rect};
use crate::palette::{GRAVEL, YARD};
use endless_asset::Prop;
use endless_scene::{Material, MeshBuilder};
use endless_world::math::f64::atan2;
use endless_world::{ParkedVehicle, Pose, Stream, VehicleRef};
use glam::DVec2;

/// Thickness of what is laid, and distance between its corners on uneven land, metres.
const SLAB_M: f64 = 0.03;
const STEP_M: f64 = 1.5;
/// Forecourts deeper than this have cars on them, metres.
const BAY_M: f64 = 5.3;
/// Share of drives and of bays on forecourts with a car.
const ON_DRIVES: f64 = 0.5;
const ON_FORECOURTS: f64 = 0.4;
/// Half the width of a way to a door, and of a drive, metres.
const DOORWAY_M: f64 = 0.7;
const DRIVE_M: f64 = 1.35;
/// Most parked vehicles of a town: instance ids are few.
const MOST: usize = 2500;

/// A house as its front garden sees it: `x` along the front wall, `y` from it towards the road.
struct GardenFrame {
    middle: DVec2,
    axis: DVec2,
    half: f64,
    depth: f64,
}

impl GardenFrame {
    fn of(yard: &FrontYard) -> Self {
        let out = -yard.rect.axis.perp();
        let middle = yard.rect.centre + out * yard.rect.half.y;
        Self { middle, axis: yard.rect.axis, half: yard.rect.half.x, depth: yard.front_m }
    }

    fn at(&self, x: f64, y: f64) -> DVec2 {
        self.middle + self.axis * x - self.axis.perp() * y
    }

    fn rect(&self, x: [f64; 2], y: [f64; 2]) -> Rect {
        let half = DVec2::new(x[1] - x[0], y[1] - y[0]) / 2.0;
        Rect { centre: self.at(0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])), half, axis: self.axis }
    }
}

/// Lays gardens out.
pub(crate) struct GardenBuilder<'a> {
    pub(crate) pavement: &'a PavementIndex,
    pub(crate) land: &'a GroundGrid,
}

impl GardenBuilder<'_> {
    /// Ways, drives and forecourts, with the cars on them; before any camera. Returns where forecourts are.
    pub(crate) fn pave(
        &self,
        yards: &[FrontYard],
        mesh: &mut MeshBuilder,
        assembly: &mut TownAssembly<'_>,
    ) -> OccupiedSpace {
        let mut forecourts = OccupiedSpace::default();
        for (i, yard) in yards.iter().enumerate() {
            let front = GardenFrame::of(yard);
            let mut stream = assembly.stream(100_000 + i as u64);
            match yard.kind {
                BuildingKind::House | BuildingKind::Flats => {
                    let half = if yard.kind == BuildingKind::House { DOORWAY_M } else { 2.0 * DOORWAY_M };
                    let material = *stream.pick(&[YARD, YARD, GRAVEL]);
                    let (x, y) = ([-half, half], [0.02, front.depth]);
                    if self.is_open(&front.rect(x, [0.1, front.depth - 0.1])) {
                        self.slab(mesh, &front, x, y, material);
                        assembly.occupied.take(front.rect(x, [0.3, front.depth.max(0.6)]));
                    }
                    if yard.kind == BuildingKind::House {
                        self.drive(mesh, &front, material, assembly, &mut stream);
                    }
                }
                BuildingKind::Barn => {}
                _ => {
                    if self.forecourt(mesh, &front, yard.kind, assembly, &mut stream) {
                        forecourts.take(front.rect([-front.half, front.half], [0.0, front.depth]));
                    }
                }
            }
        }
        forecourts
    }

    /// A drive beside a house, where there is room.
    fn drive(
        &self,
        mesh: &mut MeshBuilder,
        front: &GardenFrame,
        material: Material,
        assembly: &mut TownAssembly<'_>,
        stream: &mut Stream,
    ) {
        let side = if stream.chance(0.5) { 1.0 } else { -1.0 };
        let (with_car, turned) = (stream.chance(ON_DRIVES), stream.chance(0.7));
        for side in [side, -side] {
            let middle = side * (front.half + 0.75 + DRIVE_M);
            let (x, y) = ([middle - DRIVE_M, middle + DRIVE_M], [-3.2, front.depth]);
            let rect = front.rect(x, [y[0], y[1] - 0.1]);
            if !self.is_open(&rect) || !assembly.occupied.try_take(rect) {
                continue;
            }
            self.slab(mesh, front, x, y, material);
            if with_car {
                let at = front.at(middle + stream.range_f64(-0.08, 0.08), (y[0] + 2.6).min(front.depth - 2.6));
                self.car(assembly, at, front, turned, stream);
            }
            return;
        }
    }

    /// The whole ground before shops, offices and halls, where it is open: whether it is.
    fn forecourt(
        &self,
        mesh: &mut MeshBuilder,
        front: &GardenFrame,
        kind: BuildingKind,
        assembly: &mut TownAssembly<'_>,
        stream: &mut Stream,
    ) -> bool {
        let x = [-front.half, front.half];
        let rect = front.rect(x, [0.1, front.depth - 0.1]);
        if !self.is_open(&rect)
            || (front.depth > 0.8 && !assembly.occupied.is_free(&front.rect(x, [0.7, front.depth - 0.1])))
        {
            return false;
        }
        self.slab(mesh, front, x, [0.02, front.depth], YARD);
        if front.depth < BAY_M || !matches!(kind, BuildingKind::Shop | BuildingKind::Hall) {
            return true;
        }
        let mut x = -front.half + 1.6;
        while x < front.half - 1.6 {
            // Doors and gates in the middle stay free.
            if x.abs() > 2.8 && stream.chance(ON_FORECOURTS) {
                let at = front.at(x, 2.75);
                let bay = front.rect([x - 1.15, x + 1.15], [0.35, 5.2]);
                if assembly.occupied.try_take(bay) {
                    self.car(assembly, at, front, stream.chance(0.7), stream);
                }
            }
            x += 2.7;
        }
        true
    }

    /// Hedges, fences and railings along front gardens, and hedges between them; where no camera stands.
    pub(crate) fn fence(&self, yards: &[FrontYard], assembly: &mut TownAssembly<'_>) {
        for (i, yard) in yards.iter().enumerate().filter(|(_, y)| y.kind == BuildingKind::House && y.front_m > 2.0) {
            let front = GardenFrame::of(yard);
            let mut stream = assembly.stream(110_000 + i as u64);
            let reach = front.half + 1.4;
            let (prop, length) = match stream.below(5) {
                0 | 1 => (Prop::Hedge, 1.0),
                2 => (Prop::FencePanel, 2.0),
                3 => (Prop::Railing, 2.0),
                _ => continue,
            };
            let y = front.depth - 0.5;
            self.row(assembly, prop, length, front.at(-reach, y), front.at(reach, y));
            for side in [-1.0, 1.0] {
                if stream.chance(0.6) {
                    let x = side * (reach + 0.2);
                    let back = -2.0 * yard.rect.half.y - 4.0;
                    self.row(assembly, Prop::Hedge, 1.0, front.at(x, y - 0.6), front.at(x, back));
                }
            }
        }
    }

    /// A row of pieces, leaving gaps where something is.
    fn row(&self, assembly: &mut TownAssembly<'_>, prop: Prop, length: f64, from: DVec2, to: DVec2) {
        let along = (to - from).normalize_or(DVec2::X);
        let count = (from.distance(to) / length).floor() as usize;
        for k in 0..count {
            let at = from + along * (length * (k as f64 + 0.5));
            let half = DVec2::new(length / 2.0 - 0.02, 0.3);
            let spot = PropPose { z: self.land.height(at) - 0.02, ..PropPose::new(at, atan2(along.y, along.x)) };
            if self.is_open(&Rect::new(at, half, spot.yaw)) {
                assembly.put(prop, spot, half, None);
            }
        }
    }

    /// Whether no pavement lies there.
    fn is_open(&self, rect: &Rect) -> bool {
        let (nx, ny) = ((rect.half.x * 2.0).ceil().max(1.0) as i32, (rect.half.y * 2.0).ceil().max(1.0) as i32);
        let share = |i: i32, n: i32| 2.0 * f64::from(i) / f64::from(n) - 1.0;
        (0..=nx).all(|i| {
            (0..=ny).all(|j| {
                let p = rect.axis * (rect.half.x * share(i, nx)) + rect.axis.perp() * (rect.half.y * share(j, ny));
                !self.pavement.is_paved(rect.centre + p)
            })
        })
    }

    /// A slab that follows the land.
    fn slab(&self, mesh: &mut MeshBuilder, front: &GardenFrame, x: [f64; 2], y: [f64; 2], material: Material) {
        if y[1] - y[0] < 0.05 {
            return;
        }
        let count = |from: f64, to: f64| ((to - from) / STEP_M).ceil().max(1.0) as usize;
        let (nx, ny) = (count(x[0], x[1]), count(y[0], y[1]));
        let corner = |i: usize, j: usize| {
            let p = front.at(x[0] + (x[1] - x[0]) * i as f64 / nx as f64, y[0] + (y[1] - y[0]) * j as f64 / ny as f64);
            p.extend(self.land.level(p).max(self.land.height(p)) + SLAB_M)
        };
        for i in 0..nx {
            for j in 0..ny {
                // `y` runs to the right of `x`: counter-clockwise from above.
                let corners = [corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j), corner(i, j)];
                quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), material);
            }
        }
    }

    /// A car of ordinary length; the caller has taken the place.
    fn car(&self, assembly: &mut TownAssembly<'_>, at: DVec2, front: &GardenFrame, nose_in: bool, stream: &mut Stream) {
        let fits = |length: f32| (3.0..4.85).contains(&length);
        let chosen = assembly.catalogue.choose_parked(stream, |spec| fits(spec.length_m));
        let Some(model) = chosen.filter(|_| assembly.parked.len() < MOST) else { return };
        let vehicle = VehicleRef { model, variant: stream.next_u64() };
        let inwards = front.axis.perp();
        let ahead = if nose_in { inwards } else { -inwards };
        let height = |p: DVec2| self.land.level(p).max(self.land.height(p)) + SLAB_M;
        let grade = (height(at + ahead * 1.3) - height(at - ahead * 1.3)) / 2.6;
        let pose = Pose::level(at.extend(height(at)).as_vec3(), atan2(ahead.y, ahead.x) as f32);
        let pitch_rad = endless_world::math::atan(grade as f32);
        assembly.parked.push(ParkedVehicle { vehicle, pose: Pose { pitch_rad, ..pose } });
    }
}
