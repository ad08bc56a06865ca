//! The least that a client is, and a server for all tests of a file.

use endless_carla::rpc::read_value;
use endless_carla::server::{QualityLevel, Server, ServerSettings};
use endless_carla::wire::{
    Actor, ActorAttributeValue, ActorDefinition, ActorDescription, Bytes, EpisodeSettings, Transform, Wire,
};
use endless_interchange::MapLibrary;
use rmpv::Value;
use std::io::{Read, Write};
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpStream};
use std::path::PathBuf;
use std::thread;
use std::time::Duration;

/// A town that is made soon.
pub(crate) const MAP: &str = "Town02";

/// A server of its own; it ends with the program.
pub(crate) fn serve() -> SocketAddr {
    serve_recording(None)
}

/// The same with a folder for recordings.
pub(crate) fn serve_recording(recordings: Option<PathBuf>) -> SocketAddr {
    let bind = IpAddr::V4(Ipv4Addr::LOCALHOST);
    let settings =
        ServerSettings { bind, port: 0, map: MAP.to_owned(), seed: 0, quality: QualityLevel::Epic, recordings };
    let server = Server::bind(&settings, MapLibrary::builtin()).expect("ports are free");
    let address = server.address();
    thread::spawn(|| server.run());
    address
}

/// A client.
pub(crate) struct Client {
    stream: TcpStream,
    address: SocketAddr,
    calls: u32,
}

impl Client {
    pub(crate) fn new(address: SocketAddr) -> Self {
        let stream = TcpStream::connect(address).expect("the server listens");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a timeout");
        Self { stream, address, calls: 0 }
    }

    /// The result of a method: as it is, or why it failed.
    pub(crate) fn raw(&mut self, method: &str, arguments: &[Value]) -> Value {
        self.calls += 1;
        let metadata = Value::Array(vec![Value::Boolean(false)]);
        let parameters = std::iter::once(metadata).chain(arguments.iter().cloned()).collect();
        let request = Value::Array(vec![0.into(), self.calls.into(), method.into(), Value::Array(parameters)]);
        let mut bytes = Vec::new();
        rmpv::encode::write_value(&mut bytes, &request).expect("memory");
        self.stream.write_all(&bytes).expect("the server reads");
        let answer = read_value(&mut self.stream).expect("the server answers");
        let [kind, id, error, result] = &answer.as_array().expect("a response")[..] else { panic!("{answer}") };
        assert_eq!((kind, id, error), (&Value::from(1), &Value::from(self.calls), &Value::Nil));
        result.clone()
    }

    /// The value of a method, or its failure.
    pub(crate) fn call(&mut self, method: &str, arguments: &[Value]) -> Result<Value, String> {
        let result = self.raw(method, arguments);
        let wrapper = result[0].as_array().expect("a wrapper").clone();
        match &wrapper[..] {
            [Value::Boolean(false)] => Ok(Value::Nil),
            [index, value] if index == &Value::from(1) => Ok(value.clone()),
            [_, error] => Err(error[0].as_str().expect("a text").to_owned()),
            _ => panic!("{result}"),
        }
    }

    pub(crate) fn get<T: Wire>(&mut self, method: &str, arguments: &[Value]) -> T {
        let value = self.call(method, arguments).unwrap_or_else(|error| panic!("{method}: {error}"));
        T::from_value(&value).unwrap_or_else(|error| panic!("{method}: {error}"))
    }

    /// Time passes in steps of a twentieth of a second, when this client says so.
    pub(crate) fn synchronous(&mut self) {
        let settings =
            EpisodeSettings { synchronous_mode: true, fixed_delta_seconds: Some(0.05), ..EpisodeSettings::default() };
        let _: u64 = self.get("set_episode_settings", &[settings.to_value()]);
    }

    pub(crate) fn tick(&mut self) -> u64 {
        self.get("tick_cue", &[])
    }

    /// The description of an actor with these attributes changed.
    pub(crate) fn description(&mut self, id: &str, changed: &[(&str, &str)]) -> ActorDescription {
        let all: Vec<ActorDefinition> = self.get("get_actor_definitions", &[]);
        let definition = all.iter().find(|definition| definition.id == id).expect("a blueprint");
        let value = |attribute: &str, usual: &str| {
            changed.iter().find(|(name, _)| *name == attribute).map_or(usual, |(_, value)| value).to_owned()
        };
        let attributes = definition.attributes.iter().map(|attribute| ActorAttributeValue {
            id: attribute.id.clone(),
            kind: attribute.kind,
            value: value(&attribute.id, &attribute.value),
        });
        ActorDescription { uid: definition.uid, id: id.to_owned(), attributes: attributes.collect() }
    }

    pub(crate) fn spawn(&mut self, description: &ActorDescription, transform: &Transform) -> Actor {
        self.get("spawn_actor", &[description.to_value(), transform.to_value()])
    }

    /// Listens to a stream.
    pub(crate) fn listen(&mut self, token: &Bytes) -> Stream {
        let id = u32::from_le_bytes(token.0[..4].try_into().expect("a token"));
        let tokens: Vec<Bytes> = self.get("get_sensor_token", &[id.into()]);
        let port = u16::from_le_bytes(tokens[0].0[4..6].try_into().expect("a token"));
        let mut stream = TcpStream::connect((self.address.ip(), port)).expect("streams are served");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a timeout");
        stream.write_all(&id.to_le_bytes()).expect("the server reads");
        Stream(stream)
    }
}

/// A stream that is listened to.
pub(crate) struct Stream(pub(crate) TcpStream);

/// A message of a stream.
pub(crate) struct Message {
    pub(crate) type_id: u64,
    pub(crate) frame: u64,
    pub(crate) payload: Vec<u8>,
}

impl Stream {
    pub(crate) fn next(&mut self) -> Message {
        let mut length = [0; 4];
        self.0.read_exact(&mut length).expect("a message");
        let mut bytes = vec![0; u32::from_le_bytes(length) as usize];
        self.0.read_exact(&mut bytes).expect("all of it");
        let number = |at: usize| u64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"));
        Message { type_id: number(0), frame: number(8), payload: bytes[48..].to_vec() }
    }

    /// The message of a frame; earlier ones are passed over.
    pub(crate) fn of_frame(&mut self, frame: u64) -> Message {
        loop {
            let message = self.next();
            assert!(message.frame <= frame, "frame {} in place of {frame}", message.frame);
            if message.frame == frame {
                return message;
            }
        }
    }
}
