//! The standard, element by element: what `docs/opendrive.md` says is read has an effect, what it says is reported is
//! reported with its line.

use endless_road::opendrive::{self, OpenDriveDocument};
use endless_road::{LandUse, LaneType, MapObjectKind, MarkingColor, RoadMap, TrafficControl};
use glam::DVec3;

/// A road along x, 100 m, with two driving lanes of 3.5 m, and what is given besides.
#[derive(Default)]
struct File {
    /// Inside the road, before the lanes.
    profile: &'static str,
    plan_view: &'static str,
    lane_offset: &'static str,
    /// Inside the right lane.
    lane: &'static str,
    /// Instead of the right lane's width.
    width: &'static str,
    /// More lanes to the right.
    more: &'static str,
    /// Behind the lanes.
    beside: &'static str,
    /// Behind the road.
    rest: &'static str,
}

impl File {
    fn text(&self) -> String {
        let or = |text: &'static str, usual: &'static str| if text.is_empty() { usual } else { text };
        let width = "<width sOffset='0' a='3.5' b='0' c='0' d='0'/>";
        format!(
            "<OpenDRIVE><header revMajor='1' revMinor='8'/>\n<road id='1' length='100' junction='-1'>\n\
             <planView>{}</planView>\n{}\n<lanes>{}<laneSection s='0'>\
             <left><lane id='1' type='driving'>{width}</lane></left>\
             <center><lane id='0' type='none'/></center>\n\
             <right><lane id='-1' type='driving'>{}{}</lane>{}</right></laneSection></lanes>\n{}\n</road>{}</OpenDRIVE>",
            or(self.plan_view, "<geometry s='0' x='0' y='0' hdg='0' length='100'><line/></geometry>"),
            self.profile,
            self.lane_offset,
            or(self.width, width),
            self.lane,
            self.more,
            self.beside,
            self.rest
        )
    }

