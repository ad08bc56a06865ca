use super::*;
use endless_world::{ObjectClass, TrackPoint};
use glam::DVec2;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const FCD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fcd-export xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    <timestep time="0.00">
        <vehicle id="a &amp; b" x="10.00" y="20.00" angle="90.00" type="passenger" speed="10.00" lane="l_0" slope="0.00"/>
    </timestep>
    <timestep time="1.00">
        <vehicle id="a &amp; b" x="20.00" y="20.00" z="4.5" angle="0.00" type="passenger" speed="10.00"/>
        <person id="p" x="1.00" y="2.00" angle="180.00" speed="1.20" type="zebra"/>
        <person id="inside" vehicle="a" x="1.00" y="2.00" angle="180.00" speed="1.20"/>
    </timestep>
</fcd-export>
"#;

fn fault(text: &str) -> String {
    TrackFile::from_bytes(text.as_bytes()).expect_err("wrong").to_string()
}

#[test]
fn fcd_is_read_with_its_axes() {
    let file = TrackFile::from_bytes(FCD.as_bytes()).expect("tracks");
    let [car, person] = &file.tracks[..] else { panic!("two tracks: {:?}", file.tracks) };
    assert_eq!((car.name.as_str(), car.class, car.point), ("a & b", ObjectClass::Car, TrackPoint::Front));
    let [first, second] = &car.pieces[0][..] else { panic!("two samples") };
    assert_eq!((first.position, first.height_m, first.speed_mps), (DVec2::new(10.0, 20.0), None, Some(10.0)));
    assert!(first.yaw_rad.abs() < 1e-12, "90 degrees clockwise from north is east");
    assert!((second.yaw_rad - FRAC_PI_2).abs() < 1e-12, "0 is north");
    assert_eq!(
        (person.class, person.point),
        (ObjectClass::Pedestrian, TrackPoint::Centre),
        "whatever its type is called"
    );
    assert_eq!((file.begin_s, file.end_s, file.notes.len()), (0.0, 1.0, 0));
}

#[test]
fn csv_is_read_in_any_order() {
    let text = "\u{feff}ID, Time ,class,x,y,yaw,z,speed,colour\n\"a,b\",0.5,car,1,2,3.14,,,red\n\na,0,bus,1,2,0,7,2.5,blue\n\"a,b\",0,car,0,2,0,,,red\n";
    let file = TrackFile::from_bytes(text.as_bytes()).expect("tracks");
    let [quoted, bus] = &file.tracks[..] else { panic!("two tracks: {:?}", file.tracks) };
    assert_eq!((quoted.name.as_str(), quoted.point), ("a,b", TrackPoint::Centre));
    assert_eq!(quoted.pieces[0].iter().map(|sample| sample.time_s).collect::<Vec<_>>(), [0.0, 0.5]);
    assert_eq!(
        (bus.class, bus.pieces[0][0].height_m, bus.pieces[0][0].speed_mps),
        (ObjectClass::Bus, Some(7.0), Some(2.5))
    );
}

#[test]
fn what_is_guessed_is_told_in_one_line_each() {
    let mut text = "time,id,class,x,y,yaw,length\n".to_owned();
    for (id, class, length) in [("1", "zebra", ""), ("2", "yak", "11"), ("3", "tram", ""), ("4", "car", "")] {
        text += &format!("0,{id},{class},0,0,0,{length}\n1,{id},{class},1,0,0,\n1,{id},{class},9,0,0,\n");
    }
    text += "9,4,car,9,0,0,\n9.5,4,car,900,0,0,\n";
    let file = TrackFile::from_bytes(text.as_bytes()).expect("tracks");
    let classes: Vec<ObjectClass> = file.tracks.iter().map(|track| track.class).collect();
    assert_eq!(classes, [ObjectClass::Car, ObjectClass::Bus, ObjectClass::Car]);
    assert_eq!(file.tracks[2].pieces.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1, 1], "a gap, and a jump");
    assert_eq!(file.tracks[2].pieces[0][1].position.x, 1.0, "the first of one instant");
    assert_eq!(
        file.notes,
        [
            "2 tracks of a type that is not known ('zebra', 'yak'): played as what has their length, else as cars",
            "1 track of which there are no models ('tram'): left out",
            "3 tracks with several rows of one instant ('1', '2', '4'): the first of these counts",
            "1 track with gaps of more than 2.0 s ('4'): absent meanwhile",
            "1 track with jumps faster than 80 m/s ('4'): they vanish, and appear elsewhere",
        ]
    );
}

