//! Why a file is no asset, each with what to do about it.

/// Why a file cannot be imported. The caller says which file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImportError {
    /// The manifest is not what it should be.
    #[error("{line}:{column}: {message}")]
    Manifest {
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
    /// A field of the manifest's entry cannot be.
    #[error("its entry has {field} = {given}: {rule}")]
    Entry {
        /// Name of the field.
        field: &'static str,
        /// What it says.
        given: String,
        /// What it may be.
        rule: String,
    },
    /// The file is too long.
    #[error("the file has more than {most_mib} MiB: simplify the model or its images")]
    TooLong {
        /// The most.
        most_mib: usize,
    },
    /// Not a `.glb` file at all.
    #[error("not a binary glTF file: export it as glTF 2.0 Binary (.glb)")]
    NotGlb,
    /// The version of glTF is another.
    #[error("glTF version {version}: export it as glTF 2.0")]
    Version {
        /// As the file says.
        version: u32,
    },
    /// The file ends before its end.
    #[error("the file is cut off: {part} should have {expected} bytes, {actual} are there; copy or export it again")]
    Truncated {
        /// What of it.
        part: &'static str,
        /// As the file says.
        expected: usize,
        /// As it is.
        actual: usize,
    },
    /// The document does not hold together.
    #[error("the file is damaged: {what}; export it again")]
    Damaged {
        /// What was found.
        what: String,
    },
    /// The file needs an extension of glTF that is not read.
    #[error("the file needs the extension {name}: export it without (no compression)")]
    Extension {
        /// Of glTF's registry.
        name: String,
    },
    /// A buffer lies in another file, or an image lies in one that is not there.
    #[error("{what} lies outside of the file ({uri}): export everything as one .glb, or put images beside it")]
    Outside {
        /// What.
        what: &'static str,
        /// Where, shortened.
        uri: String,
    },
    /// An image cannot be decoded.
    #[error("image {number} cannot be read ({why}): embed PNG or JPEG of at most {most_px} pixels a side")]
    Image {
        /// In the file's list.
        number: usize,
        /// What the decoder says.
        why: String,
        /// Longest side.
        most_px: usize,
    },
    /// Positions that are no places.
    #[error("vertex {vertex} of mesh '{mesh}' is not a number or beyond 100 km: remove it in the modelling program")]
    NotFinite {
        /// Name or number of the mesh.
        mesh: String,
        /// Of its primitive.
        vertex: usize,
    },
    /// There is nothing to see.
    #[error("the file has no triangles: export meshes, not curves, points or an empty scene")]
    Empty,
    /// Too many triangles.
    #[error("the model has more than {most} triangles: simplify it")]
    TooMany {
        /// The most.
        most: usize,
    },
    /// The mesh is not a surface.
    #[error(
        "{share_percent} % of the edges join more than two faces (at most {most_percent} %): remove doubled and inner faces"
    )]
    NotASurface {
        /// Share found.
        share_percent: u32,
        /// Share allowed.
        most_percent: u32,
    },
    /// Size and shape disagree.
    #[error(
        "scaled to a length of {:.2} m it is {:.2} m wide and {:.2} m high, the entry says {:.2} and {:.2}: mend `size` or \
         `forward`",
        found[0], found[1], found[2], stated[1], stated[2]
    )]
    Size {
        /// Length, width, height, metres.
        found: [f32; 3],
        /// The entry's.
        stated: [f32; 3],
    },
    /// A vehicle without axles.
    #[error(
        "no node's name begins with '{wheels}' and the entry has no axles: name the wheels' nodes or write `axles`"
    )]
    NoAxles {
        /// The names looked for.
        wheels: String,
    },
    /// The entry names a material that the file has not.
    #[error("{field} names the material '{name}', which the file has not (it has {known})")]
    NoMaterial {
        /// Field of the entry.
        field: &'static str,
        /// As written.
        name: String,
        /// Those there are.
        known: String,
    },
    /// A lamp that is nowhere near the body.
    #[error("the lamp at {at:?} is not on the vehicle: places are metres ahead, to the left, up, from the middle")]
    LampOffBody {
        /// As written.
        at: [f32; 3],
    },
}
