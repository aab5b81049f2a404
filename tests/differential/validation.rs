//! Translation validation: what the compiler made of every emitted function is what its definition says.
//!
//! The proof of a kernel is one of its internal program. Here the compiled function itself runs on expressions, so all
//! that comes behind the proof is covered: the printing of the program, the order of fields and parameters, the
//! conversions to and from arrays, and what the compiler reads in it. What it computes is multiplied out and compared
//! with the definition, modulo what the types of the inputs promise: with the polynomials of the specification, and
//! with the naive reference run on unknowns, which shares no code with the generator. For all inputs at once and
//! without any tolerance.
//!
//! Besides, operation by operation, it must be the program that was proved, for that is what bounds of rounding errors
//! and counts of operations are about. That is all that is asked of functions that are no polynomials, and of their
//! versions by polynomials: of these the program is proved, see `ga_codegen::proof`.

use crate::dispatch::{CompiledKernel, Output, take, take_scalar};
use crate::expression::{Expansion, Traced, replay};
use crate::interpreter::interpret;
use crate::suite;
use ga_codegen::kernel::{ComponentValue, Definition};
use ga_codegen::reference::Multivector;
use ga_codegen::symbolic::{Polynomial, Relations, Symbol};
use ga_codegen::{Compiled, Part};
use std::collections::BTreeMap;

/// How many functions were found to be what they should.
#[derive(Debug, Default, PartialEq)]
struct Validated {
    /// Whole kernels equal to their definition as polynomials.
    kernels: usize,
    /// Of these and of the parts, those that are equal only by what their inputs promise.
    by_relations: usize,
    /// Parts of kernels.
    parts: usize,
    /// Functions that are no polynomials, equal to the program that was proved.
    analytic: usize,
}

/// The functions of a preset, each with what it was compiled from; an error if one has none or is missing.
fn pairs<'a>(
    compiled: &'a [Compiled],
    functions: &'a [CompiledKernel<Traced>],
) -> Result<Vec<(&'a Compiled, &'a CompiledKernel<Traced>)>, String> {
    let mut by_name: BTreeMap<&str, _> = functions.iter().map(|function| (function.name, function)).collect();
    let pairs = compiled.iter().map(|compiled| match by_name.remove(compiled.name.as_str()) {
        Some(function) => Ok((compiled, function)),
        None => Err(format!("{}: expected a function in the list, found none", compiled.name)),
    });
    let pairs = pairs.collect::<Result<_, _>>()?;
    match by_name.keys().next() {
        Some(name) => Err(format!("{name}: expected a kernel of that name, found none")),
        None => Ok(pairs),
    }
}

/// The unknowns that a function takes, in the order of its parameters: of a part the record comes first.
fn arguments(definition: &Definition, compiled: &Compiled) -> Vec<Traced> {
    let uniform = &definition.kernels[compiled.kernel].uniform;
    let coefficients = compiled.specification.coefficients.iter().enumerate();
    let taken = |wanted: &dyn Fn(usize) -> bool| {
        let taken = coefficients.clone().filter(|(_, coefficient)| wanted(coefficient.parameter));
        taken.map(|(index, _)| Traced::input(index as Symbol)).collect::<Vec<_>>()
    };
    match compiled.part {
        Part::Whole => taken(&|_| true),
        Part::Prepare => taken(&|parameter| uniform[parameter]),
        Part::Apply => {
            let record = taken(&|parameter| parameter == uniform.len());
            let varying = taken(&|parameter| parameter < uniform.len() && !uniform[parameter]);
            [record, varying].concat()
        }
    }
}

/// That two polynomials are equal modulo relations.
fn equal(found: &Polynomial, expected: &Polynomial, relations: &Relations, names: &[String]) -> Result<(), String> {
    let difference = relations.difference(found, expected).map_err(|overflow| overflow.to_string())?;
    if difference.is_zero() {
        return Ok(());
    }
    let (found, expected) = (found.display(names), expected.display(names));
    Err(format!("expected {expected}, found {found}, which differs by {}", difference.display(names)))
}

