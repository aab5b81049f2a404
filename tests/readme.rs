//! The README shows what the generator emits and code that runs.

use std::fs;
use std::path::Path;
use std::process::Command;

fn readme() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).expect("the README is there")
}

/// The code blocks of one language.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    text.split(&fence).skip(1).filter_map(|rest| Some(rest.split_once("```")?.0.to_owned())).collect()
}

#[test]
fn readme_shows_the_emitted_kernel() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--package", "ga-codegen", "--", "emit", "pga3d", "--kernel", "motor_transform_point"])
        .current_dir(root)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let emitted = String::from_utf8(output.stdout).expect("Rust is UTF-8");
    let function: String =
        emitted.lines().filter(|line| !line.starts_with("#[inline]")).map(|l| l.to_owned() + "\n").collect();
    let shown = &blocks(&readme(), "rust")[0];
    assert!(function.contains(shown.trim_end()), "expected in the README:\n{function}\nfound:\n{shown}");
}

#[test]
fn readme_shows_the_costs_beside_the_records() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/budgets.md");
    let budgets = fs::read_to_string(path).expect("the table of budgets");
    let mut expected = "| kernel | record | mul+add | FMA |\n|---|---|---|---|\n".to_owned();
    for line in budgets.lines() {
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        if let [name, record, _, cost, fma, _] = cells[..]
            && record.contains('+')
        {
            expected += &format!("| {name} | {record} | {cost} | {fma} |\n");
        }
    }
    let readme = readme();
    let shown = readme.split_once("<!-- costs -->\n").and_then(|(_, rest)| rest.split_once("<!-- /costs -->"));
    let shown = shown.expect("the README's place for the costs").0;
    assert!(shown == expected, "expected between the marks of the README:\n{expected}");
}

#[test]
fn ten_lines_of_use_hold() {
    use pga_motor::f32::{Direction, Motor, Point, Rotor, Translator};

    let turn = Rotor::about_z(std::f32::consts::FRAC_PI_2);
    let step = Translator::from_vector(Direction::new(2.0, 0.0, 0.0));
    let motor: Motor = step * turn;
    let moved = motor.transform_point(Point::new(1.0, 0.0, 0.0));
    // One rounding of cos and sin and a few operations on numbers up to 2: a few times 2^-24.
    assert!(moved.distance_to_point(Point::new(2.0, 1.0, 0.0)) < 1e-6);
    let line = moved & Point::ORIGIN;
    let carried = motor >> line;
    let half = (motor.log() * 0.5).exp();
    assert!((half * half - motor).norm() < 1e-6 && carried.is_finite());
}

#[test]
fn readme_shows_the_counterexample_that_a_test_pins() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("ga-codegen/tests/check.rs");
    let tests = fs::read_to_string(path).expect("the tests of the checks");
    let blocks = blocks(&readme(), "text");
    let shown = blocks.iter().find(|block| block.contains("found another at")).expect("a counterexample");
    assert!(tests.contains(shown.trim_end()), "expected in a test:\n{shown}");
    assert!(tests.contains(blocks_with(&readme(), "Check::new").trim_end()), "expected the README's line in a test");
}

/// The first code block with this in it.
fn blocks_with(text: &str, what: &str) -> String {
    blocks(text, "rust").into_iter().find(|block| block.contains(what)).expect("a code block of the README")
}

mod plane {
    ga_macros::algebra! {
        signature (2, 0, 0);
        basis 1 e1 e2 e12;
        /// An arrow in the plane.
        entity Vector { x: e1, y: e2 }
        /// A rotation of the plane.
        entity Rotor { c: 1, s: e12 } where c*c == 1 - s*s;
        kernel rotor_mul_rotor(a: Rotor, b: Rotor) -> Rotor = a * b;
        kernel rotor_transform_vector(r: Rotor, v: Vector) -> Vector = r >> v;
    }
}

#[test]
fn an_algebra_of_ones_own_holds() {
    use plane::{Rotor, Vector};

    let quarter = Rotor::new(0.5_f64.sqrt(), -(0.5_f64.sqrt()));
    let turned = quarter >> Vector::new(1.0, 0.0);
    assert!((turned.x).abs() < 1e-15 && (turned.y - 1.0).abs() < 1e-15);
}
