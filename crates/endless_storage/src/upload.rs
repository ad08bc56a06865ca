//! A complete video moves to its bucket, file by file: each goes from this machine once it is there. So a killed upload goes on
//! with what is here, and the disk has room for the next video.

use crate::{
    bucket::{Bucket, for_all},
    error::{Problem, StorageError},
    work_folder::{BUILDS, SCENE, WorkFolder, remove},
};
use endless_pipeline::StoreError;

/// Uploads what is left of a video, `scene.json` last.
pub(crate) async fn upload(bucket: &Bucket, work: &WorkFolder, name: &str) -> Result<(), StoreError> {
    let folder = format!("videos/{name}");
    let scene = format!("{folder}/{SCENE}");
    let contents = work.contents(name)?;
    // Where scene.json is, the video is complete: what is made again is not.
    let before = bucket.list(&folder).await?;
    if before.contains_key(SCENE) && before != contents {
        bucket.remove(&scene).await?;
    }
    let here: Vec<String> = work.here(name)?.into_keys().filter(|file| file != SCENE).collect();
    for_all(here, |file| move_file(bucket, work, name, file)).await?;
    let there = bucket.list(&folder).await?;
    if let Some((lost, _)) = contents.iter().find(|(file, size)| *file != SCENE && there.get(*file) != Some(*size)) {
        work.forget(name)?;
        return Err(bucket.error("cannot upload", Problem::Lost(lost.clone()), &folder).into());
    }
    bucket.put_file(&scene, &work.outgoing(name).join(SCENE)).await?;
    Ok(work.uploaded(name)?)
}

async fn move_file(bucket: &Bucket, work: &WorkFolder, video: &str, file: String) -> Result<(), StorageError> {
    let path = work.outgoing(video).join(&file);
    let name = format!("videos/{video}/{file}");
    bucket.put_file(&name, &path).await?;
    if file == BUILDS {
        return Ok(());
    }
    remove(&path).map_err(|e| bucket.error("cannot upload", Problem::Disk(e.to_string()), &name))
}
