//! Requests and their answers.

use super::error::ClientError;
use super::patience::{PatientReader, StopFlag, Wait};
use crate::rpc::read_value;
use crate::wire::Wire;
use rmpv::Value;
use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpStream, ToSocketAddrs};
use std::time::Duration;

/// How long a server may take to accept a connection.
const CONNECT: Duration = Duration::from_secs(5);

/// A connection to a server: one request at a time.
pub(super) struct Connection {
    stream: TcpStream,
    reader: BufReader<PatientReader>,
    calls: u32,
    stop: StopFlag,
}

/// Connects to a host and port.
pub(super) fn connect(host: &str, port: u16) -> Result<TcpStream, ClientError> {
    let addresses = (host, port).to_socket_addrs().map_err(ClientError::Refused)?;
    let mut refused = std::io::Error::from(std::io::ErrorKind::NotFound);
    for address in addresses.collect::<Vec<SocketAddr>>() {
        match TcpStream::connect_timeout(&address, CONNECT) {
            Ok(stream) => {
                stream.set_nodelay(true).map_err(ClientError::Lost)?;
                return Ok(stream);
            }
            Err(error) => refused = error,
        }
    }
    Err(ClientError::Refused(refused))
}

impl Connection {
    /// Connects to a host and port.
    pub(super) fn new(host: &str, port: u16, stop: &StopFlag) -> Result<Self, ClientError> {
        let stream = connect(host, port)?;
        let reader = BufReader::new(PatientReader::new(stream.try_clone().map_err(ClientError::Lost)?));
        Ok(Self { stream, reader, calls: 0, stop: stop.clone() })
    }

    /// A value that a method gives.
    pub(super) fn get<T: Wire>(
        &mut self,
        method: &'static str,
        arguments: Vec<Value>,
        limit: Duration,
    ) -> Result<T, ClientError> {
        let value = self.call(method, arguments, limit)?;
        T::from_value(&value).map_err(|error| ClientError::Protocol(format!("{method}: {error}")))
    }

    /// Calls a method: what is in its wrapper.
    pub(super) fn call(
        &mut self,
        method: &'static str,
        arguments: Vec<Value>,
        limit: Duration,
    ) -> Result<Value, ClientError> {
        unwrapped(method, &self.bare(method, arguments, limit)?)
    }

    /// Calls a method: what it answers, as it is.
    pub(super) fn bare(
        &mut self,
        method: &'static str,
        mut arguments: Vec<Value>,
        limit: Duration,
    ) -> Result<Value, ClientError> {
        arguments.insert(0, metadata(false));
        let id = self.send(method, arguments)?;
        self.answer(id, method, limit)
    }

    /// Calls a method without metadata and wrappers, as TrafficManagers have theirs.
    pub(super) fn plain(
        &mut self,
        method: &'static str,
        arguments: Vec<Value>,
        limit: Duration,
    ) -> Result<Value, ClientError> {
        let id = self.send(method, arguments)?;
        self.answer(id, method, limit)
    }

    /// Calls a method and waits for no answer.
    pub(super) fn tell(&mut self, method: &'static str, mut arguments: Vec<Value>) -> Result<(), ClientError> {
        arguments.insert(0, metadata(true));
        self.send(method, arguments).map(drop)
    }

    fn send(&mut self, method: &str, parameters: Vec<Value>) -> Result<u32, ClientError> {
        self.calls = self.calls.wrapping_add(1);
        let request = [Value::from(0), Value::from(self.calls), Value::from(method), Value::Array(parameters)];
        let mut bytes = Vec::new();
        // Nothing can go wrong in memory.
        let _ = rmpv::encode::write_value(&mut bytes, &Value::Array(request.into()));
        self.stream.write_all(&bytes).map_err(ClientError::Lost)?;
        Ok(self.calls)
    }

