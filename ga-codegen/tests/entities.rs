//! What the types of the presets promise. These lists are the assumptions of every proof: a relation more, and kernels get
//! cheaper by being wrong for values that the type should allow.

use ga_codegen::kernel::{ComponentValue, Definition};

fn definition(preset: &str) -> Definition {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    ga_codegen::define(text.parse().expect("tokens")).expect("a preset without errors")
}

/// Every entity as `Name {field: blade, ...} where relation, ...`; a field that is named like its blade only once.
fn described(preset: &str) -> Vec<String> {
    let entity = |entity: &ga_codegen::kernel::Entity| {
        let components = entity.components.iter().map(|component| match &component.value {
            ComponentValue::Field(name) if *name == component.name => name.clone(),
            ComponentValue::Field(name) => format!("{name}: {}", component.name),
            ComponentValue::Constant(value) => format!("{value}: {}", component.name),
        });
        let components: Vec<_> = components.collect();
        let statements: Vec<_> = entity.statements.iter().map(|statement| statement.text.as_str()).collect();
        let promise = if statements.is_empty() { String::new() } else { format!(" where {}", statements.join(", ")) };
        format!("{} {{{}}}{promise}", entity.name, components.join(", "))
    };
    let described: Vec<_> = definition(preset).entities.iter().map(entity).collect();
    println!("{preset}\n  {}", described.join("\n  "));
    described
}

#[test]
fn entities_in_space_promise_what_the_design_says_and_no_more() {
    let expected = [
        "Scalar {: 1}",
        "Motor {s: 1, e23, e31, e12, e01, e02, e03, e0123} where s * s == 1 - e23 * e23 - e31 * e31 - e12 * e12, \
         e23 * e01 == s * e0123 - e31 * e02 - e12 * e03",
        "EvenMultivector {s: 1, e23, e31, e12, e01, e02, e03, e0123}",
        "Rotor {s: 1, e23, e31, e12} where s * s == 1 - e23 * e23 - e31 * e31 - e12 * e12",
        "Translator {1: 1, e01, e02, e03}",
        "Line {e23, e31, e12, e01, e02, e03}",
        "UnitLine {e23, e31, e12, e01, e02, e03} where e31 * e31 == 1 - e23 * e23 - e12 * e12, \
         e23 * e01 == 0 - e31 * e02 - e12 * e03",
        "Plane {e1, e2, e3, e0}",
        "UnitPlane {e1, e2, e3, e0} where e1 * e1 == 1 - e2 * e2 - e3 * e3",
        "Point {x: e032, y: e013, z: e021, 1: e123}",
        "Direction {x: e032, y: e013, z: e021}",
        "ProjectivePoint {e032, e013, e021, e123}",
        "OddMultivector {e1, e2, e3, e0, e032, e013, e021, e123}",
        "Pseudoscalar {e0123}",
    ];
    assert_eq!(described("pga3d"), expected);
}

#[test]
fn entities_in_the_plane_promise_what_the_design_says_and_no_more() {
    let expected = [
        "Scalar {: 1}",
        "Motor {s: 1, e12, e01, e20} where s * s == 1 - e12 * e12",
        "EvenMultivector {s: 1, e12, e01, e20}",
        "Rotor {s: 1, e12} where s * s == 1 - e12 * e12",
        "Translator {1: 1, e01, e20}",
        "Bivector {e12, e01, e20}",
        "Line {e1, e2, e0}",
        "UnitLine {e1, e2, e0} where e1 * e1 == 1 - e2 * e2",
        "Point {x: e20, y: e01, 1: e12}",
        "Direction {x: e20, y: e01}",
        "OddMultivector {e1, e2, e0, e012}",
        "Pseudoscalar {e012}",
    ];
    assert_eq!(described("pga2d"), expected);
}

/// What single kernels assume beyond their types: unit directions, and a cosine with its sine.
#[test]
fn kernels_assume_what_is_listed_here_beyond_their_types_and_no_more() {
    let mut assumptions = Vec::new();
    for preset in ga_codegen::preset::NAMES {
        for kernel in definition(preset).kernels {
            let texts = kernel.statements.iter().map(|statement| statement.text.as_str());
            assumptions.extend(texts.map(|text| format!("{preset} {}: {text}", kernel.name)));
        }
    }
    println!("{}", assumptions.join("\n"));
    let expected = [
        "pga3d point_join_unit_direction: b.y * b.y == 1 - b.x * b.x - b.z * b.z",
        "pga3d direction_rotor: d.x * d.x == 1 - d.y * d.y - d.z * d.z",
        "pga3d direction_rotor: c * c == 1 - s * s",
        "pga3d unit_line_screw: c * c == 1 - s * s",
        "pga3d line_axis: l.e31 * l.e31 == 1 - l.e23 * l.e23 - l.e12 * l.e12",
        "pga2d point_join_unit_direction: b.y * b.y == 1 - b.x * b.x",
        "pga2d point_turn: c * c == 1 - s * s",
    ];
    assert_eq!(assumptions, expected);
}
