//! Where a server is: `carla://HOST:PORT`.

use std::fmt;

/// The port of CARLA.
const CARLA_PORT: u16 = 2000;

/// A host and a port.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Address {
    /// Name or number of the host.
    pub host: String,
    /// Its port.
    pub port: u16,
}

impl Address {
    /// From the value of `--simulator`; `None` if it names no CARLA server.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn of_simulator(text: &str) -> Option<Result<Self, String>> {
        let rest = text.strip_prefix("carla://").or_else(|| (text == "carla").then_some(""))?;
        let rest = rest.trim_end_matches('/');
        Some(if rest.is_empty() { Ok(Self::local(CARLA_PORT)) } else { Self::with_port(rest, CARLA_PORT) })
    }

    fn local(port: u16) -> Self {
        Self { host: "127.0.0.1".to_owned(), port }
    }
}

impl Address {
    /// From `HOST` or `HOST:PORT`.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn with_port(text: &str, usual: u16) -> Result<Self, String> {
        let (host, port) = match text.rsplit_once(':') {
            // The colons of an address of version 6 are in brackets.
            Some((host, port)) if !port.contains(']') => (host, Some(port)),
            _ => (text, None),
        };
        let host = host.trim_start_matches('[').trim_end_matches(']');
        let wrong = || format!("'{text}' is no HOST:PORT, as in 127.0.0.1:2000");
        if host.is_empty() || host.contains(char::is_whitespace) || host.contains('/') {
            return Err(wrong());
        }
        let port = port.map_or(Ok(usual), |port| port.parse::<u16>().ok().filter(|port| *port > 0).ok_or_else(wrong));
        Ok(Self { host: host.to_owned(), port: port? })
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.host.contains(':') {
            write!(f, "[{}]:{}", self.host, self.port)
        } else {
            write!(f, "{}:{}", self.host, self.port)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_read() {
        let of = |text: &str| Address::of_simulator(text).map(|address| address.map(|a| a.to_string()));
        assert_eq!(of("builtin"), None);
        assert_eq!(of("carla"), Some(Ok("127.0.0.1:2000".to_owned())));
        assert_eq!(of("carla://gpu-1:2010"), Some(Ok("gpu-1:2010".to_owned())));
        assert_eq!(of("carla://gpu-1/"), Some(Ok("gpu-1:2000".to_owned())));
        assert_eq!(of("carla://[::1]:99"), Some(Ok("[::1]:99".to_owned())));
        assert_eq!(of("carla://[::1]"), Some(Ok("[::1]:2000".to_owned())));
        for wrong in ["carla://a b", "carla://:2000", "carla://host:0", "carla://host:70000", "carla://host:x"] {
            assert!(matches!(of(wrong), Some(Err(_))), "{wrong}");
        }
    }
}
