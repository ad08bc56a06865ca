//! OpenDRIVE on files that are at hand everywhere: what is read, what is refused, and that nothing breaks the reader.

use endless_road::opendrive::{self, OpenDriveDocument, OpenDriveError};
use endless_road::{LaneType, MapObjectKind, RoadMap, TrafficControl, Turn, WalkKind};
use glam::DVec3;
use proptest::prelude::*;

const CROSSROADS: &str = include_str!("../data/crossroads.xodr");

/// A road along x with given parts.
fn road(plan_view: &str, lanes: &str) -> String {
    format!(
        "<OpenDRIVE><header revMajor='1' revMinor='6'/>\n<road id='1' length='100' junction='-1'>\n\
         <planView>{plan_view}</planView>\n<lanes>{lanes}</lanes></road></OpenDRIVE>"
    )
}

const STRAIGHT: &str = "<geometry s='0' x='0' y='0' hdg='0' length='100'><line/></geometry>";

fn section(s: f64, lanes: &[(i32, &str, f64)]) -> String {
    let side = |pick: fn(i32) -> bool| -> String {
        let of = lanes.iter().filter(|lane| pick(lane.0));
        of.map(|(id, kind, width)| {
            format!("<lane id='{id}' type='{kind}'><width sOffset='0' a='{width}' b='0' c='0' d='0'/></lane>")
        })
        .collect()
    };
    format!(
        "<laneSection s='{s}'><left>{}</left><center><lane id='0' type='none'/></center><right>{}</right></laneSection>",
        side(|id| id > 0),
        side(|id| id < 0)
    )
}

/// What every map must be, whatever file it came from.
fn check_invariants(map: &RoadMap) {
    let network = &map.network;
    for lane in &network.lanes {
        assert!(lane.centerline.length() >= 0.5, "lane {:?} is {} m long", lane.id, lane.centerline.length());
        assert!(lane.width_m.is_finite() && lane.width_m > 0.0);
        let end = lane.centerline.at(lane.centerline.length());
        for &next in &lane.successors {
            let start = network.lane(next).centerline.at(0.0);
            assert!(end.position.distance(start.position) < 0.05);
        }
        for (side, sign) in [(lane.left, 1.0), (lane.right, -1.0)] {
            let Some(other) = side.map(|id| network.lane(id)) else { continue };
            let middle = lane.centerline.at(0.5 * lane.centerline.length());
            let (_, t) = other.centerline.project(middle.position.truncate());
            assert!(t * sign < 0.0, "lane {:?} has {:?} on the wrong side", lane.id, other.id);
        }
    }
    for crossing in 0..network.crossings.len() {
        let edges =
            network.walk.edges.iter().filter(|e| matches!(e.kind, WalkKind::Crossing(c) if c.index() == crossing));
        assert_eq!(edges.count(), 1, "crossing {crossing} joins two places");
    }
    let mut seen = vec![false; network.walk.nodes.len()];
    network.walk.edges.iter().flat_map(|edge| edge.nodes).for_each(|node| seen[node.index()] = true);
    assert!(seen.iter().all(|&seen| seen), "no place on the sidewalk is isolated");
    for strip in &map.lane_surfaces {
        assert!(strip.left.len() == strip.right.len() && strip.left.len() >= 2);
        assert!(strip.left.iter().chain(&strip.right).all(|p| p.is_finite()));
    }
}

