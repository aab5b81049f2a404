//! The picture: a strip of film, a panel for each pose, all at the same scale.

use std::fmt::Write as _;

use pga_motor::{Motor, Point};

use super::anatomy::{Anatomy, Bone, Side};
use super::panel::Panel;
use super::view::{Seen, View, nice};

pub(crate) struct Filmstrip {
    pub(crate) title: String,
    pub(crate) summary: String,
    pub(crate) anatomy: Anatomy,
    pub(crate) panels: Vec<Panel>,
}

/// Pixels.
const FIGURE_HEIGHT: f64 = 300.0;
const MARGIN: f64 = 26.0;
const GAP: f64 = 10.0;
const HEADER: f64 = 64.0;
const PERFORATION: f64 = 34.0;
const CAPTION: f64 = 30.0;
/// At most.
const PANELS_IN_A_ROW: usize = 8;

/// The rectangle of the skeleton's space, as seen, that every panel shows; and its scale.
struct Window {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    /// Pixels for one unit of length.
    scale: f64,
}

impl Window {
    fn around(view: &View, panels: &[Panel]) -> Self {
        let reach = view.size * 0.04;
        let mut window = Self { left: -reach, right: reach, bottom: -reach, top: reach, scale: 1.0 };
        for panel in panels {
            let motor = view.panel_motor(panel.points[0]);
            for &point in &panel.points {
                let seen = Seen::through(motor, point);
                window.left = window.left.min(seen.x);
                window.right = window.right.max(seen.x);
                window.bottom = window.bottom.min(seen.y);
                window.top = window.top.max(seen.y);
            }
        }
        window.scale = FIGURE_HEIGHT / (window.top - window.bottom).max((window.right - window.left) / 1.6);
        window
    }

    fn width(&self) -> f64 {
        (self.right - self.left) * self.scale + 2.0 * MARGIN
    }

    fn height(&self) -> f64 {
        (self.top - self.bottom) * self.scale + 2.0 * MARGIN + CAPTION
    }

    /// Pixels from the panel's upper left corner.
    fn place(&self, seen: Seen) -> [f64; 2] {
        [MARGIN + (seen.x - self.left) * self.scale, MARGIN + (self.top - seen.y) * self.scale]
    }
}

