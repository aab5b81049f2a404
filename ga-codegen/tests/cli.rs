//! The command line: what it prints, what it refuses, and with which exit status.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ga-codegen")).args(arguments).output().expect("the command line runs")
}

/// What a run that succeeds prints.
#[track_caller]
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {errors}");
    assert!(errors.is_empty(), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// What a run that fails says. It prints nothing else.
#[track_caller]
fn refused(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(!output.status.success(), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stdout));
    String::from_utf8(output.stderr).expect("text")
}

/// A file of that name for this test alone.
fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).expect("a writable directory for tests");
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path that is text")
}

// report

/// The kernels that the record table names and that are in the preset so far.
const RECORDS: [&str; 47] = [
    "motor_mul_motor",
    "rotor_mul_rotor",
    "rotor_mul_translator",
    "motor_mul_rotor",
    "rotor_mul_motor",
    "motor_mul_translator",
    "translator_mul_motor",
    "motor_transform_point",
    "motor_transform_projective_point",
    "motor_transform_direction",
    "motor_transform_origin",
    "motor_transform_plane",
    "motor_transform_line",
    "motor_transform_motor",
    "rotor_transform_point",
    "rotor_transform_plane",
    "rotor_transform_line",
    "translator_transform_point",
    "translator_transform_line",
    "translator_transform_plane",
    "plane_reflect_plane",
    "plane_reflect_point",
    "plane_reflect_line",
    "line_exp",
    "motor_log",
    "plane_meet_plane",
    "plane_meet_line",
    "plane_meet_point",
    "line_meet_line",
    "point_join_point",
    "point_join_line",
    "point_join_plane",
    "line_join_line",
    "projective_point_join_projective_point",
    "plane_inner_plane",
    "plane_inner_line",
    "plane_inner_point",
    "line_inner_line",
    "line_inner_point",
    "line_commutator_line",
    "plane_mul_plane",
    "line_mul_line",
    "plane_mul_line",
    "plane_mul_point",
    "point_mul_point",
    "plane_meet_plane_meet_plane",
    "point_join_point_join_point",
];

fn kernels(json: &str) -> Vec<Value> {
    match serde_json::from_str(json).expect("JSON") {
        Value::Array(kernels) => kernels,
        other => panic!("expected an array, found {other}"),
    }
}

#[test]
fn the_json_report_has_every_kernel_with_the_pinned_keys() {
    let kernels = kernels(&printed(&["report", "pga3d", "--json"]));
    let mut names = BTreeSet::new();
    for kernel in &kernels {
        let name = kernel["kernel"].as_str().expect("a name");
        assert!(names.insert((name.to_owned(), kernel["cost_model"].as_str().map(str::to_owned))), "{name} twice");
        assert!(kernel["definition"].as_str().is_some_and(|definition| !definition.is_empty()), "{name}");
        assert!(kernel["output"].is_string(), "{name}");
        assert!(kernel["cost_model"].is_string(), "{name}");
        assert_eq!(kernel["proved"], Value::Bool(true), "{name}");
        for input in kernel["inputs"].as_array().expect("inputs") {
            assert!(input["name"].is_string() && input["type"].is_string(), "{name}: {input}");
        }
        for key in ["mul", "add", "div", "sqrt", "fma", "depth"] {
            assert!(kernel["emitted"][key].is_u64(), "{name}: {key}");
        }
        // What is no polynomial has no expansion to count.
        let expanded = &kernel["expanded"];
        let counted = expanded["mul"].is_u64() && expanded["add"].is_u64();
        let is_analytic = ["exp", "log", "sqrt", "normalize"].iter().any(|function| {
            kernel["definition"].as_str().is_some_and(|definition| definition.starts_with(&format!("{function}(")))
        });
        assert_eq!(counted, !is_analytic, "{name}: {expanded}");
    }
    for record in RECORDS {
        assert!(names.iter().any(|(name, _)| name == record), "{record} is not in the report");
    }
}

