//! The recorder and the replayer: what happens goes into files of CARLA's format, and comes out of them again.

mod folder;
mod place;
mod recorded;
mod recording;
mod replay;
mod replay_events;
mod replay_frame;
mod replay_motion;
mod replayer;
mod state;
mod writer;

pub(super) use replayer::ReplayRequest;
pub(super) use state::Recordings;
