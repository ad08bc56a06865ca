//! Who owns the world: answers requests one after the other, and lets time pass.

use super::call::{Call, Method};
use super::call_error::CallError;
use super::methods;
use super::world::World;
use crate::rpc::{Answer, Caller, ConnectionId, Request, RpcEvent};
use crate::wire::EpisodeSettings;
use std::collections::BTreeMap;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// The longest step that passes at once, seconds: a slow machine makes time slow.
const LONGEST_STEP_S: f64 = 0.1;
/// The shortest, when time does not wait.
const SHORTEST_FRAME: Duration = Duration::from_millis(5);
/// Asked as fast as they are answered by traffic managers, whom they pace: in asynchronous mode their answers wait until the middle
/// between two frames. A manager's step is then over before the next snapshot comes: one that tells in the middle of a step that
/// a vehicle has gone ends the client's program.
const PACING: &[&str] = &["apply_batch", "get_vehicle_light_states"];

/// Without a snapshot before and after the answer to a client that has loaded a map: it lets go of its stream then, and a snapshot
/// in that very moment can end its program.
const SILENCE_BEFORE: Duration = Duration::from_millis(20);
const SILENCE_AFTER: Duration = Duration::from_millis(100);

/// Owns the world.
pub(super) struct Engine {
    world: World,
    methods: BTreeMap<&'static str, Method>,
    events: Receiver<RpcEvent>,
    /// Answers that wait, and until when.
    held: Vec<(Caller, Vec<u8>)>,
    release: Option<Instant>,
    last_frame: Instant,
}

impl Engine {
    pub(super) fn new(world: World, events: Receiver<RpcEvent>) -> Self {
        Self { world, methods: methods::all(), events, held: Vec::new(), release: None, last_frame: Instant::now() }
    }

    /// Answers and lets time pass until nobody can ask any more.
    pub(super) fn run(mut self) {
        loop {
            let event = match self.until_next() {
                None => self.events.recv().map_err(RecvTimeoutError::from),
                Some(left) => self.events.recv_timeout(left),
            };
            match event {
                Ok(RpcEvent::Call(caller, request)) if self.is_held(&request) => self.hold(caller, &request),
                Ok(RpcEvent::Call(caller, request)) => self.answer(&caller, &request),
                Ok(RpcEvent::Gone(client)) => self.forget(client),
                Err(RecvTimeoutError::Timeout) if self.is_release_due() => self.release(),
                Err(RecvTimeoutError::Timeout) => self.frame_of_the_clock(),
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// In asynchronous mode, how long until the next frame, or until answers that wait are given.
    fn until_next(&self) -> Option<Duration> {
        if self.world.settings.synchronous_mode {
            return None;
        }
        let frame = self.last_frame + self.step();
        let next = self.release.map_or(frame, |release| release.min(frame));
        Some(next.saturating_duration_since(Instant::now()))
    }

    /// From one frame of the clock to the next.
    fn step(&self) -> Duration {
        Duration::from_secs_f64(self.world.step_s().min(1.0)).max(SHORTEST_FRAME)
    }

    /// Does what is asked; the answer waits.
    fn hold(&mut self, caller: Caller, request: &Request) {
        let message = self.message(&caller, request);
        self.held.push((caller, message));
        let (step, now) = (self.step(), Instant::now());
        let middle = self.last_frame + step / 2;
        self.release.get_or_insert(if now < middle { middle } else { middle + step });
    }

    fn is_release_due(&self) -> bool {
        self.release.is_some_and(|release| Instant::now() >= release)
    }

    fn release(&mut self) {
        self.release = None;
        self.held.drain(..).for_each(|(caller, message)| caller.send(message));
    }

    fn is_held(&self, request: &Request) -> bool {
        !self.world.settings.synchronous_mode && PACING.contains(&request.method.as_str())
    }

    fn answer(&mut self, caller: &Caller, request: &Request) {
        let (synchronous, episode) = (self.world.settings.synchronous_mode, self.world.episode.id);
        let message = self.message(caller, request);
        let is_another = self.world.episode.id != episode;
        if is_another {
            thread::sleep(SILENCE_BEFORE);
        }
        caller.send(message);
        if is_another {
            self.last_frame = Instant::now() + SILENCE_AFTER;
        }
        if self.world.settings.synchronous_mode != synchronous {
            tracing::info!(client = caller.id.0, synchronous = !synchronous, "time runs otherwise");
            self.time_runs_otherwise();
        }
    }

    /// Does what is asked, and gives the answer.
    fn message(&mut self, caller: &Caller, request: &Request) -> Vec<u8> {
        let call = Call { caller, request };
        let result = match self.methods.get(request.method.as_str()) {
            Some(method) => method(&mut self.world, &call),
            None => Err(CallError::refused(format!("not supported: {}", request.method))),
        };
        let answer = result.unwrap_or_else(|error| {
            let method = &request.method;
            match &error {
                CallError::Argument(_) => tracing::warn!(client = caller.id.0, "{method}: {error}"),
                CallError::Refused(_) => tracing::info!(client = caller.id.0, "{method}: {error}"),
            }
            if request.asynchronous { Answer::Void } else { Answer::Failure(error.to_string()) }
        });
        answer.into_message(request.call_id)
    }

    /// The clock counts from now on; in synchronous mode nobody waits for it.
    fn time_runs_otherwise(&mut self) {
        self.last_frame = Instant::now();
        self.release();
    }

    /// A client has gone. Who made time pass and went without a word leaves no world that stands still.
    fn forget(&mut self, client: ConnectionId) {
        if self.world.ticking == Some(client) {
            self.world.ticking = None;
            if self.world.settings.synchronous_mode {
                tracing::warn!("the client that ticked has gone: back to asynchronous mode");
                self.world.set_settings(EpisodeSettings { synchronous_mode: false, ..self.world.settings.clone() });
                self.time_runs_otherwise();
            }
        }
    }

    /// In asynchronous mode a frame passes.
    fn frame_of_the_clock(&mut self) {
        let passed_s = self.last_frame.elapsed().as_secs_f64().min(LONGEST_STEP_S);
        self.last_frame = Instant::now();
        self.world.advance(passed_s);
    }
}