/// That the results of a polynomial function are those specified. Whether their polynomials are the same as they stand.
fn equals_specification(compiled: &Compiled, found: &[Polynomial]) -> Result<bool, String> {
    let specification = &compiled.specification;
    assert_eq!(found.len(), specification.outputs.len());
    for (field, (found, expected)) in specification.fields.iter().zip(found.iter().zip(&specification.outputs)) {
        equal(found, expected, &specification.relations, &specification.names())
            .map_err(|error| format!("`{field}`: {error}"))?;
    }
    Ok(found == specification.outputs)
}

/// That the results of a polynomial kernel are what its definition gives on the reference, in every blade.
fn equals_reference(
    definition: &Definition,
    compiled: &Compiled,
    found: &[Polynomial],
    expansion: &mut Expansion,
) -> Result<(), String> {
    let kernel = &definition.kernels[compiled.kernel];
    let (output, specification) = (&definition.entities[kernel.output], &compiled.specification);
    let value = interpret(definition, kernel, &arguments(definition, compiled));
    let mut found = found.iter().cloned();
    let mut rest = value.clone();
    for component in &output.components {
        let found = match component.value {
            ComponentValue::Field(_) => found.next().expect("a result for every field"),
            ComponentValue::Constant(constant) => Polynomial::constant(constant),
        };
        let coefficient = value.coefficient(&component.name);
        let expected = expansion.polynomial(coefficient)?;
        equal(&found, &expected, &specification.relations, &specification.names())
            .map_err(|error| format!("`{}` on the reference: {error}", component.name))?;
        let term = Multivector::from_blades(value.signature(), [(&component.name, coefficient)]);
        rest = rest.sub(&term.expect("a word of the signature"));
    }
    for (blade, coefficient) in rest.blades() {
        let beyond = expansion.polynomial(coefficient)?;
        equal(&Polynomial::zero(), &beyond, &specification.relations, &specification.names())
            .map_err(|error| format!("`{blade}` of {}: {error}", output.name))?;
    }
    Ok(())
}

/// That what the type of a result promises follows from what the inputs promise.
fn keeps_promises(compiled: &Compiled, found: &Output<Traced>, expansion: &mut Expansion) -> Result<(), String> {
    let specification = &compiled.specification;
    for error in &found.relation_errors {
        let error = expansion.polynomial(*error)?;
        equal(&error, &Polynomial::zero(), &specification.relations, &specification.names())
            .map_err(|error| format!("a broken promise: {error}"))?;
    }
    Ok(())
}

fn validate_function(
    definition: &Definition,
    compiled: &Compiled,
    function: &CompiledKernel<Traced>,
    validated: &mut Validated,
) -> Result<(), String> {
    let specification = &compiled.specification;
    let found = (function.call)(&arguments(definition, compiled));
    if specification.analytic.is_none() {
        let mut expansion = Expansion::default();
        let fields = found.fields.iter().map(|&field| expansion.polynomial(field));
        let fields: Vec<_> = fields.collect::<Result<_, _>>()?;
        let is_same = equals_specification(compiled, &fields)?;
        validated.by_relations += usize::from(!is_same);
        if compiled.part == Part::Whole {
            equals_reference(definition, compiled, &fields, &mut expansion)?;
            keeps_promises(compiled, &found, &mut expansion)?;
            validated.kernels += 1;
        } else {
            validated.parts += 1;
        }
    } else {
        validated.analytic += 1;
    }
    let inputs: Vec<_> = (0..specification.coefficients.len()).map(|symbol| Traced::input(symbol as Symbol)).collect();
    if found.fields != replay(&compiled.program, &inputs) {
        return Err("expected the program that was proved, found another".to_owned());
    }
    Ok(())
}

/// Validates every function of a preset; the error names the first that is not what it should be.
fn validate(definition: &Definition, functions: &[CompiledKernel<Traced>]) -> Result<Validated, String> {
    let compiled = ga_codegen::compile(definition).expect("a preset that is proved");
    let mut validated = Validated::default();
    for (compiled, function) in pairs(&compiled, functions)? {
        validate_function(definition, compiled, function, &mut validated)
            .map_err(|error| format!("{}: {error}", compiled.name))?;
    }
    Ok(validated)
}