#[test]
fn long_steps_of_a_file_are_no_gaps() {
    let text: String = (0..5).map(|k| format!("{},a,car,{k},0,0\n", 10 * k)).collect();
    let file = TrackFile::from_bytes(format!("time,id,class,x,y,yaw\n{text}").as_bytes()).expect("tracks");
    assert_eq!((file.tracks[0].pieces.len(), file.notes.len()), (1, 0));
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    let header = "time,id,class,x,y,yaw\n";
    for (text, told) in [
        (String::new(), "neither SUMO's FCD"),
        ("<net/>".to_owned(), "neither SUMO's FCD"),
        ("time,id,x,y\n0,a,0,0\n".to_owned(), "time,id,class,x,y,yaw"),
        (header.to_owned(), "nobody"),
        ("<fcd-export><timestep time=\"0\"/></fcd-export>".to_owned(), "nobody"),
        (format!("{header}0,a,car,1,nan,0\n"), "line 2: y is 'nan'"),
        (format!("{header}0,a,car,1,1,0\n0,b,car,1e99,1,0\n"), "line 3: x is '1e99'"),
        (format!("{header}0,a,car,1\n"), "line 2: the column y is missing"),
        (format!("{header}0,,car,1,1,0\n"), "line 2: the id is empty"),
        (FCD.replace("angle=\"0.00\"", ""), "line 7: angle is missing"),
        (FCD.replace("y=\"20.00\" z", "y=\"north\" z"), "line 7: y is 'north'"),
        (FCD.replace("</timestep>", ""), "line"),
        (FCD.replace("20.00", "10.00001").replace("10.00\"", "10.00001\""), "--fcd-output.geo"),
    ] {
        let fault = fault(&text);
        assert!(fault.contains(told) && fault.lines().count() == 1, "{text:?}: {fault}");
    }
    let error = TrackFile::read(Path::new("no such file.xml")).expect_err("none").to_string();
    assert!(error.contains("cannot read the tracks") && error.contains("no such file.xml"), "{error}");
}

proptest! {
    #[test]
    fn no_text_stops_the_readers(text in "(time,id,class,x,y,yaw\n)?([0-9a-z,.\"<>/=&;\n é-]|<timestep time=\"1\">|<vehicle ){0,80}") {
        if let Err(fault) = TrackFile::from_bytes(text.as_bytes()) {
            prop_assert_eq!(fault.to_string().lines().count(), 1);
        }
    }

    #[test]
    fn what_is_written_is_read(
        rows in prop::collection::vec((0u32..40, 0u8..4, -1e4..1e4f64, -1e4..1e4f64, -PI..PI), 1..40)
    ) {
        let mut csv = "time,id,class,x,y,yaw\n".to_owned();
        let mut fcd = "<fcd-export>".to_owned();
        for (time, id, x, y, yaw) in &rows {
            csv += &format!("{time},{id},car,{x},{y},{yaw}\n");
            let angle = 90.0 - yaw.to_degrees();
            fcd += &format!("<timestep time=\"{time}\"><vehicle id=\"{id}\" type=\"car\" x=\"{x}\" y=\"{y}\" angle=\"{angle}\"/></timestep>");
        }
        let [csv, fcd] = [csv, fcd + "</fcd-export>"].map(|text| TrackFile::from_bytes(text.as_bytes()).expect("tracks"));
        let mut told = 0;
        for (a, b) in csv.tracks.iter().zip(&fcd.tracks) {
            let [a, b] = [a, b].map(|track| track.pieces.concat());
            prop_assert!(a.is_sorted_by(|x, y| x.time_s < y.time_s));
            prop_assert_eq!(a.len(), b.len());
            told += a.len();
            for (a, b) in a.iter().zip(&b) {
                prop_assert!(a.position == b.position && a.time_s == b.time_s && (a.yaw_rad - b.yaw_rad).abs() < 1e-9);
            }
        }
        let mut distinct: Vec<(u32, u8)> = rows.iter().map(|row| (row.0, row.1)).collect();
        distinct.sort_unstable();
        distinct.dedup();
        prop_assert_eq!(told, distinct.len());
    }
}