    fn map(&self) -> RoadMap {
        let text = self.text();
        opendrive::read(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    /// The middle of the right lane at x = 50.
    fn right_lane(&self) -> DVec3 {
        let map = self.map();
        let lanes = map.network.lanes.iter().filter(|lane| lane.junction.is_none());
        let places = lanes.map(|lane| lane.centerline.position(0.5 * lane.centerline.length()));
        places.min_by(|a, b| a.y.total_cmp(&b.y)).expect("a lane")
    }
}

fn close(a: DVec3, x: f64, y: f64, z: f64) {
    assert!(a.distance(DVec3::new(x, y, z)) < 0.02, "{a} is not {x}, {y}, {z}");
}

#[test]
fn lanes_lie_where_widths_borders_offsets_and_slopes_put_them() {
    close(File::default().right_lane(), 50.0, -1.75, 0.0);
    close(
        File { width: "<border sOffset='0' a='-3' b='-0.01' c='0' d='0'/>", ..File::default() }.right_lane(),
        50.0,
        -1.75,
        0.0,
    );
    close(
        File { lane_offset: "<laneOffset s='0' a='1' b='0.01' c='0' d='0'/>", ..File::default() }.right_lane(),
        50.0,
        -0.25,
        0.0,
    );
    let height = "<elevationProfile><elevation s='0' a='2' b='0.02' c='0' d='0'/></elevationProfile>";
    close(File { profile: height, ..File::default() }.right_lane(), 50.0, -1.75, 3.0);
    let lean = "<lateralProfile><superelevation s='0' a='0.1' b='0' c='0' d='0'/></lateralProfile>";
    close(File { profile: lean, ..File::default() }.right_lane(), 50.0, -1.741, -0.1747);
    let shape = "<lateralProfile><shape s='0' t='-4' a='0.4' b='-0.1' c='0' d='0'/><shape s='0' t='0' a='0' b='0' c='0' d='0'/></lateralProfile>";
    close(File { profile: shape, ..File::default() }.right_lane(), 50.0, -1.75, 0.175);
    for (side, z) in [("right", -0.175), ("both", -0.175), ("left", 0.0)] {
        let fall = match side {
            "right" => "<lateralProfile><crossfall side='right' s='0' a='0.0997' b='0' c='0' d='0'/></lateralProfile>",
            "both" => "<lateralProfile><crossfall side='both' s='0' a='0.0997' b='0' c='0' d='0'/></lateralProfile>",
            _ => "<lateralProfile><crossfall side='left' s='0' a='0.0997' b='0' c='0' d='0'/></lateralProfile>",
        };
        close(File { profile: fall, ..File::default() }.right_lane(), 50.0, -1.75, z);
    }
}

#[test]
fn a_level_lane_does_not_lean_with_its_road() {
    let file = File {
        profile: "<lateralProfile><superelevation s='0' a='0.1' b='0' c='0' d='0'/></lateralProfile>",
        more: "<lane id='-2' type='sidewalk' level='true'><width sOffset='0' a='2' b='0' c='0' d='0'/>\
               <height sOffset='0' inner='0.12' outer='0.2'/></lane>",
        ..File::default()
    };
    let map = file.map();
    let walk = map.lane_surfaces.iter().find(|strip| strip.kind == LaneType::Sidewalk).expect("a sidewalk");
    // Its inner edge where the lane beside it ends, its outer edge 8 cm higher.
    let edge = -3.5 * 0.0998;
    assert!((walk.left[0].z - edge - 0.12).abs() < 0.01 && (walk.right[0].z - edge - 0.2).abs() < 0.01, "{walk:?}");
}

#[test]
fn every_curve_of_the_plan_view_ends_where_it_should() {
    for (shape, x, y) in [
        ("<arc curvature='0.01'/>", 84.147, 45.970),
        ("<spiral curvStart='0' curvEnd='0.02'/>", 90.45, 31.03),
        ("<poly3 a='0' b='0' c='0.001' d='0'/>", 99.35, 9.871),
        ("<paramPoly3 aU='0' bU='100' cU='0' dU='0' aV='0' bV='0' cV='10' dV='0' pRange='normalized'/>", 100.0, 10.0),
        ("<paramPoly3 aU='0' bU='1' cU='0' dU='0' aV='0' bV='0' cV='0.001' dV='0' pRange='arcLength'/>", 100.0, 10.0),
    ] {
        let plan = format!("<geometry s='0' x='0' y='0' hdg='0' length='100'>{shape}</geometry>");
        let text = File::default()
            .text()
            .replace("<geometry s='0' x='0' y='0' hdg='0' length='100'><line/></geometry>", &plan);
        let map = opendrive::read(&text).expect(shape);
        let marks: Vec<DVec3> = map.lane_surfaces.iter().flat_map(|s| s.left.iter().chain(&s.right)).copied().collect();
        let nearest = marks.iter().map(|p| p.distance(DVec3::new(x, y, 0.0))).fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.05, "{shape}: {nearest:.3} m off");
    }
}

#[test]
fn paint_has_its_kind_weight_colour_and_length() {
    let with = |mark: &'static str| File { lane: mark, ..File::default() }.map().markings;
    assert_eq!(with("<roadMark sOffset='0' type='solid solid' color='yellow'/>").len(), 2);
    let broken = with("<roadMark sOffset='0' type='broken' color='white' width='0.15'/>");
    assert!(broken.len() == 1 && broken[0].dash.is_some() && (broken[0].width_m - 0.15).abs() < 1e-9);
    let bold = with("<roadMark sOffset='0' type='solid' weight='bold' color='yellow'/>");
    assert!(bold[0].width_m > 0.2 && bold[0].color == MarkingColor::Yellow && bold[0].dash.is_none());
    let typed = with(
        "<roadMark sOffset='0' type='broken' color='white'><type name='x' width='0.1'>\
         <line length='1' space='2' tOffset='0.2' sOffset='5' width='0.1'/></type></roadMark>",
    );
    assert_eq!(typed[0].dash, Some([1.0, 2.0]));
    assert!((typed[0].line.length() - 95.0).abs() < 0.1);
    let once = with(
        "<roadMark sOffset='0' type='solid' color='white'><explicit>\
         <line length='12' tOffset='0' sOffset='30' width='0.3'/></explicit></roadMark>",
    );
    assert!((once[0].line.length() - 12.0).abs() < 0.01 && (once[0].line.points()[0].x - 30.0).abs() < 0.01);
    assert_eq!(with("<roadMark sOffset='0' type='none'/>").len(), 0);
    // The second half of the lane alone.
    assert!((with("<roadMark sOffset='50' type='solid' color='white'/>")[0].line.length() - 50.0).abs() < 0.1);
}

#[test]
fn speeds_have_units() {
    for (speed, mps) in
        [("max='10' unit='m/s'", 10.0), ("max='36' unit='km/h'", 10.0), ("max='30' unit='mph'", 13.4112)]
    {
        let text = File::default().text().replace(
            "<lane id='-1' type='driving'>",
            &format!("<lane id='-1' type='driving'><speed sOffset='0' {speed}/>"),
        );
        let map = opendrive::read(&text).expect("a road");
        assert!(map.network.lanes.iter().any(|lane| (lane.speed_limit_mps - mps).abs() < 1e-6), "{speed}");
    }
}

#[test]
fn objects_stand_where_they_are_put() {
    let map = File {
        beside: "<objects><object id='1' type='tree' s='10' t='8' zOffset='0' height='7'>\
                 <repeat s='10' length='40' distance='10' tStart='8' tEnd='12' heightStart='7' heightEnd='7' zOffsetStart='0' zOffsetEnd='0'/></object>\
                 <object id='2' type='building' s='50' t='20' length='12' width='8' height='9' hdg='0'/>\
                 <object id='3' type='trafficIsland' s='70' t='0' length='6' width='1.5'/>\
                 <object id='4' type='vegetation' subtype='forest' s='20' t='-30'><outlines><outline id='0'>\
                 <cornerRoad s='0' t='-20' dz='0' height='5'/><cornerRoad s='40' t='-20' dz='0' height='5'/>\
                 <cornerRoad s='40' t='-50' dz='0' height='5'/></outline></outlines></object>\
                 <object id='5' type='crosswalk' s='80' t='0' zOffset='0' hdg='0'><outline>\
                 <cornerLocal u='-1.5' v='-3.5' z='0' height='0'/><cornerLocal u='1.5' v='-3.5' z='0' height='0'/>\
                 <cornerLocal u='1.5' v='3.5' z='0' height='0'/><cornerLocal u='-1.5' v='3.5' z='0' height='0'/></outline></object>\
                 <object id='6' type='parkingSpace' s='30' t='-6' length='5' width='2.5'/>\
                 <object id='7' type='pole' name='lamp' s='40' t='5'/><bridge s='40' length='20' name='b' id='8' type='concrete'/></objects>",
        more: "<lane id='-2' type='sidewalk'><width sOffset='0' a='2' b='0' c='0' d='0'/></lane>",
        ..File::default()
    }
    .map();
    let trees: Vec<DVec3> =
        map.objects.iter().filter(|t| t.kind == MapObjectKind::Tree(Some(7.0))).map(|t| t.position).collect();
    assert_eq!(trees.len(), 5);
    close(trees[4], 50.0, 12.0, 0.0);
    assert_eq!(map.footprints.len(), 1);
    assert_eq!(map.footprints[0].height_m, Some(9.0));
    assert!(map.footprints[0].outline.iter().any(|p| p.distance(glam::DVec2::new(56.0, 24.0)) < 0.01));
    assert!(map.lane_surfaces.iter().any(|s| s.kind == LaneType::Median && s.left.iter().all(|p| p.z > 0.1)));
    assert!(map.areas.iter().any(|area| area.kind == LandUse::Wood && area.outline.len() == 3));
    assert!(
        map.lane_surfaces.iter().any(|s| s.kind == LaneType::Parking) && map.lane_surfaces.iter().any(|s| s.bridge)
    );
    assert!(map.objects.iter().any(|thing| thing.kind == MapObjectKind::StreetLamp));
    // One sidewalk only: the crossing leads to nothing and is told.
    assert!(map.notes.iter().any(|note| note.text.contains("no sidewalk at one end")));
}

#[test]
fn signals_stand_where_they_really_stand() {
    let signal = "<signals><signal id='1' s='90' t='-4' dynamic='no' orientation='+' type='206' subtype='-1' country='DE' zOffset='2'>\
                  <positionInertial x='93' y='-6' z='0.5' hdg='0'/></signal></signals>";
    let map = File { beside: signal, ..File::default() }.map();
    let stop = map.objects.iter().find(|thing| thing.kind == MapObjectKind::Stop).expect("a stop sign");
    close(stop.position, 93.0, -6.0, 0.5);
    // It counts where it is valid: traffic along the road stops.
    assert_eq!(map.network.lanes.iter().filter(|lane| lane.end_control == TrafficControl::Stop).count(), 1);
    let elsewhere = signal.replace(
        "<positionInertial x='93' y='-6' z='0.5' hdg='0'/>",
        "<positionRoad roadId='1' s='40' t='7' zOffset='0' hOffset='0'/>",
    );
    let text = File::default().text().replace("</lanes>\n", &format!("</lanes>\n{elsewhere}"));
    let map = opendrive::read(&text).expect("a road");
    close(map.objects[0].position, 40.0, 7.0, 0.0);
}

#[test]
fn a_direct_junction_joins_roads_and_a_virtual_one_is_told() {
    let road = |id: &str, x: f64, link: &str| {
        format!(
            "<road id='{id}' length='100' junction='-1'><link>{link}</link><planView><geometry s='0' x='{x}' y='0' hdg='0' length='100'>\
             <line/></geometry></planView><lanes><laneSection s='0'><center><lane id='0' type='none'/></center><right>\
             <lane id='-1' type='driving'><width sOffset='0' a='3.5' b='0' c='0' d='0'/></lane></right></laneSection></lanes></road>"
        )
    };
    let file = |kind: &str| {
        let first = road("1", 0.0, "<successor elementType='junction' elementId='9'/>");
        let second = road("2", 100.0, "<predecessor elementType='junction' elementId='9'/>");
        format!(
            "<OpenDRIVE><header revMajor='1' revMinor='7'/>{first}{second}\n<junction id='9' type='{kind}'><connection id='0' incomingRoad='1' \
             linkedRoad='2' contactPoint='start'><laneLink from='-1' to='-1'/></connection></junction></OpenDRIVE>"
        )
    };
    let joined = |map: &RoadMap| map.network.lanes.iter().map(|lane| lane.successors.len()).sum::<usize>();
    assert_eq!(joined(&opendrive::read(&file("direct")).expect("two roads")), 1);
    for kind in ["virtual", "crossing"] {
        let map = opendrive::read(&file(kind)).expect("two roads");
        assert_eq!(joined(&map), 0);
        assert!(
            map.notes.iter().any(|note| note.place == "line 2" && note.text.contains("junction 9")),
            "{:?}",
            map.notes
        );
    }
}

#[test]
fn what_is_not_used_is_told_with_its_line() {
    for (text, words) in [
        (File { rest: "\n<junction id='7'><boundary><segment type='lane'/></boundary></junction>", ..File::default() }.text(), "<boundary> in <junction> is not used"),
        (File { rest: "\n<junction id='7'><elevationGrid gridSpacing='1'><elevation center='0'/></elevationGrid></junction>", ..File::default() }.text(), "<elevationGrid> in <junction> is not used"),
        (File { rest: "\n<junction id='7'><crossPath id='1' crossingRoad='2'/></junction>", ..File::default() }.text(), "<crossPath> in <junction> is not used"),
        (File { beside: "<objects>\n<tunnel s='0' length='50' id='1' type='standard'/></objects>", ..File::default() }.text(), "<tunnel> in <objects> is not used"),
        (File { beside: "\n<railroad><switch/></railroad>", ..File::default() }.text(), "<railroad> in <road> is not used"),
        (File { lane: "\n<access sOffset='0' rule='deny' restriction='bus'/>", ..File::default() }.text(), "<access> in <lane> is not used"),
        (File { profile: "<lateralProfile>\n<crossSectionSurface/></lateralProfile>", ..File::default() }.text(), "<crossSectionSurface> in <lateralProfile> is not used"),
        (File { beside: "\n<fountain/>", ..File::default() }.text(), "<fountain> in <road> is not known"),
        (File { lane: "", more: "\n<lane id='-2' type='bidirectional'><width sOffset='0' a='3' b='0' c='0' d='0'/></lane>", ..File::default() }.text(), "for both directions"),
    ] {
        let document = OpenDriveDocument::parse(&text).expect("well formed");
        let note = document.notes.iter().find(|note| note.text.contains(words));
        let note = note.unwrap_or_else(|| panic!("{words}: {:?}", document.notes));
        assert!(note.place.starts_with("line ") && !note.place.starts_with("line 1:"), "{note:?}");
    }
}
