//! Records one video: goes through a session once, renders frames on all threads, writes everything in order.
//!
//! There is one kind of thread. A worker first does ordered work if some waits (feeding a camera's video encoder and
//! its list of objects), and else takes the session, goes on by a frame, gives the session back, renders all cameras,
//! encodes and writes the images. Where a simulator has no random access, it renders before it gives the session back. The
//! scheduler keeps the workers within a window of frames, so memory is the same after ten seconds and after an hour.

mod camera_sink;
mod capture;
mod event_sink;
mod files;
mod frame;
mod labels;
mod layers;
mod line_sinks;
mod recording;
mod scheduler;
mod sensor_times;
mod sink;
mod stored;
mod streams;
mod times;
mod vehicle_sensors;
mod video;
mod workers;

pub use sensor_times::SensorTimes;
pub use times::StageTimes;
pub(crate) use {
    capture::{CapturedFrame, SensorPlace, StreamReading, StreamReadings, capture, lens_at, measure},
    labels::labels,
    layers::as_stored,
    line_sinks::{GnssTrack, ImuTrack},
    recording::Recording,
    stored::{count_files, stream_is_complete},
    streams::{CameraStream, Stream, StreamModel, sensor_seed},
    times::{Stage, StageClock},
    vehicle_sensors::Noticed,
    video::{OpenedSession, camera_record, open_session, prepare_session, record_video},
    workers::{FrameOutput, Observed, Observers, run_workers, worker_pool},
};
