//! A proxy between a client and a server that loses, mixes up and falsifies what the server sends.

use endless_carla::rpc::read_value;
use rmpv::Value;
use std::io::{self, BufReader, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicU16, AtomicU32, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

/// What goes wrong on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Fault {
    /// One in ten messages of sensors does not arrive.
    LosesATenth,
    /// Every seventh arrives after the one that follows it.
    DeliversLate,
    /// Every third arrives twice.
    SaysThingsTwice,
    /// A stream rests for a while.
    Stalls,
    /// Two actors have one id in the first pictures of instances.
    ReusesIds,
    /// A connection stays open and says nothing any more.
    Hangs,
    /// A message is not what it says.
    SendsGarbage,
    /// The server is CARLA 0.9.15: what it is asked must be in its terms.
    IsOlder,
}

/// How often it happened.
#[derive(Debug, Clone, Default)]
pub(crate) struct Faults(Arc<AtomicU32>);

impl Faults {
    pub(crate) fn count(&self) -> u32 {
        self.0.load(Ordering::SeqCst)
    }

    fn note(&self) -> u32 {
        self.0.fetch_add(1, Ordering::SeqCst)
    }
}

/// A proxy of a server: where it listens, and how often something went wrong.
pub(crate) fn proxy(server: SocketAddr, fault: Fault) -> (SocketAddr, Faults) {
    let faults = Faults::default();
    let requests = TcpListener::bind("127.0.0.1:0").expect("a port");
    let streams = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = requests.local_addr().expect("an address");
    let stream_port = streams.local_addr().expect("an address").port();
    let messages = Arc::new(AtomicUsize::new(0));
    // As the server's tokens name it.
    let upstream = Arc::new(AtomicU16::new(0));
    let (named, noted) = (Arc::clone(&upstream), faults.clone());
    thread::spawn(move || {
        for client in requests.incoming().flatten() {
            let named = Arc::clone(&named);
            let older = (fault == Fault::IsOlder).then(|| noted.clone());
            thread::spawn(move || pass_requests(&client, server, stream_port, &named, older));
        }
    });
    let noted = faults.clone();
    thread::spawn(move || {
        for client in streams.incoming().flatten() {
            let (faults, messages) = (noted.clone(), Arc::clone(&messages));
            let upstream = SocketAddr::new(server.ip(), upstream.load(Ordering::SeqCst));
            // A client that hangs up ends it.
            thread::spawn(move || pass_messages(client, upstream, fault, &faults, &messages));
        }
    });
    (address, faults)
}

/// Requests as they are; in answers, tokens name the proxy's port. Of an older server, requests that it would not understand are
/// noted, and answers are as it gives them.
fn pass_requests(
    client: &TcpStream,
    server: SocketAddr,
    stream_port: u16,
    named: &AtomicU16,
    older: Option<Faults>,
) -> io::Result<()> {
    let upstream = TcpStream::connect(server)?;
    upstream.set_nodelay(true)?;
    client.set_nodelay(true)?;
    let (mut from, mut to) = (client.try_clone()?, upstream.try_clone()?);
    let is_older = older.is_some();
    thread::spawn(move || {
        let _ = match older {
            None => io::copy(&mut from, &mut to).map(drop),
            Some(faults) => older::pass_requests(&mut BufReader::new(from), &mut to, &faults),
        };
        let _ = to.shutdown(std::net::Shutdown::Both);
    });
    let mut answers = BufReader::new(upstream);
    let mut client = client;
    while let Ok(mut answer) = read_value(&mut answers) {
        redirect(&mut answer, stream_port, named);
        if is_older {
            older::answer(&mut answer);
        }
        write_value(&mut client, &answer)?;
    }
    client.shutdown(std::net::Shutdown::Both)
}

fn write_value(to: &mut impl Write, value: &Value) -> io::Result<()> {
    let mut bytes = Vec::new();
    rmpv::encode::write_value(&mut bytes, value).map_err(io::Error::other)?;
    to.write_all(&bytes)
}

fn redirect(value: &mut Value, port: u16, named: &AtomicU16) {
    match value {
        Value::Binary(token) if token.len() == 24 => {
            named.store(u16::from_le_bytes([token[4], token[5]]), Ordering::SeqCst);
            token[4..6].copy_from_slice(&port.to_le_bytes());
        }
        Value::Array(values) => values.iter_mut().for_each(|value| redirect(value, port, named)),
        _ => {}
    }
}

