//! A small writer gives the reader something to read.

use super::*;
use proptest::prelude::*;

fn varint(mut v: u64, out: &mut Vec<u8>) {
    while v >= 0x80 {
        out.push(v as u8 | 0x80);
        v >>= 7;
    }
    out.push(v as u8);
}

fn number(field: u64, v: u64, out: &mut Vec<u8>) {
    varint(field << 3, out);
    varint(v, out);
}

fn bytes(field: u64, data: &[u8], out: &mut Vec<u8>) {
    varint(field << 3 | 2, out);
    varint(data.len() as u64, out);
    out.extend_from_slice(data);
}

fn zigzag(v: i64) -> u64 {
    ((v << 1) ^ (v >> 63)) as u64
}

fn list(values: &[u64]) -> Vec<u8> {
    let mut out = Vec::new();
    values.iter().for_each(|&v| varint(v, &mut out));
    out
}

fn blob(kind: &str, content: &[u8], zlib: bool) -> Vec<u8> {
    let mut body = Vec::new();
    if zlib {
        bytes(3, &miniz_oxide::deflate::compress_to_vec_zlib(content, 6), &mut body);
    } else {
        bytes(1, content, &mut body);
    }
    let mut header = Vec::new();
    bytes(1, kind.as_bytes(), &mut header);
    number(3, body.len() as u64, &mut header);
    let mut out = (header.len() as u32).to_be_bytes().to_vec();
    out.extend(header);
    out.extend(body);
    out
}

/// Two dense nodes, the first tagged, and a way along them.
pub(crate) fn sample(zlib: bool) -> Vec<u8> {
    let mut header = Vec::new();
    bytes(4, b"OsmSchema-V0.6", &mut header);
    bytes(4, b"DenseNodes", &mut header);
    let mut strings = Vec::new();
    for text in ["", "highway", "residential", "traffic_signals"] {
        bytes(1, text.as_bytes(), &mut strings);
    }
    let mut dense = Vec::new();
    bytes(1, &list(&[zigzag(10), zigzag(1)]), &mut dense);
    bytes(8, &list(&[zigzag(-120_500_000), zigzag(5_000)]), &mut dense);
    bytes(9, &list(&[zigzag(-771_400_000), zigzag(7_000)]), &mut dense);
    bytes(10, &list(&[1, 3, 0, 0]), &mut dense);
    let mut way = Vec::new();
    number(1, 77, &mut way);
    bytes(2, &list(&[1]), &mut way);
    bytes(3, &list(&[2]), &mut way);
    bytes(8, &list(&[zigzag(10), zigzag(1)]), &mut way);
    let mut group = Vec::new();
    bytes(2, &dense, &mut group);
    bytes(3, &way, &mut group);
    let mut block = Vec::new();
    bytes(1, &strings, &mut block);
    bytes(2, &group, &mut block);
    [blob("OSMHeader", &header, zlib), blob("OSMData", &block, zlib)].concat()
}

#[test]
fn reads_raw_and_packed_blobs() {
    for zlib in [false, true] {
        let file = sample(zlib);
        assert!(looks_like(&file));
        let extract = read(&file).expect("well formed");
        assert!((extract.nodes[&10].lat + 12.05).abs() < 1e-9 && (extract.nodes[&11].lon + 77.1393).abs() < 1e-9);
        assert_eq!(extract.nodes[&10].tags.get("highway"), Some("traffic_signals"));
        assert!(extract.nodes[&11].tags.iter().next().is_none());
        assert_eq!(extract.ways[0].nodes, [10, 11]);
        assert_eq!(extract.ways[0].tags.get("highway"), Some("residential"));
    }
}

proptest! {
    #[test]
    fn damaged_files_give_errors(cut in 0usize..400, changes in prop::collection::vec((0usize..400, any::<u8>()), 0..6), zlib: bool) {
        let mut file = sample(zlib);
        for (at, byte) in changes {
            let n = file.len();
            file[at % n] = byte;
        }
        file.truncate(cut.max(1));
        let _ = read(&file);
    }
}
