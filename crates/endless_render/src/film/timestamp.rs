//! The time that a recorder stamps into its pictures.

use endless_world::{ImageSize, RecorderClock, glyph};

/// What the clock shows so many seconds after the first frame.
fn text(clock: RecorderClock, later_s: u32) -> String {
    let second = clock.second + later_s;
    let [year, month, day] = (0..second / 86_400).fold(clock.date, |date, _| next_day(date));
    let second = second % 86_400;
    format!("{year:04}-{month:02}-{day:02} {:02}:{:02}:{:02}", second / 3600, second / 60 % 60, second % 60)
}

/// The day after, in the Gregorian calendar.
fn next_day([year, month, day]: [u16; 3]) -> [u16; 3] {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let days = match month {
        2 => 28 + u16::from(leap),
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    };
    match (day < days, month < 12) {
        (true, _) => [year, month, day + 1],
        (false, true) => [year, month + 1, 1],
        (false, false) => [year + 1, 1, 1],
    }
}

/// Stamps the time into a picture's upper left corner: white with a dark rim.
pub(super) fn stamp(clock: RecorderClock, later_s: u32, size: ImageSize, rgb: &mut [[u8; 3]]) {
    let dot = i64::from(size.height / 300).max(1);
    let (left, top) = (8 * dot, 8 * dot);
    for (value, rim) in [([16; 3], 1), ([240; 3], 0)] {
        for (n, character) in text(clock, later_s).chars().enumerate() {
            let Some(rows) = glyph(character) else { continue };
            for (y, row) in (0i64..).zip(rows) {
                for x in (0..5i64).filter(|x| row >> (4 - x) & 1 == 1) {
                    let (x, y) = (left + (n as i64 * 6 + x) * dot, top + y * dot);
                    fill(rgb, size, [x - rim, y - rim], dot + 2 * rim, value);
                }
            }
        }
    }
}

fn fill(rgb: &mut [[u8; 3]], size: ImageSize, [x0, y0]: [i64; 2], side: i64, value: [u8; 3]) {
    for y in y0.max(0)..(y0 + side).min(i64::from(size.height)) {
        for x in x0.max(0)..(x0 + side).min(i64::from(size.width)) {
            rgb[(y * i64::from(size.width) + x) as usize] = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_ticks() {
        let clock = RecorderClock { date: [2024, 3, 9], second: 23 * 3600 + 59 * 60 + 58 };
        assert_eq!(text(clock, 1), "2024-03-09 23:59:59");
        assert_eq!(text(clock, 2), "2024-03-10 00:00:00");
        assert_eq!(next_day([2024, 2, 28]), [2024, 2, 29]);
        assert_eq!(next_day([2100, 2, 28]), [2100, 3, 1]);
        assert_eq!(next_day([2025, 12, 31]), [2026, 1, 1]);
    }

    #[test]
    fn small_pictures_are_no_trouble() {
        for (width, height) in [(1, 1), (20, 3), (200, 40)] {
            let size = ImageSize { width, height };
            let mut rgb = vec![[100u8; 3]; size.pixels()];
            stamp(RecorderClock { date: [2024, 1, 1], second: 0 }, 0, size, &mut rgb);
            assert_eq!(rgb.iter().any(|p| *p != [100; 3]), width >= 20 && height >= 10);
        }
    }
}
