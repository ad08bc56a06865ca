//! From what a design plans to a finished vehicle: put together, centred, and exactly as large as planned.

use super::rider_fit::RiderFit;
use super::wheel::Wheel;
use crate::shape::Sculpt;
use endless_scene::Mesh;
use glam::{Affine3A, Mat3, Vec3};
use std::sync::Arc;

/// Measures that are known before anything is built; in the frame in which the vehicle is built, metres.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct VehicleMeasures {
    /// x of the foremost and the rearmost point.
    pub(crate) front: f32,
    pub(crate) rear: f32,
    /// Without mirrors and bars.
    pub(crate) width: f32,
    pub(crate) height: f32,
    /// x of the foremost and the rearmost axle.
    pub(crate) axles: [f32; 2],
    pub(crate) wheel_radius: f32,
}

impl VehicleMeasures {
    /// x of the middle.
    pub(crate) fn middle(&self) -> f32 {
        0.5 * (self.front + self.rear)
    }

    /// The same of a vehicle this many times as large.
    pub(crate) fn scaled(&self, k: f32) -> Self {
        Self {
            front: self.front * k,
            rear: self.rear * k,
            width: self.width * k,
            height: self.height * k,
            axles: self.axles.map(|x| x * k),
            wheel_radius: self.wheel_radius * k,
        }
    }
}

/// Where a vehicle bends that draws another: x in the frame in which it is built, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HitchMeasures {
    /// About this the trailer turns.
    pub(crate) hitch: f32,
    /// Middle of the trailer's axles.
    pub(crate) axle: f32,
    /// Foremost point of the trailer.
    pub(crate) front: f32,
    /// Rearmost point of what draws it.
    pub(crate) towing_rear: f32,
}

impl HitchMeasures {
    /// Each measure, changed.
    fn map(self, f: impl Fn(f32) -> f32) -> Self {
        let Self { hitch, axle, front, towing_rear } = self;
        Self { hitch: f(hitch), axle: f(axle), front: f(front), towing_rear: f(towing_rear) }
    }
}

/// What a design makes of a draw: measures at once, the vehicle when it is needed.
pub(crate) struct VehicleBlueprint {
    pub(crate) size: VehicleMeasures,
    pub(crate) joint: Option<HitchMeasures>,
    pub(crate) build: Box<dyn FnOnce() -> Assembly>,
}

impl VehicleBlueprint {
    pub(crate) fn new(size: VehicleMeasures, build: impl FnOnce() -> Assembly + 'static) -> Self {
        Self { size, joint: None, build: Box::new(build) }
    }

    /// With a trailer whose rearmost point and height are given; what it is like is built in the same frame, with the
    /// x and y of its wheels.
    pub(crate) fn towing(
        mut self,
        joint: HitchMeasures,
        rear: f32,
        height: f32,
        build: impl FnOnce() -> (Sculpt, Vec<(f32, f32)>) + 'static,
    ) -> Self {
        self.size.rear = rear;
        self.size.height = self.size.height.max(height);
        self.joint = Some(joint);
        self.with(move |assembly| {
            let (body, wheels) = build();
            let z = assembly.wheel_radius;
            let wheels = wheels.into_iter().flat_map(|(x, y)| {
                [(y, false), (-y, true)].map(|(y, mirrored)| Wheel {
                    position: Vec3::new(x, y, z),
                    steered: false,
                    mirrored,
                })
            });
            assembly.trailer = Some(TowedAssembly { hitch: joint.hitch, body, wheels: wheels.collect() });
        })
    }

    /// The same vehicle, this many times as large.
    pub(crate) fn scaled(self, k: f32) -> Self {
        Self {
            size: self.size.scaled(k),
            joint: self.joint.map(|j| j.map(|x| x * k)),
            build: Box::new(move || (self.build)().scaled(k)),
        }
    }

    /// With more on it, or painted over.
    pub(crate) fn with(self, dress: impl FnOnce(&mut Assembly) + 'static) -> Self {
        Self {
            size: self.size,
            joint: self.joint,
            build: Box::new(move || {
                let mut assembly = (self.build)();
                dress(&mut assembly);
                assembly
            }),
        }
    }

    /// The finished vehicle.
    pub(crate) fn finish(self) -> VehicleParts {
        (self.build)().finish(&self.size)
    }
}

/// A finished vehicle: what is drawn, and how it is ridden. Object frame.
#[derive(Debug, Clone)]
pub(crate) struct VehicleParts {
    pub(crate) body: Arc<Mesh>,
    pub(crate) wheels: Vec<Wheel>,
    pub(crate) wheel_mesh: Arc<Mesh>,
    pub(crate) headlights: Vec<Vec3>,
    pub(crate) fit: Option<RiderFit>,
    pub(crate) trailer: Option<Trailer>,
}

/// What a vehicle draws, in the vehicle's object frame as it stands when the vehicle goes straight on.
#[derive(Debug, Clone, PartialEq)]
pub struct Trailer {
    /// On the ground under the joint about which it turns.
    pub hitch: Vec3,
    /// Everything but wheels.
    pub body: Arc<Mesh>,
    /// With the vehicle's wheel mesh.
    pub wheels: Vec<Wheel>,
}

