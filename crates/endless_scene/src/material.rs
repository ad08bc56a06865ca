//! Materials of surfaces as data; the renderer gives each its BSDF.

use endless_world::ClassTag;
use serde::Deserialize;

/// The vehicle lights that switch an emitter. Manifests of imported models use these names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
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
}

/// The aspect of a signal group that lights a lens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LensAspect {
    /// Red, or the red standing figure.
    Red,
    /// Yellow.
    Yellow,
    /// Green, or the green walking figure.
    Green,
}

/// The kind of a surface: decides procedural detail, reflection and emission in the renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
    VehicleLight(LightSlot),
    /// A traffic light's lens; the instance names the signal group.
    SignalLens(LensAspect),
    /// A street lamp's lens: lit at night.
    LampLens,
}

impl Surface {
    /// All of them.
    pub const ALL: &'static [Self] = &[
        Self::Asphalt,
        Self::RoadPaint,
        Self::Paving,
        Self::Cobbles,
        Self::Kerb,
        Self::Concrete,
        Self::Grass,
        Self::Soil,
        Self::Gravel,
        Self::Brick,
        Self::Plaster,
        Self::Stone,
        Self::Cladding,
        Self::RoofTile,
        Self::FlatRoof,
        Self::Wood,
        Self::WindowGlass,
        Self::ShopGlass,
        Self::LitSign,
        Self::CarPaint,
        Self::CarGlass,
        Self::Rubber,
        Self::Plastic,
        Self::Metal,
        Self::Chrome,
        Self::Painted,
        Self::Cloth,
        Self::Skin,
        Self::Hair,
        Self::Leather,
        Self::Bark,
        Self::Foliage,
        Self::Water,
        Self::Plate,
        Self::VehicleLight(LightSlot::Head),
        Self::VehicleLight(LightSlot::Tail),
        Self::VehicleLight(LightSlot::Brake),
        Self::VehicleLight(LightSlot::IndicatorLeft),
        Self::VehicleLight(LightSlot::IndicatorRight),
        Self::VehicleLight(LightSlot::Reverse),
        Self::SignalLens(LensAspect::Red),
        Self::SignalLens(LensAspect::Yellow),
        Self::SignalLens(LensAspect::Green),
        Self::LampLens,
    ];

    /// Name in files: `CarPaint`, `VehicleLight(Head)`.
    pub fn name(self) -> String {
        format!("{self:?}")
    }

    /// The surface of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|s| s.name() == name)
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
