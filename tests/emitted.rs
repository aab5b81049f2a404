//! The emitted Rust, as the command line writes it: committed under `golden/`, up to date, the same on every run, fit for
//! rustc alone, and right: the differential tests of `pga-motor` run on it too.

use std::path::{Path, PathBuf};
use std::process::Command;

#[macro_use]
#[path = "differential/dispatch.rs"]
mod dispatch;
#[macro_use]
#[path = "differential/exact.rs"]
mod exact;
#[path = "differential/interpreter.rs"]
mod interpreter;
#[path = "differential/samples.rs"]
mod samples;
#[macro_use]
#[path = "differential/suite.rs"]
mod suite;
#[macro_use]
#[path = "differential/tracked.rs"]
mod tracked;

/// The committed files as modules.
#[allow(dead_code, unreachable_pub, clippy::all)]
mod golden {
    // The compiler shows the remark with any error of these lines.
    #[path = "pga2d.rs"]
    #[rustfmt::skip]
    pub(crate) mod pga2d; // to make it: cargo run -p ga-codegen -- emit pga2d -o tests/golden/pga2d.rs
    #[path = "pga3d.rs"]
    #[rustfmt::skip]
    pub(crate) mod pga3d; // to make it: cargo run -p ga-codegen -- emit pga3d -o tests/golden/pga3d.rs
}

exact_scalar!(golden::pga3d::scalar { type Four = golden::pga3d::scalar::Array4<Self>; } {});
tracked_scalar!(golden::pga3d::scalar { type Four = golden::pga3d::scalar::Array4<Self>; } {});
exact_scalar!(golden::pga2d::scalar {} {});
tracked_scalar!(golden::pga2d::scalar {} {});

mod pga3d {
    use crate::golden::pga3d as compiled;
    use crate::golden::pga3d::scalar;

    // An emitted file without `export` has no list of its own; being fresh, it has the kernels of the preset.
    pga_motor::pga3d_kernels!(dispatch); // is one missing? cargo run -p ga-codegen -- emit pga3d -o tests/golden/pga3d.rs
    claims!("pga3d", 200);

    /// What stands for four lanes in the emitted file itself.
    #[test]
    fn packed_kernels_are_the_kernel() {
        use crate::dispatch::take;
        use compiled::kernels::{motor_mul_motor, motor_mul_motor_packed};

        let definition = crate::suite::definition("pga3d");
        let kernel = definition.kernel("motor_mul_motor").expect("the product of motors");
        let mut random = crate::samples::Random(1);
        for _ in 0..200 {
            let row: Vec<crate::exact::Exact> = crate::samples::row(&definition, kernel, &mut random);
            let row = &mut row.as_slice();
            let (a, b) = (take(row), take(row));
            assert_eq!(motor_mul_motor_packed(a, b), motor_mul_motor(a, b));
        }
    }
}

mod pga2d {
    use crate::golden::pga2d as compiled;
    use crate::golden::pga2d::scalar;

    pga_motor::pga2d_kernels!(dispatch); // is one missing? cargo run -p ga-codegen -- emit pga2d -o tests/golden/pga2d.rs
    claims!("pga2d", 200);
}

const PRESETS: [&str; 2] = ["pga3d", "pga2d"];

fn golden_file(preset: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(preset).with_extension("rs")
}

/// What `ga-codegen emit` writes to standard output.
fn emit(preset: &str) -> Vec<u8> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| env!("CARGO").into());
    let output = Command::new(cargo)
        .args(["run", "--quiet", "--offline", "--package", "ga-codegen", "--", "emit", preset])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

#[test]
fn golden_files_are_what_the_command_line_emits_every_time() {
    for preset in PRESETS {
        let renewal = format!("cargo run -p ga-codegen -- emit {preset} -o tests/golden/{preset}.rs");
        let golden = std::fs::read(golden_file(preset))
            .unwrap_or_else(|error| panic!("tests/golden/{preset}.rs: {error}; make it with `{renewal}`"));
        let emitted = emit(preset);
        assert!(golden == emitted, "tests/golden/{preset}.rs is not what is emitted now; renew it with `{renewal}`");
        assert!(emitted == emit(preset), "{preset}: two runs emit different files");
    }
}

#[test]
fn golden_files_compile_with_rustc_alone() {
    for preset in PRESETS {
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let output = Command::new(rustc)
            .args([
                "--edition",
                "2024",
                "--crate-type",
                "lib",
                "-D",
                "warnings",
                "--out-dir",
                env!("CARGO_TARGET_TMPDIR"),
            ])
            .arg(golden_file(preset))
            .output()
            .expect("rustc");
        assert!(output.status.success(), "{preset}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
