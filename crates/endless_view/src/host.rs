//! Under which names this server answers.
//!
//! A page of another site can make its own name lead to this machine (DNS rebinding), and would then read the dataset as
//! if it were its own. The browser tells the name it used, so only names that are this machine's for sure are answered.

use std::net::{IpAddr, Ipv6Addr};

/// Whether a request under this name is for a server that listens at `bound`. The port does not matter: a tunnel may have
/// another.
pub(crate) fn is_own(host: &str, bound: IpAddr) -> bool {
    let Some(name) = without_port(host) else { return false };
    if name.eq_ignore_ascii_case("localhost") {
        return true;
    }
    match address(name) {
        // Who is let in from elsewhere uses an address of this machine, and no name of DNS is an address.
        Some(address) => address.is_loopback() || !bound.is_loopback(),
        None => false,
    }
}

/// The name, if the rest is a port.
fn without_port(host: &str) -> Option<&str> {
    let end = if host.starts_with('[') { host.find(']')? + 1 } else { host.find(':').unwrap_or(host.len()) };
    let (name, rest) = host.split_at(end);
    let port = match rest.strip_prefix(':') {
        Some(port) => port.len() <= 5 && !port.is_empty() && port.bytes().all(|byte| byte.is_ascii_digit()),
        None => rest.is_empty(),
    };
    port.then_some(name)
}

fn address(name: &str) -> Option<IpAddr> {
    match name.strip_prefix('[') {
        Some(rest) => rest.strip_suffix(']')?.parse::<Ipv6Addr>().ok().map(IpAddr::V6),
        None => name.parse::<std::net::Ipv4Addr>().ok().map(IpAddr::V4),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Ipv4Addr;

    #[test]
    fn only_names_of_this_machine_are_own() {
        let loopback = IpAddr::V4(Ipv4Addr::LOCALHOST);
        for host in ["localhost", "LocalHost:80", "127.0.0.1", "127.0.0.1:65535", "127.9.9.9", "[::1]", "[::1]:8080"] {
            assert!(is_own(host, loopback), "{host}");
        }
        let foreign = [
            "",
            ":",
            ":80",
            "evil.example",
            "localhost.evil.example",
            "127.0.0.1.evil.example",
            "localhost:",
            "localhost:80:80",
            "localhost:8o",
            "localhost:123456",
            "192.168.0.7",
            "0.0.0.0",
            "[::2]",
            "[::1",
            "[::1]x",
            "::1",
            "user@localhost",
            "localhost/",
            "localhost evil",
            "2130706433",
            "0x7f.1",
            "127.1",
            "[fe80::1%25lo]",
            "localhost.",
        ];
        for host in foreign {
            assert!(!is_own(host, loopback), "{host}");
        }
        let open = IpAddr::V4(Ipv4Addr::UNSPECIFIED);
        assert!(is_own("192.168.0.7:8080", open) && is_own("[fe80::1]", open) && !is_own("evil.example", open));
    }
}