#[test]
fn a_product_of_motors_costs_48_multiplications_and_40_additions() {
    let kernels = kernels(&printed(&["report", "pga3d", "--json"]));
    let product = kernels.iter().find(|kernel| kernel["kernel"] == "motor_mul_motor").expect("the product of motors");
    assert_eq!(product["definition"], "a * b");
    assert_eq!((&product["inputs"][1]["name"], &product["inputs"][1]["type"]), (&"b".into(), &"Motor".into()));
    assert_eq!(product["output"], "Motor");
    assert_eq!((&product["expanded"]["mul"], &product["expanded"]["add"]), (&48.into(), &40.into()));
    assert_eq!((&product["emitted"]["mul"], &product["emitted"]["add"]), (&48.into(), &40.into()));
}

#[test]
fn a_polynomial_kernel_has_neither_division_nor_root() {
    for preset in ["pga3d", "pga2d"] {
        for kernel in kernels(&printed(&["report", preset, "--json"])) {
            if kernel["expanded"].is_object() {
                let emitted = &kernel["emitted"];
                assert_eq!((&emitted["div"], &emitted["sqrt"]), (&0.into(), &0.into()), "{}", kernel["kernel"]);
            }
        }
    }
}

#[test]
fn the_command_alone_is_the_report_of_pga3d() {
    let without_time = |text: String| text.rsplit_once(" proved, in ").expect("the time at the end").0.to_owned();
    let alone = without_time(printed(&[]));
    assert_eq!(alone, without_time(printed(&["report", "pga3d"])));
    assert!(alone.starts_with("pga3d: Cl(3,0,1), "), "{alone}");
    assert!(alone.contains("(m: Motor, p: Point) -> Point = m >> p"), "{alone}");
}

// Broken definitions.

#[test]
fn a_broken_file_is_an_error_with_line_and_column() {
    let broken =
        file("broken.ga", "signature (2, 0, 1);\nentity Line { e1, e2, e3 }\nkernel flip(a: Lime) -> Line = -a;\n");
    for command in ["report", "emit"] {
        let message = refused(&[command, text(&broken)]);
        let expected = format!(
            "error: expected a blade of the basis (1 e0 e1 e2 e01 e02 e12 e012), found `e3`\n  --> {path}:2:23\n\
             error: expected an entity (Scalar, Line), found `Lime`\n  --> {path}:3:16\n",
            path = broken.display()
        );
        assert_eq!(message, expected);
    }
}

#[test]
fn a_kernel_that_its_output_cannot_hold_is_an_error_with_line_and_column() {
    let path = file("cannot_hold.ga", "signature (1, 0, 0);\nentity X { e1 }\nkernel f(a: X) -> X = a * a;\n");
    let message = refused(&["report", text(&path)]);
    assert!(message.contains("kernel `f`: expected an output that can hold `1`"), "{message}");
    assert!(message.ends_with(&format!("--> {}:3:19\n", path.display())), "{message}");
}

#[test]
fn a_file_that_is_not_made_of_tokens_is_an_error_with_line_and_column() {
    let path = file("brackets.ga", "signature (1, 0, 0);\nentity X { e1\n");
    let message = refused(&["report", text(&path)]);
    assert!(message.contains(&format!("--> {}:", path.display())), "{message}");
}

#[test]
fn an_unknown_source_is_refused_by_every_command() {
    for command in ["report", "emit", "table"] {
        let message = refused(&[command, "pga4d"]);
        assert!(message.contains("expected a preset (pga3d, pga2d)"), "{message}");
        assert!(message.contains("found `pga4d`"), "{message}");
    }
}

// emit

#[test]
fn emit_writes_one_kernel() {
    let emitted = printed(&["emit", "pga3d", "--kernel", "point_sub_point"]);
    assert!(
        emitted.contains("pub fn point_sub_point<T: Scalar>(a: Point<T>, b: Point<T>) -> Direction<T> {"),
        "{emitted}"
    );
    assert_eq!(emitted.matches("fn ").count(), 1, "{emitted}");
}

