//! VeRi-776: `image_train/0001_c001_00016450_0.jpg`, `image_query/`, `image_test/`, lists of names, and labels of colour and type in
//! XML (Liu et al. 2016). A camera is a site of a map.

use super::{
    crops::{Role, crops},
    identities::{KnownIdentities, told_by},
};
use crate::{
    ExportError, Sequence, SourceDataset,
    exporter::Exporter,
    job::{Export, VideoJob},
    xml::escaped,
};
use endless_world::ObjectClass;
use std::collections::BTreeMap;

/// Vehicles with four wheels and more.
#[derive(Debug, Default)]
pub(crate) struct Veri {
    identities: KnownIdentities,
}

const CLASSES: &[ObjectClass] = &[ObjectClass::Car, ObjectClass::Van, ObjectClass::Truck, ObjectClass::Bus];
/// Folder, list of names and labels of each role.
const TRAIN: [&str; 3] = ["image_train", "name_train.txt", "train_label.xml"];
const QUERY: [&str; 3] = ["image_query", "name_query.txt", "query_label.xml"];
const TEST: [&str; 3] = ["image_test", "name_test.txt", "test_label.xml"];
/// Colours of vehicles, from 1 on.
const COLORS: [&str; 13] = [
    "black", "grey", "white", "red", "orange", "yellow", "green", "blue", "purple", "pink", "brown", "beige", "silver",
];

fn parts(role: Role) -> [&'static str; 3] {
    match role {
        Role::Train => TRAIN,
        Role::Query => QUERY,
        Role::Gallery => TEST,
    }
}

/// The number of each site of each map, from 1.
fn site_numbers(sequences: &[Sequence]) -> BTreeMap<(String, String), usize> {
    let mut numbers: BTreeMap<(String, String), usize> =
        sequences.iter().map(|s| ((s.video.map.clone(), s.site.clone()), 0)).collect();
    numbers.values_mut().enumerate().for_each(|(place, number)| *number = place + 1);
    numbers
}

impl Exporter for Veri {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        told_by("veri", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let identities = self.identities.of(video.export, CLASSES)?;
        let sequences = &video.export.dataset.sequences;
        let sites = site_numbers(sequences);
        let mut lists = [TRAIN, QUERY, TEST].map(|[folder, ..]| (folder, String::new()));
        crops(video, identities, CLASSES, |crop, role| {
            let sequence = &sequences[crop.sequence];
            let site = sites[&(sequence.video.map.clone(), sequence.site.clone())];
            let time = sequence.video.video as usize * 1_000_000 + crop.frame as usize;
            let name = format!("{:04}_c{site:03}_{time:08}_0.jpg", crop.identity);
            let [folder, ..] = parts(role);
            video.export.target.write(format!("{folder}/{name}"), &crop.jpg)?;
            let color = crop.actor.vehicle.as_ref().and_then(|vehicle| vehicle.color).map(|color| color.name.name());
            let color = COLORS.iter().position(|&known| Some(known) == color).map_or(0, |place| place + 1);
            let kind = CLASSES.iter().position(|&class| class == crop.actor.class).map_or(0, |place| place + 1);
            let row = format!("{name} {} {site} {color} {kind}\n", crop.identity);
            lists.iter_mut().filter(|(other, _)| *other == folder).for_each(|(_, list)| list.push_str(&row));
            Ok(())
        })?;
        for (folder, list) in lists {
            let mut part = video.create_part(folder)?;
            part.write(list.as_bytes())?;
            part.finish()?;
        }
        Ok(())
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for [folder, names, labels] in [TRAIN, QUERY, TEST] {
            export.target.path(format!("{folder}/-"))?;
            let (mut list, mut xml) = (export.target.create(names)?, export.target.create(labels)?);
            xml.write(b"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TrainingImages Version=\"1.0\">\n<Items>\n")?;
            for split in 0..export.splits.len() {
                for line in export.lines_of(folder, split) {
                    let line = line?;
                    let words: Vec<&str> = line.split(' ').collect();
                    let [name, identity, site, color, kind] = words[..] else { continue };
                    list.write(format!("{name}\n").as_bytes())?;
                    let item = format!(
                        "<Item imageName=\"{}\" vehicleID=\"{identity:0>4}\" cameraID=\"c{site:0>3}\" colorID=\"{color}\" typeID=\"{kind}\"/>\n",
                        escaped(name)
                    );
                    xml.write(item.as_bytes())?;
                }
            }
            xml.write(b"</Items>\n</TrainingImages>\n")?;
            list.finish()?;
            xml.finish()?;
        }
        let numbered = |words: &[&str]| {
            words.iter().enumerate().map(|(place, word)| format!("{} {word}\n", place + 1)).collect::<String>()
        };
        export.target.write("list_color.txt", numbered(&COLORS).as_bytes())?;
        let kinds: Vec<&str> = CLASSES.iter().map(|class| class.name()).collect();
        export.target.write("list_type.txt", numbered(&kinds).as_bytes())
    }
}
