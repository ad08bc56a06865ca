//! Numbers as C++ streams write them: six significant digits, no zeros at the end.

/// A number's text.
pub(super) fn general(number: f64) -> String {
    const DIGITS: i32 = 6;
    if number.is_nan() {
        return "nan".to_owned();
    }
    if number.is_infinite() {
        return if number > 0.0 { "inf" } else { "-inf" }.to_owned();
    }
    let scientific = format!("{number:.5e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..DIGITS).contains(&exponent) {
        let decimals = (DIGITS - 1 - exponent).max(0) as usize;
        return without_zeros(&format!("{number:.decimals$}")).to_owned();
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", without_zeros(mantissa), exponent.abs())
}

/// The same of a number of single precision.
pub(super) fn general32(number: f32) -> String {
    general(number.into())
}

/// Numbers in brackets.
pub(super) fn vector<const N: usize>(numbers: [f32; N]) -> String {
    format!("({})", numbers.map(general32).join(", "))
}

fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_cpp_writes_them() {
        for (number, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.05, "0.05"),
            (-123.456_789, "-123.457"),
            (1_234_567.0, "1.23457e+06"),
            (999_999.5, "1e+06"),
            (100_000.0, "100000"),
            (0.000_123_456_78, "0.000123457"),
            (0.000_012_345, "1.2345e-05"),
            (f64::NAN, "nan"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(general(number), text);
        }
        assert_eq!(vector([1.0, -0.5]), "(1, -0.5)");
    }
}
