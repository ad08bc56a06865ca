use super::controller::{Controller, LEAST_GREEN_S, MOST_GREEN_S, PASSAGE_S};
use super::detector::Calls;
use super::stage::stages;
use endless_road::{SignalPhase, SignalProgram};
use endless_world::SignalAspect::{self, Green, Red, Yellow};
use endless_world::{SignalId, Stream};

const STEP_S: f64 = 1.0 / 30.0;
/// Signals: the main road, the side road, people over the side road and over the main road.
const MAIN: usize = 0;
const SIDE: usize = 1;
const OVER_SIDE: usize = 2;
const OVER_MAIN: usize = 3;

fn program() -> SignalProgram {
    let mut phases = Vec::new();
    for [go, walk] in [[MAIN, OVER_SIDE], [SIDE, OVER_MAIN]] {
        for (duration_s, car, person) in
            [(12.0, Green, Green), (8.0, Green, Yellow), (3.0, Yellow, Red), (2.0, Red, Red)]
        {
            let aspect = |signal: usize| {
                if signal == go {
                    car
                } else if signal == walk {
                    person
                } else {
                    Red
                }
            };
            let aspects = (0..4).map(|signal| (SignalId(signal as u16), aspect(signal))).collect();
            phases.push(SignalPhase { duration_s, aspects });
        }
    }
    SignalProgram { phases, offset_s: 0.0 }
}

fn controller() -> Controller {
    Controller::new(stages(&program(), &|signal| signal.0 >= 2).expect("two stages"))
}

fn shown(controller: &Controller) -> [SignalAspect; 4] {
    let mut all = [Red; 4];
    controller.shown().iter().for_each(|(signal, aspect)| all[usize::from(signal.0)] = *aspect);
    all
}

/// Seconds for which each signal is green in a row, while those of `calls` call at a time.
fn greens(controller: &mut Controller, seconds: f64, calls: impl Fn(f64) -> Vec<usize>) -> [Vec<f64>; 4] {
    let mut runs: [Vec<f64>; 4] = Default::default();
    let mut before = [Red; 4];
    for k in 0..(seconds / STEP_S) as usize {
        let called = calls(k as f64 * STEP_S);
        controller.step(&Calls::of((0..4).map(|signal| called.contains(&signal)).collect()), STEP_S);
        let now = shown(controller);
        for signal in 0..4 {
            if now[signal] == Green {
                if before[signal] != Green {
                    runs[signal].push(0.0);
                }
                *runs[signal].last_mut().expect("begun") += STEP_S;
            }
        }
        before = now;
    }
    runs
}

#[test]
fn a_side_street_without_a_call_never_gets_green() {
    let runs = greens(&mut controller(), 600.0, |_| vec![MAIN]);
    assert!(runs[SIDE].is_empty() && runs[OVER_MAIN].is_empty() && runs[MAIN].len() == 1);
    let runs = greens(&mut controller(), 600.0, |_| vec![]);
    assert!(runs[SIDE].is_empty() && runs[MAIN].len() == 1, "the main road is green when nobody calls");
}

#[test]
fn a_queue_holds_green_for_the_most_and_a_gap_ends_it() {
    let both = greens(&mut controller(), 600.0, |_| vec![MAIN, SIDE]);
    for signal in [MAIN, SIDE] {
        let whole = &both[signal][1..both[signal].len() - 1];
        assert!(whole.len() > 4 && whole.iter().all(|green_s| (green_s - MOST_GREEN_S).abs() < 0.1), "{whole:?}");
    }
    // One car on the side street, detected for 9 s of its green.
    let one = greens(&mut controller(), 120.0, |at_s| if (20.0..35.0).contains(&at_s) { vec![SIDE] } else { vec![] });
    let [green_s] = one[SIDE][..] else { panic!("{:?}", one[SIDE]) };
    let began_s = 20.0 + 5.0;
    assert!((began_s + green_s - 35.0 - PASSAGE_S).abs() < 0.2, "{green_s}");
    assert_eq!(one[MAIN].len(), 2, "back to the main road");
}

#[test]
fn green_is_never_shorter_than_the_least() {
    let short = greens(&mut controller(), 120.0, |at_s| if (20.0..25.3).contains(&at_s) { vec![SIDE] } else { vec![] });
    assert!((short[SIDE][0] - LEAST_GREEN_S).abs() < 0.1, "{:?}", short[SIDE]);
}

#[test]
fn people_get_their_walk_and_clearance_when_they_call() {
    let runs =
        greens(&mut controller(), 120.0, |at_s| if (20.0..25.3).contains(&at_s) { vec![OVER_MAIN] } else { vec![] });
    assert_eq!(runs[OVER_MAIN].len(), 1);
    assert!((runs[OVER_MAIN][0] - 7.0).abs() < 0.1 && runs[SIDE][0] > 15.0 - 0.1, "{runs:?}");
    // Beside a road that is green already, without anybody else.
    let runs =
        greens(&mut controller(), 60.0, |at_s| if (20.0..20.1).contains(&at_s) { vec![OVER_SIDE] } else { vec![] });
    assert!(runs[OVER_SIDE].len() == 1 && runs[MAIN].len() == 1, "{runs:?}");
}

/// Whoever calls: nobody who conflicts is green or yellow together, greens last, and no green follows another without yellow and red.
#[test]
fn conflicting_signals_are_never_green_together() {
    let mut stream = Stream::named(1, "test.actuated", &[]);
    let mut controller = controller();
    let mut called = vec![false; 4];
    let (mut green_s, mut before) = ([0.0; 4], [Red; 4]);
    for k in 0..200_000 {
        if k % 20 == 0 {
            let signal = stream.below(4);
            called[signal] = stream.chance(0.4);
        }
        controller.step(&Calls::of(called.clone()), STEP_S);
        let now = shown(&controller);
        let open = |signal: usize| now[signal] != Red;
        assert!(!(open(MAIN) || open(OVER_SIDE)) || !(open(SIDE) || open(OVER_MAIN)), "{now:?}");
        for signal in 0..4 {
            let ends = before[signal] == Green && now[signal] != Green;
            assert!(!ends || now[signal] == Yellow, "{before:?} {now:?}");
            assert!(!ends || green_s[signal] > LEAST_GREEN_S - 0.1, "{} s of green", green_s[signal]);
            green_s[signal] = if now[signal] == Green { green_s[signal] + STEP_S } else { 0.0 };
        }
        before = now;
    }
}

#[test]
fn a_program_whose_greens_change_without_all_red_stays_as_it_is() {
    let mut program = program();
    program.phases.retain(|phase| phase.aspects.iter().any(|(_, aspect)| *aspect != Red));
    assert!(stages(&program, &|signal| signal.0 >= 2).is_none());
}
