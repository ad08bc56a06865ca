//! Times what a scene costs: baking its cameras and rendering its frames.

use anyhow::Result;
use endless_dataset::SpawnCounts;
use endless_pipeline::{
    BuiltinMap, BuiltinSimulator, MapCatalog, MapUse, SimulationSession, SimulationStep, Simulator, SimulatorError,
};
use endless_world::{SceneSettings, SensorLayers, WorldState};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::time::Instant;

/// Loads towns, bakes cameras and renders frames by the clock.
pub(super) struct SceneTimer<'s> {
    simulator: &'s BuiltinSimulator,
    /// Loads and bakes.
    all_threads: ThreadPool,
    /// Renders: a frame is the work of one thread.
    one_thread: ThreadPool,
}

/// What a scene costs.
pub(super) struct SceneCost {
    /// Vehicles and people that found room.
    pub(super) spawned: SpawnCounts,
    /// Making the models of what moves: wall seconds with all threads.
    pub(super) models_s: f64,
    /// Baking: wall seconds a camera with all threads.
    pub(super) bake_s: f64,
    /// Milliseconds a camera frame, on one thread.
    pub(super) frame_ms: f64,
}

/// A populated scene whose cameras are baked.
pub(super) type BakedSession<'m> = Box<dyn SimulationSession<'m> + 'm>;

impl<'s> SceneTimer<'s> {
    pub(super) fn new(simulator: &'s BuiltinSimulator, threads: usize) -> Result<Self> {
        let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
        Ok(Self { simulator, all_threads: pool(threads)?, one_thread: pool(1)? })
    }

    /// A town, and the seconds that it took to build.
    pub(super) fn load(&self, map: &str) -> Result<(BuiltinMap, f64)> {
        let cameras = self.simulator.cameras(map)?;
        let wanted = MapUse { name: map, cameras: &cameras, videos: &[] };
        let start = Instant::now();
        let map = self.all_threads.install(|| self.simulator.load_map(&wanted))?;
        Ok((map, start.elapsed().as_secs_f64()))
    }

    /// What a scene costs with the frames that its settings say.
    pub(super) fn cost(&self, map: &BuiltinMap, settings: &SceneSettings) -> Result<SceneCost> {
        let (mut session, models_s) = self.prepare(map, settings)?;
        let cameras = settings.cameras.len() as f64;
        let bake_s = session.stats().bake.as_secs_f64() / cameras;
        let times_ms = self.render(&mut session, settings.frames, |_, _| ())?;
        let frame_ms = times_ms.iter().sum::<f64>() / times_ms.len() as f64 / cameras;
        Ok(SceneCost { spawned: session.spawned(), models_s, bake_s, frame_ms })
    }

    /// A scene ready to be rendered, and the seconds that the models of what moves took.
    pub(super) fn prepare<'m>(
        &'m self,
        map: &'m BuiltinMap,
        settings: &'m SceneSettings,
    ) -> Result<(BakedSession<'m>, f64)> {
        let mut session = self.simulator.open_session(map, settings, SensorLayers::default())?;
        let start = Instant::now();
        self.all_threads.install(|| session.prepare())?;
        let models = start.elapsed().saturating_sub(session.stats().bake);
        Ok((session, models.as_secs_f64()))
    }

    /// Renders a frame that does not count and so many that do: the milliseconds that each took for all cameras together.
    /// `direct` may change the world before it is rendered; it gets the number of the frame among those that count.
    pub(super) fn render(
        &self,
        session: &mut BakedSession<'_>,
        frames: u32,
        mut direct: impl FnMut(u32, &mut WorldState) + Send,
    ) -> Result<Vec<f64>> {
        let mut frame_ms = |frame| -> Result<f64, SimulatorError> {
            let SimulationStep { mut state, task } = session.tick()?;
            direct(frame, &mut state);
            let start = Instant::now();
            let rendered = task.render(&state)?;
            let time = start.elapsed();
            drop(rendered);
            Ok(time.as_secs_f64() * 1e3)
        };
        self.one_thread.install(|| {
            // The first takes the memory that all others use again.
            frame_ms(0)?;
            Ok((0..frames).map(frame_ms).collect::<Result<_, _>>()?)
        })
    }
}
