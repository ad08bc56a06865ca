//! What tells a client where a stream is: 24 bytes.

use crate::wire::Bytes;

/// Names a stream of this server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    /// The stream's number, never 0.
    pub stream: u32,
    /// The port at which streams are served.
    pub port: u16,
}

/// The protocol.
const TCP: u8 = 1;
/// In the place of the kind of an address: clients take the host that they know.
const SAME_HOST: u8 = 0;

impl Token {
    /// As it travels.
    pub fn bytes(self) -> Bytes {
        let mut bytes = vec![0; 24];
        bytes[..4].copy_from_slice(&self.stream.to_le_bytes());
        bytes[4..6].copy_from_slice(&self.port.to_le_bytes());
        (bytes[6], bytes[7]) = (TCP, SAME_HOST);
        Bytes(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_token_is_the_documented_one() {
        let Bytes(bytes) = Token { stream: 1, port: 2001 }.bytes();
        assert_eq!(bytes[..8], [1, 0, 0, 0, 0xd1, 7, 1, 0]);
        assert_eq!(bytes[8..], [0; 16]);
    }
}
