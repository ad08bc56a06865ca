//! Market-1501: `bounding_box_train/0001_c1s1_000151_00.jpg` and `query/`, `bounding_box_test/` (Zheng et al. 2015).

use super::{
    crops::{Role, crops},
    identities::{KnownIdentities, told_by},
};
use crate::{
    ExportError, SourceDataset,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_world::ObjectClass;

/// People on foot.
#[derive(Debug, Default)]
pub(crate) struct Market {
    identities: KnownIdentities,
}

const CLASSES: &[ObjectClass] = &[ObjectClass::Pedestrian];

impl Exporter for Market {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        told_by("market1501", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let identities = self.identities.of(video.export, CLASSES)?;
        let sequences = &video.export.dataset.sequences;
        crops(video, identities, CLASSES, |crop, role| {
            let folder = match role {
                Role::Train => "bounding_box_train",
                Role::Query => "query",
                Role::Gallery => "bounding_box_test",
            };
            let sequence = &sequences[crop.sequence];
            let (camera, session) = (sequence.camera + 1, sequence.video.video + 1);
            let name = format!("{:04}_c{camera}s{session}_{:06}_00.jpg", crop.identity, crop.frame);
            video.export.target.write(format!("{folder}/{name}"), &crop.jpg)
        })
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        // Readers want all three folders.
        for folder in ["bounding_box_train", "query", "bounding_box_test"] {
            export.target.path(format!("{folder}/-"))?;
        }
        Ok(())
    }
}
