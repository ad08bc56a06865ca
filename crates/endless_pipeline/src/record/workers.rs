//! The workers of a video: one after the other they take the session on by a frame, then all finish their frames side by
//! side, and what must be in order waits for its turn.

use super::{
    recording::Recording,
    scheduler::{FrameScheduler, WorkerJob},
    times::Stage,
    vehicle_sensors::{Noticed, VehicleSensors},
};
use crate::{GenerateError, SimulationSession, SimulationStep, Simulator, SimulatorError};
use endless_annotate::{Happenings, SceneObserver};
use endless_world::WorldState;
use std::sync::{Barrier, Mutex, PoisonError};

pub(crate) type BoxedSession<'m> = Box<dyn SimulationSession<'m> + 'm>;

/// The threads of a run. Whatever works side by side, loading and baking too, finds this pool around it.
pub(crate) fn worker_pool(
    simulator: &impl Simulator,
    threads: usize,
) -> Result<rayon::ThreadPool, rayon::ThreadPoolBuildError> {
    let waiting = usize::from(simulator.capabilities().waits);
    rayon::ThreadPoolBuilder::new().num_threads(threads.max(1) + waiting).build()
}

/// Where the frames of a video go.
pub(crate) trait FrameOutput<'m>: Sync {
    /// A frame, with all that the simulator says of it.
    type Captured;
    /// What waits for its turn in one of the queues.
    type Item: Send;

    /// How many queues there are.
    fn queues(&self) -> usize;

    /// Takes from a step what needs the simulator.
    fn capture(&self, step: SimulationStep<'m>) -> Result<Self::Captured, GenerateError>;

    /// Does everything that need not be in order; one item a queue.
    fn finish(&self, captured: Self::Captured, observed: Observed) -> Result<Vec<Self::Item>, GenerateError>;

    /// Takes a queue's item whose turn it is.
    fn push(&self, queue: usize, item: Self::Item) -> Result<(), GenerateError>;
}

/// What follows from the world states up to a frame.
pub(crate) struct Observed {
    pub(crate) happenings: Happenings,
    /// By the places of their streams.
    pub(crate) noticed: Vec<(usize, Noticed)>,
}

/// Sees the frames in their order: whoever has the session has it.
pub(crate) struct Observers {
    scene: SceneObserver,
    vehicles: VehicleSensors,
}

impl Observers {
    /// Those of a recording's session.
    pub(crate) fn new<'m, S: Simulator>(
        recording: &Recording<'_>,
        simulator: &'m S,
        map: &'m S::Map,
        session: &BoxedSession<'m>,
    ) -> Self {
        let Recording { settings, recipe, streams, .. } = *recording;
        let lines = recipe.counting_lines.iter().filter(|line| line.map == settings.map).cloned().collect();
        let marks = simulator.map_features(map).map_or(&[][..], |features| &features.marks);
        let carrier = |sensor| session.carrier(sensor);
        let vehicles = VehicleSensors::new(streams, carrier, || session.bodies(), marks);
        Self { scene: SceneObserver::new(session.road_facts(), lines), vehicles }
    }

    fn observe(&mut self, state: &WorldState) -> Observed {
        Observed { happenings: self.scene.observe(state), noticed: self.vehicles.observe(state) }
    }
}

/// Runs a session through all frames of its video; gives it back.
pub(crate) fn run_workers<'m>(
    recording: &Recording<'_>,
    session: BoxedSession<'m>,
    observers: Observers,
    output: &impl FrameOutput<'m>,
    random_access: bool,
) -> Result<Option<BoxedSession<'m>>, GenerateError> {
    let threads = recording.pool.current_num_threads();
    let window = 2 * threads as u32 + 2;
    let scheduler = FrameScheduler::new(session, output.queues(), recording.settings.frames, window);
    let observers = Mutex::new(observers);
    let work = VideoWorkers { recording, scheduler: &scheduler, observers: &observers, output, random_access };
    let failure = Mutex::new(None);
    // Nobody begins before all are there: a thread that helped one at work, and took up its own part only while it waited
    // for a piece of that, would wait here for the one that waits for it.
    let all_here = Barrier::new(threads);
    recording.pool.broadcast(|_| {
        all_here.wait();
        let _stop_others_on_panic = scheduler.stop_on_panic();
        if let Err(error) = work.all() {
            failure.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            scheduler.stop();
        }
    });
    match failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(error) => Err(error),
        None => Ok(scheduler.into_session()),
    }
}

/// The state that all workers of a video share.
struct VideoWorkers<'a, 'm, Output: FrameOutput<'m>> {
    recording: &'a Recording<'a>,
    scheduler: &'a FrameScheduler<BoxedSession<'m>, Output::Item>,
    observers: &'a Mutex<Observers>,
    output: &'a Output,
    random_access: bool,
}

impl<'m, Output: FrameOutput<'m>> VideoWorkers<'_, 'm, Output> {
    /// Runs one worker until no job is left.
    fn all(&self) -> Result<(), GenerateError> {
        while let Some(job) = self.scheduler.next() {
            if self.recording.progress.is_stopped() {
                return Err(SimulatorError::Interrupted.into());
            }
            match job {
                WorkerJob::Frame { frame, session } => self.frame(frame, session)?,
                WorkerJob::Sink { camera: queue, item } => {
                    self.output.push(queue, item)?;
                    self.scheduler.sink_done(queue);
                }
            }
        }
        Ok(())
    }

    fn frame(&self, frame: u32, mut session: BoxedSession<'m>) -> Result<(), GenerateError> {
        let clock = self.recording.clock;
        let step = clock.time(Stage::Traffic, || session.tick())?;
        if step.state.frame != frame {
            return Err(SimulatorError::FramesDropped { expected: frame, got: step.state.frame }.into());
        }
        let observed = clock.time(Stage::Traffic, || {
            self.observers.lock().unwrap_or_else(PoisonError::into_inner).observe(&step.state)
        });
        let captured = if self.random_access {
            self.scheduler.return_session(session);
            self.output.capture(step)?
        } else {
            let captured = self.output.capture(step)?;
            self.scheduler.return_session(session);
            captured
        };
        self.scheduler.deliver(frame, self.output.finish(captured, observed)?);
        Ok(())
    }
}