/// The two parts of kernels, by the record between them with its fields.
macro_rules! parts {
    ($($record:ident [$($field:ident)*] $prepare:ident($uniform:ident), $apply:ident($varying:ident);)*) => {
        fn parts() -> Vec<CompiledKernel<Traced>> {
            let prepare: Vec<CompiledKernel<Traced>> = vec![$(CompiledKernel {
                name: stringify!($prepare),
                call: |row| {
                    let row = &mut { row };
                    let record = compiled::kernels::$prepare(take::<_, _, compiled::$uniform<Traced>>(row));
                    assert!(row.is_empty(), "a field for every coefficient");
                    Output { fields: vec![$(record.$field),*], relation_errors: Vec::new() }
                },
            }),*];
            let apply: Vec<CompiledKernel<Traced>> = vec![$(CompiledKernel {
                name: stringify!($apply),
                call: |row| {
                    let row = &mut { row };
                    let record = compiled::$record { $($field: take_scalar(row)),* };
                    let value = compiled::kernels::$apply(record, take::<_, _, compiled::$varying<Traced>>(row));
                    assert!(row.is_empty(), "a field for every coefficient");
                    Output { fields: value.to_array().to_vec(), relation_errors: Vec::new() }
                },
            }),*];
            prepare.into_iter().chain(apply).collect()
        }
    };
}

mod pga3d {
    use super::*;
    use pga_motor as compiled;

    mod variants {
        use pga_motor as compiled;
        use pga_motor::scalar;

        dispatch! {
            fn motor_mul_motor_packed(a: Motor, b: Motor) -> Motor;
            fn motor_mul_rotor_packed(a: Motor, b: Rotor) -> Motor;
            fn rotor_mul_motor_packed(a: Rotor, b: Motor) -> Motor;
            fn rotor_mul_rotor_packed(a: Rotor, b: Rotor) -> Rotor;
            fn even_mul_even_packed(a: EvenMultivector, b: EvenMultivector) -> EvenMultivector;
            fn rotor_transform_line_fma(r: Rotor, l: Line) -> Line;
            fn motor_mul_motor_fma(a: Motor, b: Motor) -> Motor;
            fn motor_transform_point_fma(m: Motor, p: Point) -> Point;
            fn even_normalize_fma(m: EvenMultivector) -> Motor;
            fn motor_scalar_product_motor_fma(a: Motor, b: Motor) -> Scalar;
            fn line_exp_f32(l: Line) -> Motor;
            fn line_exp_f64(l: Line) -> Motor;
            fn motor_log_f32(m: Motor) -> Line;
            fn motor_log_f64(m: Motor) -> Line;
        }
    }

    parts! {
        Matrix [x_1 x_x x_y x_z y_1 y_x y_y y_z z_1 z_x z_y z_z] motor_to_matrix(Motor), matrix_apply_point(Point);
        DirectionMatrix [x_x x_y x_z y_x y_y y_z z_x z_y z_z]
            motor_to_direction_matrix(Motor), matrix_apply_direction(Direction);
        PlaneMatrix [e1_e1 e1_e2 e1_e3 e2_e1 e2_e2 e2_e3 e3_e1 e3_e2 e3_e3 e0_e1 e0_e2 e0_e3]
            motor_to_plane_matrix(Motor), matrix_apply_plane(Plane);
        LineMatrix [
            e23_e23 e23_e31 e23_e12 e31_e23 e31_e31 e31_e12 e12_e23 e12_e31 e12_e12
            e01_e23 e01_e31 e01_e12 e02_e23 e02_e31 e02_e12 e03_e23 e03_e31 e03_e12
        ] motor_to_line_matrix(Motor), matrix_apply_line(Line);
    }

    /// Every function that is emitted for a kernel or a part of one.
    pub(super) fn functions() -> Vec<CompiledKernel<Traced>> {
        crate::pga3d::table().into_iter().chain(variants::table()).chain(parts()).collect()
    }
}

mod pga2d {
    use super::*;

