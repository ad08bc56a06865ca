//! A report as one web page that needs nothing else: styles, scripts, data and pictures are in it.

mod escape;
mod picture;

use super::format::whole;
use super::model::{Chart, HeatMapFigure, Item, Report, Table, Tile};
use escape::{html, script_json};
use picture::{legend_png, png_address};
use serde::Serialize;
use std::fmt::Write as _;

/// Chart.js 4.6.1 (MIT): `assets/chart.LICENSE.md`.
const CHART_LIBRARY: &str = include_str!("../../assets/chart.umd.min.js");
const STYLE: &str = include_str!("../../assets/page.css");
const SCRIPT: &str = include_str!("../../assets/page.js");
/// Nothing may be loaded from anywhere, whatever a dataset's words say.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:";

/// What the script needs of a chart.
#[derive(Serialize)]
struct ChartData<'a> {
    label_axis: &'a str,
    value_axis: &'a str,
    labels: &'a [String],
    series: Vec<SeriesData<'a>>,
    stacked: bool,
    lying: bool,
    ordered: bool,
    percent: bool,
}

#[derive(Serialize)]
struct SeriesData<'a> {
    name: &'a str,
    values: &'a [f64],
}

impl Report {
    /// As one HTML page.
    pub fn page(&self) -> String {
        let mut charts = Vec::new();
        let mut body = String::new();
        let _ = write!(body, "<header><h1>{}</h1><p>{}</p></header>\n<nav>", html(&self.title), html(&self.subtitle));
        for (number, section) in self.sections.iter().enumerate() {
            let _ = write!(body, "<a href=\"#s{number}\">{}</a>", html(&section.title));
        }
        body.push_str("</nav>\n<main>\n");
        for (number, section) in self.sections.iter().enumerate() {
            let _ = writeln!(body, "<section id=\"s{number}\"><h2>{}</h2>", html(&section.title));
            if !section.note.is_empty() {
                let _ = writeln!(body, "<p class=\"note\">{}</p>", html(&section.note));
            }
            body.push_str("<div class=\"items\">\n");
            for item in &section.items {
                write_item(&mut body, item, &mut charts);
            }
            body.push_str("</div></section>\n");
        }
        let data = script_json(&serde_json::to_string(&charts).unwrap_or_else(|_| "[]".into()));
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n\
             <body>\n{body}</main>\n\
             <footer>Made by endless {}. Charts by Chart.js, MIT licence.</footer>\n\
             <script type=\"application/json\" id=\"charts\">{data}</script>\n\
             <script>{CHART_LIBRARY}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
            html(&self.title),
            env!("CARGO_PKG_VERSION"),
        )
    }
}

fn write_item<'a>(body: &mut String, item: &'a Item, charts: &mut Vec<ChartData<'a>>) {
    match item {
        Item::Tiles(tiles) => write_tiles(body, tiles),
        Item::Table(table) => {
            let width = match (table.columns.len(), table.rows.len()) {
                (0..=2, _) => " narrow",
                (3..=4, _) | (5..=6, 0..=8) => " half",
                _ => " wide",
            };
            // What is longer than a screen has a scroll bar of its own.
            let tall = if table.rows.len() > 24 { " tall" } else { "" };
            let title = html(&table.title);
            let _ = write!(body, "<figure class=\"table{width}{tall}\"><figcaption>{title}</figcaption>");
            write_table(body, table);
            body.push_str("</figure>\n");
        }
        Item::Chart(chart) => write_chart(body, chart, charts),
        Item::HeatMaps(maps) => maps.iter().for_each(|map| write_heat_map(body, map)),
        Item::List(sentences) => {
            body.push_str("<ul class=\"hints\">");
            for sentence in sentences {
                let _ = write!(body, "<li>{}</li>", html(sentence));
            }
            body.push_str("</ul>\n");
        }
    }
}

fn write_tiles(body: &mut String, tiles: &[Tile]) {
    body.push_str("<dl class=\"tiles\">");
    for tile in tiles {
        let _ = write!(body, "<div><dt>{}</dt><dd>{}</dd></div>", html(&tile.name), html(&tile.value));
    }
    body.push_str("</dl>\n");
}

