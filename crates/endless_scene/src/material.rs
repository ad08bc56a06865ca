//! Materials of surfaces as data; the renderer gives each its BSDF.

use endless_world::ClassTag;
use serde::Deserialize;
use strum::EnumString;

/// The vehicle lights that switch an emitter. Manifests of imported models use these names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, EnumString)]
#[serde(rename_all = "snake_case")]
pub enum LightSlot {
    /// Headlight lens.
    Head,
    /// Tail light; brighter when braking.
    Tail,
    /// Brake light only (third brake light).
    Brake,
    /// Left indicator.
    IndicatorLeft,
    /// Right indicator.
    IndicatorRight,
    /// Reversing light.
    Reverse,
    /// The left half of a beacon, of the colour of its lens.
    BeaconLeft,
    /// The right half.
    BeaconRight,
}

/// The aspect of a signal group that lights a lens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString)]
pub enum LensAspect {
    /// Red, or the red standing figure.
    Red,
    /// Yellow.
    Yellow,
    /// Green, or the green walking figure.
    Green,
}

/// The kind of a surface: decides procedural detail, reflection and emission in the renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString)]
pub enum Surface {
    // Ground; detail from world position.
    /// Road surface: aggregate, patches, cracks, tyre tracks. uv = (along the lane in metres, metres left of the lane
    /// centre) where known, so that wheel paths darken.
    Asphalt,
    /// Worn white or yellow paint on asphalt; colour from the base colour.
    RoadPaint,
    /// Sidewalk slabs.
    Paving,
    /// Small square stones set in rows of a roadway.
    Cobbles,
    /// Kerb stone.
    Kerb,
    /// Cast concrete.
    Concrete,
    /// Lawn.
    Grass,
    /// Bare earth.
    Soil,
    /// Loose stones.
    Gravel,
    // Buildings; uv in metres along the wall (u) and up (v).
    /// Brick courses.
    Brick,
    /// Painted render, with stains.
    Plaster,
    /// Stone blocks.
    Stone,
    /// Sheet metal or panel cladding with seams.
    Cladding,
    /// Roof tiles.
    RoofTile,
    /// Flat bitumen or gravel roof.
    FlatRoof,
    /// Boards.
    Wood,
    /// A building's window: the integer part of uv names the window, the fraction is the place in it. Shows an
    /// interior; some are lit at night.
    WindowGlass,
    /// A shop's window: like a window, always lit in the evening.
    ShopGlass,
    /// A lit sign or awning front; base colour, emits at night.
    LitSign,
    // Things.
    /// Two-layer paint; the instance's tint multiplies the base colour.
    CarPaint,
    /// Vehicle glass, dark tinted.
    CarGlass,
    /// Tyre.
    Rubber,
    /// Moulded plastic.
    Plastic,
    /// Bare or galvanised metal.
    Metal,
    /// Mirror-like metal trim, rims.
    Chrome,
    /// Painted metal: poles, street furniture.
    Painted,
    /// Textile; the base colour is final.
    Cloth,
    /// Skin.
    Skin,
    /// Hair.
    Hair,
    /// Leather, shoes.
    Leather,
    /// Bark.
    Bark,
    /// Leaves: two-sided, light shines through.
    Foliage,
    /// Water surface.
    Water,
    /// Retro-reflective plate (signs, licence plates).
    Plate,
    // Emitters.
    /// A vehicle's light.
    #[strum(disabled)]
    VehicleLight(LightSlot),
    /// A traffic light's lens; the instance names the signal group.
    #[strum(disabled)]
    SignalLens(LensAspect),
    /// A street lamp's lens: lit at night.
    LampLens,
}

impl Surface {
    /// Name in files: `CarPaint`, `VehicleLight(Head)`.
    pub fn name(self) -> String {
        format!("{self:?}")
    }

    /// The surface of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        let of = |kind: &str| name.strip_prefix(kind)?.strip_prefix('(')?.strip_suffix(')');
        match (of("VehicleLight"), of("SignalLens")) {
            (Some(slot), _) => Some(Self::VehicleLight(slot.parse().ok()?)),
            (_, Some(aspect)) => Some(Self::SignalLens(aspect.parse().ok()?)),
            _ => name.parse().ok(),
        }
    }
}

/// One entry of a mesh's material table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Kind.
    pub surface: Surface,
    /// Linear (not sRGB) albedo, 0 to 1.
    pub base_color: [f32; 3],
    /// The class that pixels of this material carry when the instance has no class of its own ("stuff").
    pub tag: ClassTag,
}

impl Material {
    /// A material.
    pub const fn new(surface: Surface, base_color: [f32; 3], tag: ClassTag) -> Self {
        Self { surface, base_color, tag }
    }
}
