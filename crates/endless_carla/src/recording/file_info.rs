//! All that a recording holds, as `show_recorder_file_info` tells it.

use super::bytes::RecordingError;
use super::date::date_text;
use super::log_reader::{LogHeader, LogReader};
use super::number::{general, general32, vector};
use super::packet::Packet;
use super::physics_record::RecordedPhysics;
use super::record::{FrameStart, RecordedActor, RecordedBox, RecordedCollision};
use std::fmt::Write as _;
use std::io::{Read, Seek};

/// Most text, bytes: that of some minutes of a hundred actors, all packets told.
const MOST_TEXT: usize = 256 << 20;
/// In CARLA's order, of bits and names.
const VEHICLE_LIGHTS: [(u32, &str); 11] = [
    (1, "Position"),
    (2, "LowBeam"),
    (4, "HighBeam"),
    (8, "Brake"),
    (16, "RightBlinker"),
    (32, "LeftBlinker"),
    (64, "Reverse"),
    (256, "Interior"),
    (128, "Fog"),
    (512, "Special1"),
    (1024, "Special2"),
];

/// The text of a recording: its frames with what came, went, was joined and met in them, or with `all` packets.
///
/// # Errors
/// When it cannot be read, or has more to tell than fits into an answer.
pub fn file_info<R: Read + Seek>(log: &mut LogReader<R>, all: bool) -> Result<String, RecordingError> {
    let mut text = header_text(log.header());
    let mut frame = FrameStart::default();
    let mut is_told = true;
    while let Some(packet) = log.packet()? {
        match packet {
            Packet::FrameStart(start) => (frame, is_told) = (start, false),
            _ => {
                let lines = packet_text(&packet, all);
                if !lines.is_empty() && !is_told {
                    tell_frame(&mut text, &frame);
                    is_told = true;
                }
                text += &lines;
            }
        }
        if all && !is_told {
            tell_frame(&mut text, &frame);
            is_told = true;
        }
        if text.len() > MOST_TEXT {
            return Err(RecordingError::Text(MOST_TEXT >> 20));
        }
    }
    let _ = write!(text, "\nFrames: {}\nDuration: {} seconds\n", frame.id, general(frame.elapsed_s));
    Ok(text)
}

/// Version, map and date.
pub(super) fn header_text(header: &LogHeader) -> String {
    format!("Version: {}\nMap: {}\nDate: {}\n\n", header.version, header.map, date_text(header.date_s))
}

fn tell_frame(text: &mut String, frame: &FrameStart) {
    let _ = writeln!(text, "Frame {} at {} seconds", frame.id, general(frame.elapsed_s));
}

/// The lines of a packet.
fn packet_text(packet: &Packet, all: bool) -> String {
    match packet {
        Packet::Created(actors) => actors.iter().map(created).collect(),
        Packet::Destroyed(actors) => actors.iter().map(|actor| format!(" Destroy {actor}\n")).collect(),
        Packet::Parents(parents) => {
            let line = |p: &super::RecordedParent| format!(" Parenting {} with {} (parent)\n", p.child, p.parent);
            parents.iter().map(line).collect()
        }
        Packet::Collisions(collisions) => collisions.iter().map(collision).collect(),
        _ if !all => String::new(),
        Packet::Positions(list) => lines("Positions", list, |p| {
            format!("  Id: {} Location: {} Rotation {}\n", p.actor, vector(p.location), vector(p.rotation))
        }),
        Packet::LightStates(list) => lines("State traffic lights", list, |l| {
            let (frozen, elapsed) = (u8::from(l.frozen), general32(l.elapsed_s));
            format!("  Id: {} state: {} frozen: {frozen} elapsedTime: {elapsed}\n", l.actor, l.state)
        }),
        Packet::Vehicles(list) => lines("Vehicle animations", list, |v| {
            let [steer, throttle, brake] = [v.steer, v.throttle, v.brake].map(general32);
            let (id, hand_brake, gear) = (v.actor, u8::from(v.hand_brake), v.gear);
            format!(
                "  Id: {id} Steering: {steer} Throttle: {throttle} Brake {brake} Handbrake: {hand_brake} Gear: {gear}\n"
            )
        }),
        Packet::Walkers(list) => {
            lines("Walker animations", list, |w| format!("  Id: {} speed: {}\n", w.actor, general32(w.speed)))
        }
        Packet::VehicleLights(list) => {
            lines("Vehicle light animations", list, |l| format!("  Id: {} {}\n", l.actor, lit(l.lights)))
        }
        Packet::SceneLights(list) => lines("Scene light changes", list, |l| {
            let [r, g, b, _] = l.color;
            let (enabled, intensity) = (if l.active { "True" } else { "False" }, general32(l.intensity));
            format!("  Id: {} enabled: {enabled} intensity: {intensity} RGB_color: {}\n", l.light, vector([r, g, b]))
        }),
        Packet::Kinematics(list) => lines("Dynamic actors", list, |k| {
            let (linear, angular) = (vector(k.velocity), vector(k.angular_velocity));
            format!("  Id: {} linear_velocity: {linear} angular_velocity: {angular}\n", k.actor)
        }),
        Packet::Boxes(list) => lines("Actor bounding boxes", list, bounds),
        Packet::Triggers(list) => lines("Actor trigger volumes", list, bounds),
        Packet::PlatformTime(seconds) => format!(" Current platform time: {}\n", general(*seconds)),
        Packet::Physics(list) => lines("Physics Control events", list, physics),
        Packet::LightTimes(list) => lines("Traffic Light time events", list, |t| {
            let [green, yellow, red] = [t.green_s, t.yellow_s, t.red_s].map(general32);
            format!("  Id: {} green_time: {green} yellow_time: {yellow} red_time: {red}\n", t.actor)
        }),
        Packet::FrameStart(_) | Packet::FrameEnd | Packet::Other(_) => String::new(),
    }
}

