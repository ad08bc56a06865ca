//! MOTChallenge and MOTS: tracks in text files, a folder a camera and video.
//!
//! Frames, ids and the corners of boxes are counted from 1 (Milan et al. 2016, "MOT16", section 5; Voigtlaender et al. 2019,
//! "MOTS"). `seqmaps/train.txt` lists the sequences of a part, as TrackEval reads it.

mod boxes;
mod masks;
mod sequence;

pub(crate) use boxes::Mot;
pub(crate) use masks::Mots;
