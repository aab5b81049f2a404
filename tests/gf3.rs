//! Labels of blades in GF(3): which labelings products keep, what the published one is, and what every generated
//! product of motors makes of both.

#[macro_use]
#[path = "differential/dispatch.rs"]
#[allow(dead_code)]
mod dispatch;
#[macro_use]
#[path = "differential/exact.rs"]
#[allow(dead_code)]
mod exact;
#[path = "differential/interpreter.rs"]
#[allow(dead_code)]
mod interpreter;
#[path = "differential/samples.rs"]
#[allow(dead_code)]
mod samples;
#[path = "differential/tracked.rs"]
#[allow(dead_code, unused_macros)]
mod tracked;

use dispatch::{CompiledKernel, take};
use exact::Exact;
use ga_codegen::algebra::{Product, Sign};
use ga_codegen::kernel::{Definition, Entity, ExpressionKind, Kernel, Operator};
use ga_codegen::reference::Multivector;
use pga_motor::EvenMultivector;
use pga_motor::gf3::{Presence, Tolerances, Trit, verify_motor_gf3};
use proptest::prelude::*;
use samples::Random;

exact_scalar!(pga_motor::scalar {
    type Four = pga_motor::scalar::Array4<Self>;
} {
    const EPSILON: Self = Exact::ZERO;
    const PI: Self = Exact::ZERO;
    fn to_f64(self) -> f64 {
        self.to_f64()
    }
});

mod pga3d {
    use pga_motor as compiled;
    pub(crate) use pga_motor::f64 as types;
    use pga_motor::scalar;
    pga_motor::pga3d_kernels!(dispatch);
}

mod pga2d {
    use pga_motor::pga2d as compiled;
    pub(crate) use pga_motor::pga2d::f64 as types;
    use pga_motor::scalar;
    pga_motor::pga2d_kernels!(dispatch);
}

fn definition(preset: &str) -> Definition {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    ga_codegen::define(text.parse().expect("tokens")).expect("a preset without errors")
}

/// The names of the basis blades of even grade in 3D, in the order of the fields of `EvenMultivector`.
const EVEN: [&str; 8] = ["1", "e23", "e31", "e12", "e01", "e02", "e03", "e0123"];

/// The degree in e0 of a blade, from its name alone.
fn degree(word: &str) -> u32 {
    u32::from(word.contains('0'))
}

/// The published trit of a blade, from its name alone.
fn published(word: &str) -> Option<i8> {
    match (word.len(), degree(word)) {
        (1, _) => Some(-1),
        (3, 0) => Some(0),
        (3, _) => Some(1),
        _ => None,
    }
}

/// A product of two even basis blades: their places in `EVEN`, the sign of the product and its place.
type BladeProduct = (usize, usize, Sign, usize);

/// The products of even basis blades that are not 0, by the reference.
fn products_of_reference() -> Vec<BladeProduct> {
    let signature = definition("pga3d").basis.signature();
    let blade = |word| Multivector::from_blades(signature, [(word, Exact::ONE)]).expect("a blade of 3D");
    let product = |i: usize, j: usize| {
        let product = blade(EVEN[i]).geometric(&blade(EVEN[j]));
        let place = EVEN.iter().position(|word| product.coefficient(word) != Exact::ZERO)?;
        let sign = if product.coefficient(EVEN[place]) == Exact::ONE { Sign::Plus } else { Sign::Minus };
        Some((i, j, sign, place))
    };
    (0..64).filter_map(|pair| product(pair / 8, pair % 8)).collect()
}

/// The same by the generator's Cayley table.
fn products_of_generator() -> Vec<BladeProduct> {
    let basis = definition("pga3d").basis;
    let table = ga_codegen::algebra::table(&basis, Product::Geometric);
    let place = |word: &str| EVEN.iter().position(|other| *other == word);
    let row = |word: &str| basis.blades().iter().position(|blade| blade.name == word).expect("a blade of 3D");
    let product = |i: usize, j: usize| {
        let (sign, word) = table[row(EVEN[i])][row(EVEN[j])]?;
        Some((i, j, sign, place(word).expect("an even blade")))
    };
    (0..64).filter_map(|pair| product(pair / 8, pair % 8)).collect()
}

/// How many products do not have the sum of their factors' labels.
fn broken(labels: &[Trit; 8], products: &[BladeProduct]) -> usize {
    products.iter().filter(|(i, j, _, product)| labels[*i] + labels[*j] != labels[*product]).count()
}

#[test]
fn reference_and_generator_have_the_same_48_even_blade_products() {
    assert_eq!(products_of_reference(), products_of_generator());
    assert_eq!(products_of_reference().len(), 48);
}