impl Filmstrip {
    pub(crate) fn svg(&self) -> String {
        let figures: Vec<&[Point<f64>]> = self.panels.iter().map(|panel| panel.points.as_slice()).collect();
        let view = View::of(&figures);
        let window = Window::around(&view, &self.panels);
        let rows = self.panels.len().div_ceil(PANELS_IN_A_ROW);
        let columns = self.panels.len().div_ceil(rows);
        let strip = window.height() + 2.0 * PERFORATION;
        let width = (columns as f64 * (window.width() + GAP) + GAP).max(520.0);
        let height = HEADER + rows as f64 * (strip + GAP) + GAP;

        let mut svg = String::new();
        self.write_head(&mut svg, width, height, &window);
        for (row, panels) in self.panels.chunks(columns).enumerate() {
            let y = HEADER + row as f64 * (strip + GAP);
            write_film(&mut svg, y, width, strip);
            for (column, panel) in panels.iter().enumerate() {
                let x = GAP + column as f64 * (window.width() + GAP);
                put(&mut svg, format_args!(r#"<g transform="translate({x:.1} {:.1})">"#, y + PERFORATION));
                self.write_panel(&mut svg, &view, &window, panel);
                put(&mut svg, format_args!("</g>"));
            }
        }
        svg + "</svg>\n"
    }

    fn write_head(&self, svg: &mut String, width: f64, height: f64, window: &Window) {
        let (panel_width, panel_height) = (window.width(), window.height());
        put(
            svg,
            format_args!(
                r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0} {height:.0}" width="{width:.0}" height="{height:.0}" font-family="system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif">
<style>
.left {{ stroke: #d1495b; }} .right {{ stroke: #2f6fb0; }} .middle {{ stroke: #39424e; }}
.joint {{ fill: #fdfcf8; stroke-width: 1.6; }} .head {{ fill: #fdfcf8; }} .bone, .shadow {{ stroke-linecap: round; fill: none; }}
.shadow {{ stroke: #000; stroke-opacity: .09; }} .ground {{ stroke: #8b8f96; stroke-width: 1.5; }} .tick {{ stroke: #c4c2bb; }}
.caption {{ font-size: 14px; fill: #4a4f57; text-anchor: middle; }}
</style>
<defs><clipPath id="panel"><rect width="{panel_width:.1}" height="{panel_height:.1}" rx="7"/></clipPath></defs>
<rect width="{width:.0}" height="{height:.0}" fill="#fff"/>"##
            ),
        );
        let (title, summary) = (escape(&self.title), escape(&self.summary));
        put(
            svg,
            format_args!(
                r##"<text x="{GAP}" y="29" font-size="21" font-weight="600" fill="#23272e">{title}</text>
<text x="{GAP}" y="50" font-size="14" fill="#6b7079">{summary}</text>"##
            ),
        );
        for (place, (side, name)) in [(Side::Left, "left"), (Side::Right, "right")].into_iter().enumerate() {
            if self.anatomy.sides.contains(&side) {
                let x = width - GAP - 150.0 + 80.0 * place as f64;
                let class = side.name();
                put(
                    svg,
                    format_args!(
                        r##"<path class="{class} bone" stroke-width="5" d="M{x:.0} 45h22"/><text x="{:.0}" y="50" font-size="14" fill="#6b7079">{name}</text>"##,
                        x + 30.0
                    ),
                );
            }
        }
    }

    fn write_panel(&self, svg: &mut String, view: &View, window: &Window, panel: &Panel) {
        let (width, height) = (window.width(), window.height());
        let motor = view.panel_motor(panel.points[0]);
        put(
            svg,
            format_args!(
                r##"<g clip-path="url(#panel)"><rect width="{width:.1}" height="{height:.1}" fill="#fdfcf8"/>"##
            ),
        );
        write_ground(svg, view, window, motor, panel.points[0]);
        self.write_shadow(svg, view, window, motor, &panel.points);
        let seen: Vec<Seen> = panel.points.iter().map(|&point| Seen::through(motor, point)).collect();
        self.write_figure(svg, view, window, &seen);
        put(svg, format_args!("</g>"));
        let (x, y, caption) = (width / 2.0, height - 13.0, escape(&panel.caption));
        put(svg, format_args!(r#"<text class="caption" x="{x:.1}" y="{y:.1}">{caption}</text>"#));
    }

    /// The figure laid flat on the ground by a sun straight above.
    fn write_shadow(&self, svg: &mut String, view: &View, window: &Window, motor: Motor<f64>, points: &[Point<f64>]) {
        let mut path = String::new();
        for bone in &self.anatomy.bones {
            let [[x1, y1], [x2, y2]] = [bone.from, bone.to].map(|end| {
                let below = Point::new(points[end].x, view.ground, points[end].z);
                window.place(Seen::through(motor, below))
            });
            let _ = write!(path, "M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}");
        }
        put(svg, format_args!(r#"<path class="shadow" stroke-width="5" d="{path}"/>"#));
    }

    /// Bones, joints and heads, the far ones first.
    fn write_figure(&self, svg: &mut String, view: &View, window: &Window, seen: &[Seen]) {
        let middle = |bone: &Bone| (seen[bone.from].near + seen[bone.to].near) / 2.0;
        let mut shapes: Vec<(f64, String)> = Vec::new();
        for bone in &self.anatomy.bones {
            let [from, to] = [seen[bone.from], seen[bone.to]];
            let near = middle(bone);
            let ([x1, y1], [x2, y2]) = (window.place(from), window.place(to));
            if (x1 - x2).hypot(y1 - y2) < 0.05 {
                continue;
            }
            let (class, stroke) = (bone.side.name(), 5.0 + 6.0 * near / view.size);
            shapes.push((
                near,
                format!(
                    r#"<path class="{class} bone" stroke-width="{stroke:.1}" d="M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}"/>"#
                ),
            ));
        }
        for (joint, &side) in self.anatomy.sides.iter().enumerate() {
            // A dot lies on the bones that meet in it.
            let meeting = self.anatomy.bones.iter().filter(|bone| bone.from == joint || bone.to == joint);
            let near = meeting.map(middle).fold(seen[joint].near, f64::max);
            let ([x, y], class) = (window.place(seen[joint]), side.name());
            shapes.push((near, format!(r#"<circle class="{class} joint" cx="{x:.1}" cy="{y:.1}" r="2.9"/>"#)));
        }
        for &(bottom, top) in &self.anatomy.heads {
            let ([x1, y1], [x2, y2]) = (window.place(seen[bottom]), window.place(seen[top]));
            let (x, y, r) = ((x1 + x2) / 2.0, (y1 + y2) / 2.0, (x1 - x2).hypot(y1 - y2) * 0.55);
            let near = seen[bottom].near.max(seen[top].near);
            shapes.push((
                near,
                format!(r#"<circle class="middle head" stroke-width="4" cx="{x:.1}" cy="{y:.1}" r="{r:.1}"/>"#),
            ));
        }
        shapes.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, shape) in shapes {
            put(svg, format_args!("{shape}"));
        }
    }
}

/// A strip of film with its perforation.
fn write_film(svg: &mut String, y: f64, width: f64, height: f64) {
    put(svg, format_args!(r##"<rect y="{y:.1}" width="{width:.1}" height="{height:.1}" fill="#22262c"/>"##));
    let holes = (width / 30.0).floor();
    let pitch = width / holes;
    for edge in [y + 10.0, y + height - 24.0] {
        let mut path = String::new();
        for hole in 0..holes as usize {
            let x = (hole as f64 + 0.5) * pitch - 9.0;
            let _ = write!(
                path,
                "M{x:.1} {edge:.1}m3 0h12a3 3 0 0 1 3 3v8a3 3 0 0 1-3 3h-12a3 3 0 0 1-3-3v-8a3 3 0 0 1 3-3z"
            );
        }
        put(svg, format_args!(r##"<path fill="#f2f1ec" d="{path}"/>"##));
    }
}

/// The ground line below the root, and marks that stand still in the world while the figure moves over them.
fn write_ground(svg: &mut String, view: &View, window: &Window, motor: Motor<f64>, root: Point<f64>) {
    let [tx, tz] = view.track;
    let spacing = nice(view.size / 5.0);
    let root_along = root.x * tx + root.z * tz;
    let reach = (2.0 * view.size / spacing).ceil() as i32;
    for mark in -reach..=reach {
        let ahead = mark as f64 * spacing - root_along.rem_euclid(spacing);
        let end = |side: f64| {
            let sideways = side * view.size * 0.3;
            let point =
                Point::new(root.x + ahead * tx - sideways * tz, view.ground, root.z + ahead * tz + sideways * tx);
            window.place(Seen::through(motor, point))
        };
        let ([x1, y1], [x2, y2]) = (end(-1.0), end(1.0));
        put(svg, format_args!(r#"<path class="tick" d="M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}"/>"#));
    }
    let [_, y] = window.place(Seen { x: 0.0, y: 0.0, near: 0.0 });
    put(svg, format_args!(r#"<path class="ground" d="M0 {y:.1}H{:.1}"/>"#, window.width()));
}

pub(crate) fn escape(text: &str) -> String {
    // Characters that no XML may hold are left out.
    let text: String = text.chars().filter(|character| !character.is_control()).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn put(svg: &mut String, line: std::fmt::Arguments<'_>) {
    let _ = writeln!(svg, "{line}");
}
