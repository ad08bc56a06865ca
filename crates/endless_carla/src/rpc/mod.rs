//! msgpack-rpc over TCP as CARLA speaks it: requests `[0, call id, method, [[asynchronous], arguments…]]`, responses
//! `[1, call id, error, result]`, one after the other without anything between them.

mod answer;
mod connection;
mod decode;
mod eager;
mod listener;
mod request;
mod standing;

pub use answer::Answer;
pub(crate) use answer::{failure, success};
pub use connection::{Caller, ConnectionId};
pub use decode::{DecodeError, read_value};
pub use listener::{RpcEvent, listen};
pub use request::Request;
pub use standing::StandingAnswers;
