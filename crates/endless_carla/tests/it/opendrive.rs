//! Worlds of OpenDRIVE texts that clients send.

use crate::client::{Client, serve};
use endless_carla::wire::{MapInfo, OpendriveGenerationParameters, Wire};
use rmpv::Value;

const TEXT: &str = r#"<OpenDRIVE><header revMajor="1" revMinor="6"><geoReference>+proj=tmerc +lat_0=48 +lon_0=11</geoReference></header>
    <road name="r" length="200" id="1" junction="-1">
    <planView><geometry s="0" x="0" y="0" hdg="0" length="200"><line/></geometry></planView>
    <lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right>
        <lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>
        <lane id="-2" type="sidewalk"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane>
    </right></laneSection></lanes></road></OpenDRIVE>"#;

fn load(client: &mut Client) -> Result<Value, String> {
    client.call("load_new_episode", &["OpenDriveMap".into(), true.into(), 65535.into()])
}

#[test]
fn a_text_becomes_a_world() {
    let mut client = Client::new(serve());
    assert!(load(&mut client).expect_err("there is none yet").contains("OpenDriveMap"));
    let parameters = OpendriveGenerationParameters::default();
    client.call("copy_opendrive_to_file", &[TEXT.into(), parameters.to_value()]).expect("a map");
    load(&mut client).expect("loaded");
    let map: MapInfo = client.get("get_map_info", &[]);
    assert_eq!(map.name, "Carla/Maps/OpenDriveMap");
    assert!(!map.recommended_spawn_points.is_empty());
    for point in &map.recommended_spawn_points {
        let place = &point.location;
        assert!((0.0..200.0).contains(&place.x) && (place.y - 1.75).abs() < 0.1, "{place:?}");
    }
    let text: String = client.get("get_map_data", &[]);
    assert!(text.contains("<road ") && text.contains("+lat_0=48 +lon_0=11"));
    assert_eq!(client.get::<Vec<String>>("get_required_files", &["Nav".into()]).len(), 1);
    // What is no map is refused, and the world before it stays.
    for broken in ["", "<OpenDRIVE", "<OpenDRIVE/>", &TEXT[..400]] {
        let error = client.call("copy_opendrive_to_file", &[broken.into(), parameters.to_value()]);
        let error = error.expect_err("no map");
        assert!(error.starts_with("opendrive could not be correctly parsed: "), "{error}");
    }
    load(&mut client).expect("loaded again");
    assert_eq!(client.get::<String>("get_map_data", &[]), text);
    // Another text takes its place; without pedestrians it has no mesh.
    let nobody = OpendriveGenerationParameters { enable_pedestrian_navigation: false, ..parameters };
    let longer = TEXT.replace("200", "300");
    client.call("copy_opendrive_to_file", &[longer.into(), nobody.to_value()]).expect("a map");
    load(&mut client).expect("loaded");
    assert_ne!(client.get::<String>("get_map_data", &[]), text);
    assert!(client.get::<Vec<String>>("get_required_files", &["Nav".into()]).is_empty());
}
