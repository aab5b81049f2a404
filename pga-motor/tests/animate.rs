//! The command line of the example `animate`: what it prints, what it writes and how it fails.

#[allow(dead_code, reason = "an example's own main is for the example")]
#[path = "../examples/animate/main.rs"]
mod animate;

use std::fs;
use std::path::{Path, PathBuf};

use pga_motor::import::bvh::{self, Bvh};
use pga_motor::skeleton::local_to_model;
use pga_motor::{Motor, Point};
use serde_json::Value;

/// Two frames: the arm hangs, then it has turned by 90 degrees about z and gone 2 along x.
const ARM: &str = "\
HIERARCHY
ROOT shoulder { OFFSET 0 0 0 CHANNELS 4 Xposition Yposition Zposition Zrotation
    JOINT hand { OFFSET 0 -3 0 End Site { OFFSET 0 -1 0 } } }
MOTION
Frames: 2
Frame Time: 0.5
0 5 0 0
2 5 0 90
";

struct Ended {
    code: u8,
    out: String,
    log: String,
}

fn run<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Ended {
    let (mut out, mut log) = (Vec::new(), Vec::new());
    let code = animate::run(lexopt::Parser::from_args(arguments), &mut out, &mut log);
    let text = |bytes| String::from_utf8(bytes).expect("what is said is text");
    Ended { code, out: text(out), log: text(log) }
}

/// What a run prints that must succeed.
#[track_caller]
fn json<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Value {
    let ended = run(arguments);
    assert_eq!((ended.code, ended.log.as_str()), (0, ""));
    serde_json::from_str(&ended.out).expect("what is printed is JSON")
}

/// What a run that must fail says, after the program's name.
#[track_caller]
fn fault<'a>(code: u8, arguments: impl IntoIterator<Item = &'a str>) -> String {
    let ended = run(arguments);
    assert_eq!((ended.code, ended.out.as_str()), (code, ""), "{}", ended.log);
    ended.log.strip_prefix("animate: ").expect("the program's name comes first").trim_end().to_owned()
}

/// A file in a folder of its own, which goes with it.
struct Scratch {
    folder: PathBuf,
}

impl Scratch {
    fn new(test: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("animate-{test}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder for files");
        Self { folder }
    }

    fn path(&self, name: &str) -> String {
        self.folder.join(name).to_str().expect("the path is text").to_owned()
    }

