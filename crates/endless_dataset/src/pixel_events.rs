//! Files of an event camera: NumPy arrays of records (NEP 1, version 1.0), so that `numpy.load` opens them. The fields are
//! those of CARLA's `DVSEventArray`: x and y as u16, t as i64 (here microseconds), pol as bool; 13 bytes an event.

use endless_world::PixelEvent;

const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
const BEFORE_LENGTH: &str =
    "{'descr': [('x', '<u2'), ('y', '<u2'), ('t', '<i8'), ('pol', '|b1')], 'fortran_order': False, 'shape': (";
const AFTER_LENGTH: &str = ",), }";
/// The data begin at a multiple of this.
const ALIGNED: usize = 64;
const EVENT_BYTES: usize = 13;

/// An event as 13 bytes, least significant first.
type EventBytes = [u8; EVENT_BYTES];

/// The `.npy` file of events.
pub fn encode_pixel_events(events: &[PixelEvent]) -> Vec<u8> {
    let mut bytes = header(events.len());
    bytes.reserve(events.len() * EVENT_BYTES);
    for event in events {
        let mut record: EventBytes = [0; EVENT_BYTES];
        record[0..2].copy_from_slice(&event.x.to_le_bytes());
        record[2..4].copy_from_slice(&event.y.to_le_bytes());
        record[4..12].copy_from_slice(&event.t_us.to_le_bytes());
        record[12] = u8::from(event.polarity);
        bytes.extend(record);
    }
    bytes
}

/// The events of such a file, in its order.
///
/// # Errors
/// What is wrong with it. Files of other programs may have other headers: they are refused.
pub fn decode_pixel_events(bytes: &[u8]) -> Result<Vec<PixelEvent>, String> {
    let text = "is no NumPy file of events";
    let length_bytes = bytes.strip_prefix(MAGIC).and_then(|rest| rest.first_chunk::<2>()).ok_or(text)?;
    let begin = MAGIC.len() + 2 + usize::from(u16::from_le_bytes(*length_bytes));
    let (head, data) = bytes.split_at_checked(begin).ok_or("ends in its header")?;
    let words = std::str::from_utf8(&head[MAGIC.len() + 2..]).map_err(|_not_text| text)?;
    let count = words.strip_prefix(BEFORE_LENGTH).and_then(|rest| rest.split_once(AFTER_LENGTH)).ok_or(text)?;
    let count: usize = count.0.parse().map_err(|_no_number| text)?;
    if head != header(count) {
        return Err(text.to_owned());
    }
    let (records, rest) = data.as_chunks::<EVENT_BYTES>();
    if records.len() != count || !rest.is_empty() {
        return Err(format!("has {} bytes of events instead of those of {count}", data.len()));
    }
    records.iter().map(event).collect()
}

fn event(record: &EventBytes) -> Result<PixelEvent, String> {
    let [x0, x1, y0, y1, time @ .., polarity] = *record;
    let polarity = match polarity {
        0 => false,
        1 => true,
        other => return Err(format!("has an event of polarity {other}")),
    };
    Ok(PixelEvent {
        t_us: i64::from_le_bytes(time),
        y: u16::from_le_bytes([y0, y1]),
        x: u16::from_le_bytes([x0, x1]),
        polarity,
    })
}

fn header(count: usize) -> Vec<u8> {
    let mut words = format!("{BEFORE_LENGTH}{count}{AFTER_LENGTH}");
    let end = MAGIC.len() + 2 + words.len() + 1;
    words.extend(std::iter::repeat_n(' ', end.next_multiple_of(ALIGNED) - end));
    words.push('\n');
    let length = u16::try_from(words.len()).expect("a header is short");
    [MAGIC, &length.to_le_bytes(), words.as_bytes()].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn events() -> impl Strategy<Value = Vec<PixelEvent>> {
        let event = (any::<i64>(), any::<u16>(), any::<u16>(), any::<bool>());
        let event = event.prop_map(|(t_us, y, x, polarity)| PixelEvent { t_us, y, x, polarity });
        prop::collection::vec(event, 0..50)
    }

    /// `numpy.load` of these bytes gives [(3, 4, -5, True), (1, 2, 1000000000000, False)].
    #[test]
    fn numpy_knows_the_format() {
        let event = |x, y, t_us, polarity| PixelEvent { t_us, y, x, polarity };
        let bytes = encode_pixel_events(&[event(3, 4, -5, true), event(1, 2, 1_000_000_000_000, false)]);
        let (head, data) = bytes.split_at(128);
        assert_eq!(head[..10], *b"\x93NUMPY\x01\x00\x76\x00");
        let words = "{'descr': [('x', '<u2'), ('y', '<u2'), ('t', '<i8'), ('pol', '|b1')], 'fortran_order': False, \
                     'shape': (2,), }";
        assert_eq!(std::str::from_utf8(&head[10..]).map(str::trim_end), Ok(words));
        assert_eq!(head[127], b'\n');
        let first = [3, 0, 4, 0, 0xfb, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1];
        let second = [1, 0, 2, 0, 0, 0x10, 0xa5, 0xd4, 0xe8, 0, 0, 0, 0];
        assert_eq!(data, [first, second].concat());
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(events in events()) {
            let bytes = encode_pixel_events(&events);
            prop_assert_eq!((bytes.len() - EVENT_BYTES * events.len()) % ALIGNED, 0);
            prop_assert_eq!(decode_pixel_events(&bytes), Ok(events));
        }

        #[test]
        fn damaged_files_are_told(events in events(), at in any::<prop::sample::Index>(), to in any::<u8>(), cut in any::<bool>()) {
            let good = encode_pixel_events(&events);
            let mut bytes = good.clone();
            let place = at.index(bytes.len());
            if cut { bytes.truncate(place) } else { bytes[place] = to }
            // A changed value is no damage; anything else is.
            if let Ok(read) = decode_pixel_events(&bytes) {
                prop_assert_eq!(encode_pixel_events(&read), bytes);
            }
        }

        #[test]
        fn any_bytes_are_judged(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            prop_assert!(decode_pixel_events(&bytes).is_err());
            prop_assert!(decode_pixel_events(&[MAGIC, &bytes].concat()).is_err());
        }
    }
}
