//! Programs on values of four lanes: their recipes are read, replayed, refused where they do not fit, and found by a search.

use ga_codegen::factor::{pack, replay_packed, write_packed_recipe};
use ga_codegen::kernel::Definition;
use ga_codegen::program::{Count, PackedProgram, PackedRecipe};
use ga_codegen::proof::prove;
use ga_codegen::{compile, define, tasks};

const ROTORS: &str = "
signature (3, 0, 0);
basis 1 e1 e2 e3 e23 e31 e12 e123;
entity Rotor { s: 1, e23, e31, e12 }
entity Vector { x: e1, y: e2, z: e3 }
kernel turn(a: Rotor, b: Rotor) -> Rotor = a * b packed;
";

const TURN: &str = "recipe turn packed {
    p = [a.s, a.e23, a.e31, a.e12];
    q = [b.s, b.e23, b.e31, b.e12];
    t = p[1, 1, 2, 3] * q[1, 0, 0, 0] + p[2, 3, 1, 2] * q[2, 2, 3, 1];
    out[s, e23, e31, e12] = p[0, 0, 0, 0] * q + t[-0, 1, 2, 3] - p[3, 2, 3, 1] * q[3, 3, 1, 2];
}";

/// The errors of the rotors' block with this behind it, as `line:column: message`.
fn errors(behind: &str) -> Vec<String> {
    let block = format!("{ROTORS}{behind}");
    let found = ga_codegen::expand(block.trim_start().parse().expect("tokens")).err().into_iter().flatten();
    let described = found.map(|error| {
        let start = error.span().start();
        format!("{}:{}: {error}", start.line, start.column + 1)
    });
    described.collect()
}

fn definition(behind: &str) -> Definition {
    define(format!("{ROTORS}{behind}").parse().expect("tokens")).expect("a definition")
}

#[track_caller]
fn assert_error(behind: &str, expected: &str) {
    assert_eq!(errors(behind), [expected], "{behind}");
}

/// The recipe with a part of it exchanged, which must be there.
#[track_caller]
fn turn_with(part: &str, other: &str) -> String {
    assert!(TURN.contains(part), "{part}");
    TURN.replace(part, other)
}

#[test]
fn a_packed_kernel_is_emitted_beside_the_scalar_one() {
    let definition = definition(TURN);
    let compiled = compile(&definition).expect("a recipe that is proved");
    let [whole, packed] = compiled.as_slice() else { panic!("two programs") };
    assert_eq!((whole.name.as_str(), packed.name.as_str()), ("turn", "turn_packed"));
    assert!(whole.packed.is_none());
    assert_eq!(Count::of(&packed.program).flops(), Count::of(&whole.program).flops());
    let count = packed.packed.as_ref().expect("a packed program").count();
    assert_eq!(
        count.to_string(),
        "4 mul + 3 add + 7 shuffle + 1 negate on four lanes, after 2 loads",
        "as written in the recipe"
    );
    let emitted = ga_codegen::emit::rust(&definition, &compiled).expect("Rust").to_string();
    for part in ["pub trait Four", "fn turn_packed", "T :: Four :: IS_FAST", "0b11_10_01_01", "0b0001"] {
        assert!(emitted.contains(part), "{part} in {emitted}");
    }
}

#[test]
fn what_is_not_packed_knows_nothing_of_lanes() {
    let block = ROTORS.replace(" packed", "");
    let emitted = ga_codegen::expand(block.parse().expect("tokens")).expect("Rust").to_string();
    assert!(!emitted.contains("Four"), "{emitted}");
}

#[test]
fn a_packed_kernel_without_a_recipe_says_how_to_search_one() {
    assert_error(
        "",
        "5:50: expected a recipe `recipe turn packed { ... }` for a `packed` kernel, found none: `ga-codegen search \
         DEFINITION --kernel turn` finds one for a product",
    );
}