    /// The answer to a request; those to earlier ones, for which nobody waits, are passed over.
    fn answer(&mut self, id: u32, method: &'static str, limit: Duration) -> Result<Value, ClientError> {
        let wait = Wait::new("answer", limit, &self.stop);
        loop {
            self.reader.get_mut().wait = Some(wait.clone());
            if let Err(error) = self.reader.fill_buf() {
                return Err(self.reader.get_mut().reason(ClientError::Lost(error)));
            }
            self.reader.get_mut().wait = Some(wait.to_the_end());
            let response = read_value(&mut self.reader).map_err(|error| self.reader.get_mut().reason(error))?;
            let [kind, answered, error, result] = response.as_array().map_or(&[][..], Vec::as_slice) else {
                return Err(ClientError::Protocol("a response has four elements".to_owned()));
            };
            if kind.as_u64() != Some(1) {
                return Err(ClientError::Protocol("a response begins with 1".to_owned()));
            }
            if answered.as_u64() != Some(id.into()) {
                continue;
            }
            if !error.is_nil() {
                let text = error.as_str().map_or_else(|| error.to_string(), str::to_owned);
                return Err(ClientError::Failed { method, text });
            }
            return Ok(result.clone());
        }
    }
}

fn metadata(asynchronous: bool) -> Value {
    Value::Array(vec![Value::from(asynchronous)])
}

/// What is in the wrapper of an answer: `[[1, value]]`, `[[false]]`, or an error.
pub(super) fn unwrapped(method: &'static str, answer: &Value) -> Result<Value, ClientError> {
    let wrapper = answer.as_array().and_then(|outer| outer.first()).and_then(Value::as_array);
    match wrapper.map(Vec::as_slice) {
        Some([Value::Boolean(false)]) => Ok(Value::Nil),
        Some([Value::Integer(index), value]) if index.as_u64() == Some(1) => Ok(value.clone()),
        Some([_, error]) => {
            let text = error.as_array().and_then(|error| error.first()).and_then(Value::as_str);
            Err(ClientError::Failed { method, text: text.unwrap_or("it failed").to_owned() })
        }
        _ => Err(ClientError::Protocol(format!("{method} was answered without CARLA's wrapper"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrappers_are_read() {
        let answer = |inner: Vec<Value>| Value::Array(vec![Value::Array(inner)]);
        assert_eq!(unwrapped("a", &answer(vec![1.into(), 7.into()])).unwrap(), Value::from(7));
        assert_eq!(unwrapped("a", &answer(vec![false.into()])).unwrap(), Value::Nil);
        let failure = answer(vec![0.into(), Value::Array(vec!["no".into()])]);
        assert_eq!(unwrapped("spawn", &failure).unwrap_err().to_string(), "spawn: no");
        let of_void = answer(vec![true.into(), Value::Array(vec!["no".into()])]);
        assert!(matches!(unwrapped("a", &of_void), Err(ClientError::Failed { .. })));
        for garbage in [Value::Nil, Value::from("x"), Value::Array(vec![]), answer(vec![])] {
            assert!(matches!(unwrapped("a", &garbage), Err(ClientError::Protocol(_))));
        }
    }

    #[test]
    fn an_answer_in_which_somebody_stops_is_not_taken_for_the_next() {
        let listener = std::net::TcpListener::bind(("127.0.0.1", 0)).expect("a port");
        let port = listener.local_addr().expect("an address").port();
        let stop = StopFlag::default();
        let stopped = stop.clone();
        let server = std::thread::spawn(move || {
            let (mut stream, _) = listener.accept().expect("a client");
            for id in 1..=2 {
                read_value(&mut stream).expect("a request");
                let mut answer = Vec::new();
                let parts = [1.into(), id.into(), Value::Nil, Value::from("as said")];
                rmpv::encode::write_value(&mut answer, &Value::Array(parts.into())).expect("memory");
                let (first, rest) = answer.split_at(6);
                stream.write_all(first).expect("a client");
                std::thread::sleep(Duration::from_millis(50));
                stopped.stop();
                std::thread::sleep(Duration::from_millis(250));
                stream.write_all(rest).expect("a client");
            }
        });
        let mut connection = Connection::new("127.0.0.1", port, &stop).expect("a server");
        let limit = Duration::from_secs(20);
        let first = connection.plain("first", vec![], limit);
        assert!(matches!(first, Ok(_) | Err(ClientError::Interrupted)), "{first:?}");
        let next = stop.pause(|| connection.plain("next", vec![], limit)).expect("an answer of its own");
        assert_eq!(next.as_str(), Some("as said"));
        server.join().expect("no panic");
    }
}
