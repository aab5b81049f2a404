//! The picture: a panel for each motion, in which everything moves by SVG's own means.

use std::fmt::Write as _;

use pga_motor::f64::{Motor, Point};

use crate::cube::{self, Face};
use crate::motion::Motion;

/// Pixels.
const PANEL: f64 = 380.0;
const GAP: f64 = 20.0;
const HEADER: f64 = 84.0;
const CAPTION: f64 = 78.0;
const MARGIN: f64 = 20.0;
/// Pixels for one unit of length in the picture.
const SCALE: f64 = 74.0;

/// Seconds of a round.
const DURATION: f64 = 10.0;

/// Poses in a round. In between, corners and colours go straight.
const POSES: usize = 150;

pub(crate) fn svg(motions: &[Motion]) -> String {
    let width = GAP + motions.len() as f64 * (PANEL + GAP);
    let height = HEADER + CAPTION + PANEL + GAP;
    let mut svg = String::new();
    write_head(&mut svg, width, height);
    for (index, motion) in motions.iter().enumerate() {
        let x = GAP + index as f64 * (PANEL + GAP);
        put(&mut svg, format_args!(r#"<g transform="translate({x:.0} {HEADER:.0})">"#));
        write_panel(&mut svg, motion);
        put(&mut svg, format_args!("</g>"));
    }
    svg + "</svg>\n"
}

fn write_head(svg: &mut String, width: f64, height: f64) {
    put(
        svg,
        format_args!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0} {height:.0}" width="{width:.0}" height="{height:.0}" font-family="system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif">
<style>
.card {{ fill: #fdfcf8; stroke: #e3e0d6; }} .name {{ font-size: 19px; font-weight: 600; fill: #23272e; }}
.formula {{ font-size: 14px; fill: #4a4f57; font-family: 'DejaVu Sans Mono', Consolas, monospace; text-anchor: end; }}
.remark {{ font-size: 14px; fill: #6b7079; }} .way {{ fill: none; stroke: #b9b5a8; stroke-width: 1.5; stroke-dasharray: 1 5; stroke-linecap: round; }}
.face {{ stroke: #23272e; stroke-width: 1.4; stroke-linejoin: round; }}
</style>
<rect width="{width:.0}" height="{height:.0}" fill="#fff"/>
<text x="{GAP}" y="36" font-size="23" font-weight="600" fill="#23272e">A cube, about several axes at once</text>
<text x="{GAP}" y="62" font-size="15" fill="#6b7079">A face is drawn while the eye is in front of its plane; the light on it follows from the plane’s normal. Dotted, the way of the centre.</text>"##
        ),
    );
}

fn write_panel(svg: &mut String, motion: &Motion) {
    let Motion { name, formula, remark, at } = motion;
    let (right, height, middle) = (PANEL - MARGIN, CAPTION + PANEL, PANEL / 2.0);
    put(
        svg,
        format_args!(
            r#"<rect class="card" width="{PANEL}" height="{height}" rx="10"/>
<text class="name" x="{MARGIN}" y="36">{name}</text><text class="formula" x="{right}" y="36">{formula}</text>
<text class="remark" x="{MARGIN}" y="60">{remark}</text>
<g transform="translate({middle} {})">"#,
            CAPTION + middle
        ),
    );
    put(svg, format_args!(r#"<path class="way" d="{}"/>"#, outline(steps().map(|t| center(at(t))))));
    for face in cube::faces() {
        write_face(svg, &face, *at);
    }
    put(svg, format_args!("</g>"));
}

fn center(motor: Motor) -> [f64; 2] {
    cube::project(motor.transform_point(Point::ORIGIN))
}

/// The times of the poses, from 0 to 1.
fn steps() -> impl Iterator<Item = f64> {
    (0..=POSES).map(|pose| pose as f64 / POSES as f64)
}

fn write_face(svg: &mut String, face: &Face, at: fn(f64) -> Motor) {
    let outlines: Vec<_> = steps().map(|t| outline(face.outline(at(t)))).collect();
    let shades: Vec<_> = steps().map(|t| colour(face.shade(at(t)))).collect();
    let (times, states) = visibility(face, at);
    let timing = format_args!(r#"dur="{DURATION}s" repeatCount="indefinite""#).to_string();
    put(
        svg,
        format_args!(
            r#"<path class="face" d="{}" fill="{}" visibility="{}">
<animate attributeName="d" {timing} values="{}"/>
<animate attributeName="fill" {timing} values="{}"/>
<animate attributeName="visibility" {timing} calcMode="discrete" keyTimes="{}" values="{}"/>
</path>"#,
            outlines[0],
            shades[0],
            states[0],
            outlines.join(";"),
            shades.join(";"),
            times.join(";"),
            states.join(";"),
        ),
    );
}

/// When a face comes to be seen or hidden, from 0 on, and which of them.
fn visibility(face: &Face, at: fn(f64) -> Motor) -> (Vec<String>, Vec<&'static str>) {
    let is_seen = |t: f64| face.turned_to_eye(at(t)) > 0.0;
    let state = |seen| if seen { "visible" } else { "hidden" };
    let (mut times, mut states) = (vec!["0".to_owned()], vec![state(is_seen(0.0))]);
    for (before, after) in steps().zip(steps().skip(1)) {
        if is_seen(before) != is_seen(after) {
            times.push(format!("{:.5}", change(is_seen, before, after)));
            states.push(state(is_seen(after)));
        }
    }
    (times, states)
}

/// The time at which something changes that is not the same before and after, by halving the interval.
fn change(is_seen: impl Fn(f64) -> bool, mut before: f64, mut after: f64) -> f64 {
    for _ in 0..20 {
        let middle = (before + after) / 2.0;
        if is_seen(middle) == is_seen(before) { before = middle } else { after = middle }
    }
    after
}

/// A closed line, in pixels from the middle of the panel, y down.
fn outline(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let mut path = String::new();
    for (index, [x, y]) in points.into_iter().enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{command}{:.1} {:.1}", x * SCALE, -y * SCALE);
    }
    path + "Z"
}

fn colour(parts: [f64; 3]) -> String {
    let [red, green, blue] = parts.map(|part| part.round().clamp(0.0, 255.0) as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn put(svg: &mut String, line: std::fmt::Arguments<'_>) {
    let _ = writeln!(svg, "{line}");
}
