//! Definition blocks that come with the crate.

/// The names of the presets.
pub const NAMES: [&str; 2] = ["pga3d", "pga2d"];

/// The text of a preset's definition block.
pub fn text(name: &str) -> Option<&'static str> {
    match name {
        "pga3d" => Some(concat!(include_str!("presets/pga3d.ga"), include_str!("presets/pga3d.recipes.ga"))),
        "pga2d" => Some(concat!(include_str!("presets/pga2d.ga"), include_str!("presets/pga2d.recipes.ga"))),
        _ => None,
    }
}

pub(crate) fn names() -> String {
    NAMES.map(|name| format!("`{name}`")).join(", ")
}