#[test]
fn emit_refuses_an_unknown_kernel() {
    assert_eq!(refused(&["emit", "pga2d", "--kernel", "fly"]), "error: expected a kernel of pga2d, found `fly`\n");
}

#[test]
fn emit_writes_a_file_that_names_its_definition_and_command() {
    let definition = file(
        "complex.ga",
        "signature (0, 1, 0);\nentity Complex { re: 1, im: e1 }\n\
        kernel product(a: Complex, b: Complex) -> Complex = a * b;\n",
    );
    let output = Path::new(env!("CARGO_TARGET_TMPDIR")).join("complex.rs");
    let said = printed(&["emit", text(&definition), "-o", text(&output)]);
    assert_eq!(said, format!("{}: 1 kernels of {}, all proved\n", output.display(), definition.display()));
    let written = std::fs::read_to_string(&output).expect("the written file");
    assert_eq!(written, printed(&["emit", text(&definition)]));
    assert!(written.starts_with("// Generated by ga-codegen from the definition of "), "{written}");
    assert!(written.contains("pub fn product<T: Scalar>"), "{written}");
}

#[test]
fn emit_says_which_file_it_cannot_write() {
    let nowhere = Path::new(env!("CARGO_TARGET_TMPDIR")).join("missing").join("out.rs");
    let message = refused(&["emit", "pga2d", "-o", text(&nowhere)]);
    assert!(message.starts_with(&format!("error: {}: ", nowhere.display())), "{message}");
}

// table

/// The cells of a row of a text table.
fn cells(table: &str, row: usize) -> Vec<&str> {
    table.lines().nth(row).expect("a row").split_whitespace().collect()
}

#[test]
fn a_table_of_a_signature_is_in_ascending_words() {
    let table = printed(&["table", "3,0,1", "--product", "geometric"]);
    let names = "1 e0 e1 e2 e3 e01 e02 e03 e12 e13 e23 e012 e013 e023 e123 e0123";
    assert_eq!(table.lines().count(), 17);
    assert_eq!(cells(&table, 0), names.split(' ').collect::<Vec<_>>());
    // Worked out on paper: e0 and e13 times every blade.
    assert_eq!(
        cells(&table, 2),
        "e0 e0 0 e01 e02 e03 0 0 0 e012 e013 e023 0 0 0 e0123 0".split(' ').collect::<Vec<_>>()
    );
    let expected = "e13 e13 e013 -e3 -e123 e1 -e03 -e0123 e01 e23 -1 -e12 e023 -e0 -e012 e2 e02";
    assert_eq!(cells(&table, 10), expected.split(' ').collect::<Vec<_>>());
    let aligned: BTreeSet<_> = table.lines().map(str::len).collect();
    assert_eq!(aligned.len(), 1, "all lines are of the same width");
}

#[test]
fn a_table_of_a_preset_is_in_its_own_words() {
    let table = printed(&["table", "pga3d"]);
    assert_eq!(cells(&table, 0)[9], "e31");
    // e31 e12 = -e23 and e12 e31 = e23.
    assert_eq!(cells(&table, 10)[9], "-e23");
    assert_eq!(cells(&table, 9)[10], "e23");
    assert_eq!(cells(&table, 10)[10], "-1");
}

#[test]
fn tables_come_as_markdown_and_csv() {
    let markdown = printed(&["table", "2,0,0", "--format", "markdown"]);
    let expected = "\
|  | 1 | e1 | e2 | e12 |
|---|---|---|---|---|
| 1 | 1 | e1 | e2 | e12 |
| e1 | e1 | 1 | e12 | e2 |
| e2 | e2 | -e12 | 1 | -e1 |
| e12 | e12 | -e2 | e1 | -1 |
";
    assert_eq!(markdown, expected);
    let csv = printed(&["table", "1,0,1", "--product", "outer", "--format", "csv"]);
    assert_eq!(csv, ",1,e0,e1,e01\n1,1,e0,e1,e01\ne0,e0,0,e01,0\ne1,e1,-e01,0,0\ne01,e01,0,0,0\n");
}

