//! Clients that do what they should not.

use crate::client::{Client, serve};
use endless_carla::wire::{EpisodeInfo, EpisodeSettings};
use rmpv::Value;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

#[test]
fn wrong_requests_are_answered_and_harm_nobody() {
    let mut client = Client::new(serve());
    assert_eq!(client.call("no_such_method", &[]), Err("not supported: no_such_method".to_owned()));
    assert!(client.call("destroy_actor", &[]).is_err());
    assert!(client.call("destroy_actor", &["one".into()]).is_err());
    assert!(client.call("spawn_actor", &[Value::Nil, Value::Nil]).is_err());
    assert!(client.call("load_new_episode", &["Atlantis".into(), true.into(), 0.into()]).is_err());
    assert!(client.call("set_episode_settings", &[Value::Array(vec![])]).is_ok(), "short structs have defaults");
    let batch = client.raw("apply_batch", &[Value::Array(vec![Value::Nil, Value::from(7)]), false.into()]);
    assert_eq!(batch.as_array().map(Vec::len), Some(2), "an answer for each command");
    assert_eq!(client.get::<String>("version", &[]), "0.9.16");
}

#[test]
fn garbage_and_silence_harm_nobody() {
    let address = serve();
    let mut client = Client::new(address);
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    let port = u16::from_le_bytes([episode.token[0].0[4], episode.token[0].0[5]]);
    let silent: Vec<TcpStream> =
        [address.port(), port].map(|port| TcpStream::connect((address.ip(), port)).expect("open")).into();
    for port in [address.port(), port] {
        for garbage in [&b"GET / HTTP/1.1\r\n\r\n"[..], &[0xff; 5000], &[0xdd, 0xff, 0xff, 0xff, 0xff], &[0x91; 5000]] {
            let mut stream = TcpStream::connect((address.ip(), port)).expect("open");
            // The server may have closed it already.
            let _ = stream.write_all(garbage);
            let _ = stream.set_read_timeout(Some(Duration::from_secs(20)));
            let mut rest = Vec::new();
            let _ = stream.shutdown(std::net::Shutdown::Write);
            let _ = stream.read_to_end(&mut rest);
        }
    }
    assert_eq!(client.get::<String>("version", &[]), "0.9.16");
    drop(silent);
}

#[test]
fn a_client_that_dies_while_it_ticks_leaves_a_world_that_goes_on() {
    let address = serve();
    let mut other = Client::new(address);
    let episode: EpisodeInfo = other.get("get_episode_info", &[]);
    let mut snapshots = other.listen(&episode.token[0]);
    let mut ticking = Client::new(address);
    ticking.synchronous();
    let frame = ticking.tick();
    snapshots.of_frame(frame);
    drop(ticking);
    assert!(snapshots.next().frame > frame);
    assert!(!other.get::<EpisodeSettings>("get_episode_settings", &[]).synchronous_mode);
}

#[test]
fn who_does_not_read_holds_up_nobody() {
    let address = serve();
    let mut client = Client::new(address);
    let episode: EpisodeInfo = client.get("get_episode_info", &[]);
    let _deaf: Vec<_> = (0..20).map(|_| client.listen(&episode.token[0])).collect();
    let mut snapshots = client.listen(&episode.token[0]);
    let begun = Instant::now();
    for _ in 0..30 {
        snapshots.next();
    }
    assert!(begun.elapsed() < Duration::from_secs(30));
}
