//! Who owns the world: answers requests one after the other, and lets time pass.

use super::call::{Call, Method};
use super::call_error::CallError;
use super::methods;
use super::timely_snapshot::TickAnswer;
use super::world::World;
use crate::rpc::{Answer, Caller, ConnectionId, Request, RpcEvent};
use std::collections::BTreeMap;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

/// The longest step that passes at once, seconds: a slow machine makes time slow.
const LONGEST_STEP_S: f64 = 0.1;
/// The shortest, when time does not wait.
const SHORTEST_FRAME: Duration = Duration::from_millis(5);
/// Asked as fast as they are answered by traffic managers, whom they pace: in asynchronous mode they wait for the next frame.
const PACING: &[&str] = &["apply_batch", "get_vehicle_light_states"];

/// Owns the world.
pub(super) struct Engine {
    world: World,
    methods: BTreeMap<&'static str, Method>,
    events: Receiver<RpcEvent>,
    /// They wait for the next frame.
    held: Vec<(Caller, Request)>,
    last_frame: Instant,
}

impl Engine {
    pub(super) fn new(world: World, events: Receiver<RpcEvent>) -> Self {
        Self { world, methods: methods::all(), events, held: Vec::new(), last_frame: Instant::now() }
    }

    /// Answers and lets time pass until nobody can ask any more.
    pub(super) fn run(mut self) {
        loop {
            let event = match self.until_next_frame() {
                None => self.events.recv().map_err(RecvTimeoutError::from),
                Some(left) => self.events.recv_timeout(left),
            };
            match event {
                Ok(RpcEvent::Call(caller, request)) if self.is_held(&request) => self.held.push((caller, request)),
                Ok(RpcEvent::Call(caller, request)) if self.is_tick(&request) => self.tick(&caller, &request),
                Ok(RpcEvent::Call(caller, request)) => self.answer(&caller, &request),
                Ok(RpcEvent::Gone(client)) => self.forget(client),
                Err(RecvTimeoutError::Timeout) => self.frame_of_the_clock(),
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// In asynchronous mode, how long until the next frame.
    fn until_next_frame(&self) -> Option<Duration> {
        if self.world.settings.synchronous_mode {
            return None;
        }
        let step = Duration::from_secs_f64(self.world.step_s().min(1.0)).max(SHORTEST_FRAME);
        Some((self.last_frame + step).saturating_duration_since(Instant::now()))
    }

    fn is_held(&self, request: &Request) -> bool {
        !self.world.settings.synchronous_mode && PACING.contains(&request.method.as_str())
    }

    fn is_tick(&self, request: &Request) -> bool {
        self.world.settings.synchronous_mode && request.method == "tick_cue"
    }

    /// In synchronous mode an answer to a tick goes with the snapshot of its frame: a client that has the one and not the other
    /// looks for it without a pause, on the processor that renders.
    fn tick(&mut self, caller: &Caller, request: &Request) {
        let frame = self.world.episode.frame + 1;
        let answer = Answer::of(&frame).into_message(request.call_id);
        self.world.tick(caller.id, Some(TickAnswer { caller: caller.clone(), message: answer }));
    }

    fn answer(&mut self, caller: &Caller, request: &Request) {
        let call = Call { caller, request };
        let synchronous = self.world.settings.synchronous_mode;
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
        caller.send(answer.into_message(request.call_id));
        if self.world.settings.synchronous_mode != synchronous {
            tracing::info!(client = caller.id.0, synchronous = !synchronous, "time runs otherwise");
            self.time_runs_otherwise();
        }
    }

    /// The clock counts from now on; in synchronous mode nobody waits for it.
    fn time_runs_otherwise(&mut self) {
        self.last_frame = Instant::now();
        for (caller, request) in std::mem::take(&mut self.held) {
            self.answer(&caller, &request);
        }
    }

    /// A client has gone. Who made time pass and went without a word leaves no world that stands still.
    fn forget(&mut self, client: ConnectionId) {
        if self.world.ticking == Some(client) {
            self.world.ticking = None;
            if self.world.settings.synchronous_mode {
                tracing::warn!("the client that ticked has gone: back to asynchronous mode");
                self.world.settings.synchronous_mode = false;
                self.time_runs_otherwise();
            }
        }
    }

    /// In asynchronous mode a frame passes; those who were held are answered.
    fn frame_of_the_clock(&mut self) {
        let passed_s = self.last_frame.elapsed().as_secs_f64().min(LONGEST_STEP_S);
        self.last_frame = Instant::now();
        self.world.advance(passed_s, None);
        for (caller, request) in std::mem::take(&mut self.held) {
            self.answer(&caller, &request);
        }
    }
}
