//! A clip as a page plays it: where everything is, many times a second, by several interpolations.

use indicatif::{ProgressBar, ProgressStyle};
use pga_motor::Point;
use pga_motor::skeleton::Interpolation;

use super::player::Player;

/// Poses in a second, where the clip is not too long for it.
const RATE: f64 = 60.0;

/// Poses of a short clip, so that it can be slowed down.
const LEAST: usize = 241;

/// Numbers in all tracks together; 12 MB as a page stores them.
const MOST_NUMBERS: usize = 3_000_000;

/// The ways that are laid over each other.
const COMPARED: [Interpolation; 3] = [Interpolation::Nlerp, Interpolation::Screw, Interpolation::Split];

/// One interpolation, run through.
pub(crate) struct Track {
    pub(crate) interpolation: Interpolation,
    /// Pose after pose.
    pub(crate) poses: Vec<Vec<Point<f64>>>,
}

pub(crate) struct Tracks {
    /// Those that are compared, and behind them the one asked for if it is another.
    pub(crate) all: Vec<Track>,
    /// Seconds of the first pose and the last; those between are evenly spaced.
    pub(crate) span: [f64; 2],
}

impl Tracks {
    /// Runs the clip through, with a bar on a terminal.
    pub(crate) fn of(player: &mut Player<'_>) -> Result<Self, String> {
        let mut ways = COMPARED.to_vec();
        ways.extend(Some(player.interpolation()).filter(|way| !COMPARED.contains(way)));
        let numbers = 3 * ways.len() * (player.source().joints.len() + player.source().tips.len());
        let times = player.times(pose_count(player.clip().duration(), numbers));
        let bar = progress_bar(ways.len() * times.len());
        let all = ways.into_iter().map(|interpolation| {
            let poses = times.iter().map(|&time| {
                bar.inc(1);
                player.drawable_points(time, interpolation)
            });
            Ok(Track { interpolation, poses: poses.collect::<Result<_, String>>()? })
        });
        let all = all.collect::<Result<_, String>>()?;
        bar.finish_and_clear();
        Ok(Self { all, span: [times[0], times[times.len() - 1]] })
    }

    pub(crate) fn pose_count(&self) -> usize {
        self.all[0].poses.len()
    }

    /// Index of the track of an interpolation.
    pub(crate) fn find(&self, interpolation: Interpolation) -> Option<usize> {
        self.all.iter().position(|track| track.interpolation == interpolation)
    }

    /// The point that the compared interpolations take farthest apart.
    pub(crate) fn most_different(&self) -> usize {
        let tracks = &self.all[..COMPARED.len()];
        let pairs = [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (&tracks[a].poses, &tracks[b].poses));
        let mut farthest = (0, 0.0);
        for (a, b) in pairs.into_iter().flat_map(|(a, b)| a.iter().zip(b)) {
            for (point, (&p, &q)) in a.iter().zip(b).enumerate() {
                let distance = p.distance_to_point(q);
                if distance > farthest.1 {
                    farthest = (point, distance);
                }
            }
        }
        farthest.0
    }
}

/// How many poses: so many a second, or as many as there is room for.
fn pose_count(duration: f64, numbers_in_a_pose: usize) -> usize {
    let room = MOST_NUMBERS / numbers_in_a_pose.max(1);
    // Where the product is larger than any count, the conversion gives the largest there is.
    ((duration * RATE).ceil() as usize).saturating_add(1).max(LEAST).min(room).max(2)
}

/// Seen on a terminal only.
fn progress_bar(steps: usize) -> ProgressBar {
    let style =
        ProgressStyle::with_template("posing {wide_bar} {percent} %, {eta} left").expect("the template is valid");
    ProgressBar::new(steps as u64).with_style(style)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_clips_have_fewer_poses_a_second_and_short_ones_more() {
        assert_eq!(pose_count(0.5, 300), 241);
        assert_eq!(pose_count(10.0, 300), 601);
        assert_eq!(pose_count(1e5, 300), 10_000);
        assert_eq!(pose_count(f64::MAX, usize::MAX), 2);
    }
}