#[test]
fn every_product_has_a_table() {
    let all = [
        "geometric",
        "outer",
        "regressive",
        "inner",
        "left-contraction",
        "right-contraction",
        "scalar",
        "commutator",
        "anticommutator",
    ];
    // The product of e12 and e2 in the plane is e1, of grade 2 - 1, and e12 is the identity of the join.
    let expected = ["e1", "0", "e2", "e1", "0", "e1", "0", "e1", "0"];
    for (product, expected) in all.into_iter().zip(expected) {
        let table = printed(&["table", "2,0,0", "--product", product]);
        assert_eq!(cells(&table, 4)[3], expected, "{product}");
    }
}

#[test]
fn an_unknown_product_format_or_signature_is_refused() {
    let product = refused(&["table", "3,0,1", "--product", "cross"]);
    assert!(product.contains("expected one of geometric, outer, regressive, inner, left-contraction"), "{product}");
    assert!(refused(&["table", "3,0,1", "--format", "pdf"]).contains("'pdf'"));
    assert!(refused(&["table", "3,0"]).contains("a signature p,q,r, found `3,0`"));
    assert!(refused(&["table", "9,0,0"]).contains("expected at most 8 generators, found Cl(9,0,0)"));
    refused(&["dance"]);
}

// search

const SANDWICH: &str = "
signature (3, 0, 0);
entity Vector { x: e1, y: e2, z: e3 }
entity Rotor { s: 1, e23, e31: e13, e12 } where s*s == 1 - e23*e23 - e31*e31 - e12*e12;
kernel turn(uniform r: Rotor, v: Vector) -> Vector = r >> v cost flops, fma hoist Matrix, prepare, apply;
";

#[test]
fn a_search_leaves_recipes_that_expansion_replays() {
    let (block, recipes) = (file("turn.ga", SANDWICH), file("turn.recipes.ga", ""));
    let search = |restarts: &str| printed(&["search", text(&block), "--restarts", restarts, "-o", text(&recipes)]);
    let _ = std::fs::remove_file(recipes.with_extension("search.json"));
    let log = search("40");
    assert!(log.starts_with("turn flops: 18+12 (18 FMA, "), "{log}");
    assert!(log.contains("40 restarts, found at "), "{log}");
    let found = std::fs::read_to_string(&recipes).expect("the recipes");
    assert!(found.starts_with("recipe turn flops {\n") && found.contains("recipe prepare flops {\n"), "{found}");

    // What was done is not done again; the same search ends alike.
    assert_eq!(search("40"), log);
    assert_eq!(std::fs::read_to_string(&recipes).expect("the recipes"), found);
    std::fs::remove_file(recipes.with_extension("search.json")).expect("the state of the search");
    assert_eq!(search("40"), log);
    assert_eq!(std::fs::read_to_string(&recipes).expect("the recipes"), found);

    // A search for some kernels leaves the recipes of the others.
    let (two, more) =
        (file("two.ga", &format!("{SANDWICH}kernel back(r: Rotor, v: Vector) -> Vector = ~r >> v;\n")), found.clone());
    printed(&["search", text(&two), "--kernel", "back", "--restarts", "10", "-o", text(&recipes)]);
    let both = std::fs::read_to_string(&recipes).expect("the recipes");
    assert!(both.starts_with(&more) && both.contains("recipe back flops {\n"), "{both}");

    // The block with the recipes is replayed and proved.
    let both = file("turned.ga", &format!("{SANDWICH}{found}"));
    let report = printed(&["report", text(&both)]);
    assert!(report.contains("All 4 programs proved"), "{report}");
    assert!(report.contains("18+12"), "{report}");
}

