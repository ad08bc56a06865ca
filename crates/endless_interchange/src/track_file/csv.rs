//! CSV: a line for each road user at each instant, in any order, below a header that names the columns.

use super::TrackFault;
use super::gather::Gatherer;
use super::row::{Numbers, Row};
use endless_world::{TrackPoint, TrackSample};

/// Columns that a file must have.
const REQUIRED: [&str; 6] = ["time", "id", "class", "x", "y", "yaw"];
/// Columns that it may have.
const OPTIONAL: [&str; 3] = ["z", "speed", "length"];

/// Places of the columns in a line.
struct Columns {
    required: [usize; REQUIRED.len()],
    optional: [Option<usize>; OPTIONAL.len()],
}

/// Hands on the rows of a file. Other columns than those that are known are passed over; fields may stand in quotes.
pub(super) fn read(text: &str, gatherer: &mut Gatherer) -> Result<(), TrackFault> {
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let (_, header) = lines.next().ok_or(TrackFault::Format)?;
    let columns = Columns::of(header).ok_or(TrackFault::Format)?;
    for (number, line) in lines {
        let row = columns.row(&Numbers { line: number }, line)?;
        gatherer.instant(row.sample.time_s);
        gatherer.add(&row);
    }
    Ok(())
}

impl Columns {
    fn of(header: &str) -> Option<Self> {
        let names: Vec<String> = fields(header).map(str::to_ascii_lowercase).collect();
        let place = |name: &&str| names.iter().position(|other| other == name);
        let mut required = [0; REQUIRED.len()];
        for (column, name) in required.iter_mut().zip(&REQUIRED) {
            *column = place(name)?;
        }
        Some(Self { required, optional: OPTIONAL.map(|name| place(&name)) })
    }

    fn row<'a>(&self, numbers: &Numbers, line: &'a str) -> Result<Row<'a>, TrackFault> {
        let fields: Vec<&str> = fields(line).collect();
        let mut required = [""; REQUIRED.len()];
        for ((field, &column), name) in required.iter_mut().zip(&self.required).zip(REQUIRED) {
            *field = fields.get(column).ok_or_else(|| numbers.fault(format!("the column {name} is missing")))?;
        }
        let [time, id, kind, x, y, yaw] = required;
        if id.is_empty() {
            return Err(numbers.fault("the id is empty: give each road user a name or a number".to_owned()));
        }
        let [z, speed, length] = self.optional.map(|column| column.and_then(|column| fields.get(column).copied()));
        Ok(Row {
            id,
            kind,
            on_foot: false,
            length_m: numbers.optional("length", length)?.filter(|&length| length > 0.0),
            point: TrackPoint::Centre,
            sample: TrackSample {
                time_s: numbers.time_s(time)?,
                position: numbers.position(x, y)?,
                height_m: numbers.optional("z", z)?,
                yaw_rad: numbers.number("yaw", yaw)?,
                speed_mps: numbers.optional("speed", speed)?,
            },
        })
    }
}

/// The fields of a line. A comma in quotes does not end one.
fn fields(line: &str) -> impl Iterator<Item = &str> {
    let mut quoted = false;
    let parts = line.split(move |c| {
        quoted ^= c == '"';
        c == ',' && !quoted
    });
    parts.map(|field| {
        let field = field.trim();
        field.strip_prefix('"').and_then(|inner| inner.strip_suffix('"')).unwrap_or(field).trim()
    })
}
