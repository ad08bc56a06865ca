//! Props.

use super::attribute::{choice, fixed, float, role_name};
use super::entry::Blueprint;
use super::kind::{BlueprintKind, PropBlueprint, PropBody};
use super::prop_table::{Body, PROPS, Row, Size};
use crate::wire::{AttributeType, BoundingBox, Vector3D};
use endless_asset::{Catalogue, Prop};
use endless_world::ClassTag;

/// CARLA's props.
pub(super) fn blueprints(catalogue: &Catalogue) -> impl Iterator<Item = Blueprint> {
    PROPS.iter().map(|row| blueprint(catalogue, row)).chain([mesh()])
}

fn blueprint(catalogue: &Catalogue, &(name, size, tag, body): &Row) -> Blueprint {
    let body = match body {
        Body::Nothing => None,
        Body::Piece(prop) => {
            // Those that CARLA numbers (`bench02`) are further variants.
            let digits = name.trim_start_matches(|c: char| !c.is_ascii_digit());
            let number = digits.parse::<u32>().map_or(0, |number| number.saturating_sub(1));
            Some(PropBody { prop, variant: number % catalogue.prop_variants(prop).max(1) })
        }
        Body::Sign(code) => {
            let place = Catalogue::sign_codes().iter().position(|&other| other == code);
            place.map(|place| PropBody { prop: Prop::TrafficSign, variant: place as u32 })
        }
    };
    let attributes = vec![role_name(&["prop"]), fixed("size", AttributeType::String, size.name())];
    let bounding_box = body.map_or_else(|| size.box_on_ground(), |body| bounds(catalogue, body));
    let id = format!("static.prop.{name}");
    Blueprint::new(&id, attributes, BlueprintKind::Prop(PropBlueprint { body }), bounding_box, vec![tag])
}

/// A mesh out of CARLA's own files; there are none here, so it stays unseen.
fn mesh() -> Blueprint {
    let attributes = vec![
        role_name(&["prop"]),
        choice("mesh_path", AttributeType::String, &[""]),
        float("mass", "0.0"),
        float("scale", "1.0"),
    ];
    let kind = BlueprintKind::Prop(PropBlueprint { body: None });
    Blueprint::new("static.prop.mesh", attributes, kind, BoundingBox::default(), vec![ClassTag::Static])
}

/// The box of a piece: our y is to the left, CARLA's to the right.
fn bounds(catalogue: &Catalogue, body: PropBody) -> BoundingBox {
    let (low, high) = catalogue.prop(body.prop, body.variant).bounds();
    let [center, extent] = [(low + high) * 0.5, (high - low) * 0.5];
    BoundingBox {
        location: Vector3D { x: center.x, y: -center.y, z: center.z },
        extent: Vector3D { x: extent.x, y: extent.y, z: extent.z },
        ..BoundingBox::default()
    }
}

impl Size {
    const fn name(self) -> &'static str {
        match self {
            Self::Tiny => "tiny",
            Self::Small => "small",
            Self::Medium => "medium",
            Self::Big => "big",
            Self::Huge => "huge",
        }
    }

    /// About as large as such a thing is.
    fn box_on_ground(self) -> BoundingBox {
        let half = match self {
            Self::Tiny => 0.1,
            Self::Small => 0.2,
            Self::Medium => 0.5,
            Self::Big => 1.0,
            Self::Huge => 2.0,
        };
        BoundingBox {
            location: Vector3D { z: half, ..Vector3D::default() },
            extent: Vector3D { x: half, y: half, z: half },
            ..BoundingBox::default()
        }
    }
}