fn write_table(body: &mut String, table: &Table) {
    body.push_str("<div class=\"scroll\"><table>");
    if table.columns.iter().any(|column| !column.is_empty()) {
        body.push_str("<thead><tr>");
        table.columns.iter().for_each(|column| {
            let _ = write!(body, "<th scope=\"col\">{}</th>", html(column));
        });
        body.push_str("</tr></thead>");
    }
    body.push_str("<tbody>");
    for (place, row) in table.rows.iter().enumerate() {
        body.push_str(if place + table.sums >= table.rows.len() { "<tr class=\"sum\">" } else { "<tr>" });
        for (column, cell) in row.iter().enumerate() {
            let tag = if column == 0 { "th scope=\"row\"" } else { "td" };
            let _ = write!(body, "<{tag}>{}</{}>", html(cell), &tag[..2]);
        }
        body.push_str("</tr>");
    }
    body.push_str("</tbody></table></div>");
}

/// Labels without an order lie, with bars beside them, where there are more of them than fit below bars.
fn is_lying(chart: &Chart) -> bool {
    !chart.ordered && (chart.labels.len() > 5 || chart.labels.iter().any(|label| label.chars().count() > 14))
}

fn write_chart<'a>(body: &mut String, chart: &'a Chart, charts: &mut Vec<ChartData<'a>>) {
    let lying = is_lying(chart);
    let bars = chart.labels.len() * if chart.stacked { 1 } else { chart.series.len() };
    let height = if lying { 90 + bars * if chart.stacked { 22 } else { 15 } } else { 290 };
    let note = if chart.note.is_empty() { String::new() } else { format!(" <small>{}</small>", html(&chart.note)) };
    let _ = write!(
        body,
        "<figure class=\"chart half\"><figcaption>{}{note}</figcaption><div class=\"plot\" style=\"height:{height}px\">\
         <canvas data-chart=\"{}\" role=\"img\" aria-label=\"{}\"></canvas></div>",
        html(&chart.title),
        charts.len(),
        html(&format!("{}: {} by {}", chart.title, chart.value_axis, chart.label_axis)),
    );
    body.push_str("<details><summary>Numbers</summary>");
    write_table(body, &numbers(chart));
    body.push_str("</details></figure>\n");
    charts.push(ChartData {
        label_axis: &chart.label_axis,
        value_axis: &chart.value_axis,
        labels: &chart.labels,
        series: chart.series.iter().map(|s| SeriesData { name: &s.name, values: &s.values }).collect(),
        stacked: chart.stacked,
        lying,
        ordered: chart.ordered,
        percent: chart.percent,
    });
}

/// The numbers of a chart, with their sums and shares where they are parts of a whole.
fn numbers(chart: &Chart) -> Table {
    let sums = chart.sums();
    let total: f64 = sums.iter().sum();
    let several = chart.series.len() > 1;
    let mut columns = vec![chart.label_axis.clone()];
    columns.extend(chart.series.iter().map(|series| series.name.clone()));
    if chart.stacked {
        columns.extend(several.then(|| "all".to_owned()).into_iter().chain(["share".to_owned()]));
    }
    let number = |value: f64| if chart.percent { format!("{value:.2}%") } else { whole(value as u64) };
    let row = |place: usize| {
        let mut cells = vec![chart.labels[place].clone()];
        cells.extend(chart.series.iter().map(|series| number(series.values[place])));
        if chart.stacked {
            cells.extend(several.then(|| number(sums[place])));
            cells.push(if total > 0.0 { super::format::percent_of(sums[place] / total) } else { "\u{2013}".into() });
        }
        cells
    };
    Table { title: String::new(), columns, rows: (0..chart.labels.len()).map(row).collect(), sums: 0 }
}

fn write_heat_map(body: &mut String, figure: &HeatMapFigure) {
    let map = &figure.map;
    let most = map.counts.iter().copied().max().unwrap_or_default();
    let _ = writeln!(
        body,
        "<figure class=\"heat\"><figcaption>{}</figcaption><img class=\"map\" src=\"{}\" alt=\"heat map of {}\">\
         <div class=\"legend\">0 <img src=\"{}\" alt=\"\"> {} boxes in a cell</div></figure>",
        html(&figure.title),
        png_address(map),
        html(&figure.title),
        legend_png(),
        whole(most),
    );
}
