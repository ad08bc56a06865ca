//! The folder of imported maps: for each a copy of its file, and a manifest beside it.

use super::{
    MapError,
    name::{default_name, is_built_in, is_name},
    read::{format_of, parse, read_bytes},
    stored_map::{ImportOptions, MapFormat, StoredMap},
};
use crate::{content_hash::content_hash, user_data_folder};
use endless_dataset::write_durable;
use endless_road::RoadMap;
use std::{
    env, fs,
    path::{Path, PathBuf},
};

/// A folder of imported maps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapStore {
    folder: PathBuf,
}

impl MapStore {
    /// The user's own: `$ENDLESS_MAPS`, or `endless/maps` where the platform keeps data.
    ///
    /// # Errors
    /// When the platform names no such place, either.
    pub fn user() -> Result<Self, MapError> {
        let told = env::var_os("ENDLESS_MAPS").filter(|folder| !folder.is_empty()).map(PathBuf::from);
        told.or_else(|| user_data_folder("maps")).map(Self::at).ok_or(MapError::NoFolder)
    }

    /// In a folder, which need not exist.
    pub fn at(folder: PathBuf) -> Self {
        Self { folder }
    }

    fn manifest(&self, name: &str) -> PathBuf {
        self.folder.join(format!("{name}.toml"))
    }

    fn source(&self, map: &StoredMap) -> PathBuf {
        self.folder.join(format!("{}.{}", map.name, if map.format == MapFormat::Osm { "osm" } else { "xodr" }))
    }

    /// Names of the maps there are, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let mut names: Vec<String> = entries
            .filter_map(|e| e.file_name().into_string().ok()?.strip_suffix(".toml").map(str::to_owned))
            .filter(|name| is_name(name) && !is_built_in(name))
            .collect();
        names.sort();
        names
    }

    /// The manifest of a map; `None` if there is no map of this name.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn find(&self, name: &str) -> Result<Option<StoredMap>, MapError> {
        let path = self.manifest(name);
        if !is_name(name) || is_built_in(name) || !path.is_file() {
            return Ok(None);
        }
        let text = String::from_utf8_lossy(&read_bytes(&path)?).into_owned();
        let damaged = |reason: String| MapError::Damaged { path: path.clone(), reason };
        let map: StoredMap = toml::from_str(&text)
            .map_err(|e: toml::de::Error| damaged(e.message().lines().collect::<Vec<_>>().join(", ")))?;
        if map.name != name {
            return Err(damaged(format!("it calls itself '{}'", map.name)));
        }
        Ok(Some(map))
    }

    /// The map itself.
    ///
    /// # Errors
    /// When its file is gone, changed or no map.
    pub fn read(&self, map: &StoredMap) -> Result<RoadMap, MapError> {
        let path = self.source(map);
        let bytes = fs::read(&path).map_err(|cause| MapError::Damaged {
            path: self.manifest(&map.name),
            reason: format!("its file {} cannot be read: {cause}", path.display()),
        })?;
        if content_hash(&bytes) != map.blake3 {
            let reason = "its file was changed after it was imported".to_owned();
            return Err(MapError::Damaged { path: self.manifest(&map.name), reason });
        }
        parse(&bytes, map.format, map.driving_side, &path)
    }

    /// Reads a file, has it judged, and keeps it under a name (by default the file's). What is there is whole:
    /// the manifest is written last.
    ///
    /// # Errors
    /// When the file is no map, the name is taken, or `judge` refuses.
    pub fn import(
        &self,
        file: &Path,
        options: &ImportOptions<'_>,
        judge: impl FnOnce(&str, &RoadMap) -> Result<(), MapError>,
    ) -> Result<StoredMap, MapError> {
        let ImportOptions { name, driving_side, replace } = *options;
        let bytes = read_bytes(file)?;
        let format = format_of(&bytes, file)?;
        let source = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let name = name.map_or_else(|| default_name(&source), str::to_owned);
        if !is_name(&name) {
            return Err(MapError::Name { name });
        }
        if is_built_in(&name) {
            return Err(MapError::Taken { name, imported: false });
        }
        let map = StoredMap { blake3: content_hash(&bytes), name, format, driving_side, source };
        if !replace && self.find(&map.name)?.is_some_and(|there| there.content_hash() != map.content_hash()) {
            return Err(MapError::Taken { name: map.name, imported: true });
        }
        judge(&map.name, &parse(&bytes, format, driving_side, file)?)?;
        fs::create_dir_all(&self.folder).map_err(|cause| MapError::Folder { path: self.folder.clone(), cause })?;
        write_durable(&self.source(&map), &bytes)?;
        let text = toml::to_string(&map).expect("a manifest is plain data");
        write_durable(&self.manifest(&map.name), text.as_bytes())?;
        Ok(map)
    }
}

#[cfg(test)]
mod tests {
    use super::super::read::MOST_BYTES;
    use super::*;
    use endless_world::DrivingSide;
    use std::fs::File;

