//! Packets.

use super::bytes::{RecordingError, Stored, read_list, write_list};
use super::physics_record::RecordedPhysics;
use super::record::{
    FrameStart, RecordedActor, RecordedBox, RecordedCollision, RecordedKinematics, RecordedLightState,
    RecordedLightTimes, RecordedParent, RecordedPosition, RecordedSceneLight, RecordedVehicle, RecordedVehicleLights,
    RecordedWalker,
};

macro_rules! packets {
    ($($(#[$meta:meta])* $name:ident($type:ty) = $number:literal;)*) => {
        /// A packet.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Packet {
            /// A frame begins.
            FrameStart(FrameStart),
            /// A frame ends.
            FrameEnd,
            /// Seconds on the clock of the machine.
            PlatformTime(f64),
            $($(#[$meta])* $name(Vec<$type>),)*
            /// Of a number that is none of these.
            Other(u8),
        }

        impl Packet {
            /// Appends it to a file's bytes. What is more than a packet can count goes into packets that follow.
            pub fn write(&self, out: &mut Vec<u8>) {
                match self {
                    Self::FrameStart(start) => packet(0, out, |out| start.write(out)),
                    Self::FrameEnd => packet(1, out, |_| ()),
                    Self::PlatformTime(seconds) => packet(14, out, |out| seconds.write(out)),
                    $(Self::$name(list) => lists($number, list, out),)*
                    Self::Other(_) => {}
                }
            }

            /// Of a number, from its bytes.
            pub(super) fn read(number: u8, bytes: &[u8]) -> Result<Self, RecordingError> {
                let bytes = &mut &*bytes;
                Ok(match number {
                    0 => Self::FrameStart(FrameStart::read(bytes)?),
                    1 => Self::FrameEnd,
                    14 => Self::PlatformTime(f64::read(bytes)?),
                    $($number => Self::$name({
                        let count = u16::read(bytes)?;
                        read_list(count.into(), bytes)?
                    }),)*
                    _ => Self::Other(number),
                })
            }
        }
    };
}

packets! {
    /// Actors have come.
    Created(RecordedActor) = 2;
    /// Actors have gone.
    Destroyed(u32) = 3;
    /// Actors hang on others.
    Parents(RecordedParent) = 4;
    /// Actors have met.
    Collisions(RecordedCollision) = 5;
    /// Where actors are.
    Positions(RecordedPosition) = 6;
    /// What traffic lights show.
    LightStates(RecordedLightState) = 7;
    /// How vehicles are driven.
    Vehicles(RecordedVehicle) = 8;
    /// How walkers walk.
    Walkers(RecordedWalker) = 9;
    /// Lights of vehicles.
    VehicleLights(RecordedVehicleLights) = 10;
    /// Lamps of the map that have changed.
    SceneLights(RecordedSceneLight) = 11;
    /// How actors move.
    Kinematics(RecordedKinematics) = 12;
    /// Boxes of actors.
    Boxes(RecordedBox) = 13;
    /// What vehicles are made of.
    Physics(RecordedPhysics) = 15;
    /// How long traffic lights show their colours.
    LightTimes(RecordedLightTimes) = 16;
    /// Where vehicles stand at lights and signs.
    Triggers(RecordedBox) = 17;
}

fn lists<T: Stored>(number: u8, list: &[T], out: &mut Vec<u8>) {
    let mut chunks = list.chunks(u16::MAX.into());
    // An empty list is told of, too.
    for chunk in std::iter::once(chunks.next().unwrap_or_default()).chain(chunks) {
        packet(number, out, |out| {
            (chunk.len() as u16).write(out);
            write_list(chunk, out);
        });
    }
}

fn packet(number: u8, out: &mut Vec<u8>, content: impl FnOnce(&mut Vec<u8>)) {
    number.write(out);
    let at = out.len();
    0u32.write(out);
    content(out);
    let size = (out.len() - at - size_of::<u32>()) as u32;
    out[at..at + size_of::<u32>()].copy_from_slice(&size.to_le_bytes());
}
