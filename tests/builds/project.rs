//! A crate outside the workspace that depends on `pga-motor`, as a user's does.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The crate `probe`, with a target folder of its own of the given name.
pub(crate) struct Project {
    root: PathBuf,
    target: PathBuf,
}

impl Project {
    /// Lays the crate out anew. What an earlier run has built in the target folder stays.
    pub(crate) fn new(name: &str) -> Self {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("builds").join(name);
        fs::create_dir_all(root.join("src")).expect("a folder to write to");
        for file in ["src/lib.rs", "src/main.rs"] {
            let text = fs::read(workspace.join("tests/builds/probe").join(file)).expect("a source of the probe");
            fs::write(root.join(file), text).expect("a folder to write to");
        }
        let path = |of: &str| workspace.join(of).display().to_string().replace('\\', "/");
        let manifest = format!(
            "[package]\nname = \"probe\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
             pga-motor = {{ path = \"{}\" }}\nga-codegen = {{ path = \"{}\", default-features = false }}\n\
             [profile.release]\ncodegen-units = 1\n",
            path("pga-motor"),
            path("ga-codegen")
        );
        fs::write(root.join("Cargo.toml"), manifest).expect("a folder to write to");
        // The versions that the workspace is tested with.
        fs::copy(workspace.join("Cargo.lock"), root.join("Cargo.lock")).expect("the workspace's lock file");
        let target = root.join("target");
        Self { root, target }
    }

    /// Runs cargo on the crate, for the machine that everyone has: without the flags in the environment of whoever runs the tests.
    pub(crate) fn cargo(&self, arguments: &[&str]) -> Output {
        let output = Command::new(env!("CARGO"))
            .args(arguments)
            .env("CARGO_TARGET_DIR", &self.target)
            .current_dir(&self.root)
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("CARGO_BUILD_RUSTFLAGS")
            .env_remove("CARGO_BUILD_TARGET")
            .env_remove("RUSTC_WRAPPER")
            .output()
            .expect("cargo runs, as it does this test");
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "cargo {}: {text}", arguments.join(" "));
        output
    }

    /// A file that was built.
    pub(crate) fn built(&self, file: &str) -> PathBuf {
        self.target.join(file)
    }
}
