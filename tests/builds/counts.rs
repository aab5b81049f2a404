//! Instructions that loops execute, as callgrind counts them where it is installed: what no clock can blur.

use std::process::Command;

use crate::probe;
use crate::project::Project;

/// How many items a probe works on.
const COUNT: u64 = 1024;

/// Each probe, and how many instructions for each item it may execute with AVX2, the widest that callgrind knows. A tenth above what was
/// counted with Rust 1.95.
const BUDGETS: [(&str, f64); 13] = [
    ("compose", 15.1),
    ("points", 5.1),
    ("point_pairs", 9.3),
    ("exp", 12.5),
    ("log", 14.0),
    ("renormalize", 7.2),
    ("nlerp", 14.7),
    ("slerp", 38.7),
    ("screw_lerp", 53.5),
    ("crowd_kinematics", 24.2),
    ("crowd_sampling", 55.9),
    ("kinematics", 80.7),
    ("products", 66.1),
];

/// The instructions that a probe executes, all that it calls included.
fn count(project: &Project, probe: &str) -> u64 {
    let out = project.built("callgrind.out");
    let output = Command::new("valgrind")
        .args([
            "--tool=callgrind",
            &format!("--toggle-collect={probe}"),
            &format!("--callgrind-out-file={}", out.display()),
        ])
        .arg(project.built("release/probe"))
        .arg(probe)
        .output()
        .expect("valgrind runs, as it told its version");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{probe}: {text}");
    let collected = text.lines().find_map(|line| line.split("Collected :").nth(1));
    collected.and_then(|number| number.trim().parse().ok()).unwrap_or_else(|| panic!("{probe}: no count in {text}"))
}

#[test]
fn loops_execute_no_more_instructions_than_they_did() {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("not counted: valgrind is not installed");
        return;
    }
    let project = probe();
    project.cargo(&["build", "--release"]);
    let mut over = Vec::new();
    for (name, budget) in BUDGETS {
        let found = count(project, name) as f64 / COUNT as f64;
        println!("{name}: {found:.2} instructions an item");
        if found > budget {
            over.push(format!("{name}: expected at most {budget} instructions an item, found {found:.2}"));
        }
    }
    assert!(over.is_empty(), "{}", over.join("\n"));
}
