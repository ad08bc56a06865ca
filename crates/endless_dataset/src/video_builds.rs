//! `builds.json` of a video: the builds of the program that worked on it.

use crate::{BuildIdentity, DatasetError, VideoLayout, durable::sync_folder, read_json, write_json_durable};
use std::fs;

impl VideoLayout {
    /// The builds that worked on the video, in the order in which they came; none if nothing says so.
    pub fn read_builds(&self) -> Option<Vec<BuildIdentity>> {
        read_json(&self.builds()).ok().filter(|builds: &Vec<BuildIdentity>| !builds.is_empty())
    }

    /// Notes that a build works on the video, before it writes anything else there. Makes the folder if there is none.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn note_build(&self, build: &BuildIdentity) -> Result<(), DatasetError> {
        let folder = self.folder();
        fs::create_dir_all(folder).map_err(|e| DatasetError::io("cannot make the folder", folder, e))?;
        let noted = self.read_builds();
        let mut builds = match &noted {
            Some(builds) => builds.clone(),
            None if self.is_begun()? => vec![BuildIdentity::unknown()],
            None => Vec::new(),
        };
        if !builds.iter().any(|other| other.makes_same_bytes(build)) {
            builds.push(build.clone());
            write_json_durable(&self.builds(), &builds)?;
            folder.parent().map_or(Ok(()), sync_folder)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DatasetLayout;

    #[test]
    fn each_build_is_noted_once_and_what_nobody_noted_is_unknown() {
        let folder = tempfile::tempdir().expect("temp");
        let layout = DatasetLayout::new(folder.path());
        let build = |sources: &str| BuildIdentity { version: "1".into(), commit: None, sources: sources.into() };
        let video = layout.video_named("0000_a");
        for sources in ["a", "b", "a"] {
            video.note_build(&build(sources)).expect("writable");
        }
        assert_eq!(video.read_builds(), Some(vec![build("a"), build("b")]));

        let video = layout.video_named("0001_a");
        assert!(!video.is_begun().expect("nothing there"));
        fs::create_dir_all(video.folder()).expect("writable");
        fs::write(video.folder().join(".builds.json.tmp"), "").expect("writable");
        assert!(!video.is_begun().expect("readable"));
        fs::write(video.folder().join("frames.jsonl"), "{}").expect("writable");
        assert!(video.is_begun().expect("readable"));
        video.note_build(&build("a")).expect("writable");
        assert_eq!(video.read_builds(), Some(vec![BuildIdentity::unknown(), build("a")]));
    }
}
