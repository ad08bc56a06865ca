//! The meshes of props, by kind and variant.

use crate::furniture;
use crate::plant;
use crate::prop::Prop;
use endless_scene::Mesh;

/// A plant or a piece of furniture.
pub(crate) fn prop(prop: Prop, variant: u32) -> Mesh {
    let variant = variant % variants(prop);
    match prop {
        Prop::BroadleafTree => plant::broadleaf(variant),
        Prop::Conifer => plant::conifer(variant),
        Prop::Palm => plant::palm(variant),
        Prop::Bush => plant::bush(variant),
        Prop::Hedge => plant::hedge(variant),
        Prop::Planter => plant::planter(variant),
        Prop::Corn => plant::corn(variant),
        Prop::Cypress => plant::cypress(variant),
        Prop::BareTree => plant::bare(variant),
        Prop::FlowerBed => plant::flower_bed(variant),
        Prop::GrassTuft => plant::grass(variant),
        Prop::Wheat => plant::wheat(variant),
        Prop::Rock => plant::rock(variant),
        _ => furniture::furniture(prop, variant),
    }
}

/// How many variants there are.
pub(crate) fn variants(prop: Prop) -> u32 {
    match prop {
        Prop::BroadleafTree => plant::BROADLEAF_VARIANTS,
        Prop::Conifer => plant::CONIFER_VARIANTS,
        Prop::BareTree => plant::BARE_VARIANTS,
        Prop::Palm | Prop::Corn | Prop::Cypress | Prop::GrassTuft => 3,
        Prop::FlowerBed | Prop::Rock => 4,
        Prop::Wheat => 2,
        Prop::Bush | Prop::Planter => 4,
        Prop::Hedge => 2,
        _ => furniture::variants(prop),
    }
}
