//! The picture: a panel for each way, all at the same scale.

use std::fmt::Write as _;

use pga_motor::pga2d::f64::Point;

use crate::scene::{self, BOXES, Way};

/// Pixels.
const PANEL_WIDTH: f64 = 560.0;
const MARGIN: f64 = 24.0;
const GAP: f64 = 20.0;
const HEADER: f64 = 84.0;
const CAPTION: f64 = 78.0;
const COLUMNS: usize = 2;

/// From the first box to the last.
const COLOURS: [[f64; 3]; 2] = [[38.0, 99.0, 171.0], [214.0, 79.0, 48.0]];

/// The rectangle of the plane that every panel shows.
struct Window {
    left: f64,
    top: f64,
    /// Pixels for one unit of length.
    scale: f64,
    /// Pixels.
    height: f64,
}

impl Window {
    fn around(ways: &[Way]) -> Self {
        let (mut low, mut high) = ([0.0_f64; 2], [0.0_f64; 2]);
        for point in ways.iter().flat_map(shown) {
            for (axis, x) in [point.x, point.y].into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
            }
        }
        let scale = (PANEL_WIDTH - 2.0 * MARGIN) / (high[0] - low[0]);
        let height = (high[1] - low[1]) * scale + 2.0 * MARGIN;
        Self { left: low[0], top: high[1], scale, height }
    }

    /// Pixels from the upper left corner of a panel's picture.
    fn place(&self, point: Point) -> [f64; 2] {
        [MARGIN + (point.x - self.left) * self.scale, MARGIN + (self.top - point.y) * self.scale]
    }

    fn path(&self, points: &[Point]) -> String {
        let mut path = String::new();
        for (index, &point) in points.iter().enumerate() {
            let ([x, y], command) = (self.place(point), if index == 0 { 'M' } else { 'L' });
            let _ = write!(path, "{command}{x:.1} {y:.1}");
        }
        path
    }
}

/// Every point of a way that is to be seen.
fn shown(way: &Way) -> impl Iterator<Item = Point> {
    let corners = way.motors.iter().flat_map(|&motor| scene::outline(motor));
    let names = way.motors.iter().map(|&motor| scene::name_place(motor));
    corners.chain(names).chain(way.path.iter().copied()).chain(way.center)
}