#[test]
fn packed_stands_behind_polynomials_of_types_with_fields() {
    let expected = "expected `packed` at a polynomial definition of a type with fields, found another kernel";
    let dot = "kernel dot(a: Vector, b: Vector) -> Scalar = a | b packed;\n";
    assert_error(&format!("{dot}{TURN}"), &format!("6:52: {expected}"));
    let exp = "entity Bivector { e23, e31, e12 }\nkernel exp(b: Bivector) -> Rotor = exp(b) packed;\n";
    assert_error(&format!("{exp}{TURN}"), &format!("7:43: {expected}"));
    assert_error(
        &format!("kernel back(a: Rotor, b: Rotor) -> Rotor = b * a packed cost fma;\n{TURN}"),
        "6:57: expected an operator, `where`, `cost`, `packed`, `polynomial`, `hoist` or `;`, found `cost`",
    );
    assert_error(
        &format!("kernel turn_packed(a: Rotor) -> Rotor = -a;\n{TURN}"),
        "5:8: expected names that are not taken, found `turn_packed`, which is",
    );
}

#[test]
fn recipes_that_do_not_fit_say_why() {
    let unfit = |reason: &str| {
        format!(
            "6:8: expected a recipe that fits `turn`, found that {reason}: remove it and renew it with `ga-codegen search \
             DEFINITION --kernel turn`"
        )
    };
    assert_eq!(errors(TURN), [""; 0]);
    let other_sign = turn_with("t[-0, 1, 2, 3]", "t[-0, 1, 2, -3]");
    let difference = "coefficient `e12`: program minus definition is -2 a.e31 b.e23 - 2 a.e12 b.s";
    assert_error(&other_sign, &unfit(difference));
    assert_error(&turn_with("p = [a.s", "p = [a.t"), &unfit("it loads `a.t`, which is no input"));
    assert_error(&turn_with("* q +", "* r +"), &unfit("it uses `r`, which is not known there"));
    assert_error(&turn_with("    q =", "    p ="), &unfit("it names `p` twice"));
    assert_error(&turn_with("out[s, e23", "out[_, e23"), &unfit("it has no lane for `s`"));
    assert_error(&turn_with("out[s, e23", "out[s, s"), &unfit("it has two lanes for `s`"));
    assert_error(&turn_with("out[s, e23", "out[w, e23"), &unfit("it has a lane for `w`, which is no output"));
}

#[test]
fn recipes_belong_to_one_packed_kernel() {
    assert_error(&format!("{TURN}\n{TURN}"), "12:8: expected one packed recipe for `turn`, found a second");
    assert_error(
        &format!("{TURN}\nrecipe twist packed {{ }}"),
        "12:8: expected a recipe for a `packed` kernel, found none named `twist`",
    );
}

#[test]
fn what_is_no_packed_recipe_is_found_where_it_stands() {
    for (part, other, expected) in [
        ("p = [a.s,", "p = [", "7:9: expected a list of four coefficients, found 3"),
        ("q[1, 0, 0, 0]", "q[1, 0, 0]", "9:26: expected a list of four lanes, found 3"),
        ("q[1, 0, 0, 0]", "q[1, 0, 0, 4]", "9:36: expected a lane from 0 to 3, found 4"),
        ("q[1, 0, 0, 0]", "q[1, 0, 0, x]", "9:36: expected a whole number, found `x`"),
        ("[a.s, a.e23", "[a.s, +", "7:15: expected a coefficient or a number, found `+`"),
        ("[a.s, a.e23", "[a.s, 1/0", "7:15: expected a denominator other than 0"),
        ("    q =", "    q[s, e23, e31, e12] =", "8:5: expected `out` before a list of fields, found `q`"),
        ("t = p", "t = 3 * p", "9:9: expected 2 or a value of four lanes, found 3"),
        ("t = p", "t = / p", "9:9: expected a row, four coefficients or `(`, found `/`"),
        ("t = p[1, 1, 2, 3]", "t = (p p)", "9:12: expected an operator or `)`, found `p`"),
        ("out[s, e23", "out[s, 1", "10:12: expected a field or `_`, found `1`"),
        ("out[s, e23, e31, e12]", "out[s]", "10:8: expected a list of four fields, found 1"),
    ] {
        assert_error(&turn_with(part, other), expected);
    }
    let deep = turn_with("t = p", &format!("t = {}p", "p * ".repeat(400)));
    let found = errors(&deep);
    assert!(found[0].ends_with("expected an expression nested at most 300 deep, found a deeper one"), "{found:?}");
}

