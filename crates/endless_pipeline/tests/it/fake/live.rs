//! A simulator as a server elsewhere may be: frames come in order and only once, no two sessions are alike, actors come
//! and go, and sometimes it fails.

use super::{paint, parked, placed, two_maps, world};
use endless_annotate::{SceneObjects, WorldKeypoints};
use endless_dataset::SpawnCounts;
use endless_pipeline::{
    Capabilities, MapUse, RenderTask, SceneTruth, SimulationSession, SimulationStep, Simulator, SimulatorError,
};
use endless_world::{SceneSettings, SensorFrame, SensorLayers, WorldState};
use std::{
    collections::VecDeque,
    io,
    sync::{
        Mutex,
        atomic::{AtomicBool, AtomicU8, Ordering},
    },
    time::Duration,
};

/// What goes wrong in a session.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Fault {
    None,
    /// It is not even opened.
    NoScene,
    /// The connection breaks at a tick.
    DiesAt(u32),
    /// Nothing comes of rendering.
    HangsAt(u32),
    /// A tick gives the frame after the next one.
    SkipsAt(u32),
    /// The sensors give the frame after this one.
    SensorsSkipAt(u32),
}

#[derive(Default)]
pub(crate) struct LiveFake {
    /// Of the sessions to come; none afterwards.
    pub(crate) faults: Mutex<VecDeque<Fault>>,
    /// Sessions opened until now: each paints its number into the first pixel.
    pub(crate) sessions: AtomicU8,
    /// Whether a frame waits to be rendered.
    pending: AtomicBool,
}

two_maps!(LiveFake);

impl Simulator for LiveFake {
    type Map = ();

    fn capabilities(&self) -> Capabilities {
        Capabilities { random_access: false, repeatable: false, waits: true }
    }

    fn load_map(&self, _wanted: &MapUse<'_>) -> Result<(), SimulatorError> {
        Ok(())
    }

    fn open_session<'m>(
        &'m self,
        _map: &'m (),
        settings: &'m SceneSettings,
        _wanted: SensorLayers,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError> {
        let fault = self.faults.lock().expect("unpoisoned").pop_front().unwrap_or(Fault::None);
        let number = self.sessions.fetch_add(1, Ordering::SeqCst) + 1;
        self.pending.store(false, Ordering::SeqCst);
        if fault == Fault::NoScene {
            let source = Box::new(io::Error::other("no room for the cameras"));
            return Err(SimulatorError::Scene { video: settings.video, map: settings.map.clone(), source });
        }
        Ok(Box::new(LiveSession { fake: self, settings, fault, number, next: 0 }))
    }
}

struct LiveSession<'m> {
    fake: &'m LiveFake,
    settings: &'m SceneSettings,
    fault: Fault,
    number: u8,
    next: u32,
}

impl<'m> SimulationSession<'m> for LiveSession<'m> {
    fn spawned(&self) -> SpawnCounts {
        SpawnCounts { parked: 0, ..placed(self.settings) }
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        assert!(!self.fake.pending.swap(true, Ordering::SeqCst), "a frame is rendered before the next tick");
        if self.fault == Fault::DiesAt(self.next) {
            let source = io::Error::from(io::ErrorKind::ConnectionReset);
            return Err(SimulatorError::ConnectionLost { address: "localhost:2000".into(), source });
        }
        if self.fault == Fault::SkipsAt(self.next) {
            self.next += 1;
        }
        let mut state = world(self.settings, u64::from(self.number), self.next);
        self.next += 1;
        // Each is there for eight frames of sixteen, and who stands still is listed with the others.
        state.actors.retain(|a| (u32::from(a.id.0) * 5 + state.frame) % 16 < 8);
        state.actors.insert(0, parked());
        let task = LiveTask { fake: self.fake, settings: self.settings, fault: self.fault, number: self.number };
        Ok(SimulationStep { state, task: Box::new(task) })
    }
}

struct LiveTask<'m> {
    fake: &'m LiveFake,
    settings: &'m SceneSettings,
    fault: Fault,
    number: u8,
}

impl<'m> RenderTask<'m> for LiveTask<'_> {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        SceneTruth { objects: SceneObjects::new(state, &[]), bodies: WorldKeypoints::new(), shapes: None }
    }

    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        if self.fault == Fault::HangsAt(state.frame) {
            return Err(SimulatorError::Timeout { action: "give a frame", limit: Duration::from_secs(10) });
        }
        let mut frames: Vec<SensorFrame> =
            (0..self.settings.cameras.len() as u32).map(|camera| paint(self.settings, state, camera)).collect();
        for frame in &mut frames {
            frame.rgb.data[0] = [self.number; 3];
            frame.frame += u32::from(self.fault == Fault::SensorsSkipAt(state.frame));
        }
        self.fake.pending.store(false, Ordering::SeqCst);
        Ok(frames)
    }
}