fn lines<T>(title: &str, list: &[T], line: impl Fn(&T) -> String) -> String {
    let mut text = format!(" {title}: {}\n", list.len());
    text.extend(list.iter().map(line));
    text
}

fn created(actor: &RecordedActor) -> String {
    let RecordedActor { id, blueprint, kind, location, .. } = actor;
    let mut text = format!(" Create {id}: {blueprint} ({kind}) at {}\n", vector(*location));
    for attribute in &actor.attributes {
        let _ = writeln!(text, "  {} = {}", attribute.id, attribute.value);
    }
    text
}

fn collision(collision: &RecordedCollision) -> String {
    let hero = |is: bool| if is { " (hero) " } else { "" };
    let RecordedCollision { id, first, second, first_is_hero, second_is_hero } = collision;
    format!(" Collision id {id} between {first}{} with {second}{}\n", hero(*first_is_hero), hero(*second_is_hero))
}

fn lit(lights: u32) -> String {
    let names: Vec<&str> = VEHICLE_LIGHTS.iter().filter(|(bit, _)| lights & bit != 0).map(|(_, name)| *name).collect();
    if names.is_empty() { "None".to_owned() } else { names.join(" ") }
}

fn bounds(bounds: &RecordedBox) -> String {
    format!("  Id: {} origin: {} extension: {}\n", bounds.actor, vector(bounds.origin), vector(bounds.extent))
}

fn physics(recorded: &RecordedPhysics) -> String {
    let p = &recorded.physics;
    let mut text = format!("  Id: {}\n", recorded.actor);
    for (name, number) in [
        ("max_rpm", p.max_rpm),
        ("MOI", p.moi),
        ("damping_rate_full_throttle", p.damping_rate_full_throttle),
        ("damping_rate_zero_throttle_clutch_engaged", p.damping_rate_zero_throttle_clutch_engaged),
        ("damping_rate_zero_throttle_clutch_disengaged", p.damping_rate_zero_throttle_clutch_disengaged),
    ] {
        let _ = writeln!(text, "   {name} = {}", general32(number));
    }
    let _ = writeln!(text, "   use_gear_auto_box = {}", p.use_gear_autobox);
    for (name, number) in [
        ("gear_switch_time", p.gear_switch_time),
        ("clutch_strength", p.clutch_strength),
        ("final_ratio", p.final_ratio),
        ("mass", p.mass),
        ("drag_coefficient", p.drag_coefficient),
    ] {
        let _ = writeln!(text, "   {name} = {}", general32(number));
    }
    let middle = &p.center_of_mass;
    let _ = writeln!(text, "   center_of_mass = {}", vector([middle.x, middle.y, middle.z]));
    for (name, curve) in [("torque_curve", &p.torque_curve), ("steering_curve", &p.steering_curve)] {
        let points: Vec<String> = curve.iter().map(|point| vector([point.x, point.y])).collect();
        let _ = writeln!(text, "   {name} = {}", points.join(" "));
    }
    text += "   forward_gears:\n";
    for (number, gear) in p.forward_gears.iter().enumerate() {
        let [ratio, down, up] = [gear.ratio, gear.down_ratio, gear.up_ratio].map(general32);
        let _ = writeln!(text, "    gear {number}: ratio {ratio} down_ratio {down} up_ratio {up}");
    }
    text += "   wheels:\n";
    for (number, w) in p.wheels.iter().enumerate() {
        let _ = write!(text, "    wheel {number}:");
        for (name, value) in [
            ("tire_friction", w.tire_friction),
            ("damping_rate", w.damping_rate),
            ("max_steer_angle", w.max_steer_angle),
            ("radius", w.radius),
            ("max_brake_torque", w.max_brake_torque),
            ("max_handbrake_torque", w.max_handbrake_torque),
        ] {
            let _ = write!(text, " {name} {}", general32(value));
        }
        let _ = writeln!(text, " position {}", vector([w.position.x, w.position.y, w.position.z]));
    }
    text
}