fn pass_messages(
    mut client: TcpStream,
    server: SocketAddr,
    fault: Fault,
    faults: &Faults,
    messages: &AtomicUsize,
) -> io::Result<()> {
    const STALL: Duration = Duration::from_millis(2500);
    let mut upstream = TcpStream::connect(server)?;
    let mut id = [0; 4];
    client.read_exact(&mut id)?;
    upstream.write_all(&id)?;
    let mut held: Option<Vec<u8>> = None;
    loop {
        let mut message = read_message(&mut upstream)?;
        let number = messages.fetch_add(1, Ordering::SeqCst);
        let kind = message.get(4).copied().unwrap_or_default();
        match fault {
            Fault::LosesATenth if number % 10 == 7 => {
                faults.note();
                continue;
            }
            Fault::DeliversLate if number % 7 == 3 && held.is_none() => {
                faults.note();
                held = Some(message);
                continue;
            }
            Fault::SaysThingsTwice if number.is_multiple_of(3) => {
                faults.note();
                client.write_all(&message)?;
            }
            Fault::Stalls if number == 30 => {
                faults.note();
                thread::sleep(STALL);
            }
            // Once the first picture has come: the client has to begin the video again.
            Fault::Hangs if number > 30 && faults.count() == 0 => {
                faults.note();
                thread::sleep(Duration::from_secs(60));
            }
            Fault::SendsGarbage if number > 30 && faults.count() == 0 => {
                faults.note();
                message[..4].copy_from_slice(&7u32.to_le_bytes());
            }
            Fault::IsOlder => older::message(&mut message),
            Fault::ReusesIds if kind == INSTANCES && faults.count() < 3 && share_ids(&mut message) => {
                faults.note();
            }
            _ => {}
        }
        client.write_all(&message)?;
        if let Some(late) = held.take() {
            client.write_all(&late)?;
        }
    }
}

/// The type of pictures of instances.
const INSTANCES: u8 = 15;

/// A message with its length.
fn read_message(stream: &mut TcpStream) -> io::Result<Vec<u8>> {
    let mut message = vec![0; 4];
    stream.read_exact(&mut message)?;
    let length = u32::from_le_bytes([message[0], message[1], message[2], message[3]]) as usize;
    message.resize(4 + length, 0);
    stream.read_exact(&mut message[4..])?;
    Ok(message)
}

/// Paints the pixels of each vehicle with the id of another that is seen; whether there are two of many pixels.
fn share_ids(message: &mut [u8]) -> bool {
    const PIXELS: usize = 4 + 48 + 12;
    const CAR: u8 = 14;
    let mut seen = std::collections::BTreeMap::<[u8; 2], u32>::new();
    for pixel in message[PIXELS..].chunks_exact(4).filter(|pixel| pixel[2] == CAR) {
        *seen.entry([pixel[0], pixel[1]]).or_default() += 1;
    }
    let mut large = seen.iter().filter(|(_, count)| **count > 60).map(|(id, _)| *id);
    let (Some(one), Some(other)) = (large.next(), large.next()) else { return false };
    for pixel in message[PIXELS..].chunks_exact_mut(4).filter(|pixel| pixel[2] == CAR) {
        if [pixel[0], pixel[1]] == one {
            pixel[..2].copy_from_slice(&other);
        }
    }
    true
}

/// What of the protocol was otherwise in 0.9.15.
mod older {
    use super::{Faults, read_value, write_value};
    use rmpv::Value;
    use std::io::{self, BufReader, Read, Write};

    /// Calls that came with 0.9.16.
    const LATER: [&str; 6] = [
        "get_actor_bounding_box",
        "get_actor_component_names",
        "get_actor_bone_names",
        "get_actor_socket_names",
        "get_telemetry_data",
        "set_wheel_pitch_angle",
    ];

    /// Passes requests on, and notes those that are not of this version.
    pub(super) fn pass_requests(
        from: &mut BufReader<impl Read>,
        to: &mut impl Write,
        faults: &Faults,
    ) -> io::Result<()> {
        while let Ok(request) = read_value(from) {
            if !is_understood(&request) {
                faults.note();
            }
            write_value(to, &request)?;
        }
        Ok(())
    }

    fn is_understood(request: &Value) -> bool {
        let (method, parameters) = (request[2].as_str().unwrap_or_default(), request[3].as_array());
        let parameters = parameters.map_or(&[][..], Vec::as_slice);
        match method {
            // Metadata, description, transform, parent and kind of attachment: no socket.
            "spawn_actor_with_parent" => parameters.len() == 5,
            "apply_batch" => parameters.get(1).and_then(Value::as_array).is_some_and(|all| all.iter().all(is_command)),
            _ => !LATER.contains(&method),
        }
    }

    /// What is spawned has a description, a transform, a parent, and what is done next.
    fn is_command(command: &Value) -> bool {
        command[0][0] != Value::from(0) || command[0][1].as_array().is_some_and(|fields| fields.len() == 4)
    }

    /// Its version, and boxes that name no actor.
    pub(super) fn answer(value: &mut Value) {
        match value {
            Value::String(text) if text.as_str() == Some("0.9.16") => *value = "0.9.15".into(),
            Value::Array(values) => {
                values.iter_mut().for_each(answer);
                let is_vector = |value: &Value| {
                    value.as_array().is_some_and(|numbers| numbers.len() == 3 && numbers.iter().all(Value::is_number))
                };
                if values.len() == 4 && values[..3].iter().all(is_vector) && values[3].is_u64() {
                    values.pop();
                }
            }
            _ => {}
        }
    }

    /// Snapshots have another type.
    pub(super) fn message(message: &mut [u8]) {
        const TYPE: std::ops::Range<usize> = 4..12;
        const SNAPSHOTS: [u64; 2] = [16, 17];
        if let Some(kind) = message.get_mut(TYPE).filter(|kind| **kind == SNAPSHOTS[1].to_le_bytes()) {
            kind.copy_from_slice(&SNAPSHOTS[0].to_le_bytes());
        }
    }
}
