//! Whoever means harm gets an error of theirs, and nothing else.

use crate::{
    fixture::{Fixture, SECRET},
    http::{get, get_with, send},
};
use std::{collections::BTreeSet, net::SocketAddr};

/// Ways to a file that nobody may see, were a path made of them.
fn paths() -> Vec<String> {
    let ups =
        ["..", "%2e%2e", "%2E%2E", ".%2e", "%252e%252e", "..%00", "%c0%ae%c0%ae", "..;", "....", "\u{ff0e}\u{ff0e}"];
    let slashes = ["/", "%2f", "%2F", "\\", "%5c", "%252f", "//", "/./", "%c0%af"];
    let files = ["secret.txt", "dataset.json", "etc/passwd", "videos"];
    let prefixes = ["/", "/api/", "/api/videos/", "/api/videos/0/cameras/0/images/"];
    let mut paths = Vec::new();
    for prefix in prefixes {
        for up in ups {
            for slash in slashes {
                for file in files {
                    paths.push(format!("{prefix}{up}{slash}{up}{slash}{file}"));
                }
            }
        }
    }
    let plain = [
        "/secret.txt",
        "//secret.txt",
        "/./secret.txt",
        "/dataset.json",
        "/scenes/0000.json",
        "/videos/",
        "/.lock",
        "/index.html",
        "/page/main.js",
        "/main.js/",
        "/main.js%00",
        "/MAIN.JS",
        "/api",
        "/api/",
        "/api/dataset/",
        "/api/videos",
        "/api/videos/-1",
        "/api/videos/1.5",
        "/api/videos/4294967296",
        "/api/videos/0x0",
        "/api/videos/%00",
        "/api/videos/0%20",
        "/api/videos/0/cameras/18446744073709551616/map",
        "/api/videos/0/cameras/-1/map",
        "/api/videos/0/cameras/camera_a/map",
        "/api/videos/0/cameras/0/objects",
        "/api/videos/0/cameras/9/map",
        "/api/videos/0/cameras/0/objects?from=0",
        "/api/videos/0/cameras/0/objects?from=-1&count=1",
        "/api/videos/0/cameras/0/objects?from=0&count=x",
        "/api/videos/0/cameras/0/objects?from=0&count=1&path=/etc/passwd",
        "/api/videos/0/cameras/0/objects?from=0&from=1&count=1",
        "/api/videos/0/cameras/0/images/secret/0",
        "/api/videos/0/cameras/0/images/RGB/0",
        "/api/videos/0/cameras/0/images/rgb/0.png",
        "/api/videos/0/cameras/0/images/rgb/-0",
        "/api/videos/0/cameras/0/images/rgb/99",
        "/api/videos/0/cameras/0/images/rgb/4294967295",
        "/api/videos/0/cameras/0/images//0",
        "/api/videos/0/cameras/0/images/rgb%2f..%2f..%2fsecret.txt/0",
        "/api/videos/0/cameras/0/pictures/%2e%2e/0",
        "/api/videos/0/cameras/0/images/.%2f/0",
        "/api/videos/00000000000000000000000000000000000001",
        "/favicon.ico",
        "/robots.txt",
        "/.git/config",
        "/%3Cscript%3Ealert(1)%3C/script%3E",
    ];
    paths.extend(plain.map(str::to_owned));
    paths
}

