//! Cityscapes: `leftImg8bit/train/Town03/Town03_000000_000123_leftImg8bit.png` beside `gtFine/...` with `labelIds`, `instanceIds`,
//! `labelTrainIds` and `color`, as cityscapesScripts reads them (Cordts et al. 2016). Maps are its cities, the cameras of videos its
//! sequences.

use crate::{
    ExportError, LabelledFrame,
    exporter::Exporter,
    frame_list,
    job::{Export, VideoJob},
    pictures::place_png,
    png::{encode_grey8, encode_grey16},
};
use endless_dataset::{encode_png, write_atomic};
use endless_world::{ClassTag, Image, InstanceId, InstancePixel};
use std::collections::BTreeMap;

/// Fine annotations.
#[derive(Debug)]
pub(crate) struct Cityscapes;

/// A class of Cityscapes.
struct CityClass {
    id: u8,
    /// What is trained; 255 is left out.
    train_id: u8,
    color: [u8; 3],
    /// Whether its objects are counted.
    counted: bool,
}

/// Its class of a tag (`labels.py` of cityscapesScripts).
fn city_class(tag: ClassTag) -> CityClass {
    let class = |id, train_id, color| CityClass { id, train_id, color, counted: (24..34).contains(&id) };
    match tag {
        ClassTag::Roads | ClassTag::RoadLines => class(7, 0, [128, 64, 128]),
        ClassTag::Sidewalks => class(8, 1, [244, 35, 232]),
        ClassTag::RailTrack => class(10, 255, [230, 150, 140]),
        ClassTag::Buildings => class(11, 2, [70, 70, 70]),
        ClassTag::Walls => class(12, 3, [102, 102, 156]),
        ClassTag::Fences => class(13, 4, [190, 153, 153]),
        ClassTag::GuardRail => class(14, 255, [180, 165, 180]),
        ClassTag::Bridge => class(15, 255, [150, 100, 100]),
        ClassTag::Poles => class(17, 5, [153, 153, 153]),
        ClassTag::TrafficLight => class(19, 6, [250, 170, 30]),
        ClassTag::TrafficSigns => class(20, 7, [220, 220, 0]),
        ClassTag::Vegetation => class(21, 8, [107, 142, 35]),
        ClassTag::Terrain => class(22, 9, [152, 251, 152]),
        ClassTag::Sky => class(23, 10, [70, 130, 180]),
        ClassTag::Pedestrians => class(24, 11, [220, 20, 60]),
        ClassTag::Rider => class(25, 12, [255, 0, 0]),
        ClassTag::Car => class(26, 13, [0, 0, 142]),
        ClassTag::Truck => class(27, 14, [0, 0, 70]),
        ClassTag::Bus => class(28, 15, [0, 60, 100]),
        ClassTag::Train => class(31, 16, [0, 80, 100]),
        ClassTag::Motorcycle => class(32, 17, [0, 0, 230]),
        ClassTag::Bicycle => class(33, 18, [119, 11, 32]),
        ClassTag::Static => class(4, 255, [0, 0, 0]),
        ClassTag::Dynamic => class(5, 255, [111, 74, 0]),
        ClassTag::Ground => class(6, 255, [81, 0, 81]),
        _ => class(0, 255, [0, 0, 0]),
    }
}

/// The images of a frame.
struct Labels {
    ids: Image<u8>,
    train_ids: Image<u8>,
    colors: Image<[u8; 3]>,
    instances: Image<u16>,
}

/// Objects of each class are counted from 0 in the order of their ids.
fn labels(instance: &Image<InstancePixel>) -> Labels {
    let mut numbers: BTreeMap<(u8, InstanceId), u16> = BTreeMap::new();
    for run in instance.data.chunk_by(|a, b| a == b) {
        let class = city_class(run[0].tag);
        if class.counted && run[0].id != InstanceId::STUFF {
            numbers.insert((class.id, run[0].id), 0);
        }
    }
    let mut counts: BTreeMap<u8, u16> = BTreeMap::new();
    for ((class, _), number) in &mut numbers {
        let count = counts.entry(*class).or_default();
        (*number, *count) = (*count, *count + 1);
    }
    let size = instance.size;
    let mut labels = Labels {
        ids: Image { size, data: Vec::with_capacity(size.pixels()) },
        train_ids: Image { size, data: Vec::with_capacity(size.pixels()) },
        colors: Image { size, data: Vec::with_capacity(size.pixels()) },
        instances: Image { size, data: Vec::with_capacity(size.pixels()) },
    };
    for run in instance.data.chunk_by(|a, b| a == b) {
        let class = city_class(run[0].tag);
        let number = numbers.get(&(class.id, run[0].id));
        // A thousand objects of a class and more have no number of their own: they are a group.
        let single = number.filter(|&&number| number < 1000);
        let value = single.map_or(u16::from(class.id), |number| u16::from(class.id) * 1000 + number);
        labels.ids.data.extend(std::iter::repeat_n(class.id, run.len()));
        labels.train_ids.data.extend(std::iter::repeat_n(class.train_id, run.len()));
        labels.colors.data.extend(std::iter::repeat_n(class.color, run.len()));
        labels.instances.data.extend(std::iter::repeat_n(value, run.len()));
    }
    labels
}

/// Letters and digits only: the underscore divides the words of a file's name.
fn city(map: &str) -> String {
    map.chars().filter(|c| c.is_alphanumeric() || *c == '-').collect()
}

impl Exporter for Cityscapes {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let target = video.export.target;
        let mut list = video.create_part(frame_list::PART)?;
        for (place, sequence) in video.sequences() {
            let city = city(&sequence.video.map);
            let folder = format!("{}/{city}", video.split());
            let make = |frame: &LabelledFrame<'_>| {
                let name = format!("{city}_{place:06}_{:06}", frame.frame);
                place_png(video, frame, &format!("leftImg8bit/{folder}/{name}_leftImg8bit.png"))?;
                let instance = frame.instance()?;
                let labels = labels(&instance);
                let write = |kind: &str, bytes: &[u8]| {
                    target
                        .path(format!("gtFine/{folder}/{name}_gtFine_{kind}.png"))
                        .and_then(|path| Ok(write_atomic(&path, bytes)?))
                };
                write("labelIds", &encode_grey8(&labels.ids))?;
                write("labelTrainIds", &encode_grey8(&labels.train_ids))?;
                write("instanceIds", &encode_grey16(&labels.instances))?;
                write("color", &encode_png(&labels.colors))?;
                Ok(frame_list::line(name, frame))
            };
            video.frames(sequence, make, |line| Ok(list.write(line.as_bytes())?))?;
        }
        Ok(list.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        frame_list::write(export)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;

    #[test]
    fn objects_are_counted_by_class() {
        let pixel = |tag, id| InstancePixel { tag, id: InstanceId(id) };
        let size = ImageSize { width: 5, height: 1 };
        let data = vec![
            pixel(ClassTag::Roads, 0),
            pixel(ClassTag::Car, 9),
            pixel(ClassTag::Car, 4),
            pixel(ClassTag::Pedestrians, 7),
            pixel(ClassTag::Unlabeled, 0),
        ];
        let labels = labels(&Image { size, data });
        assert_eq!(labels.ids.data, [7, 26, 26, 24, 0]);
        assert_eq!(labels.train_ids.data, [0, 13, 13, 11, 255]);
        assert_eq!(labels.instances.data, [7, 26001, 26000, 24000, 0]);
        assert_eq!(city("My_Map-2"), "MyMap-2");
    }
}
