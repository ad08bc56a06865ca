//! What MOTChallenge and MOTS share: the folder of a sequence, and the lists of sequences.

use crate::{
    ExportError, LabelledFrame, Sequence,
    job::{Export, VideoJob},
};
use endless_dataset::Layer;

/// The folder of a sequence.
pub(super) fn folder(split: &str, sequence: &Sequence) -> String {
    format!("{split}/{}", sequence.name())
}

/// Writes `seqinfo.ini`.
pub(super) fn write_seqinfo(video: &VideoJob<'_>, sequence: &Sequence) -> Result<(), ExportError> {
    let (name, size) = (sequence.name(), sequence.output.size);
    let text = format!(
        "[Sequence]\nname={name}\nimDir=img1\nframeRate={}\nseqLength={}\nimWidth={}\nimHeight={}\nimExt=.{}\n",
        sequence.fps(),
        sequence.len(),
        size.width,
        size.height,
        sequence.extension(Layer::Rgb),
    );
    video.export.target.write(format!("{}/seqinfo.ini", folder(video.split(), sequence)), text.as_bytes())
}

/// Puts the picture of a frame where it belongs.
pub(super) fn place_picture(video: &VideoJob<'_>, frame: &LabelledFrame<'_>) -> Result<(), ExportError> {
    let sequence = frame.sequence;
    let folder = folder(video.split(), sequence);
    let below = format!("{folder}/img1/{:06}.{}", frame.place + 1, sequence.extension(Layer::Rgb));
    video.place_image(frame, Layer::Rgb, &below)
}

/// Writes the lists of sequences.
pub(super) fn write_seqmaps(export: &Export<'_>) -> Result<(), ExportError> {
    for (split, name) in export.splits.iter().enumerate() {
        let sequences = export.videos_of(split).flat_map(|video| video.sequences().collect::<Vec<_>>());
        let names = sequences.map(|(_, sequence)| sequence.name() + "\n");
        let text = "name\n".to_owned() + &names.collect::<String>();
        export.target.write(format!("seqmaps/{name}.txt"), text.as_bytes())?;
    }
    Ok(())
}