/// Whole requests, each for what it is.
fn requests(address: SocketAddr) -> Vec<(String, Vec<u8>)> {
    let mut requests = Vec::new();
    let mut add = |what: String, head: String| {
        requests.push((what, format!("{head}Connection: close\r\n\r\n").into_bytes()));
    };
    for path in paths() {
        add(path.clone(), format!("GET {path} HTTP/1.1\r\nHost: {address}\r\n"));
    }
    let hosts = [
        "evil.example",
        "evil.example:80",
        "localhost.evil.example",
        "127.0.0.1.evil.example",
        "0.0.0.0",
        "10.0.0.1",
        "192.168.1.1",
        "[::2]",
        "",
        " ",
        "localhost, evil.example",
        "user@127.0.0.1",
        "127.0.0.1:99999999",
        "127.0.0.1/..",
        "2130706433",
        "0x7f000001",
        "localhost.",
        "*",
        "\u{fffd}",
    ];
    for host in hosts {
        for path in ["/", "/api/dataset", "/api/videos/0/cameras/0/images/rgb/0"] {
            add(format!("host {host:?} {path}"), format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n"));
        }
        if !host.trim().is_empty() && !host.contains([' ', '\u{fffd}']) {
            add(format!("absolute {host}"), format!("GET http://{host}/api/dataset HTTP/1.1\r\nHost: {address}\r\n"));
        }
    }
    add("no host".into(), "GET / HTTP/1.1\r\n".into());
    add("no host, 1.0".into(), "GET / HTTP/1.0\r\n".into());
    add("two hosts".into(), format!("GET / HTTP/1.1\r\nHost: {address}\r\nHost: evil.example\r\n"));
    for method in ["POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "PROPFIND", "BREW", "CONNECT"] {
        for path in ["/", "/api/dataset", "/api/videos/0", "/api/videos/0/cameras/0/images/rgb/0"] {
            let target = if method == "CONNECT" { address.to_string() } else { path.to_owned() };
            add(format!("{method} {path}"), format!("{method} {target} HTTP/1.1\r\nHost: {address}\r\n"));
        }
    }
    for size in [20_000, 200_000, 2_000_000] {
        add(format!("header of {size}"), format!("GET / HTTP/1.1\r\nHost: {address}\r\nX: {}\r\n", "a".repeat(size)));
        add(format!("address of {size}"), format!("GET /{} HTTP/1.1\r\nHost: {address}\r\n", "a".repeat(size)));
        add(format!("host of {size}"), format!("GET / HTTP/1.1\r\nHost: {}\r\n", "a".repeat(size)));
        add(
            format!("cookie of {size}"),
            format!("GET / HTTP/1.1\r\nHost: {address}\r\nCookie: {}\r\n", "a=b; ".repeat(size / 5)),
        );
    }
    for count in [65, 100, 1000] {
        let headers: String = (0..count).map(|i| format!("X-{i}: 1\r\n")).collect();
        add(format!("{count} headers"), format!("GET / HTTP/1.1\r\nHost: {address}\r\n{headers}"));
    }
    for site in ["cross-site", "same-site"] {
        for path in ["/api/dataset", "/api/videos/0/cameras/0/images/rgb/0", "/main.js"] {
            add(
                format!("{site} {path}"),
                format!("GET {path} HTTP/1.1\r\nHost: {address}\r\nSec-Fetch-Site: {site}\r\n"),
            );
        }
    }
    let broken = [
        "GET\r\n",
        "GET /\r\n",
        "/ GET HTTP/1.1\r\n",
        "GET / HTTP/9.9\r\n",
        "GET / HTTX/1.1\r\n",
        "GET  / HTTP/1.1\r\n",
        "GET / HTTP/1.1\r\nHost\r\n",
        "GET / HTTP/1.1\r\nHost : x\r\n",
        "GET / HTTP/1.1\r\n: x\r\n",
        "G\0T / HTTP/1.1\r\n",
        "GET /\0 HTTP/1.1\r\n",
        "GET secret.txt HTTP/1.1\r\n",
        "GET ../secret.txt HTTP/1.1\r\n",
        "GET file:///etc/passwd HTTP/1.1\r\n",
        "{\"a\": 1}\r\n",
        "\x16\x03\x01\x02\r\n",
        "GET * HTTP/1.1\r\n",
    ];
    for line in broken {
        add(format!("{line:?}"), line.to_owned());
    }
    let length = "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n";
    add("two lengths".into(), format!("POST / HTTP/1.1\r\nHost: {address}\r\n{length}"));
    add("a length that is none".into(), format!("GET / HTTP/1.1\r\nHost: {address}\r\nContent-Length: -1\r\n"));
    requests
}

#[test]
fn a_thousand_hostile_requests_get_4xx_and_nothing_else() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let requests = requests(served.address);
    assert!(requests.len() > 1000, "{}", requests.len());
    let (mut wrong, mut statuses) = (Vec::new(), BTreeSet::new());
    for (what, request) in &requests {
        let answer = send(served.address, request);
        let text = answer.text();
        statuses.insert(answer.status);
        let leaks = text.contains(SECRET) || text.contains("root:") || text.contains("\"recipe\"") || text.len() > 300;
        if !(400..500).contains(&answer.status) || leaks {
            wrong.push(format!("{}: {what:.120} {text:.80}", answer.status));
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), requests.len(), wrong.join("\n"));
    assert_eq!(Vec::from_iter(statuses), [400, 403, 404, 405, 431], "each for what it is");
    assert_eq!(get(served.address, "/api/dataset").status, 200, "it goes on");
}

#[test]
fn those_who_belong_here_are_let_in() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let port = served.address.port();
    for host in
        [format!("localhost:{port}"), "localhost".into(), "127.0.0.1:8080".into(), "[::1]".into(), "LOCALHOST".into()]
    {
        let request = format!("GET /api/dataset HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        assert_eq!(send(served.address, request.as_bytes()).status, 200, "{host}");
    }
    for site in ["same-origin", "none"] {
        assert_eq!(
            get_with(served.address, "/api/dataset", &format!("Sec-Fetch-Site: {site}\r\n")).status,
            200,
            "{site}"
        );
    }
    assert_eq!(get_with(served.address, "/", "Sec-Fetch-Site: cross-site\r\n").status, 200, "a link from elsewhere");
}

#[test]
fn connections_that_say_nothing_keep_nobody_out() {
    let fixture = Fixture::new();
    let served = fixture.serve();
    let silent: Vec<_> = (0..100).map(|_| std::net::TcpStream::connect(served.address).expect("room")).collect();
    assert_eq!(get(served.address, "/api/dataset").status, 200);
    drop(silent);
}