pub(crate) fn svg(ways: &[Way]) -> String {
    let window = Window::around(ways);
    let panel = CAPTION + window.height;
    let rows = ways.len().div_ceil(COLUMNS);
    let width = GAP + COLUMNS as f64 * (PANEL_WIDTH + GAP);
    let height = HEADER + rows as f64 * (panel + GAP);

    let geodesic = ways.iter().find(|way| way.name == "screw_lerp").map_or(&[][..], |way| &way.path);

    let mut svg = String::new();
    write_head(&mut svg, width, height);
    for (index, way) in ways.iter().enumerate() {
        let x = GAP + (index % COLUMNS) as f64 * (PANEL_WIDTH + GAP);
        let y = HEADER + (index / COLUMNS) as f64 * (panel + GAP);
        put(&mut svg, format_args!(r#"<g transform="translate({x:.1} {y:.1})">"#));
        write_caption(&mut svg, way, panel);
        put(&mut svg, format_args!(r#"<g transform="translate(0 {CAPTION})">"#));
        write_way(&mut svg, &window, way, geodesic);
        put(&mut svg, format_args!("</g></g>"));
    }
    svg + "</svg>\n"
}

fn write_head(svg: &mut String, width: f64, height: f64) {
    let caption = format!(
        "A box carried between two motions of the plane, drawn for {BOXES} evenly spaced values of t; the line is the path \
         of its centre, dashed that of screw_lerp."
    );
    put(
        svg,
        format_args!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0} {height:.0}" width="{width:.0}" height="{height:.0}" font-family="system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif">
<style>
.card {{ fill: #fdfcf8; stroke: #e3e0d6; }} .name {{ font-size: 19px; font-weight: 600; fill: #23272e; }}
.formula {{ font-size: 15px; fill: #4a4f57; font-family: 'DejaVu Sans Mono', Consolas, monospace; text-anchor: end; }}
.remark {{ font-size: 14px; fill: #6b7079; }} .figure {{ font-size: 14px; fill: #6b7079; text-anchor: end; }}
.path {{ fill: none; stroke: #23272e; stroke-width: 2; }}
.other {{ fill: none; stroke: #8b8f96; stroke-width: 1.5; stroke-dasharray: 5 4; }} .box {{ stroke-width: 1.6; stroke-linejoin: round; }}
.step {{ fill: #23272e; stroke: #fdfcf8; stroke-width: 1.2; }} .mark {{ fill: none; stroke: #6b7079; stroke-width: 1.5; }}
.label {{ font-size: 13px; fill: #6b7079; }} .end {{ font-size: 17px; font-weight: 600; text-anchor: middle; }}
</style>
<rect width="{width:.0}" height="{height:.0}" fill="#fff"/>
<text x="{GAP}" y="36" font-size="23" font-weight="600" fill="#23272e">From a to b, four ways</text>
<text x="{GAP}" y="62" font-size="15" fill="#6b7079">{caption}</text>"##
        ),
    );
}

fn write_caption(svg: &mut String, way: &Way, height: f64) {
    let right = PANEL_WIDTH - MARGIN;
    let [least, most] = way.turns();
    let turns = if most - least < 0.05 { format!("{most:.1}°") } else { format!("{least:.1}° to {most:.1}°") };
    let (name, formula, remark) = (way.name, way.formula, way.remark);
    put(
        svg,
        format_args!(
            r#"<rect class="card" width="{PANEL_WIDTH}" height="{height:.1}" rx="10"/>
<text class="name" x="{MARGIN}" y="36">{name}</text><text class="formula" x="{right}" y="36">{formula}</text>
<text class="remark" x="{MARGIN}" y="60">{remark}</text><text class="figure" x="{right}" y="60">{turns} a step</text>"#
        ),
    );
}

fn write_way(svg: &mut String, window: &Window, way: &Way, geodesic: &[Point]) {
    let [x, y] = window.place(Point::ORIGIN);
    put(svg, format_args!(r#"<path class="mark" d="M{x:.1} {y:.1}m-6 0h12m-6 -6v12"/>"#));
    put(svg, format_args!(r#"<text class="label" x="{:.1}" y="{:.1}">origin</text>"#, x + 10.0, y + 16.0));
    if let Some([x, y]) = way.center.map(|center| window.place(center)) {
        put(svg, format_args!(r#"<circle class="mark" cx="{x:.1}" cy="{y:.1}" r="5"/>"#));
        put(svg, format_args!(r#"<text class="label" x="{:.1}" y="{:.1}">centre</text>"#, x + 10.0, y + 5.0));
    }
    write_boxes(svg, window, way);
    put(svg, format_args!(r#"<path class="other" d="{}"/>"#, window.path(geodesic)));
    put(svg, format_args!(r#"<path class="path" d="{}"/>"#, window.path(&way.path)));
    for motor in &way.motors {
        let [x, y] = window.place(motor.transform_origin());
        put(svg, format_args!(r#"<circle class="step" cx="{x:.1}" cy="{y:.1}" r="4"/>"#));
    }
}

/// The outlines, the ends strong and those between pale, and what the ends are called.
fn write_boxes(svg: &mut String, window: &Window, way: &Way) {
    let last = way.motors.len() - 1;
    for (index, &motor) in way.motors.iter().enumerate() {
        let colour = colour(index as f64 / last as f64);
        let is_end = index == 0 || index == last;
        let [fill, stroke] = if is_end { [0.3, 1.0] } else { [0.07, 0.55] };
        let (outline, nose) = (window.path(&scene::outline(motor)), window.path(&scene::nose(motor)));
        put(
            svg,
            format_args!(
                r#"<g fill="{colour}" stroke="{colour}"><path class="box" fill-opacity="{fill}" stroke-opacity="{stroke}" d="{outline}Z"/><path stroke="none" fill-opacity="{stroke}" d="{nose}Z"/></g>"#
            ),
        );
        if is_end {
            let [x, y] = window.place(scene::name_place(motor));
            let name = if index == 0 { "a" } else { "b" };
            put(svg, format_args!(r#"<text class="end" fill="{colour}" x="{x:.1}" y="{:.1}">{name}</text>"#, y + 6.0));
        }
    }
}

fn colour(t: f64) -> String {
    let [from, to] = COLOURS;
    let [red, green, blue] = [0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * t);
    format!("rgb({red:.0} {green:.0} {blue:.0})")
}

fn put(svg: &mut String, line: std::fmt::Arguments<'_>) {
    let _ = writeln!(svg, "{line}");
}
