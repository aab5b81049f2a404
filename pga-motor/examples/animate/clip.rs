//! What is played: a motion-capture file, or a figure that waves.

use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::{fs, str};

use pga_motor::import::bvh::{self, Bvh, Tip};
use pga_motor::skeleton::{Pose, Skeleton};
use pga_motor::{Direction, Motor, Rotor, Translator};

/// A skeleton and its motion.
pub(crate) enum Clip {
    File { name: String, file: Bvh<f64> },
    Waving { skeleton: Skeleton<f64>, tips: Vec<Tip<f64>> },
}

impl Clip {
    /// Reads a file. The error names the file and, where its content is at fault, the line and the reason.
    pub(crate) fn from_file(path: &Path) -> Result<Self, String> {
        let shown = path.display();
        let bytes = fs::read(path).map_err(|error| format!("cannot read {shown}: {error}"))?;
        let text = str::from_utf8(&bytes).map_err(|error| {
            let before = &bytes[..error.valid_up_to()];
            let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
            format!("{shown}: line {line}: expected text in UTF-8, found byte {:#04x}", bytes[before.len()])
        })?;
        let file: Bvh<f64> = bvh::parse(text).map_err(|error| format!("{shown}: {error}"))?;
        if file.frame_count() == 0 {
            return Err(format!("{shown}: expected a frame to draw, found none"));
        }
        let name = path.file_name().map_or_else(|| shown.to_string(), |name| name.to_string_lossy().into_owned());
        Ok(Self::File { name, file })
    }

    /// A figure that raises its right arm and waves.
    pub(crate) fn waving() -> Self {
        let joints = FIGURE.iter().map(|(name, parent, [x, y, z])| {
            let parent = parent.map(|parent| FIGURE.iter().position(|row| row.0 == parent).expect("a parent is a row"));
            let offset = Translator::from_vector(Direction::new(*x, *y, *z));
            (*name, parent, Motor::from(offset))
        });
        let (skeleton, _) = Skeleton::from_parents(joints).expect("the figure is a skeleton");
        let tips = TIPS.iter().map(|(name, [x, y, z])| {
            let joint = skeleton.find(name).expect("a tip hangs from a joint");
            Tip { joint, offset: Direction::new(*x, *y, *z) }
        });
        Self::Waving { tips: tips.collect(), skeleton }
    }

    pub(crate) fn title(&self) -> String {
        match self {
            Self::File { name, .. } => name.clone(),
            Self::Waving { .. } => "waving".to_owned(),
        }
    }

    pub(crate) fn summary(&self) -> String {
        let joints = self.skeleton().len();
        match self {
            Self::File { file, .. } => {
                let (frames, apart) = (file.frame_count(), file.frame_time());
                format!("joints: {joints}, frames: {frames}, {apart:.4} s apart, duration: {:.3} s", self.duration())
            }
            Self::Waving { .. } => format!("joints: {joints}, duration: {:.3} s", self.duration()),
        }
    }

    pub(crate) fn skeleton(&self) -> &Skeleton<f64> {
        match self {
            Self::File { file, .. } => file.skeleton(),
            Self::Waving { skeleton, .. } => skeleton,
        }
    }

    pub(crate) fn tips(&self) -> &[Tip<f64>] {
        match self {
            Self::File { file, .. } => file.tips(),
            Self::Waving { tips, .. } => tips,
        }
    }

    /// Seconds from the first pose to the last.
    pub(crate) fn duration(&self) -> f64 {
        match self {
            Self::File { file, .. } => (file.frame_count() - 1) as f64 * file.frame_time(),
            Self::Waving { .. } => 2.0,
        }
    }

    /// How many different poses there are at most.
    pub(crate) fn pose_count(&self) -> usize {
        match self {
            Self::File { file, .. } => file.frame_count(),
            Self::Waving { .. } => usize::MAX,
        }
    }

    /// The pose at a time in seconds, and a caption that says when it is. Of a file it is the frame nearest in time.
    pub(crate) fn pose_at(&self, time: f64) -> Result<(String, Pose<f64>), bvh::FrameError> {
        let mut pose = self.skeleton().rest_pose().clone();
        match self {
            Self::File { file, .. } => {
                let last = file.frame_count() - 1;
                let frame = if last == 0 { 0 } else { ((time / file.frame_time()).round() as usize).min(last) };
                file.pose_into(frame, &mut pose)?;
                Ok((format!("{:.2} s, frame {frame}", frame as f64 * file.frame_time()), pose))
            }
            Self::Waving { skeleton, .. } => {
                wave(skeleton, &mut pose, time);
                Ok((format!("{time:.2} s"), pose))
            }
        }
    }
}

/// Name, parent and offset in metres of each joint of the waving figure, which looks along +z.
const FIGURE: &[(&str, Option<&str>, [f64; 3])] = &[
    ("hips", None, [0.0, 0.95, 0.0]),
    ("spine", Some("hips"), [0.0, 0.12, 0.0]),
    ("chest", Some("spine"), [0.0, 0.2, 0.0]),
    ("neck", Some("chest"), [0.0, 0.2, 0.0]),
    ("head", Some("neck"), [0.0, 0.09, 0.01]),
    ("left_arm", Some("chest"), [0.18, 0.15, 0.0]),
    ("left_forearm", Some("left_arm"), [0.28, 0.0, 0.0]),
    ("left_hand", Some("left_forearm"), [0.25, 0.0, 0.0]),
    ("right_arm", Some("chest"), [-0.18, 0.15, 0.0]),
    ("right_forearm", Some("right_arm"), [-0.28, 0.0, 0.0]),
    ("right_hand", Some("right_forearm"), [-0.25, 0.0, 0.0]),
    ("left_thigh", Some("hips"), [0.1, -0.06, 0.0]),
    ("left_shin", Some("left_thigh"), [0.0, -0.43, 0.01]),
    ("left_foot", Some("left_shin"), [0.0, -0.4, -0.02]),
    ("right_thigh", Some("hips"), [-0.1, -0.06, 0.0]),
    ("right_shin", Some("right_thigh"), [0.0, -0.43, 0.01]),
    ("right_foot", Some("right_shin"), [0.0, -0.4, -0.02]),
];

const TIPS: &[(&str, [f64; 3])] = &[
    ("head", [0.0, 0.2, 0.02]),
    ("left_hand", [0.16, 0.0, 0.0]),
    ("right_hand", [-0.16, 0.0, 0.0]),
    ("left_foot", [0.02, -0.05, 0.17]),
    ("right_foot", [-0.02, -0.05, 0.17]),
];

/// Turns the joints of the resting figure, `time` seconds into the clip: the right arm goes up, waves and comes down again.
fn wave(skeleton: &Skeleton<f64>, pose: &mut Pose<f64>, time: f64) {
    let raised = (PI * time / 2.0).sin().sqrt();
    let swing = (TAU * 1.5 * time).sin() * raised;
    let turns = [
        ("spine", Rotor::about_z(0.05 * raised)),
        ("neck", Rotor::about_z(-0.12 * raised)),
        ("left_arm", Rotor::about_z(-1.3)),
        ("left_forearm", Rotor::about_y(-0.3)),
        ("right_arm", Rotor::about_z(1.3 - 1.7 * raised)),
        ("right_forearm", Rotor::about_z(-raised - 0.55 * swing) * Rotor::about_y(0.3)),
        ("right_hand", Rotor::about_z(-0.35 * swing)),
    ];
    for (name, rotor) in turns {
        let joint = skeleton.find(name).expect("the name is one of the figure's");
        pose[joint] = pose[joint] * rotor;
    }
}