#[test]
fn a_crossroads_with_every_element() {
    let map = opendrive::read(CROSSROADS).unwrap();
    check_invariants(&map);
    let network = &map.network;
    let outside = || network.lanes.iter().filter(|lane| lane.junction.is_none());
    // Three arms of one lane each way, the fourth with a section before its second lane begins.
    assert_eq!(outside().count(), 10);
    let ways = network.lanes.iter().filter(|lane| lane.junction.is_some() && lane.turn != Turn::UTurn);
    assert_eq!(ways.clone().count(), 12);
    assert_eq!(ways.filter(|lane| lane.turn == Turn::Straight).count(), 4);
    // A light on two arms that one controller switches; a stop sign, a give-way sign.
    let ends = |pick: fn(TrafficControl) -> bool| outside().filter(|lane| pick(lane.end_control)).count();
    assert_eq!(ends(|control| matches!(control, TrafficControl::Signal(_))), 2);
    assert_eq!(ends(|control| control == TrafficControl::Stop), 1);
    assert_eq!(ends(|control| control == TrafficControl::Yield), 2);
    assert_eq!(network.junctions.iter().filter(|junction| junction.program.is_some()).count(), 1);
    assert_eq!(network.crossings.len(), 3);
    // Lanes end before crossings.
    for lane in outside().filter(|lane| matches!(lane.end_control, TrafficControl::Signal(_) | TrafficControl::Stop)) {
        assert!(network.crossings.iter().all(|c| c.cuts.iter().all(|cut| cut.lane != lane.id)), "{:?}", lane.id);
    }
    let count = |pick: fn(&MapObjectKind) -> bool| map.objects.iter().filter(|thing| pick(&thing.kind)).count();
    assert_eq!(count(|kind| matches!(kind, MapObjectKind::Tree(Some(_)))), 5);
    assert_eq!(count(|kind| matches!(kind, MapObjectKind::TrafficLight(_))), 1);
    assert_eq!(count(|kind| *kind == MapObjectKind::SpeedLimit(50)), 1);
    assert!(map.lane_surfaces.iter().any(|strip| strip.kind == LaneType::Parking));
    assert!(map.lane_surfaces.iter().any(|strip| strip.bridge) && map.lane_surfaces.iter().any(|strip| strip.unpaved));
    // Miles an hour on the lane, kilometres an hour on the road.
    assert!(outside().any(|lane| (lane.speed_limit_mps - 30.0 * 0.44704).abs() < 1e-9));
    assert!(outside().any(|lane| (lane.speed_limit_mps - 50.0 / 3.6).abs() < 1e-9));
    assert!(map.georeference.unwrap().starts_with("+proj=tmerc"));
    // Up by 1 m at its beginning, less what the road leans to the right.
    let lean = 1.0 - 1.75 * 0.02;
    assert!(outside().any(|l| l.centerline.points()[0].distance(DVec3::new(-112.0, -1.75, lean)) < 0.01));
}

#[test]
fn what_is_written_is_read_again() {
    let map = opendrive::read(CROSSROADS).unwrap();
    let text = opendrive::write(&map, "again");
    let again = opendrive::read(&text).unwrap();
    check_invariants(&again);
    assert_eq!(again.notes, []);
    assert_eq!(map.network.lanes.len(), again.network.lanes.len());
    assert_eq!(map.network.crossings.len(), again.network.crossings.len());
    assert_eq!(map.georeference, again.georeference);
    let length = |map: &RoadMap| map.network.lanes.iter().map(|l| l.centerline.length()).sum::<f64>();
    assert!((length(&map) - length(&again)).abs() < 0.001 * length(&map));
    let joints = |map: &RoadMap| map.network.lanes.iter().map(|l| l.successors.len()).sum::<usize>();
    assert_eq!(joints(&map), joints(&again));
}

#[test]
fn left_hand_traffic_drives_on_the_left() {
    let lanes = section(0.0, &[(1, "driving", 3.5), (-1, "driving", 3.5)]);
    let text = road(STRAIGHT, &lanes).replace("junction='-1'", "junction='-1' rule='LHT'");
    let map = opendrive::read(&text).unwrap();
    assert!(map.left_hand);
    for lane in map.network.lanes.iter().filter(|lane| lane.junction.is_none()) {
        let middle = lane.centerline.at(50.0);
        // The lane to the left of the reference line runs along it.
        assert_eq!(middle.position.y > 0.0, middle.heading_rad.abs() < 0.1);
    }
}

#[test]
fn lanes_go_on_through_sections_and_short_ones_vanish() {
    let three = [0.0, 40.0, 40.4].map(|s| section(s, &[(-1, "driving", 3.0), (-2, "driving", 3.0)])).concat();
    let map = opendrive::read(&road(STRAIGHT, &three)).unwrap();
    assert_eq!(map.network.lanes.len(), 2);
    assert!((map.network.lanes[0].centerline.length() - 100.0).abs() < 0.01);
    assert!(map.network.lanes[0].right.is_some() || map.network.lanes[1].right.is_some());
}

#[test]
fn mistakes_are_told_in_one_line_with_their_place() {
    let lanes = section(0.0, &[(-1, "driving", 3.5)]);
    let bad_number = STRAIGHT.replace("hdg='0'", "hdg='north'");
    for (text, words) in [
        (String::new(), "line 1"),
        ("<html><body/></html>".to_owned(), "another kind of file"),
        ("<OpenDRIVE/>".to_owned(), "no lane for driving"),
        (road("", &lanes), "(of 1 roads): line 2: road: 1 has no reference line; the road was left out"),
        (road(STRAIGHT, ""), "(of 1 roads): line 4: lanes: has no <laneSection>"),
        (road(&bad_number, &lanes), "1 has no reference line"),
        (road(STRAIGHT, &section(0.0, &[(-1, "sidewalk", 3.5)])), "no lane for driving (of 1 roads)"),
        (road(STRAIGHT, &lanes.replace("a='3.5'", "a='9e6'")), "laneSection: of road 1 has a lane"),
        (CROSSROADS[..CROSSROADS.len() / 2].to_owned(), "the file ends inside <"),
    ] {
        let error = opendrive::read(&text).unwrap_err().to_string();
        assert!(error.contains(words) && !error.contains('\n'), "{words:?} is not in {error:?}");
    }
}

