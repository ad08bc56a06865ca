//! Dates as CARLA writes them.

const DAY_S: i64 = 86_400;

/// `month/day/year hour:minute:second`, of universal time.
pub(super) fn date_text(unix_s: i64) -> String {
    let (days, second) = (unix_s.div_euclid(DAY_S), unix_s.rem_euclid(DAY_S));
    let [year, month, day] = civil(days);
    let year = year.rem_euclid(100);
    format!("{month:02}/{day:02}/{year:02} {:02}:{:02}:{:02}", second / 3600, second / 60 % 60, second % 60)
}

/// Year, month and day of a day after 1 January 1970, in the Gregorian calendar, whose 400 years have 146,097 days. Years begin in
/// March here, so that the leap day is the last one.
fn civil(days: i64) -> [i64; 3] {
    // No file's date is so wrong that it matters.
    let from_march = days.clamp(-1_000_000_000, 1_000_000_000) + 719_468;
    let (era, of_era) = (from_march.div_euclid(146_097), from_march.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    [era * 400 + year + next, month, day]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_the_calendar() {
        assert_eq!(date_text(0), "01/01/70 00:00:00");
        assert_eq!(date_text(951_782_400), "02/29/00 00:00:00");
        assert_eq!(date_text(1_637_676_528), "11/23/21 14:08:48");
        assert_eq!(date_text(-1), "12/31/69 23:59:59");
        assert!(!date_text(i64::MAX).is_empty() && !date_text(i64::MIN).is_empty());
    }
}
