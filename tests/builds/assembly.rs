//! Loops over lanes are vector code, with as many instructions as their kernels have operations.
//!
//! A loop that the compiler no longer finds vectors in, or a product that is no longer fused, is ten times as slow and gives the same
//! results: no other test would notice.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::probe;

/// The functions of an assembly file with their instructions.
struct Assembly(BTreeMap<String, Vec<String>>);

impl Assembly {
    fn of_probe() -> Self {
        let project = probe();
        project.cargo(&["rustc", "--release", "--lib", "--", "--emit=asm", "-Cdebuginfo=0"]);
        let folder = fs::read_dir(project.built("release/deps")).expect("what was built");
        let files = folder.map(|entry| entry.expect("an entry of the folder").path());
        let is_ours = |path: &std::path::PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            name.starts_with("probe-") && name.ends_with(".s")
        };
        let newest = files.filter(is_ours).max_by_key(|path| path.metadata().and_then(|data| data.modified()).ok());
        Self::parse(&fs::read_to_string(newest.expect("cargo was asked for assembly")).expect("text"))
    }

    fn parse(text: &str) -> Self {
        let mut functions: BTreeMap<String, Vec<String>> = BTreeMap::new();
        let mut name = String::new();
        for line in text.lines() {
            match line.strip_suffix(':') {
                Some(label) if !label.starts_with(['.', '\t', ' ']) => name = label.trim_matches('"').to_owned(),
                _ if line.starts_with('\t') && !line.starts_with("\t.") => {
                    functions.entry(name.clone()).or_default().push(line.trim().to_owned());
                }
                _ => {}
            }
        }
        Self(functions)
    }

    /// All instructions that a function may come to, in functions whose names have the part: itself, or what it calls.
    fn reached(&self, function: &str, part: &str) -> Vec<&str> {
        let (mut open, mut seen) = (vec![function.to_owned()], BTreeSet::new());
        let mut found = Vec::new();
        while let Some(name) = open.pop() {
            let Some(instructions) = self.0.get(&name).filter(|_| seen.insert(name.clone())) else { continue };
            if name.contains(part) {
                found.extend(instructions.iter().map(String::as_str));
            }
            let targets = instructions.iter().filter(|i| i.starts_with("call") || i.starts_with("jmp"));
            open.extend(targets.filter_map(|i| i.split_whitespace().nth(1)).map(|target| {
                target.trim_start_matches('*').trim_matches('"').split('@').next().unwrap_or_default().to_owned()
            }));
        }
        assert!(!found.is_empty(), "{function} reaches nothing that is called {part}");
        found
    }
}

/// Sums, products and both, on whole registers of this kind.
fn packed_arithmetic(instructions: &[&str], register: &str) -> usize {
    let is_arithmetic = |name: &str| {
        let name = name.strip_prefix('v').unwrap_or(name);
        name.ends_with("ps")
            && ["add", "sub", "mul", "fmadd", "fmsub", "fnmadd", "fnmsub"].iter().any(|a| name.starts_with(a))
    };
    let name = |instruction: &str| instruction.split_whitespace().next().unwrap_or_default().to_owned();
    instructions.iter().filter(|i| i.contains(register) && is_arithmetic(&name(i))).count()
}

/// Each loop, and how many sums, products and fused ones it has on whole registers, once for every item of a register: as many as
/// budgets.md says that its kernel has, and what is around it. Interpolation has `nlerp`, `slerp`, `screw_lerp` and
/// `split_lerp` in it, as sampling has; `exp` the compiler writes out twice.
const LOOPS: [(&str, usize); 11] = [
    ("compose", 48),
    ("points", 9),
    ("point_pairs", 21),
    ("exp", 71),
    ("log", 40),
    ("renormalize", 21),
    ("nlerp", 382),
    ("slerp", 382),
    ("screw_lerp", 382),
    ("crowd_kinematics", 48),
    ("crowd_sampling", 356),
];

#[test]
fn loops_over_lanes_are_vector_code() {
    let assembly = Assembly::of_probe();
    let mut wrong = Vec::new();
    for (function, expected) in LOOPS {
        for (part, register) in [("run_avx512", "%zmm"), ("run_avx2", "%ymm")] {
            let instructions = assembly.reached(function, part);
            let packed = packed_arithmetic(&instructions, register);
            println!("{function}, {part}: {packed} on {register}, {} in all", instructions.len());
            let calls = instructions.iter().filter(|i| i.starts_with("call") && i.contains("fma")).count();
            assert_eq!(calls, 0, "{function}, {part}: products are fused by calls of the C library");
            // Another compiler may be a little better or worse.
            let range = expected * 19 / 20..=expected * 21 / 20;
            if !range.contains(&packed) {
                wrong.push(format!("{function}, {part}: expected {expected} on {register}, found {packed}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// In a default build, which has SSE2: 12 products of four numbers each, and the 14 shuffles of the recipe.
#[test]
fn single_products_are_packed() {
    let assembly = Assembly::of_probe();
    for function in ["products", "kinematics"] {
        let instructions = assembly.reached(function, function);
        let count = |name: &str| instructions.iter().filter(|i| i.starts_with(name)).count();
        let shuffles = ["shufps", "unpck", "movlhps", "movhlps", "pshufd"].map(count).iter().sum::<usize>();
        println!("{function}: {} products, {shuffles} shuffles, {} in all", count("mulps"), instructions.len());
        assert_eq!(count("mulss"), 0, "{function}: products of single numbers");
        assert_eq!(count("mulps"), 12, "{function}");
        assert!((10..=18).contains(&shuffles), "{function}: expected about 14 shuffles, found {shuffles}");
    }
}
