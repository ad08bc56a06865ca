//! Signals and their controllers.

/// The direction of traffic that a signal is for (OpenDRIVE's `orientation`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SignalOrientation {
    /// Traffic in the direction of `s`.
    Along,
    /// Traffic against it.
    Against,
    /// Both.
    Both,
}

/// A signal or sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// Place along the road.
    pub s: f64,
    /// Place across it.
    pub t: f64,
    /// Height above the road.
    pub z_offset: f64,
    /// Turn from the direction of the road.
    pub h_offset: f64,
    /// For whom.
    pub orientation: SignalOrientation,
    /// Whether its state changes.
    pub dynamic: bool,
    /// Country, may be empty.
    pub country: String,
    /// Code of its type.
    pub kind: String,
    /// Code of its subtype.
    pub subtype: String,
    /// Value, such as a speed.
    pub value: Option<f64>,
    /// Unit of the value.
    pub unit: String,
    /// Text on it.
    pub text: String,
    /// Ranges of lanes it is valid for; none given is all.
    pub validity: Vec<(i32, i32)>,
    /// Physical position, if it differs from the position at which it is valid.
    pub position: Option<SignalPosition>,
}

/// Physical position of a signal.
#[derive(Debug, Clone, PartialEq)]
pub enum SignalPosition {
    /// In the world: x, y, z.
    Inertial([f64; 3]),
    /// On another road: its id, `s`, `t`.
    Road(String, [f64; 2]),
}

/// A signal that stands elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalReference {
    /// The signal's id.
    pub id: String,
    /// Place along the road.
    pub s: f64,
    /// For whom.
    pub orientation: SignalOrientation,
    /// Ranges of lanes it is valid for; none given is all.
    pub validity: Vec<(i32, i32)>,
}

/// Signals that are switched together (OpenDRIVE's `controller`).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SignalController {
    /// Id.
    pub id: String,
    /// Name, may be empty.
    pub name: String,
    /// Place in the sequence.
    pub sequence: Option<u32>,
    /// Ids of the signals.
    pub signals: Vec<String>,
}
