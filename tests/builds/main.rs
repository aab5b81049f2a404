//! What a crate that uses `pga-motor` is compiled to.

#![cfg(target_arch = "x86_64")]

mod assembly;
mod counts;
mod project;

use std::sync::OnceLock;

use project::Project;

/// The probe, whose release build all tests share.
fn probe() -> &'static Project {
    static PROBE: OnceLock<Project> = OnceLock::new();
    PROBE.get_or_init(|| Project::new("release"))
}
