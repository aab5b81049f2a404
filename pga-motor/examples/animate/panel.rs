//! One pose of a filmstrip.

use pga_motor::Point;

use super::player::Player;

/// How many poses there are where nobody asked for certain ones.
pub(crate) const POSES: usize = 8;

/// A pose and when it is.
pub(crate) struct Panel {
    pub(crate) caption: String,
    pub(crate) points: Vec<Point<f64>>,
}

/// The poses at these times in seconds; at evenly spaced ones if there are none.
pub(crate) fn draw(player: &mut Player<'_>, times: &[f64]) -> Result<Vec<Panel>, String> {
    let times = if times.is_empty() { player.times(POSES) } else { times.to_vec() };
    let poses = times.into_iter().map(|time| {
        let points = player.drawable_points(time, player.interpolation())?;
        Ok(Panel { caption: format!("{time:.2} s"), points })
    });
    poses.collect()
}