#[test]
fn a_search_for_what_is_not_there_says_so() {
    let block = file("searched.ga", SANDWICH);
    let message = refused(&["search", text(&block), "--kernel", "twist"]);
    assert_eq!(message, format!("error: expected a kernel of {}, found `twist`\n", block.display()));
}

#[test]
fn the_report_is_plain_where_there_is_no_terminal_and_a_table_in_markdown() {
    assert!(!printed(&["report", "pga2d"]).contains('\u{1b}'));
    let table = printed(&["report", "pga2d", "--markdown"]);
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("| kernel | definition | model | expanded | emitted | FMA | depth | error / u | proof |")
    );
    assert_eq!(lines.next(), Some("|---|---|---|---|---|---|---|---|---|"));
    // A bar in a definition does not end a cell.
    assert!(table.contains("(a: Line, b: Line) -> Scalar = a \\| b"), "{table}");
}

#[test]
fn a_search_replaces_nothing_but_recipes() {
    let block = file("kept.ga", SANDWICH);
    let message = refused(&["search", text(&block), "--restarts", "5", "-o", text(&block)]);
    let path = block.display();
    assert_eq!(message, format!("error: {path}: expected a file of recipes to replace, found `signature`\n"));
    assert_eq!(std::fs::read_to_string(&block).expect("the block"), SANDWICH);
}

#[test]
fn another_definition_does_not_inherit_restarts() {
    let recipes = file("inherited.recipes.ga", "");
    let _ = std::fs::remove_file(recipes.with_extension("search.json"));
    let even = "
signature (3, 0, 0);
entity Even { s: 1, e23, e31: e13, e12 }
kernel turn(a: Even, b: Even) -> Scalar = scalar_product(a * b, ~(a * b));
";
    let unit = even.replace("e12 }", "e12 } where s*s == 1 - e23*e23 - e31*e31 - e12*e12;");
    let (even, unit) = (file("even.ga", even), file("unit.ga", &unit));
    let log = |block: &Path| printed(&["search", text(block), "--restarts", "60", "-o", text(&recipes)]);
    let first = log(&even);
    let second = log(&unit);
    let anew = printed(&["search", text(&unit), "--fresh", "--restarts", "60", "-o", text(&recipes)]);
    assert_ne!(first, second);
    assert_eq!(second, anew);
}

#[test]
fn parts_and_variants_go_by_their_names() {
    for name in ["motor_to_matrix", "matrix_apply_point", "rotor_transform_line_fma"] {
        let emitted = printed(&["emit", "pga3d", "--kernel", name]);
        assert!(emitted.contains(&format!("pub fn {name}<T: Scalar>(")), "{emitted}");
    }
}

// fit

#[test]
fn fit_computes_the_polynomials_that_are_there() {
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/approximation/tables.rs");
    let output = file("tables.rs", "");
    let said = printed(&["fit", "-o", text(&output)]);
    let written = std::fs::read_to_string(&output).expect("the written file");
    let there = std::fs::read_to_string(&tables).expect("the polynomials");
    let renew = "renew them: cargo run --release -- fit -o ga-codegen/src/approximation/tables.rs";
    assert!(written == there, "the polynomials of {} are not those that fit computes; {renew}", tables.display());

    // Function, precision, degree, interval, and the errors of the minimax, of what is rounded, and of its values by Horner's rule.
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), 12, "{said}");
    assert!(lines[0].starts_with("function ") && lines[0].ends_with(" minimax / u  rounded / u  Horner / u"), "{said}");
    assert!(lines[1].starts_with("cos_root     f32       5  [0, 2.5] "), "{said}");
    assert!(lines[10].starts_with("angle_slope  f64      22  [-0.0009765625, 1] "), "{said}");
    assert_eq!(lines[11], format!("{}: 10 polynomials", output.display()));
    for line in &lines[1..11] {
        let errors: Vec<f64> = line.split_whitespace().rev().take(3).map(|error| error.parse().expect(line)).collect();
        assert!(errors[2] <= errors[1] && errors[1] < errors[0] && errors[0] < 2.5, "{line}");
    }
}