#[test]
fn zero_and_plus_and_minus_the_e0_degree_are_the_only_additive_labelings() {
    let products = products_of_reference();
    let labelings =
        (0..3_usize.pow(8)).map(|code| std::array::from_fn(|i| Trit::ALL[code / 3_usize.pow(i as u32) % 3]));
    let additive: Vec<[Trit; 8]> = labelings.filter(|labels| broken(labels, &products) == 0).collect();
    let degrees = EVEN.map(|word| Trit::of_integer(degree(word).into()));
    println!("{} labelings, additive: {additive:?}", 3_usize.pow(8));
    assert_eq!(additive.len(), 3);
    for labels in [[Trit::Ergodic; 8], degrees, degrees.map(|degree| -degree)] {
        assert!(additive.contains(&labels), "{labels:?}");
    }
}

#[test]
fn published_labels_break_18_even_blade_products_or_30_by_the_label_of_the_pseudoscalar() {
    let products = products_of_reference();
    for (pseudoscalar, expected) in [(Trit::Plus, 18), (Trit::Ergodic, 30), (Trit::Minus, 30)] {
        let label = |word| published(word).map_or(Some(pseudoscalar), Trit::from_value).expect("a trit");
        let found = broken(&EVEN.map(label), &products);
        println!("e0123 labelled {pseudoscalar}: {found} of {} products broken", products.len());
        assert_eq!(found, expected);
    }
}

/// The emitted labels of an entity in the order of its fields.
struct Labels {
    degrees: &'static [u32],
    trits: &'static [Option<i8>],
}

macro_rules! labels {
    ($function:ident: $module:ident { $($entity:ident)* }) => {
        fn $function(name: &str) -> Labels {
            match name {
                Entity::SCALAR => Labels { degrees: &[0], trits: &[Some(-1)] },
                $(stringify!($entity) => Labels {
                    degrees: &$module::types::$entity::NULL_DEGREES,
                    trits: &$module::types::$entity::TRIT_LABELS,
                },)*
                _ => panic!("an entity without labels: {name}"),
            }
        }
    };
}

labels! { space_labels: pga3d {
    Motor EvenMultivector Rotor Translator Line UnitLine Plane UnitPlane Point Direction ProjectivePoint
    OddMultivector Pseudoscalar
} }
labels! { plane_labels: pga2d {
    Motor EvenMultivector Rotor Translator Bivector Line UnitLine Point Direction OddMultivector Pseudoscalar
} }

/// A preset: its name, the labels of its entities and its compiled kernels.
type Preset = (&'static str, fn(&str) -> Labels, fn() -> Vec<CompiledKernel<Exact>>);

const PRESETS: [Preset; 2] =
    [("pga3d", space_labels, pga3d::table::<Exact>), ("pga2d", plane_labels, pga2d::table::<Exact>)];

#[test]
fn every_entity_carries_the_labels_of_its_blades() {
    for (preset, labels, _) in PRESETS {
        for entity in &definition(preset).entities {
            let labels = labels(&entity.name);
            let words = || entity.fields().map(|(_, component)| component.name.as_str());
            assert_eq!(labels.degrees, words().map(degree).collect::<Vec<_>>(), "{preset} {}", entity.name);
            assert_eq!(labels.trits, words().map(published).collect::<Vec<_>>(), "{preset} {}", entity.name);
        }
    }
}

/// The kernels whose definition is a product or a sandwich of two inputs.
fn products<'a>(
    definition: &'a Definition,
    table: &'a [CompiledKernel<Exact>],
) -> impl Iterator<Item = (&'a Kernel, &'a CompiledKernel<Exact>, Operator)> {
    let operator = |kernel: &Kernel| match &kernel.expression.kind {
        ExpressionKind::Binary(operator @ (Operator::Geometric | Operator::Sandwich), a, b) => {
            let inputs = [a, b].map(|operand| matches!(operand.kind, ExpressionKind::Parameter(_)));
            (kernel.analytic.is_none() && inputs == [true; 2]).then_some(*operator)
        }
        _ => None,
    };
    let compiled = |name: &str| table.iter().find(|compiled| compiled.name == name).expect("a compiled kernel");
    definition.kernels.iter().filter_map(move |kernel| Some((kernel, compiled(&kernel.name), operator(kernel)?)))
}

/// The inputs of a kernel as multivectors of the reference.
fn inputs(definition: &Definition, kernel: &Kernel, mut row: &[Exact]) -> Vec<Multivector<Exact>> {
    let input = |parameter: &ga_codegen::kernel::Parameter| {
        let entity = &definition.entities[parameter.entity];
        let (fields, rest) = row.split_at(entity.fields().count());
        row = rest;
        interpreter::multivector(definition.basis.signature(), entity, fields)
    };
    kernel.parameters.iter().map(input).collect()
}