#[test]
fn numbers_doubles_and_groups_are_read_as_written() {
    let behind = "
kernel shear(m: Rotor, v: Vector) -> Vector = v * 3 + v / 2 packed;
recipe shear packed {
    w = [v.x, v.y, v.z, 0];
    out[_, z, _, x] = (2 * w + (w + w * [1/2, 1/2, 1/2, -1]))[1, 2, 1, 0];
    out[_, y, _, _] = (2 * w + (w + w * [1/2, 1/2, 1/2, -1]));
}
"
    .to_owned()
        + TURN;
    assert_eq!(errors(&behind), [""; 0]);
}

/// The product's task in a definition, and a program for it.
fn replayed(definition: &Definition, recipe: &PackedRecipe) -> PackedProgram {
    let kernel = definition.kernel("turn").expect("the kernel");
    let tasks = tasks(definition, kernel).expect("a kernel with a meaning");
    let task = tasks.iter().find(|task| task.packed).expect("a packed program to find");
    replay_packed(&task.specification, recipe).expect("a recipe that fits")
}

#[test]
fn what_is_written_of_doubles_is_read_back() {
    // 2 p times q, from halves: what a doubling is multiplied by stands behind it.
    let halves = turn_with("+ t[-0, 1, 2, 3]", "+ 2 * t[-0, 1, 2, 3] * [1, 1, 1, 1] - t[-0, 1, 2, 3]");
    let definition = definition(&halves);
    let specification = tasks(&definition, &definition.kernels[0]).expect("a meaning").remove(0).specification;
    let found = replayed(&definition, &definition.packed_recipes[0]);
    let text = write_packed_recipe(&specification, &found, "turn");
    let read = self::definition(&text);
    assert_eq!(write_packed_recipe(&specification, &replayed(&read, &read.packed_recipes[0]), "turn"), text);
}

#[test]
fn a_search_packs_products_and_what_it_writes_is_read_back() {
    let unsearched = definition("");
    let kernel = unsearched.kernel("turn").expect("the kernel");
    let specification = tasks(&unsearched, kernel).expect("a kernel with a meaning").remove(0).specification;
    let found = pack(&specification).expect("a product of rotors");
    assert!(prove(&specification, &found.unpack()).is_ok());
    assert_eq!(found, pack(&specification).expect("the same again"));
    let count = found.count();
    assert_eq!((count.load, count.mul, count.add, count.shuffle, count.negate), (2, 4, 3, 7, 2));
    let text = write_packed_recipe(&specification, &found, "turn");
    let definition = definition(&text);
    let read = replayed(&definition, &definition.packed_recipes[0]);
    assert!(prove(&specification, &read.unpack()).is_ok());
    assert_eq!(read.count(), found.count());
    assert_eq!(write_packed_recipe(&specification, &read, "turn"), text);
}

#[test]
fn a_search_packs_nothing_but_products_in_groups_of_four() {
    for (name, kernel) in [
        ("move", "kernel move(m: Rotor, v: Vector) -> Vector = m >> v;"),
        ("wedge", "kernel wedge(a: Vector, b: Vector) -> Rotor = a * b;"),
        ("back", "kernel back(a: Rotor) -> Rotor = ~a;"),
    ] {
        let definition = definition(&format!("{kernel}\n{TURN}"));
        let kernel = definition.kernel(name).expect("the kernel");
        let specification = tasks(&definition, kernel).expect("a kernel with a meaning").remove(0).specification;
        assert_eq!(pack(&specification), None, "{name}");
    }
}
