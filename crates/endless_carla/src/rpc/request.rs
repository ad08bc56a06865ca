//! What a client asks for.

use crate::wire::{Wire, WireError, array};
use rmpv::Value;

/// A request.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Told again in the response.
    pub call_id: u32,
    /// Name of the method.
    pub method: String,
    /// Whether the client waits for no answer.
    pub asynchronous: bool,
    /// What follows the metadata.
    pub arguments: Vec<Value>,
}

impl Request {
    /// From `[0, call id, method, [[asynchronous], arguments…]]`.
    ///
    /// # Errors
    /// When it is something else.
    pub fn from_message(message: &Value) -> Result<Self, WireError> {
        let [kind, call_id, method, parameters] = array(message, "request")? else {
            return Err(WireError::new("a request of four elements", message));
        };
        if u8::from_value(kind)? != 0 {
            return Err(WireError::new("a request (0)", kind));
        }
        let [metadata, arguments @ ..] = array(parameters, "parameters")? else {
            return Err(WireError::new("parameters that begin with metadata", parameters));
        };
        let asynchronous = array(metadata, "metadata")?.first().is_some_and(|flag| flag == &Value::Boolean(true));
        Ok(Self {
            call_id: u32::from_value(call_id)?,
            method: String::from_value(method)?,
            asynchronous,
            arguments: arguments.to_vec(),
        })
    }

    /// An argument by its place.
    ///
    /// # Errors
    /// When it is not there or of another type.
    pub fn argument<T: Wire>(&self, place: usize) -> Result<T, WireError> {
        let missing = || WireError { expected: format!("argument {}", place + 1), actual: "nothing".to_owned() };
        T::from_value(self.arguments.get(place).ok_or_else(missing)?)
    }

    /// An argument that older clients leave out.
    ///
    /// # Errors
    /// When it is of another type.
    pub fn optional<T: Wire + Default>(&self, place: usize) -> Result<T, WireError> {
        self.arguments.get(place).map_or_else(|| Ok(T::default()), T::from_value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rpc::read_value;

    #[test]
    fn requests_of_the_official_client_are_read() {
        let version = [0x94, 0, 1, 0xa7, b'v', b'e', b'r', b's', b'i', b'o', b'n', 0x91, 0x91, 0xc2];
        let request = Request::from_message(&read_value(&mut &version[..]).unwrap()).unwrap();
        let expected = Request { call_id: 1, method: "version".to_owned(), asynchronous: false, arguments: vec![] };
        assert_eq!(request, expected);
        let mut destroy = vec![0x94, 0, 0x1a, 0xad];
        destroy.extend(b"destroy_actor");
        destroy.extend([0x92, 0x91, 0xc2, 0x20]);
        let request = Request::from_message(&read_value(&mut &destroy[..]).unwrap()).unwrap();
        assert_eq!((request.call_id, request.argument::<u32>(0)), (26, Ok(32)));
        assert!(request.argument::<u32>(1).is_err());
    }
}
