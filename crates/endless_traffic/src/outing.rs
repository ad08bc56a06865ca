//! How many of those who are on the streets by day in fair weather are there at other times and in rain.

use endless_world::{TimeOfDay, Weather};

/// Shares of vehicles and of people on foot, by the time of day: a plain pattern, with half the traffic of the day in the hours
/// after nightfall, and fewer people still; in the morning, shops are closed.
const MORNING: [f64; 2] = [1.0, 0.9];
const AFTERNOON: [f64; 2] = [1.0, 1.0];
const NIGHT: [f64; 2] = [0.5, 0.4];
/// At dusk and dawn people are on their way.
const TWILIGHT: [f64; 2] = [1.0, 0.8];
/// Share of people on foot who come in rain: 13 % fewer in an hour with precipitation (Aultman-Hall, Lane and Lambert 2009,
/// "Assessing impact of weather and season on pedestrian traffic volumes", Transportation Research Record 2140).
const IN_RAIN: f64 = 0.87;

/// Shares of vehicles and of people on foot; a night whose sun is drawn is a twilight.
pub(crate) fn shares(weather: Weather, time_of_day: TimeOfDay, drawn_sun: bool) -> [f64; 2] {
    let [vehicles, people] = match time_of_day {
        TimeOfDay::Night if drawn_sun => TWILIGHT,
        TimeOfDay::Morning => MORNING,
        TimeOfDay::Afternoon => AFTERNOON,
        TimeOfDay::Night => NIGHT,
    };
    [vehicles, if weather == Weather::Rainy { people * IN_RAIN } else { people }]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nights_are_quiet_and_rain_keeps_people_at_home() {
        for weather in Weather::ALL {
            let [morning, afternoon, night] = [TimeOfDay::Morning, TimeOfDay::Afternoon, TimeOfDay::Night]
                .map(|time_of_day| shares(*weather, time_of_day, false));
            let twilight = shares(*weather, TimeOfDay::Night, true);
            assert!(twilight[0] == afternoon[0] && (night[1]..afternoon[1]).contains(&twilight[1]));
            assert!(night[0] < afternoon[0] && night[1] < morning[1] && morning[1] < afternoon[1]);
        }
        let [rain, fair] =
            [Weather::Rainy, Weather::Cloudy].map(|weather| shares(weather, TimeOfDay::Afternoon, false));
        assert!(rain[0] == fair[0] && rain[1] < fair[1]);
    }
}
