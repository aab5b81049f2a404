//! exp, log, roots, normalisation and interpolation are as accurate as floats allow, at every angle; and the reference
//! that says so keeps the laws of the algebra.

#[path = "../../examples/accuracy/big.rs"]
mod big;
#[path = "../../examples/accuracy/float.rs"]
mod float;
#[path = "../../examples/accuracy/functions.rs"]
mod functions;
#[path = "../../examples/accuracy/measure.rs"]
mod measure;
#[path = "../../examples/accuracy/plane.rs"]
mod plane;
#[path = "../../examples/accuracy/report.rs"]
mod report;
#[path = "../../examples/accuracy/samples.rs"]
mod samples;
#[path = "../../examples/accuracy/space.rs"]
mod space;
#[path = "../../examples/accuracy/textbook.rs"]
mod textbook;

mod laws;

use float::Float;
use functions::Function;

/// Units of the attainable error. One comes of rounding the inputs and the result; careful code adds the roundings of a
/// few intermediate results, each of them one more unit at most.
const LIMIT: f64 = 4.0;

/// Every function within its limit at every sample.
fn assert_accurate<T: Float>(functions: Vec<Function<T>>) {
    let mut failures = String::new();
    for function in &functions {
        failures += &exceeding(function);
    }
    assert!(failures.is_empty(), "{failures}");
}

/// The samples at which a function exceeds its limit, and by how much.
fn exceeding<T: Float>(function: &Function<T>) -> String {
    let errors = report::errors(function);
    let pair = report::largest(&errors);
    println!(
        "{} in {}: at most {:.2?} attainable errors, {:.2} of the rotation alone, relative {}; \
         textbook {}; {} samples",
        function.name,
        T::NAME,
        pair.ours.parts,
        pair.ours.rotation,
        pair.ours.relative.map(|error| format!("{error:.1e}")).join(" / "),
        pair.textbook.parts.map(|error| format!("{error:.1e}")).join(" / "),
        errors.len(),
    );
    let bad: Vec<_> = errors.iter().filter(|(_, pair)| exceeds(pair.ours)).collect();
    let mut text = String::new();
    if let Some((sample, pair)) = bad.first() {
        text += &format!(
            "{} in {}: expected at most {LIMIT} attainable errors, found {:.2?}, {:.2} of the rotation alone, \
             at {:?}, and {} more of {} samples\n",
            function.name,
            T::NAME,
            pair.ours.parts,
            pair.ours.rotation,
            sample.input,
            bad.len() - 1,
            errors.len(),
        );
    }
    text
}

fn exceeds(errors: measure::Errors) -> bool {
    errors.parts.into_iter().chain([errors.rotation]).any(|error| error > LIMIT)
}

#[test]
fn functions_of_space_are_accurate_in_f64() {
    assert_accurate::<f64>(functions::space());
}

#[test]
fn functions_of_space_are_accurate_in_f32() {
    assert_accurate::<f32>(functions::space());
}

#[test]
fn functions_of_the_plane_are_accurate_in_f64() {
    assert_accurate::<f64>(functions::plane());
}

#[test]
fn functions_of_the_plane_are_accurate_in_f32() {
    assert_accurate::<f32>(functions::plane());
}