impl VehicleParts {
    /// Body, wheels and trailer as one mesh, standing still and straight.
    pub(crate) fn whole(&self) -> Mesh {
        let mut mesh = (*self.body).clone();
        if let Some(trailer) = &self.trailer {
            mesh.append(&trailer.body, Affine3A::IDENTITY);
        }
        for wheel in self.wheels.iter().chain(self.trailer.iter().flat_map(|t| &t.wheels)) {
            let flip = Vec3::new(1.0, if wheel.mirrored { -1.0 } else { 1.0 }, 1.0);
            let place = Affine3A::from_scale_rotation_translation(flip, glam::Quat::IDENTITY, wheel.position);
            mesh.append(&self.wheel_mesh, place);
        }
        mesh
    }
}

/// A vehicle before it is centred.
#[derive(Debug, Clone)]
pub(crate) struct Assembly {
    pub(crate) body: Sculpt,
    pub(crate) wheels: Vec<Wheel>,
    pub(crate) wheel_mesh: Mesh,
    pub(crate) headlights: Vec<Vec3>,
    pub(crate) fit: Option<RiderFit>,
    pub(crate) wheel_radius: f32,
    pub(crate) trailer: Option<TowedAssembly>,
}

/// A trailer before the vehicle is centred.
#[derive(Debug, Clone)]
pub(crate) struct TowedAssembly {
    hitch: f32,
    body: Sculpt,
    wheels: Vec<Wheel>,
}

impl Assembly {
    pub(crate) fn new(body: Sculpt, wheel_mesh: Mesh, wheel_radius: f32) -> Self {
        Self { body, wheels: Vec::new(), wheel_mesh, headlights: Vec::new(), fit: None, wheel_radius, trailer: None }
    }

    /// Two wheels on an axle at x, at ±y.
    pub(crate) fn axle(&mut self, x: f32, y: f32, steered: bool) {
        for (y, mirrored) in [(y, false), (-y, true)] {
            self.wheels.push(Wheel { position: Vec3::new(x, y, self.wheel_radius), steered, mirrored });
        }
    }

    /// One wheel in the middle.
    pub(crate) fn single(&mut self, x: f32, steered: bool) {
        self.wheels.push(Wheel { position: Vec3::new(x, 0.0, self.wheel_radius), steered, mirrored: false });
    }

    fn scaled(mut self, k: f32) -> Self {
        let grow = Affine3A::from_scale(Vec3::splat(k));
        self.body = self.body.placed(grow);
        for wheel in &mut self.wheels {
            wheel.position *= k;
        }
        for p in &mut self.wheel_mesh.positions {
            *p *= k;
        }
        for p in &mut self.headlights {
            *p *= k;
        }
        self.wheel_radius *= k;
        self.trailer = self.trailer.map(|mut t| {
            t.wheels.iter_mut().for_each(|w| w.position *= k);
            TowedAssembly { hitch: t.hitch * k, body: t.body.placed(grow), wheels: t.wheels }
        });
        let grown = |f: RiderFit| RiderFit { right_foot: f.right_foot * k, ..f.moved(|p| p * k) };
        self.fit = self.fit.map(grown);
        self
    }

    /// Centres the vehicle on its footprint. Bumpers, plates and rails that stand out a little more or less than planned
    /// are brought to the planned size by stretching the body by a few thousandths.
    fn finish(mut self, size: &VehicleMeasures) -> VehicleParts {
        let middle = size.middle();
        let drawn = self.trailer.iter_mut().flat_map(|t| &mut t.wheels);
        for wheel in self.wheels.iter_mut().chain(drawn) {
            wheel.position.x -= middle;
        }
        let (wheel_low, wheel_high) = self.wheel_mesh.bounds();
        let drawn = || self.trailer.iter().flat_map(|t| &t.wheels);
        let xs = || self.wheels.iter().chain(drawn()).map(|w| w.position.x);
        let wheels_front = xs().fold(f32::NEG_INFINITY, f32::max) + wheel_high.x;
        let wheels_rear = xs().fold(f32::INFINITY, f32::min) + wheel_low.x;
        let (mut low, mut high) = self.body.bounds();
        if let Some(trailer) = &self.trailer {
            let (a, b) = trailer.body.bounds();
            (low, high) = (low.min(a), high.max(b));
        }
        // Where a wheel is the outermost part, the body keeps its place.
        let half = 0.5 * (size.front - size.rear);
        let front = if high.x - middle > wheels_front { half } else { high.x - middle };
        let rear = if low.x - middle < wheels_rear { -half } else { low.x - middle };
        let kx = (front - rear) / (high.x - low.x);
        let kz = size.height / high.z;
        let object_from_built = Affine3A::from_mat3_translation(
            Mat3::from_diagonal(Vec3::new(kx, 1.0, kz)),
            Vec3::new(rear - kx * low.x, 0.0, 0.0),
        );
        let place = |p: Vec3| object_from_built.transform_point3(p);
        VehicleParts {
            fit: self.fit.map(|f| f.moved(place)),
            headlights: self.headlights.iter().map(|&p| place(p)).collect(),
            body: self.body.placed(object_from_built).into_mesh().into(),
            wheels: self.wheels,
            wheel_mesh: self.wheel_mesh.into(),
            trailer: self.trailer.map(|t| Trailer {
                hitch: Vec3::new(place(Vec3::X * t.hitch).x, 0.0, 0.0),
                body: t.body.placed(object_from_built).into_mesh().into(),
                wheels: t.wheels,
            }),
        }
    }
}