    const FILE: &str = r#"<?xml version="1.0"?><OpenDRIVE><header revMajor="1" revMinor="6"/>
        <road name="r" length="200" id="1" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="200"><line/></geometry></planView>
        <lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
        <right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#;

    #[test]
    fn a_file_is_kept_and_found_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = MapStore::at(folder.path().join("maps"));
        let file = folder.path().join("my road.v2.xodr");
        fs::write(&file, FILE).expect("written");
        assert_eq!(store.names(), Vec::<String>::new());
        let map = store.import(&file, &ImportOptions::default(), |_, _| Ok(())).expect("a map");
        assert_eq!((map.name.as_str(), map.source.as_str()), ("my_road", "my road.v2.xodr"));
        assert_eq!(store.names(), ["my_road"]);
        assert_eq!(store.find("my_road").expect("readable"), Some(map.clone()));
        assert_eq!(store.read(&map).expect("a map").network.lanes.len(), 1);
        // The same again is no change; another content under the same name is one.
        assert_eq!(store.import(&file, &ImportOptions::default(), |_, _| Ok(())).expect("the same"), map);
        fs::write(&file, FILE.replace("200", "300")).expect("written");
        let taken = store.import(&file, &ImportOptions::default(), |_, _| Ok(())).expect_err("taken");
        assert!(taken.to_string().contains("--replace"), "{taken}");
        let other = store
            .import(&file, &ImportOptions { replace: true, ..ImportOptions::default() }, |_, _| Ok(()))
            .expect("replaced");
        assert_ne!(other.content_hash(), map.content_hash());
        // The manifest of the old content does not fit the new.
        assert!(matches!(store.read(&map), Err(MapError::Damaged { .. })));
    }

    #[test]
    fn the_name_of_a_built_in_town_is_left_to_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = MapStore::at(folder.path().join("maps"));
        let file = folder.path().join("Town04.xodr");
        fs::write(&file, FILE).expect("written");
        let map = store.import(&file, &ImportOptions::default(), |_, _| Ok(())).expect("another name");
        assert_eq!(map.name, "Town04_imported");
        for name in ["Town04", "town04", "Town04_Opt"] {
            let error = store
                .import(&file, &ImportOptions { name: Some(name), ..ImportOptions::default() }, |_, _| Ok(()))
                .expect_err("taken");
            assert!(matches!(error, MapError::Taken { imported: false, .. }), "{error}");
        }
        // A manifest that got there otherwise does not hide the town.
        fs::copy(store.manifest("Town04_imported"), store.manifest("Town04")).expect("copied");
        assert_eq!((store.names(), store.find("Town04").expect("readable")), (vec![map.name], None));
    }

    #[test]
    fn a_map_without_its_file_is_told_from_no_map() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = MapStore::at(folder.path().join("maps"));
        let file = folder.path().join("a.xodr");
        fs::write(&file, FILE).expect("written");
        let map = store.import(&file, &ImportOptions::default(), |_, _| Ok(())).expect("a map");
        fs::remove_file(store.source(&map)).expect("removed");
        assert_eq!(store.find("a").expect("its manifest is there"), Some(map.clone()));
        let error = store.read(&map).expect_err("its file is gone").to_string();
        assert!(error.contains("import it again"), "{error}");
    }

    #[test]
    fn mistakes_are_told_in_one_line() {
        let folder = tempfile::tempdir().expect("a folder");
        let store = MapStore::at(folder.path().join("maps"));
        let write = |name: &str, text: &str| {
            let path = folder.path().join(name);
            fs::write(&path, text).expect("written");
            path
        };
        let cases = [
            (write("b.xodr", FILE), Some("Town01"), "already"),
            (write("a.xodr", FILE), Some("../b"), "cannot be a map's name"),
            (write("broken.xodr", "<OpenDRIVE><road"), None, "broken.xodr"),
            (write("text.txt", "hello"), None, "neither"),
            (folder.path().join("absent.osm"), None, "cannot read"),
        ];
        for (path, name, said) in cases {
            let error = store
                .import(&path, &ImportOptions { name, ..ImportOptions::default() }, |_, _| Ok(()))
                .expect_err("refused")
                .to_string();
            assert!(error.contains(said) && !error.contains('\n'), "{error}");
        }
        let long = folder.path().join("long.osm");
        File::create(&long).and_then(|file| file.set_len(MOST_BYTES + 1)).expect("a file of holes");
        let long = store.import(&long, &ImportOptions::default(), |_, _| Ok(())).expect_err("refused").to_string();
        assert!(long.contains("cut the part"), "{long}");
        let left = ImportOptions { driving_side: Some(DrivingSide::Left), ..ImportOptions::default() };
        let left = store.import(&write("c.xodr", FILE), &left, |_, _| Ok(()));
        assert!(left.expect_err("right-hand").to_string().contains("right"));
        assert_eq!(store.names(), Vec::<String>::new());
    }
}
