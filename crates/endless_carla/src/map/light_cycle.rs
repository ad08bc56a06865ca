//! How traffic lights change, as CARLA's do: in each group one stage after another is green, then yellow, then red for a
//! moment in which all are red.

use super::TrafficLight;

/// What a traffic light shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LightState {
    /// Stop.
    #[default]
    Red,
    /// Red is next.
    Yellow,
    /// Go.
    Green,
    /// Nothing.
    Off,
}

impl LightState {
    /// As a number on the wire.
    pub const fn number(self) -> u8 {
        match self {
            Self::Red => 0,
            Self::Yellow => 1,
            Self::Green => 2,
            Self::Off => 3,
        }
    }

    /// From a number on the wire; `None` for unknown states.
    pub const fn from_number(number: u8) -> Option<Self> {
        match number {
            0 => Some(Self::Red),
            1 => Some(Self::Yellow),
            2 => Some(Self::Green),
            3 => Some(Self::Off),
            _ => None,
        }
    }
}

/// How long the lights of a stage show each colour, seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightTimes {
    /// Green.
    pub green_s: f32,
    /// Yellow.
    pub yellow_s: f32,
    /// Red before the next stage is green.
    pub red_s: f32,
}

impl Default for LightTimes {
    fn default() -> Self {
        Self { green_s: 10.0, yellow_s: 3.0, red_s: 2.0 }
    }
}

impl LightTimes {
    fn of(&self, state: LightState) -> f32 {
        match state {
            LightState::Green => self.green_s,
            LightState::Yellow => self.yellow_s,
            LightState::Red | LightState::Off => self.red_s,
        }
    }
}

/// The lights of one junction.
#[derive(Debug, Clone, PartialEq)]
struct LightGroup {
    /// Lights of each stage, and their times.
    stages: Vec<(Vec<usize>, LightTimes)>,
    /// The stage whose turn it is.
    turn: usize,
    /// What its lights show.
    showing: LightState,
    /// Seconds since they show it.
    elapsed_s: f64,
    frozen: bool,
}

/// What all traffic lights of a map show, by their place in [`super::CarlaMap::traffic_lights`].
#[derive(Debug, Clone, PartialEq)]
pub struct LightCycle {
    groups: Vec<LightGroup>,
    /// Group and stage of each light.
    places: Vec<(usize, usize)>,
    states: Vec<LightState>,
}

impl LightCycle {
    /// All groups at their beginning.
    pub fn new(lights: &[TrafficLight]) -> Self {
        let mut groups: Vec<LightGroup> = Vec::new();
        let mut places = Vec::new();
        for (light, known) in lights.iter().enumerate() {
            let (group, stage) = (known.group as usize, known.stage as usize);
            while groups.len() <= group {
                let (stages, turn, showing) = (Vec::new(), 0, LightState::Green);
                groups.push(LightGroup { stages, turn, showing, elapsed_s: 0.0, frozen: false });
            }
            let stages = &mut groups[group].stages;
            while stages.len() <= stage {
                stages.push((Vec::new(), LightTimes::default()));
            }
            stages[stage].0.push(light);
            places.push((group, stage));
        }
        let mut cycle = Self { groups, places, states: vec![LightState::Red; lights.len()] };
        cycle.reset_all();
        cycle
    }

    /// Lets time pass, seconds, in all groups that are not frozen.
    pub fn tick(&mut self, dt_s: f64) {
        for group in 0..self.groups.len() {
            if !self.groups[group].frozen && !self.groups[group].stages.is_empty() {
                self.groups[group].elapsed_s += dt_s;
                self.advance(group);
            }
        }
    }

    /// Shows what is due. A group of which no light ever shows anything for any time stays as it is.
    fn advance(&mut self, group: usize) {
        let cycle: f32 = self.groups[group].stages.iter().map(|(_, t)| t.green_s + t.yellow_s + t.red_s).sum();
        if !cycle.is_finite() || cycle <= 0.0 {
            return;
        }
        loop {
            let now = &mut self.groups[group];
            let due_s = f64::from(now.stages[now.turn].1.of(now.showing).max(0.0));
            // Seconds are sums of many small steps.
            if now.elapsed_s < due_s - 1e-6 {
                return;
            }
            now.elapsed_s = (now.elapsed_s - due_s).max(0.0);
            now.showing = match now.showing {
                LightState::Green => LightState::Yellow,
                LightState::Yellow => LightState::Red,
                LightState::Red | LightState::Off => {
                    now.turn = (now.turn + 1) % now.stages.len();
                    LightState::Green
                }
            };
            self.show(group);
        }
    }

    fn show(&mut self, group: usize) {
        let now = &self.groups[group];
        for (stage, (lights, _)) in now.stages.iter().enumerate() {
            for &light in lights {
                self.states[light] = if stage == now.turn { now.showing } else { LightState::Red };
            }
        }
    }

    /// What a light shows; nothing if there is no such light.
    pub fn state(&self, light: usize) -> LightState {
        self.states.get(light).copied().unwrap_or(LightState::Off)
    }

    /// Makes a light show something until its group changes next.
    pub fn set_state(&mut self, light: usize, state: LightState) {
        if let Some(shown) = self.states.get_mut(light) {
            *shown = state;
        }
    }