/// The part of a multivector with this degree in e0.
fn part(value: &Multivector<Exact>, of_degree: u32) -> Multivector<Exact> {
    let blades = value.blades().into_iter().filter(|(word, _)| degree(word) == of_degree);
    Multivector::from_blades(value.signature(), blades.collect::<Vec<_>>()).expect("words of the signature")
}

/// What the reference makes of the parts of the factors whose degrees have this sum modulo 3.
fn product_of_parts(factors: &[Multivector<Exact>], sum: Trit) -> Multivector<Exact> {
    let (last, before) = factors.split_last().expect("a factor");
    [0, 1].into_iter().fold(Multivector::zero(last.signature()), |total, of_degree| {
        let (part, rest) = (part(last, of_degree), sum - Trit::of_integer(of_degree.into()));
        let with = match (before, rest) {
            ([], Trit::Ergodic) => part,
            ([], _) => return total,
            (before, rest) => product_of_parts(before, rest).geometric(&part),
        };
        total.add(&with)
    })
}

/// A kernel's output among the even elements; `None` where it is another type.
fn even_output(name: &str, fields: &[Exact]) -> Option<EvenMultivector<Exact>> {
    let rest = &mut { fields };
    match name {
        "Motor" => Some(take::<_, _, pga_motor::Motor<_>>(rest).into()),
        "EvenMultivector" => Some(take(rest)),
        "Rotor" => Some(take::<_, _, pga_motor::Rotor<_>>(rest).into()),
        "Translator" => Some(take::<_, _, pga_motor::Translator<_>>(rest).into()),
        _ => None,
    }
}

/// The published check by the words of the reference alone.
fn presence(value: &Multivector<Exact>) -> Presence {
    let is_there = |label: i8, tolerance: Exact| {
        let is_large = |c: Exact| c > tolerance || -c > tolerance;
        value.blades().into_iter().any(|(word, c)| published(&word) == Some(label) && is_large(c))
    };
    Presence {
        translation: is_there(1, Exact::ZERO),
        rotation: is_there(0, Exact::ZERO),
        identity: is_there(-1, Exact::new(1, 100)),
    }
}

#[test]
fn components_of_every_motor_product_are_those_of_the_reference() {
    const CASES: usize = 50;
    let (definition, table) = (definition("pga3d"), pga3d::table::<Exact>());
    let (mut kernels, mut components, mut patterns) = (0, 0, [0; 8]);
    for (kernel, compiled, operator) in products(&definition, &table) {
        let output = &definition.entities[kernel.output];
        let labels = space_labels(&output.name);
        let mut random = Random(21);
        for _ in 0..CASES {
            let row = samples::row(&definition, kernel, &mut random);
            let found = (compiled.call)(&row).fields;
            let Some(even) = even_output(&output.name, &found) else { break };
            let mut factors = inputs(&definition, kernel, &row);
            if operator == Operator::Sandwich {
                factors.push(factors[0].reverse());
            }
            let whole = factors[1..].iter().fold(factors[0].clone(), |product, factor| product.geometric(factor));
            let case = format!("{} on {row:?}", kernel.name);

            // The published way: which parts are there.
            let there = Presence::of(even, Tolerances::published());
            assert_eq!(there, presence(&whole), "{case}");
            assert_eq!(verify_motor_gf3(even, Tolerances::published()), there.translation == there.identity, "{case}");
            patterns[pattern(there)] += 1;

            // The graded way: every coefficient comes from parts whose degrees add up to its own.
            let parts = Trit::ALL.map(|degree| product_of_parts(&factors, degree));
            for ((value, degree), (_, component)) in found.iter().zip(labels.degrees).zip(output.fields()) {
                for (trit, part) in Trit::ALL.iter().zip(&parts) {
                    let own = *trit == Trit::of_integer(i64::from(*degree));
                    let expected = if own { *value } else { Exact::ZERO };
                    assert_eq!(part.coefficient(&component.name), expected, "{case}: {}", component.name);
                }
                components += 1;
            }
        }
        kernels += usize::from(even_output(&output.name, &[Exact::ZERO; 8]).is_some());
    }
    println!("{kernels} kernels, {components} components; presence (translation, rotation, identity) {patterns:?}");
    assert!(kernels >= 40, "only {kernels} kernels give motors");
}

fn pattern(presence: Presence) -> usize {
    4 * usize::from(presence.translation) + 2 * usize::from(presence.rotation) + usize::from(presence.identity)
}

