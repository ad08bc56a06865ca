//! Numbers as people read them.

/// A whole number in groups of three digits.
pub(super) fn whole(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A share of a whole, in percent.
pub(super) fn percent(part: u64, of: u64) -> String {
    if of == 0 { "\u{2013}".into() } else { percent_of(part as f64 / of as f64) }
}

/// A share from 0 to 1, in percent.
pub(super) fn percent_of(share: f64) -> String {
    format!("{:.1}%", 100.0 * share)
}

/// A number with a decimal, or a dash.
pub(super) fn decimal(number: Option<f64>) -> String {
    number.map_or_else(|| "\u{2013}".into(), |number| format!("{number:.1}"))
}

/// A number with two decimals, or a dash.
pub(super) fn hundredths(number: Option<f64>) -> String {
    number.map_or_else(|| "\u{2013}".into(), |number| format!("{number:.2}"))
}

/// A whole number, or a dash.
pub(super) fn whole_or_dash(number: Option<u64>) -> String {
    number.map_or_else(|| "\u{2013}".into(), whole)
}

/// A length of time.
pub(super) fn duration(milliseconds: u64) -> String {
    let seconds = milliseconds as f64 / 1000.0;
    let (minutes, hours) = (milliseconds / 60_000, milliseconds / 3_600_000);
    match milliseconds {
        0..60_000 => format!("{seconds:.1} s"),
        60_000..3_600_000 => format!("{minutes} min {:.0} s", (seconds - 60.0 * minutes as f64).floor()),
        _ => format!("{hours} h {} min", minutes - 60 * hours),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_can_be_read() {
        assert_eq!([0, 999, 1000, 378_751, 1_234_567].map(whole), ["0", "999", "1,000", "378,751", "1,234,567"]);
        assert_eq!((percent(1, 8), percent(0, 0)), ("12.5%".to_owned(), "\u{2013}".to_owned()));
        assert_eq!([500, 61_000, 7_260_000].map(duration), ["0.5 s", "1 min 1 s", "2 h 1 min"]);
        assert_eq!((decimal(Some(2.25)), hundredths(None)), ("2.2".to_owned(), "\u{2013}".to_owned()));
    }
}
