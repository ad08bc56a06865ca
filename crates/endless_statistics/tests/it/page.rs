//! The page needs nothing else, and takes no word of a dataset for markup.

use crate::hand_made::{HOSTILE, dataset};
use endless_statistics::{Comparison, DatasetStatistics, GatherOptions, Report};

fn reports() -> [Report; 2] {
    let folder = dataset();
    let count = || DatasetStatistics::of_dataset(folder.path(), &GatherOptions::default()).expect("a dataset");
    [Report::of_dataset(&count()), Report::of_comparison(&Comparison::new(vec![count(), count()]))]
}

/// The page without the library of charts, which is not ours.
fn own_part(page: &str) -> String {
    let (before, rest) = page.split_once("<script>/*!").expect("the library");
    let (_, after) = rest.split_once("</script>").expect("its end");
    format!("{before}{after}")
}

#[test]
fn nothing_is_loaded() {
    for report in reports() {
        let page = report.page();
        assert!(page.starts_with("<!doctype html>") && page.contains("default-src 'none'"));
        let own = own_part(&page);
        for address in ["http://", "https://", "//cdn", "@import", "url(", "fetch(", "<link", "<iframe", "src=\"/"] {
            assert!(!own.contains(address), "{address}");
        }
        // The library names its home in comments only; it has no way to load anything under the page's policy.
        let links: Vec<&str> = page.match_indices("http").map(|(at, _)| &page[at - 3..at]).collect();
        assert!(
            links.iter().all(|before| before.contains('*') || before.contains("//") || before.ends_with(' ')),
            "{links:?}"
        );
        for (at, _) in page.match_indices("src=\"") {
            assert!(page[at..].starts_with("src=\"data:image/png;base64,"), "{}", &page[at..at + 40]);
        }
    }
}

#[test]
fn hostile_names_are_text() {
    for report in reports() {
        let page = report.page();
        assert!(page.contains("&lt;/script&gt;&lt;script&gt;alert(1)"), "it is shown");
        assert!(
            !page.contains("<img src=x") && !page.contains("<script>alert") && !page.contains("</script><script>alert")
        );
        let scripts = page.matches("<script").count();
        assert_eq!((scripts, page.matches("</script>").count()), (3, 3), "data, library, ours");
        assert!(!page.contains('\u{1b}') && !report.text().contains('\u{1b}'), "no control characters");
        let data = page.split_once("id=\"charts\">").expect("data").1.split_once("</script>").expect("its end").0;
        let charts: serde_json::Value = serde_json::from_str(data).expect("JSON");
        let labels: Vec<&str> = charts
            .as_array()
            .expect("charts")
            .iter()
            .flat_map(|c| c["labels"].as_array().expect("labels"))
            .filter_map(|l| l.as_str())
            .collect();
        assert!(labels.contains(&HOSTILE), "the chart has the name itself");
    }
}

#[test]
fn every_chart_has_its_place_axes_and_numbers() {
    for report in reports() {
        let page = report.page();
        let data = page.split_once("id=\"charts\">").expect("data").1.split_once("</script>").expect("its end").0;
        let charts: Vec<serde_json::Value> = serde_json::from_str(data).expect("JSON");
        assert!(charts.len() >= 20);
        assert_eq!(page.matches("<summary>Numbers</summary>").count(), charts.len());
        for (number, chart) in charts.iter().enumerate() {
            assert!(page.contains(&format!("data-chart=\"{number}\"")));
            assert!(
                ["label_axis", "value_axis"].iter().all(|axis| chart[axis].as_str().is_some_and(|a| !a.is_empty()))
            );
            let bars = chart["labels"].as_array().expect("labels").len();
            let series = chart["series"].as_array().expect("series");
            assert!(!series.is_empty() && series.iter().all(|s| s["values"].as_array().expect("values").len() == bars));
        }
    }
}

#[test]
fn text_has_the_table_and_the_figures_of_the_paper() {
    let text = reports()[0].text();
    for title in [
        "Datasets (the paper's Table 2)",
        "Maps (Figure 9)",
        "Weather (Figure 10)",
        "Time of day (Figure 11)",
        "Conditions (Figure 12)",
    ] {
        assert!(text.contains(title), "{title}");
    }
    assert!(text.lines().all(|line| line == line.trim_end()), "no blanks at the ends of lines");
}