#[test]
fn every_product_and_sandwich_commutes_with_rescaling_e0() {
    const CASES: usize = 10;
    let factors = [Exact::new(3, 2), Exact::new(-2, 1), Exact::ZERO];
    for (preset, labels, table) in PRESETS {
        let (definition, table) = (definition(preset), table());
        let rescaled = |fields: &[Exact], entity: usize, factor: Exact| -> Vec<Exact> {
            let degrees = labels(&definition.entities[entity].name).degrees;
            fields.iter().zip(degrees).map(|(&c, degree)| (0..*degree).fold(c, |c, _| c * factor)).collect()
        };
        let mut kernels = 0;
        for (kernel, compiled, _) in products(&definition, &table) {
            let mut random = Random(22);
            for (_, factor) in (0..CASES).flat_map(|case| factors.map(|factor| (case, factor))) {
                let row = samples::row(&definition, kernel, &mut random);
                let (mut before, mut rest) = (Vec::new(), row.as_slice());
                for parameter in &kernel.parameters {
                    let (fields, after) = rest.split_at(definition.entities[parameter.entity].fields().count());
                    before.extend(rescaled(fields, parameter.entity, factor));
                    rest = after;
                }
                let after = rescaled(&(compiled.call)(&row).fields, kernel.output, factor);
                assert_eq!((compiled.call)(&before).fields, after, "{preset} {} on {row:?}", kernel.name);
            }
            kernels += 1;
        }
        println!("{preset}: {kernels} products and sandwiches commute with rescaling");
        assert!(kernels >= 40, "{preset}: only {kernels} products");
    }
}

#[test]
fn rescale_e0_multiplies_by_the_factor_to_the_null_degree() {
    for (preset, labels, table) in PRESETS {
        let (definition, mut random, mut kernels) = (definition(preset), Random(23), 0);
        for compiled in table().iter().filter(|compiled| compiled.name.ends_with("_rescale_e0")) {
            let kernel = definition.kernel(compiled.name).expect("a kernel of the definition");
            let row = samples::row(&definition, kernel, &mut random);
            let (factor, fields) = row.split_last().expect("the factor comes last");
            let degrees = labels(&definition.entities[kernel.output].name).degrees;
            let power = |degree: u32| (0..degree).fold(Exact::ONE, |power, _| power * *factor);
            let expected: Vec<_> = fields.iter().zip(degrees).map(|(&c, &degree)| c * power(degree)).collect();
            assert_eq!((compiled.call)(&row).fields, expected, "{preset} {}", compiled.name);
            kernels += 1;
        }
        // Every entity but those on which it does nothing, rotors, or is a multiple, pseudoscalars.
        assert_eq!(kernels + 3, definition.entities.len(), "{preset}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn trits_add_and_multiply_as_integers_do(a in any::<i32>(), b in any::<i32>()) {
        let (a, b) = (i64::from(a), i64::from(b));
        let trit = Trit::of_integer;
        prop_assert_eq!(trit(a) + trit(b), trit(a + b));
        prop_assert_eq!(trit(a) - trit(b), trit(a - b));
        prop_assert_eq!(trit(a) * trit(b), trit(a * b));
        prop_assert_eq!(-trit(a), trit(-a));
        prop_assert_eq!((a - i64::from(trit(a).value())) % 3, 0);
    }

    #[test]
    fn values_of_trits_lead_back(value in any::<i8>()) {
        prop_assert_eq!(Trit::from_value(value).map(i8::from), (-1..=1).contains(&value).then_some(value));
    }

    #[test]
    fn sums_of_trits_are_sums_of_integers(values in prop::collection::vec(any::<i32>(), 0..20)) {
        let integers = values.into_iter().map(i64::from);
        prop_assert_eq!(integers.clone().map(Trit::of_integer).sum::<Trit>(), Trit::of_integer(integers.sum()));
    }

    #[test]
    fn a_part_is_there_where_a_coefficient_exceeds_its_tolerance(
        row in prop::array::uniform8(-2.0..2.0_f64),
        translation in 0.0..2.0_f64,
        rotation in 0.0..2.0_f64,
        identity in 0.0..2.0_f64,
    ) {
        let there = Presence::of(EvenMultivector::from(row), Tolerances { translation, rotation, identity });
        prop_assert_eq!(there.identity, row[0].abs() > identity);
        prop_assert_eq!(there.rotation, row[1..4].iter().any(|c| c.abs() > rotation));
        prop_assert_eq!(there.translation, row[4..7].iter().any(|c| c.abs() > translation));
        prop_assert_eq!(there.is_conserved(), there.translation == there.identity);
    }
}