    mod variants {
        use pga_motor::pga2d as compiled;
        use pga_motor::scalar;

        dispatch! {
            fn bivector_exp_f32(b: Bivector) -> Motor;
            fn bivector_exp_f64(b: Bivector) -> Motor;
            fn motor_log_f32(m: Motor) -> Bivector;
            fn motor_log_f64(m: Motor) -> Bivector;
        }
    }

    /// Every function that is emitted for a kernel.
    pub(super) fn functions() -> Vec<CompiledKernel<Traced>> {
        crate::pga2d::table().into_iter().chain(variants::table()).collect()
    }
}

fn assert_validated(preset: &str, functions: &[CompiledKernel<Traced>]) {
    let definition = suite::definition(preset);
    let validated = validate(&definition, functions).unwrap_or_else(|error| panic!("{preset} {error}"));
    let analytic = definition.kernels.iter().filter(|kernel| kernel.analytic.is_some()).count();
    assert!(validated.kernels >= definition.kernels.len() - analytic);
    assert_eq!(validated.kernels + validated.parts + validated.analytic, functions.len());
    println!(
        "{preset}: {} polynomial kernels and {} parts equal their definitions for all inputs, {} of them by what the \
         inputs promise; {} functions that are no polynomials are the programs that were proved",
        validated.kernels, validated.parts, validated.by_relations, validated.analytic
    );
}

#[test]
fn compiled_kernels_of_space_are_their_definitions() {
    assert_validated("pga3d", &pga3d::functions());
}

#[test]
fn compiled_kernels_of_the_plane_are_their_definitions() {
    assert_validated("pga2d", &pga2d::functions());
}

/// What validation says of a preset in which one function does something else.
fn validation_with(name: &str, other: fn(&[Traced]) -> Output<Traced>) -> String {
    let mut functions = pga2d::functions();
    let function = functions.iter_mut().find(|function| function.name == name).expect("a kernel of pga2d");
    function.call = other;
    validate(&suite::definition("pga2d"), &functions).expect_err("a function that does something else")
}

#[test]
fn a_wrong_sign_is_found_out_for_all_inputs() {
    let error = validation_with("motor_transform_point", |row| {
        let row = &mut { row };
        let (motor, mut point) = (take::<_, _, pga_motor::pga2d::Motor<Traced>>(row), take(row));
        point = pga_motor::pga2d::kernels::motor_transform_point(motor, point);
        Output { fields: vec![point.x, -point.y], relation_errors: Vec::new() }
    });
    assert!(error.starts_with("motor_transform_point: `y`: expected "), "{error}");
}

#[test]
fn a_result_that_is_right_by_another_way_is_found_out() {
    let error = validation_with("point_sub_point", |row| {
        // a - b as -(b - a): the same polynomial.
        Output { fields: vec![-(row[2] - row[0]), row[1] - row[3]], relation_errors: Vec::new() }
    });
    assert_eq!(error, "point_sub_point: expected the program that was proved, found another");
}

#[test]
fn another_function_of_real_numbers_is_found_out() {
    let error = validation_with("bivector_exp", |row| {
        let row = &mut { row };
        let exp = pga_motor::pga2d::kernels::bivector_exp(take(row));
        let mut fields = exp.to_array();
        fields.swap(0, 1);
        Output { fields: fields.to_vec(), relation_errors: Vec::new() }
    });
    assert_eq!(error, "bivector_exp: expected the program that was proved, found another");
    // A root among the coefficients of what should be a polynomial.
    let error = validation_with("motor_reverse", |row| {
        let root = pga_motor::Real::sqrt(row[0]);
        Output { fields: vec![root; row.len()], relation_errors: Vec::new() }
    });
    assert!(error.starts_with("motor_reverse: expected a polynomial, found Sqrt"), "{error}");
}

#[test]
fn a_function_that_is_not_in_the_list_is_missed() {
    let mut functions = pga2d::functions();
    let missing = functions.pop().expect("functions").name;
    let error = validate(&suite::definition("pga2d"), &functions).expect_err("one function too few");
    assert_eq!(error, format!("{missing}: expected a function in the list, found none"));
}