/// Every joint of the crossroads, and how long its lanes are.
fn extent(map: &RoadMap) -> (usize, f64) {
    let lanes = &map.network.lanes;
    (lanes.iter().map(|l| l.successors.len()).sum(), lanes.iter().map(|l| l.centerline.length()).sum())
}

#[test]
fn an_impossible_curve_is_replaced_by_one_that_leads_where_it_led() {
    let whole = opendrive::read(CROSSROADS).unwrap();
    let straight_on = "<paramPoly3 pRange=\"normalized\" aU=\"0\" bU=\"24.0000000000\" cU=\"0.0000000000\" \
                       dU=\"0.0000000000\" aV=\"0\" bV=\"0\" cV=\"0.0000000000\" dV=\"-0.0000000000\"/>";
    for (good, bad, words) in [
        // In the middle of a road: to where its next geometry begins.
        ("<spiral curvStart=\"0.01\" curvEnd=\"0\"/>", "<spiral curvStart=\"900\" curvEnd=\"0\"/>", "curvature 900"),
        ("<arc curvature=\"0.02\"/>", "<wave/>", "has no line, arc, spiral, poly3 or paramPoly3"),
        ("<arc curvature=\"0.02\"/>", "<arc curvature=\"round\"/>", "curvature=\"round\""),
        // A whole connecting road: to where the next road begins.
        (
            straight_on,
            "<paramPoly3 aU=\"0\" bU=\"9e6\" cU=\"0\" dU=\"0\" aV=\"0\" bV=\"0\" cV=\"0\" dV=\"0\"/>",
            "m long",
        ),
    ] {
        assert!(CROSSROADS.contains(good), "{good}");
        let map = opendrive::read(&CROSSROADS.replacen(good, bad, 1)).unwrap();
        check_invariants(&map);
        let told: Vec<_> = map.notes.iter().filter(|n| n.text.contains(words)).collect();
        assert!(told.len() == 1 && told[0].place.starts_with("line "), "{words}: {:?}", map.notes);
        assert!(told[0].text.ends_with("a curve that can be driven takes its place"), "{}", told[0].text);
        let ((joints, metres), (joints_whole, metres_whole)) = (extent(&map), extent(&whole));
        assert!(joints == joints_whole && (metres - metres_whole).abs() < 2.0, "{bad}: {joints} joints, {metres} m");
    }
}

#[test]
fn what_makes_no_sense_is_left_out_and_the_rest_of_the_map_is_read() {
    let whole = opendrive::read(CROSSROADS).unwrap();
    let lanes = whole.network.lanes.len();
    // What is changed, into what, what is told of it, and how many lanes that may cost.
    for (good, bad, words, cost) in [
        ("length=\"24.0000000000\"><param", "length=\"-24\"><param", "negative length", 1),
        ("length=\"24.0000000000\"><param", "length=\"9999999\"><param", "no road of a map is", 1),
        ("x=\"7.0000000000\" y=\"87.0000000000\"", "x=\"7.0000000000\" y=\"99987\"", "jumps by", 9),
        ("<elevation ", "<elevation s=\"none\" ", "is no usable number", 0),
        ("<signal ", "<signal s=\"?\" ", "is no usable number", 0),
        ("<laneLink from=\"-1\"", "<laneLink from=\"first\"", "which is no lane id", 1),
    ] {
        assert!(CROSSROADS.contains(good), "{good}");
        // Attributes are not given twice: the first one of the element is changed.
        let at = CROSSROADS.find(good).unwrap();
        let (before, rest) = CROSSROADS.split_at(at);
        let (element, after) = rest.split_at(rest.find('>').unwrap());
        let mut element = element.replacen(good.trim_end_matches("><param"), bad.trim_end_matches("><param"), 1);
        if let Some(second) = element.rfind(" s=\"").filter(|_| element.matches(" s=\"").count() == 2) {
            let end = second + 4 + element[second + 4..].find('"').unwrap() + 1;
            element.replace_range(second..end, "");
        }
        let map = opendrive::read(&format!("{before}{element}{after}")).unwrap();
        check_invariants(&map);
        assert!(
            map.notes.iter().any(|n| n.text.contains(words) && n.text.contains("left out")),
            "{words}: {:?}",
            map.notes
        );
        let left = map.network.lanes.len();
        assert!(left + cost >= lanes, "{bad}: {left} of {lanes} lanes");
    }
}

