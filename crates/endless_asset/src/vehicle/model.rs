//! One vehicle of the catalogue.

use super::assemble::{Trailer, VehicleBlueprint, VehicleParts};
use super::design::VehicleDesign;
use super::draw::DesignDraw;
use super::rider_fit::RiderFit;
use super::tint::{self, PaintShare};
use super::wheel::Wheel;
use endless_scene::Mesh;
use endless_world::{BodyKeypoints, BodyPart, PersonAttributes, Reid, TrailerSpec, VehicleSpec};
use glam::Vec3;
use std::sync::{Arc, OnceLock};

/// One vehicle of the catalogue: a draw from the ranges of its design, or one from a file. Its measures are known at
/// once; its meshes are made when they are first asked for.
#[derive(Clone)]
pub struct VehicleModel {
    /// Sizes and habits.
    pub spec: VehicleSpec,
    origin: VehicleOrigin,
    parts: OnceLock<Arc<VehicleParts>>,
}

/// Where a vehicle comes from.
#[derive(Clone)]
enum VehicleOrigin {
    Drawn {
        design: &'static VehicleDesign,
        draw: DesignDraw,
    },
    File {
        /// In the catalogue.
        name: Arc<str>,
        /// Colours for [`endless_scene::Surface::CarPaint`]; none: as in the file.
        paints: Option<&'static [PaintShare]>,
    },
}

impl VehicleModel {
    pub(crate) fn new(design: &'static VehicleDesign, index: u64, frequency: f64) -> Self {
        let draw = DesignDraw::new(design.name, index);
        let VehicleBlueprint { size, joint, .. } = (design.blueprint)(&draw);
        let from_middle = |x: f32| x - size.middle();
        let [front, rear] = size.axles.map(|x| x - size.middle());
        let spec = VehicleSpec {
            name: design.name,
            draw: index,
            class: design.class,
            length_m: size.front - size.rear,
            width_m: size.width,
            height_m: size.height,
            front_axle_m: front,
            rear_axle_m: rear,
            wheel_radius_m: size.wheel_radius,
            cruise_mps: design.cruise_mps,
            acceleration_mps2: design.acceleration_mps2,
            frequency,
            parks: design.parks,
            ridden: design.ridden,
            trailer: joint.map(|j| TrailerSpec {
                hitch_m: from_middle(j.hitch),
                axle_m: from_middle(j.axle),
                front_m: from_middle(j.front),
                towing_rear_m: from_middle(j.towing_rear),
            }),
        };
        Self { spec, origin: VehicleOrigin::Drawn { design, draw }, parts: OnceLock::new() }
    }

    /// From a file.
    pub(crate) fn imported(name: String, spec: VehicleSpec, parts: VehicleParts, painted: bool) -> Self {
        let paints = painted.then(|| tint::of_class(spec.class));
        Self { spec, origin: VehicleOrigin::File { name: name.into(), paints }, parts: OnceLock::from(Arc::new(parts)) }
    }

    /// Name in the catalogue: of the design, or of the file.
    pub fn name(&self) -> &str {
        match &self.origin {
            VehicleOrigin::Drawn { design, .. } => design.name,
            VehicleOrigin::File { name, .. } => name,
        }
    }

    fn parts(&self) -> &VehicleParts {
        self.parts.get_or_init(|| match &self.origin {
            VehicleOrigin::Drawn { design, draw } => Arc::new((design.blueprint)(draw).finish()),
            VehicleOrigin::File { .. } => unreachable!("what comes from a file has its parts"),
        })
    }

    /// What it draws, if it draws anything.
    pub fn trailer(&self) -> Option<&Trailer> {
        self.parts().trailer.as_ref()
    }

    /// Everything but wheels, rider and trailer. [`endless_scene::Surface::CarPaint`] is tinted per variant.
    pub fn body(&self) -> &Arc<Mesh> {
        &self.parts().body
    }

    /// Wheels, all with [`Self::wheel_mesh`].
    pub fn wheels(&self) -> &[Wheel] {
        &self.parts().wheels
    }

    /// Axis along y, centre at the origin, outer side towards +y.
    pub fn wheel_mesh(&self) -> &Arc<Mesh> {
        &self.parts().wheel_mesh
    }

    /// Centres of the headlights' lenses in the object frame (one for two-wheelers, none for bicycles).
    pub fn headlights(&self) -> &[Vec3] {
        &self.parts().headlights
    }

    /// Body, wheels and trailer as one mesh, standing still and straight.
    pub fn whole(&self) -> Mesh {
        self.parts().whole()
    }

    /// Who rides it, in place, in the vehicle's object frame; `None` for vehicles with a cabin.
    pub fn rider(&self, variant: u64) -> Option<Mesh> {
        Some(self.rider_body(variant)?.0)
    }

    /// The same with the part of the body that each triangle shows.
    pub fn rider_body(&self, variant: u64) -> Option<(Mesh, Arc<[BodyPart]>)> {
        Some(crate::person::rider_body(self.fit()?, variant))
    }

    /// The keypoints of that rider, in the vehicle's object frame.
    pub fn rider_keypoints(&self, variant: u64) -> Option<BodyKeypoints> {
        Some(crate::person::rider_keypoints(self.fit()?, variant))
    }

    /// That rider's skin, 1 to 10 on the Monk scale.
    pub fn rider_skin_tone(&self, variant: u64) -> Option<u8> {
        Some(crate::person::rider_skin_tone(self.fit()?, variant))
    }

    /// Who that rider is and what they wear.
    pub fn rider_attributes(&self, variant: u64) -> Option<PersonAttributes> {
        Some(crate::person::rider_attributes(self.fit()?, variant))
    }

    /// The identity of that rider's look.
    pub fn rider_reid(&self, variant: u64) -> Option<Reid> {
        Some(crate::person::rider_reid(self.fit()?, variant))
    }

    fn fit(&self) -> Option<&RiderFit> {
        if self.spec.ridden { self.parts().fit.as_ref() } else { None }
    }

    /// Linear paint colour of a variant, distributed as on real roads.
    pub fn tint(&self, variant: u64) -> [f32; 3] {
        self.paint(variant).unwrap_or([1.0; 3])
    }

    /// The same; `None` where the colours are those of a file.
    pub(crate) fn paint(&self, variant: u64) -> Option<[f32; 3]> {
        let paints = match &self.origin {
            VehicleOrigin::Drawn { design, .. } => Some(design.paints),
            VehicleOrigin::File { paints, .. } => *paints,
        };
        paints.map(|paints| tint::tint(paints, variant))
    }

    /// The design that it is drawn from; `None` if it is from a file.
    pub(crate) fn design_name(&self) -> Option<&'static str> {
        match &self.origin {
            VehicleOrigin::Drawn { design, .. } => Some(design.name),
            VehicleOrigin::File { .. } => None,
        }
    }
}

impl std::fmt::Debug for VehicleModel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VehicleModel").field("spec", &self.spec).finish_non_exhaustive()
    }
}