    fn with(&self, name: &str, text: &str) -> String {
        fs::write(self.path(name), text).expect("a file is written");
        self.path(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

fn position(joint: &Value) -> [f64; 3] {
    [0, 1, 2].map(|axis| joint["position"][axis].as_f64().expect("a coordinate is a number"))
}

#[test]
fn positions_are_printed_for_each_time_and_joint() {
    let scratch = Scratch::new("positions");
    let file = scratch.with("arm.bvh", ARM);
    let printed = json([&file, "--times", "0,0.25,0.5", "--json"]);
    assert_eq!((&printed["file"], &printed["clip"]), (&Value::from(file), &Value::from("arm")));
    let samples = printed["samples"].as_array().expect("samples are a list");
    // Half way the shoulder is at (1, 5, 0) and the hand, 3 away, has turned by 45 degrees from straight below towards +x.
    let diagonal = 3.0 * 0.5_f64.sqrt();
    let expected = [
        (0.0, [[0.0, 5.0, 0.0], [0.0, 2.0, 0.0]]),
        (0.25, [[1.0, 5.0, 0.0], [1.0 + diagonal, 5.0 - diagonal, 0.0]]),
        (0.5, [[2.0, 5.0, 0.0], [5.0, 5.0, 0.0]]),
    ];
    assert_eq!(samples.len(), expected.len());
    for (sample, (time, places)) in samples.iter().zip(expected) {
        assert_eq!(sample["time"], time);
        let joints = sample["joints"].as_array().expect("joints are a list");
        assert_eq!(joints.iter().map(|joint| &joint["name"]).collect::<Vec<_>>(), ["shoulder", "hand"]);
        for (joint, place) in joints.iter().zip(places) {
            let [x, y, z] = position(joint);
            let [u, v, w] = place;
            // A few roundings of numbers up to 5.
            let distance = Point::new(x, y, z).distance_to_point(Point::new(u, v, w));
            assert!(distance < 1e-14, "{joint} at {time} s instead of {place:?}");
        }
    }
}

#[test]
fn frames_are_those_of_the_reader_bit_for_bit() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/marionette.bvh");
    let Ok(text) = fs::read_to_string(&path) else {
        eprintln!("SKIPPED frames_are_those_of_the_reader_bit_for_bit: there is no file {}", path.display());
        return;
    };
    let file: Bvh<f64> = bvh::parse(&text).expect("the file is sound");
    for frame in 0..file.frame_count() {
        let mut pose = file.skeleton().rest_pose().clone();
        file.pose_into(frame, &mut pose).expect("the frame is one of the file's");
        let mut model = vec![Motor::IDENTITY; pose.len()];
        local_to_model(file.skeleton(), &pose, &mut model).expect("the buffers have the skeleton's length");
        let time = (frame as f64 * file.frame_time()).to_string();
        let printed = json([path.to_str().expect("the path is text"), "--json", "--times", &time]);
        let joints = printed["samples"][0]["joints"].as_array().expect("joints are a list");
        assert_eq!(joints.len(), model.len());
        for (joint, motor) in joints.iter().zip(model) {
            // Keys may have the other sign, which is the same motion and leads to the same digits.
            let Point { x, y, z } = motor.transform_origin();
            assert_eq!(position(joint), [x, y, z]);
        }
    }
}

#[test]
fn before_and_after_the_clip_it_stands_still() {
    let joints = |time| json(["--json", "--times", time])["samples"][0]["joints"].clone();
    assert_eq!(joints("-3"), joints("0"));
    assert_eq!(joints("1e300"), joints("2"));
    let asked = json(["--json", "--times", "1e300"]);
    assert_eq!((&asked["samples"][0]["time"], &asked["file"]), (&Value::from(1e300), &Value::Null));
}

#[test]
fn without_times_they_are_evenly_spaced() {
    let printed = json(["--json", "--clip", "leaping"]);
    let times: Vec<_> = printed["samples"].as_array().expect("a list").iter().map(|s| s["time"].as_f64()).collect();
    assert_eq!((times.len(), times[0], times[7]), (8, Some(0.0), Some(1.6)));
}

#[test]
fn a_clip_is_chosen_by_name_or_index() {
    assert_eq!(json(["--json"])["clip"], "waving");
    assert_eq!(json(["--json", "--clip", "1"])["clip"], "leaping");
    assert_eq!(json(["--json", "--clip", "waving"])["clip"], "waving");
    let expected = "figure: expected one of the clips 0 `waving`, 1 `leaping`, found `running`";
    assert_eq!(fault(1, ["--json", "--clip", "running"]), expected);
    assert_eq!(fault(1, ["--json", "--clip", "2"]), expected.replace("running", "2"));
    // A name wins over an index.
    let scratch = Scratch::new("clips");
    let file = scratch.with("7.bvh", ARM);
    assert_eq!(json([&file, "--json", "--clip", "7"])["clip"], "7");
    assert_eq!(json([&file, "--json", "--clip", "0"])["clip"], "7");
}

#[test]
fn interpolations_differ_between_keys_and_only_there() {
    let hand = |way, time| {
        let printed = json(["--json", "--clip", "leaping", "--interpolation", way, "--times", time]);
        position(&printed["samples"][0]["joints"][7])
    };
    for way in ["step", "nlerp", "slerp", "screw"] {
        assert_ne!(hand(way, "0.3"), hand("split", "0.3"), "{way}");
        assert_eq!(hand(way, "0.8"), hand("split", "0.8"), "{way}");
    }
    assert_eq!(hand("step", "0.3"), hand("split", "0"));
}

#[test]
fn keys_are_thinned_out_but_for_the_first_and_the_last() {
    let scratch = Scratch::new("every");
    let frames: Vec<_> = (0..6).map(|frame| format!("0 {} 0 0\n", frame * frame)).collect();
    let text =
        ARM.replace("Frames: 2", "Frames: 6").split_inclusive('\n').take(6).collect::<String>() + &frames.concat();
    let file = scratch.with("fall.bvh", &text);
    let heights = |every| {
        let printed = json([&file, "--json", "--every", every, "--times", "0,0.5,1,1.5,2,2.5"]);
        let samples = printed["samples"].as_array().expect("samples are a list").clone();
        samples.iter().map(|sample| position(&sample["joints"][0])[1]).collect::<Vec<_>>()
    };
    assert_eq!(heights("1"), [0.0, 1.0, 4.0, 9.0, 16.0, 25.0]);
    // The keys 0, 3 and 5 remain; between them it goes straight, up to a rounding.
    let thinned = heights("3");
    let expected = [0.0, 3.0, 6.0, 9.0, 17.0, 25.0];
    assert!(thinned.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{thinned:?}");
}

#[test]
fn a_file_without_frames_stands_in_its_rest_pose() {
    let scratch = Scratch::new("rest");
    let text = ARM.split_inclusive('\n').take(6).collect::<String>().replace("Frames: 2", "Frames: 0");
    let printed = json([&scratch.with("still.bvh", &text), "--json"]);
    assert_eq!((&printed["clip"], printed["samples"].as_array().map(Vec::len)), (&Value::from("rest"), Some(1)));
    assert_eq!(position(&printed["samples"][0]["joints"][1]), [0.0, -3.0, 0.0]);
}

#[test]
fn files_at_fault_are_named_with_the_fault() {
    let scratch = Scratch::new("faults");
    let broken = scratch.with("broken.bvh", &ARM.replace("OFFSET 0 -3 0", "OFFSET 0 -3"));
    let expected = format!("{broken}: line 3: expected a number for z of the `OFFSET` of joint `hand`, found `End`");
    assert_eq!(fault(1, [&broken, "--json"]), expected);
    let missing = scratch.path("missing.bvh");
    assert!(fault(1, [&missing, "--json"]).starts_with(&format!("{missing}: cannot be read: ")));
    let other = scratch.with("walk.fbx", "Kaydara");
    assert_eq!(fault(1, [&other, "--json"]), format!("{other}: expected a file that ends in .glb, .gltf or .bvh"));
    let far =
        scratch.with("far.bvh", &ARM.replace("2 5 0 90", "1e308 5 0 90").replace("OFFSET 0 0 0", "OFFSET 1e308 0 0"));
    assert_eq!(
        fault(1, [&far, "--json"]),
        format!("{far}: key 1, joint 0: expected a finite motor, found a NaN or an infinity")
    );
    let picture = scratch.path("no folder/out.svg");
    assert!(fault(1, ["-o", &picture]).starts_with(&format!("cannot write {picture}: ")));
}

#[test]
fn misuse_is_told_from_failure() {
    let says = |expected: &str, arguments: &[&str]| {
        let told = fault(2, arguments.iter().copied());
        assert_eq!(told, format!("{expected} (--help shows the usage)"));
    };
    says("--times: expected seconds, separated by commas, found `soon`", &["--times", "0,soon"]);
    says("--times: expected seconds, separated by commas, found `inf`", &["--times", "inf"]);
    let ways = "--interpolation: expected one of step, nlerp, slerp, screw, split, found `cubic`";
    says(ways, &["--interpolation", "cubic"]);
    says("--every: expected a whole number from 1 up, found `0`", &["--every", "0"]);
    says("--output: expected a name that ends in .svg or .html, found `out.png`", &["-o", "out.png"]);
    says("--json writes to standard output, expected no --output with it", &["--json", "-o", "out.svg"]);
    says("--times is for a filmstrip and for --json, a page plays the whole clip", &["--times", "0", "-o", "o.html"]);
    says("unexpected argument \"b.bvh\"", &["a.bvh", "b.bvh"]);
    says("invalid option '--jsn'", &["--jsn"]);
}

#[test]
fn pictures_are_written_and_said_so() {
    let scratch = Scratch::new("pictures");
    let file = scratch.with("a<b>&.bvh", &ARM.replace("hand", "</script>"));
    let strip = scratch.path("strip.SVG");
    let ended = run([&file, "-o", &strip, "--times", "0,0.25"]);
    assert_eq!((ended.code, ended.log.as_str()), (0, ""));
    assert!(ended.out.ends_with(&format!("2 poses drawn to {strip}\n")), "{}", ended.out);
    let svg = fs::read_to_string(&strip).expect("the strip is there");
    assert!(svg.contains("a&lt;b&gt;&amp;.bvh") && svg.ends_with("</svg>\n"));

    let page = scratch.path("page.html");
    let ended = run([&file, "-o", &page, "--interpolation", "slerp"]);
    assert_eq!((ended.code, ended.log.as_str()), (0, ""));
    assert!(
        ended.out.ends_with(&format!("241 poses, 480 a second, by nlerp, screw, split, slerp written to {page}\n"))
    );
    let html = fs::read_to_string(&page).expect("the page is there");
    assert!(html.contains("<title>a&lt;b&gt;&amp;.bvh</title>") && !html.contains("{{"));
    assert_eq!(html.matches("</script>").count(), 2, "a name must not end the script");
    assert!(["http:", "https:", "src="].iter().all(|other| !html.contains(other)), "a page asks for no other file");
    let data = html.split_once(r#"id="data">"#).and_then(|(_, rest)| rest.split_once("</script>")).expect("data").0;
    let data: Value = serde_json::from_str(data).expect("the page's data is JSON");
    assert_eq!(data["names"], serde_json::json!(["shoulder", "</script>", "end of </script>"]));
    // 241 poses of 3 points of 3 numbers of 4 bytes, four characters for three bytes.
    assert_eq!(data["tracks"][3]["points"].as_str().map(str::len), Some(241 * 3 * 3 * 4 / 3 * 4));
}

#[test]
fn times_outside_the_clip_are_pointed_out_beside_a_picture() {
    let scratch = Scratch::new("outside");
    let ended = run(["-o", &scratch.path("strip.svg"), "--times", "1,3"]);
    assert_eq!((ended.code, ended.log.as_str()), (0, "animate: 3 s is outside the clip, which stands still there\n"));
}

#[cfg(not(feature = "gltf"))]
#[test]
fn gltf_asks_for_its_feature() {
    let expected = "walk.glb: glTF is read by a build with `--features gltf`, which this one is not";
    assert_eq!(fault(1, ["walk.glb", "--json"]), expected);
}

#[cfg(feature = "gltf")]
#[test]
fn gltf_is_played_in_the_space_of_its_file() {
    let text = r#"{
        "asset": { "version": "2.0" },
        "nodes": [
            { "name": "armature", "children": [1], "scale": [0.5, 0.5, 0.5], "translation": [0, 0, 7] },
            { "name": "hip", "children": [2], "translation": [0, 9, 0] },
            { "name": "knee", "translation": [0, -4, 0] }
        ],
        "skins": [ { "joints": [2, 1] } ]
    }"#;
    let scratch = Scratch::new("gltf");
    let file = scratch.with("leg.gltf", text);
    let printed = json([&file, "--json"]);
    assert_eq!((&printed["clip"], printed["samples"].as_array().map(Vec::len)), (&Value::from("rest"), Some(1)));
    let joints = printed["samples"][0]["joints"].as_array().expect("joints are a list");
    assert_eq!(joints.iter().map(|joint| &joint["name"]).collect::<Vec<_>>(), ["knee", "hip"]);
    assert_eq!(joints.iter().map(position).collect::<Vec<_>>(), [[0.0, 2.5, 7.0], [0.0, 4.5, 7.0]]);
    let broken = scratch.with("broken.glb", "glTF");
    assert!(fault(1, [&broken, "--json"]).starts_with(&format!("{broken}: ")));
}
