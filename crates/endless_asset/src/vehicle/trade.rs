//! Vans of craftsmen and shops: a name on the side, a ladder on the roof, a few scrapes.

use super::assemble::VehicleBlueprint;
use super::car::CarShape;
use super::draw::DesignDraw;
use super::lettering::Sign;
use super::paint;
use super::roof_load::RoofLoad;
use super::{van, wear};

/// A small van.
pub(crate) fn small(draw: &DesignDraw) -> VehicleBlueprint {
    lettered(van::blind_small(draw), draw)
}

/// A large one.
pub(crate) fn panel(draw: &DesignDraw) -> VehicleBlueprint {
    lettered(van::blind_panel(draw), draw)
}

fn lettered(shape: CarShape, draw: &DesignDraw) -> VehicleBlueprint {
    let worn = wear::worn(&shape, draw, 0.5);
    let sign = Sign::drawn(draw);
    let rack = draw.chance("roof rack", 0.45).then(|| RoofLoad::of_craftsman(draw));
    let mut blueprint = shape.clone().blueprint();
    if let Some(rack) = rack {
        blueprint.size.height = shape.height() + rack.height();
    }
    blueprint.with(move |a| {
        shape.load_doors(&mut a.body);
        let door = shape.doors_d[shape.doors_d.len() - 1];
        let (belt, roof) = (shape.belt[2].1, shape.height());
        let along = [shape.x(shape.length - 0.35), shape.x(door + 0.18)];
        let high = (roof - 0.30 - belt).min(0.75);
        sign.on_sides(&mut a.body, along, [belt + 0.06, belt + 0.06 + high], &[paint::BODY]);
        worn(a);
        if let Some(rack) = rack {
            rack.on(&mut a.body, &shape);
        }
    })
}
