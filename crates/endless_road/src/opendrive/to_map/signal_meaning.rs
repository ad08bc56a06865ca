//! The meaning of signals by their codes and names.

use super::super::document::Signal;

/// What a signal tells drivers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SignalMeaning {
    Light,
    WalkLight,
    Stop,
    Yield,
    /// km/h.
    SpeedLimit(u16),
    Other,
}

/// By the codes of OpenDRIVE itself, Germany and the United States, which others follow, and by name.
pub(super) fn meaning(signal: &Signal) -> SignalMeaning {
    let name = signal.name.to_ascii_lowercase();
    match signal.kind.as_str() {
        "1000002" | "1000003" => SignalMeaning::WalkLight,
        "206" | "R1-1" | "R1" => SignalMeaning::Stop,
        "205" | "R1-2" | "R2" => SignalMeaning::Yield,
        "274" | "R2-1" | "maximum" => {
            let stated = signal.value.or_else(|| signal.subtype.parse().ok()).or_else(|| digits(&signal.text));
            let factor = if signal.unit == "mph" || signal.kind == "R2-1" { 1.609 } else { 1.0 };
            stated.map_or(SignalMeaning::Other, |value| {
                SignalMeaning::SpeedLimit((value * factor).clamp(1.0, 250.0).round() as u16)
            })
        }
        kind if kind.starts_with("10000") && signal.dynamic => SignalMeaning::Light,
        "1000001" => SignalMeaning::Light,
        _ if name.contains("stop") && !signal.dynamic => SignalMeaning::Stop,
        _ if name.contains("yield") && !signal.dynamic => SignalMeaning::Yield,
        _ if signal.dynamic => SignalMeaning::Light,
        _ => SignalMeaning::Other,
    }
}

fn digits(text: &str) -> Option<f64> {
    let digits: String = text.chars().filter(char::is_ascii_digit).take(3).collect();
    digits.parse().ok()
}
