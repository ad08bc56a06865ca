//! SUMO's floating car data: `<fcd-export><timestep time=""><vehicle id="" x="" y="" angle="" type="" …/>`.
//! <https://sumo.dlr.de/docs/Simulation/Output/FCDOutput.html>
//!
//! Positions of vehicles are those of the middle of the front bumper; `angle` is in degrees clockwise from north.

use super::TrackFault;
use super::gather::Gatherer;
use super::row::{Numbers, Row};
use endless_road::LineNumbers;
use endless_world::{TrackPoint, TrackSample};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;
use std::f64::consts::FRAC_PI_2;

/// SUMO's type for those that have none.
const ANY_VEHICLE: &str = "DEFAULT_VEHTYPE";
const ANY_PERSON: &str = "DEFAULT_PEDTYPE";

/// Hands on the rows of a file, those who sit in a vehicle left out.
pub(super) fn read(text: &str, gatherer: &mut Gatherer) -> Result<(), TrackFault> {
    let mut reader = Reader::from_str(text);
    let mut lines = LineNumbers::new(text);
    let mut time_s: Option<f64> = None;
    let mut root_seen = false;
    loop {
        let event = reader.read_event().map_err(|error| TrackFault::Line {
            line: lines.of(reader.error_position() as usize),
            what: error.to_string().split_whitespace().collect::<Vec<_>>().join(" "),
        })?;
        let numbers = Numbers { line: lines.of(reader.buffer_position() as usize) };
        match event {
            Event::Start(element) | Event::Empty(element) => match element.local_name().into_inner() {
                "fcd-export" => root_seen = true,
                _ if !root_seen => return Err(TrackFault::Format),
                "timestep" => {
                    let [time] = attributes(&element, ["time"], &numbers)?;
                    let time = numbers.time_s(numbers.required("time", time.as_deref())?)?;
                    gatherer.instant(time);
                    time_s = Some(time);
                }
                name @ ("vehicle" | "person") => {
                    let outside = || numbers.fault(format!("<{name}> stands outside of <timestep>"));
                    add_row(&element, name == "person", time_s.ok_or_else(outside)?, &numbers, gatherer)?;
                }
                _ => {}
            },
            Event::End(element) if element.local_name().into_inner() == "timestep" => time_s = None,
            Event::Eof if root_seen => return Ok(()),
            Event::Eof => return Err(TrackFault::Format),
            _ => {}
        }
    }
}

fn add_row(
    element: &BytesStart<'_>,
    on_foot: bool,
    time_s: f64,
    numbers: &Numbers,
    gatherer: &mut Gatherer,
) -> Result<(), TrackFault> {
    const NAMES: [&str; 9] = ["id", "x", "y", "angle", "z", "speed", "length", "type", "vehicle"];
    let values = attributes(element, NAMES, numbers)?;
    let [id, x, y, angle, z, speed, length, kind, vehicle] = values.each_ref().map(Option::as_deref);
    if vehicle.is_some_and(|vehicle| !vehicle.is_empty()) {
        return Ok(());
    }
    let clockwise_from_north = numbers.number("angle", numbers.required("angle", angle)?)?;
    gatherer.add(&Row {
        id: numbers.required("id", id)?,
        kind: kind.unwrap_or(if on_foot { ANY_PERSON } else { ANY_VEHICLE }),
        on_foot,
        length_m: numbers.optional("length", length)?.filter(|&length| length > 0.0),
        // People are as deep as their step.
        point: if on_foot { TrackPoint::Centre } else { TrackPoint::Front },
        sample: TrackSample {
            time_s,
            position: numbers.position(numbers.required("x", x)?, numbers.required("y", y)?)?,
            height_m: numbers.optional("z", z)?,
            yaw_rad: FRAC_PI_2 - clockwise_from_north.to_radians(),
            speed_mps: numbers.optional("speed", speed)?,
        },
    });
    Ok(())
}

/// The values of these attributes, as far as there are any.
fn attributes<'a, const N: usize>(
    element: &'a BytesStart<'_>,
    names: [&str; N],
    numbers: &Numbers,
) -> Result<[Option<Cow<'a, str>>; N], TrackFault> {
    let mut values = [const { None }; N];
    for attribute in element.attributes() {
        let attribute = attribute.map_err(|error| numbers.fault(error.to_string()))?;
        if let Some(place) = names.iter().position(|name| *name == attribute.key.local_name().into_inner()) {
            let raw = attribute.value;
            values[place] = Some(match quick_xml::escape::unescape(&raw) {
                Ok(Cow::Owned(value)) => Cow::Owned(value),
                _ => raw,
            });
        }
    }
    Ok(values)
}