    /// Seconds since the group of a light changed.
    pub fn elapsed_s(&self, light: usize) -> f64 {
        self.group_of(light).map_or(0.0, |group| group.elapsed_s)
    }

    /// How long a light shows each colour.
    pub fn times(&self, light: usize) -> LightTimes {
        let stage = self.places.get(light).and_then(|&(group, stage)| self.groups[group].stages.get(stage));
        stage.map_or_else(LightTimes::default, |(_, times)| *times)
    }

    /// Sets how long a light, and all that are green with it, show each colour.
    pub fn set_times(&mut self, light: usize, times: LightTimes) {
        if let Some(&(group, stage)) = self.places.get(light) {
            self.groups[group].stages[stage].1 = times;
        }
    }

    /// Whether the group of a light stands still.
    pub fn is_frozen(&self, light: usize) -> bool {
        self.group_of(light).is_some_and(|group| group.frozen)
    }

    /// Lets the group of a light stand still, or go on.
    pub fn freeze(&mut self, light: usize, frozen: bool) {
        if let Some(&(group, _)) = self.places.get(light) {
            self.groups[group].frozen = frozen;
        }
    }

    /// The same for all groups.
    pub fn freeze_all(&mut self, frozen: bool) {
        for group in &mut self.groups {
            group.frozen = frozen;
        }
    }

    /// The lights of the group of a light, ascending, itself included.
    pub fn group(&self, light: usize) -> Vec<usize> {
        let mut lights: Vec<usize> =
            self.group_of(light).into_iter().flat_map(|g| &g.stages).flat_map(|(lights, _)| lights).copied().collect();
        lights.sort_unstable();
        lights
    }

    /// Begins anew in the group of a light: its first stage is green.
    pub fn reset_group(&mut self, light: usize) {
        if let Some(&(group, _)) = self.places.get(light) {
            self.begin(group);
        }
    }

    /// The same in all groups.
    pub fn reset_all(&mut self) {
        (0..self.groups.len()).for_each(|group| self.begin(group));
    }

    fn begin(&mut self, group: usize) {
        let now = &mut self.groups[group];
        (now.turn, now.showing, now.elapsed_s) = (0, LightState::Green, 0.0);
        self.show(group);
    }

    fn group_of(&self, light: usize) -> Option<&LightGroup> {
        self.places.get(light).map(|&(group, _)| &self.groups[group])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::{BoundingBox, Transform};
    use endless_world::SignalId;

    fn lights(places: &[(u32, u32)]) -> Vec<TrafficLight> {
        let light = |(group, stage): (u32, u32)| TrafficLight {
            sign_id: String::new(),
            signal: SignalId(0),
            lanes: Vec::new(),
            pole: Transform::default(),
            trigger_boxes: Vec::new(),
            trigger_volume: BoundingBox::default(),
            group,
            stage,
            pole_index: 0,
        };
        places.iter().copied().map(light).collect()
    }

    #[test]
    fn stages_take_turns_with_a_moment_of_red() {
        use LightState::{Green, Red, Yellow};
        let mut cycle = LightCycle::new(&lights(&[(0, 0), (0, 1), (0, 0), (1, 0)]));
        let mut seen = Vec::new();
        for _ in 0..600 {
            let states = [cycle.state(0), cycle.state(1)];
            assert_eq!(cycle.state(0), cycle.state(2));
            if seen.last() != Some(&states) {
                seen.push(states);
            }
            cycle.tick(0.05);
        }
        assert_eq!(seen, [[Green, Red], [Yellow, Red], [Red, Red], [Red, Green], [Red, Yellow], [Red, Red]]);
        // 30 s: a new cycle begins.
        assert_eq!((cycle.state(0), cycle.state(3)), (Green, Green));
        assert!(cycle.elapsed_s(0).abs() < 1e-6);
    }

    #[test]
    fn lights_are_set_frozen_and_reset() {
        let mut cycle = LightCycle::new(&lights(&[(0, 0), (0, 1), (1, 0)]));
        cycle.freeze(1, true);
        cycle.tick(11.0);
        assert_eq!((cycle.state(0), cycle.state(2)), (LightState::Green, LightState::Yellow));
        cycle.set_state(1, LightState::Off);
        assert_eq!(cycle.state(1), LightState::Off);
        cycle.freeze_all(false);
        cycle.set_times(0, LightTimes { green_s: 1.0, yellow_s: 0.5, red_s: 0.0 });
        assert_eq!(cycle.times(1), LightTimes::default());
        cycle.tick(1.6);
        assert_eq!((cycle.state(0), cycle.state(1)), (LightState::Red, LightState::Green));
        assert_eq!(cycle.group(1), [0, 1]);
        cycle.reset_group(0);
        assert_eq!((cycle.state(0), cycle.state(1), cycle.elapsed_s(0)), (LightState::Green, LightState::Red, 0.0));
        assert_eq!(cycle.state(99), LightState::Off);
        for state in [LightState::Red, LightState::Yellow, LightState::Green, LightState::Off] {
            assert_eq!(LightState::from_number(state.number()), Some(state));
        }
    }
}
