//! How long users wait: for the crate in a clean debug build, and for the expansion of a preset with all its proofs, unoptimised as
//! proc-macros are.
//!
//! In seconds of processor time, which what else the machine does hardly changes.

#![cfg(target_os = "linux")]

// A binary of its own: the time of all children counts.
#[path = "../builds/project.rs"]
mod project;

use project::Project;

/// 25 s on two cores.
const CLEAN_BUILD: f64 = 50.0;
const EXPANSION: f64 = 2.0;

/// Processor time of the children that this process has waited for.
fn children_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").expect("Linux tells");
    // The second field is a name in parentheses; those after it are counted from the third.
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |field: usize| fields[field - 3].parse::<f64>().expect("a number of ticks");
    // A tick is 10 ms on every Linux that Rust runs on.
    (ticks(16) + ticks(17)) / 100.0
}

#[test]
fn clean_builds_and_expansions_are_quick() {
    let project = Project::new("times");
    let built = project.built("");
    if built.exists() {
        std::fs::remove_dir_all(built).expect("a folder of our own");
    }
    let start = children_time();
    project.cargo(&["build", "--lib"]);
    let build = children_time() - start;
    println!("clean debug build: {build:.2} s of processor time");
    assert!(build <= CLEAN_BUILD, "expected a clean build in {CLEAN_BUILD} s of processor time, found {build}");
    project.cargo(&["build"]);
    let start = children_time();
    let output = std::process::Command::new(project.built("debug/probe")).arg("expand").output().expect("just built");
    assert!(output.status.success());
    let expansion = children_time() - start;
    println!("expansion of pga3d: {expansion:.2} s of processor time");
    assert!(expansion <= EXPANSION, "expected an expansion in {EXPANSION} s of processor time, found {expansion}");
}