#[test]
fn monsters_are_refused_or_read_in_good_time() {
    let lanes = section(0.0, &[(-1, "driving", 3.5)]);
    let long = STRAIGHT.replace("'100'", "'9000000'");
    let far = STRAIGHT.replace("x='0'", "x='9999999'");
    let widening = lanes.replace("c='0' d='0'", "c='9e6' d='9e6'");
    let spiral = STRAIGHT.replace("<line/>", "<spiral curvStart='-9' curvEnd='9'/>");
    let many: String = (0..3000).map(|i| section(f64::from(i) * 0.03, &[(-1, "driving", 3.5)])).collect();
    for text in [
        road(&long, &lanes),
        road(&far, &lanes),
        road(STRAIGHT, &widening),
        road(&spiral, &lanes),
        road(STRAIGHT, &many),
    ] {
        let start = std::time::Instant::now();
        let _ = opendrive::read(&text);
        assert!(start.elapsed().as_secs() < 20, "{}", &text[..300]);
    }
    // A road that follows itself.
    let circle = road(STRAIGHT, &lanes).replace(
        "<planView>",
        "<link><predecessor elementType='road' elementId='1' contactPoint='end'/><successor elementType='road' \
         elementId='1' contactPoint='start'/></link><planView>",
    );
    assert!(opendrive::read(&circle).is_ok());
    let error = opendrive::read(&road(STRAIGHT, &widening)).unwrap_err();
    assert!(matches!(error, OpenDriveError::NoLanes { roads: 1, why: Some(_) }), "{error}");
}

#[test]
fn the_document_is_as_it_is_written() {
    let document = OpenDriveDocument::parse(CROSSROADS).unwrap();
    assert_eq!(document.revision, (1, 7));
    assert_eq!(document.roads.len(), 16);
    assert_eq!(document.junctions[0].connections.len(), 12);
    assert_eq!(document.notes, []);
}

/// Replaces what stands between a pair of quotation marks.
fn with_value(text: &str, which: usize, value: &str) -> String {
    let quotes: Vec<usize> = text.match_indices('"').map(|(at, _)| at).collect();
    let pair = 2 * (which % (quotes.len() / 2));
    format!("{}\"{value}{}", &text[..quotes[pair]], &text[quotes[pair + 1]..])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn changed_files_never_break_the_reader(
        changes in prop::collection::vec((0usize..100_000, 0usize..24), 1..6),
    ) {
        let values = [
            "", "0", "-1", "1", "2", "100", "nan", "inf", "-inf", "1e300", "-1e7", "9999999", "1e-12", "0.05", "-0.3",
            "driving", "sidewalk", "none", "start", "end", "junction", "road", "3.5", "\u{fffd}",
        ];
        let mut text = CROSSROADS.to_owned();
        for (which, value) in changes {
            text = with_value(&text, which, values[value]);
        }
        match opendrive::read(&text) {
            Ok(map) => drop(opendrive::write(&map, "changed")),
            // What the file says wrongly is told by its place in the file, not found later in the network.
            Err(error) => prop_assert!(!matches!(error, OpenDriveError::Network(_)), "{error}"),
        }
    }

    #[test]
    fn cut_and_spliced_files_never_break_the_reader(from in 0usize..24_000, to in 0usize..24_000, twice in any::<bool>()) {
        let lines: Vec<&str> = CROSSROADS.lines().collect();
        let (a, b) = (from % lines.len(), to % lines.len());
        let (a, b) = (a.min(b), a.max(b));
        let middle = if twice { [&lines[..b], &lines[a..b]].concat() } else { lines[..a].to_vec() };
        let text = [middle, lines[b..].to_vec()].concat().join("\n");
        let _ = opendrive::read(&text);
        let _ = opendrive::read(CROSSROADS.get(..from).unwrap_or(CROSSROADS));
    }

    #[test]
    fn noise_never_breaks_the_reader(text in "[<>/a-zA-Z=\"' 0-9.&;!\\-\\[\\]?]{0,200}") {
        let _ = opendrive::read(&text);
        let _ = opendrive::read(&format!("<OpenDRIVE>{text}</OpenDRIVE>"));
    }
}
