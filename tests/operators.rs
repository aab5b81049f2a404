//! Every emitted operator and conversion against the naive reference, on exact values.
//!
//! Kernels are proved, and the differential tests call them by name. The `impl`s around them are written by the emitter
//! without a proof: which operator calls which kernel, in which order, and the sums, differences and multiples of
//! linear types coefficient by coefficient. Here each is called through its operator. The lists below are complete: what
//! a preset emits is read from its tokens and compared with them.

#[path = "differential/dispatch.rs"]
#[allow(dead_code, unused_macros)]
mod dispatch;
#[macro_use]
#[path = "differential/exact.rs"]
#[allow(dead_code)]
mod exact;
#[path = "differential/samples.rs"]
#[allow(dead_code)]
mod samples;

use dispatch::{take, take_scalar};
use exact::Exact;
use ga_codegen::kernel::{ComponentValue, Definition, Entity};
use ga_codegen::reference::Multivector;
use samples::Random;
use std::collections::BTreeSet;

exact_scalar!(pga_motor::scalar {
    type Four = pga_motor::scalar::Array4<Self>;
} {
    const EPSILON: Self = Exact::ZERO;
    const PI: Self = Exact::ZERO;
    fn to_f64(self) -> f64 {
        self.to_f64()
    }
});

/// A value of an entity with exact coefficients.
trait Value: Copy {
    /// The entity.
    const NAME: &str;
    /// Takes a value off the front of a row of coefficients.
    fn take(row: &mut &[Exact]) -> Self;
    /// The coefficients in the order of the fields.
    fn fields(self) -> Vec<Exact>;
}

impl Value for Exact {
    const NAME: &str = Entity::SCALAR;
    fn take(row: &mut &[Exact]) -> Self {
        take_scalar(row)
    }
    fn fields(self) -> Vec<Exact> {
        vec![self]
    }
}

fn definition(preset: &str) -> Definition {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    ga_codegen::define(text.parse().expect("tokens")).expect("a preset without errors")
}

fn entity<V: Value>(definition: &Definition) -> &Entity {
    definition.entity(V::NAME).unwrap_or_else(|| panic!("no entity {}", V::NAME))
}

/// A random value that keeps what its type promises.
fn sample<V: Value>(definition: &Definition, random: &mut Random) -> V {
    let fields = samples::entity(definition.basis.signature(), entity::<V>(definition), random);
    V::take(&mut fields.as_slice())
}

/// A value as a multivector of the reference, its fixed coefficients with it.
fn multivector<V: Value>(definition: &Definition, value: V) -> Multivector<Exact> {
    let mut fields = value.fields().into_iter();
    let terms = entity::<V>(definition).components.iter().map(|component| {
        let coefficient = match &component.value {
            ComponentValue::Field(_) => fields.next().expect("a value for every field"),
            ComponentValue::Constant(number) => Exact::new(number.numerator(), number.denominator()),
        };
        (component.name.clone(), coefficient)
    });
    Multivector::from_blades(definition.basis.signature(), terms.collect::<Vec<_>>()).expect("words of the signature")
}

/// What an operator means.
fn meaning(symbol: &str, a: &Multivector<Exact>, b: &Multivector<Exact>) -> Multivector<Exact> {
    match symbol {
        "+" | "+=" => a.add(b),
        "-" | "-=" => a.sub(b),
        "*" | "*=" => a.geometric(b),
        "/" => a.scale(Exact::ONE / b.coefficient("1")),
        "^" => a.outer(b),
        "&" => a.regressive(b),
        "|" => a.inner(b),
        ">>" => a.sandwich(b),
        _ => panic!("an operator without a meaning: {symbol}"),
    }
}

const SAMPLES: usize = 12;

fn check_binary<A: Value, B: Value, C: Value>(definition: &Definition, symbol: &str, operator: impl Fn(A, B) -> C) {
    let mut random = Random(11);
    for _ in 0..SAMPLES {
        let (a, b): (A, B) = (sample(definition, &mut random), sample(definition, &mut random));
        if symbol == "/" && b.fields() == [Exact::ZERO] {
            continue;
        }
        let expected = meaning(symbol, &multivector(definition, a), &multivector(definition, b));
        let found = multivector(definition, operator(a, b));
        assert_eq!(found, expected, "{} {symbol} {} -> {}", A::NAME, B::NAME, C::NAME);
    }
}

fn check_unary<A: Value, B: Value>(
    definition: &Definition,
    operator: impl Fn(A) -> B,
    meaning: impl Fn(&Multivector<Exact>) -> Multivector<Exact>,
) {
    let mut random = Random(12);
    for _ in 0..SAMPLES {
        let a: A = sample(definition, &mut random);
        let expected = meaning(&multivector(definition, a));
        assert_eq!(multivector(definition, operator(a)), expected, "{} -> {}", A::NAME, B::NAME);
    }
}

/// The operators and conversions that a preset emits, such as `Motor >> Point`, `-Line` and `Motor from Rotor`.
fn emitted(preset: &str) -> BTreeSet<String> {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    let tokens = ga_codegen::expand(text.parse().expect("tokens")).expect("a preset that is proved").to_string();
    let headers = tokens.split("impl <").skip(1).filter_map(|rest| rest.split_once('{')).map(|(header, _)| header);
    headers.filter_map(|header| described(&header.replace(" for ", "|").replace(' ', ""))).collect()
}

/// From `T:Scalar>core::ops::Shr<Point<T>>|Motor<T>` to `Motor >> Point`; `None` for other traits.
fn described(header: &str) -> Option<String> {
    let (_, header) = header.split_once('>')?;
    let (implemented, on) = header.split_once('|')?;
    let on = on.trim_end_matches("<T>");
    let (name, other) = implemented.split_once('<').map_or((implemented, None), |(name, other)| (name, Some(other)));
    let other = match other.map(|other| other.trim_end_matches('>').trim_end_matches("<T")) {
        Some("T") => Entity::SCALAR,
        Some(other) => other,
        None => on,
    };
    let symbol = match name.strip_prefix("core::ops::") {
        None if name == "From" && !other.contains('[') && !on.contains('[') => "from",
        Some("Neg") => return Some(format!("-{on}")),
        Some("Add") => "+",
        Some("Sub") => "-",
        Some("Mul") => "*",
        Some("Div") => "/",
        Some("BitXor") => "^",
        Some("BitAnd") => "&",
        Some("BitOr") => "|",
        Some("Shr") => ">>",
        Some("AddAssign") => "+=",
        Some("SubAssign") => "-=",
        Some("MulAssign") => "*=",
        _ => return None,
    };
    Some(format!("{on} {symbol} {other}"))
}

/// Tests for the operators of a preset, whose types the caller names `types`.
macro_rules! operators {
    (
        preset $preset:literal;
        values [$($value:ident),*]
        binary { $($a:ident $operator:tt [$($b:ident),*];)* }
        assigning { $($c:ident $assignment:tt [$($d:ident),*];)* }
        negated [$($e:ident),*]
        converted { $($f:ident from [$($g:ident),*];)* }
    ) => {
        $(
            impl Value for types::$value<Exact> {
                const NAME: &str = stringify!($value);
                fn take(row: &mut &[Exact]) -> Self {
                    take::<Exact, _, Self>(row)
                }
                fn fields(self) -> Vec<Exact> {
                    self.to_array().to_vec()
                }
            }
        )*

        #[test]
        fn operators_give_what_they_mean() {
            let definition = &definition($preset);
            $($(
                check_binary::<types::$a<Exact>, types::$b<Exact>, _>(
                    definition, stringify!($operator), |a, b| a $operator b,
                );
            )*)*
            $($(
                check_binary::<types::$c<Exact>, types::$d<Exact>, _>(
                    definition, stringify!($assignment), |mut a, b| { a $assignment b; a },
                );
            )*)*
            $(check_unary::<types::$e<Exact>, _>(definition, |a| -a, Multivector::neg);)*
        }

        #[test]
        fn floats_scale_from_the_left_as_from_the_right() {
            let (definition, random) = (&definition($preset), &mut Random(13));
            $(
                let value = sample::<types::$c<Exact>>(definition, random).map(Exact::to_f64);
                assert_eq!(0.7 * value, value * 0.7, "{}", stringify!($c));
                let value = value.map(|x| x as f32);
                assert_eq!(0.7_f32 * value, value * 0.7_f32, "{}", stringify!($c));
            )*
        }

        #[test]
        fn conversions_keep_the_multivector() {
            let definition = &definition($preset);
            $($(
                check_unary::<types::$g<Exact>, types::$f<Exact>>(definition, |a| a.into(), Multivector::clone);
            )*)*
        }

        #[test]
        fn the_lists_hold_every_operator_and_conversion() {
            let mut listed = BTreeSet::new();
            $($(listed.insert(format!("{} {} {}", stringify!($a), stringify!($operator), stringify!($b)));)*)*
            $($(listed.insert(format!("{} {} {}", stringify!($c), stringify!($assignment), stringify!($d)));)*)*
            $(listed.insert(format!("-{}", stringify!($e)));)*
            $($(listed.insert(format!("{} from {}", stringify!($f), stringify!($g)));)*)*
            let emitted = emitted($preset);
            let unlisted: Vec<_> = emitted.difference(&listed).collect();
            assert!(unlisted.is_empty(), "emitted, not in the list: {unlisted:#?}");
            let gone: Vec<_> = listed.difference(&emitted).collect();
            assert!(gone.is_empty(), "in the list, not emitted: {gone:#?}");
        }
    };
}

mod pga3d {
    use super::*;

    mod types {
        pub(super) use pga_motor::*;
        pub(super) type Scalar<T> = T;
    }

    operators! {
        preset "pga3d";
        values [
            Motor, EvenMultivector, Rotor, Translator, Line, UnitLine, Plane, UnitPlane, Point, Direction,
            ProjectivePoint, OddMultivector, Pseudoscalar
        ]
        binary {
            Direction & [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Direction * [Scalar];
            Direction + [Direction];
            Direction - [Direction];
            Direction / [Scalar];
            Direction ^ [Plane, UnitPlane];
            Direction | [Line, Plane, UnitLine, UnitPlane];
            EvenMultivector * [
                EvenMultivector, Line, Motor, OddMultivector, Plane, Rotor, Scalar, Translator, UnitLine,
                UnitPlane
            ];
            EvenMultivector + [EvenMultivector];
            EvenMultivector - [EvenMultivector];
            EvenMultivector / [Scalar];
            Line & [Direction, Line, Point, ProjectivePoint, UnitLine];
            Line * [EvenMultivector, Line, Motor, Plane, Point, Scalar, UnitLine, UnitPlane];
            Line + [Line];
            Line - [Line];
            Line / [Scalar];
            Line ^ [Line, Plane, UnitLine, UnitPlane];
            Line | [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Motor * [
                EvenMultivector, Line, Motor, OddMultivector, Plane, Rotor, Scalar, Translator, UnitLine,
                UnitPlane
            ];
            Motor + [Motor];
            Motor - [Motor];
            Motor >> [
                Direction, EvenMultivector, Line, Motor, OddMultivector, Plane, Point, ProjectivePoint,
                Rotor, Translator, UnitLine, UnitPlane
            ];
            OddMultivector * [EvenMultivector, Motor, OddMultivector, Scalar];
            OddMultivector + [OddMultivector];
            OddMultivector - [OddMultivector];
            OddMultivector / [Scalar];
            Plane & [Direction, Point, ProjectivePoint];
            Plane * [EvenMultivector, Line, Motor, Plane, Point, Rotor, Scalar, Translator, UnitLine, UnitPlane];
            Plane + [Plane];
            Plane - [Plane];
            Plane / [Scalar];
            Plane ^ [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Plane | [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Point & [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Point * [Line, Plane, Point, UnitLine, UnitPlane];
            Point + [Direction];
            Point - [Direction, Point];
            Point ^ [Plane, UnitPlane];
            Point | [Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            ProjectivePoint & [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            ProjectivePoint * [Scalar];
            ProjectivePoint + [ProjectivePoint];
            ProjectivePoint - [ProjectivePoint];
            ProjectivePoint / [Scalar];
            ProjectivePoint ^ [Plane, UnitPlane];
            ProjectivePoint | [Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            Pseudoscalar * [Scalar];
            Pseudoscalar + [Pseudoscalar];
            Pseudoscalar - [Pseudoscalar];
            Pseudoscalar / [Scalar];
            Rotor * [EvenMultivector, Motor, Plane, Rotor, Translator, UnitLine, UnitPlane];
            Rotor >> [Direction, Line, Motor, Plane, Point, ProjectivePoint, Rotor, Translator, UnitLine, UnitPlane];
            Translator * [EvenMultivector, Motor, Plane, Rotor, Translator, UnitLine, UnitPlane];
            Translator >> [
                Direction, Line, Motor, Plane, Point, ProjectivePoint, Rotor, Translator, UnitLine,
                UnitPlane
            ];
            UnitLine & [Direction, Line, Point, ProjectivePoint, UnitLine];
            UnitLine * [EvenMultivector, Line, Motor, Plane, Point, Rotor, Translator, UnitLine, UnitPlane];
            UnitLine ^ [Line, Plane, UnitLine, UnitPlane];
            UnitLine | [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            UnitPlane & [Direction, Point, ProjectivePoint];
            UnitPlane * [EvenMultivector, Line, Motor, Plane, Point, Rotor, Translator, UnitLine, UnitPlane];
            UnitPlane ^ [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
            UnitPlane | [Direction, Line, Plane, Point, ProjectivePoint, UnitLine, UnitPlane];
        }
        assigning {
            Direction *= [Scalar];
            Direction += [Direction];
            Direction -= [Direction];
            EvenMultivector *= [Scalar];
            EvenMultivector += [EvenMultivector];
            EvenMultivector -= [EvenMultivector];
            Line *= [Scalar];
            Line += [Line];
            Line -= [Line];
            OddMultivector *= [Scalar];
            OddMultivector += [OddMultivector];
            OddMultivector -= [OddMultivector];
            Plane *= [Scalar];
            Plane += [Plane];
            Plane -= [Plane];
            ProjectivePoint *= [Scalar];
            ProjectivePoint += [ProjectivePoint];
            ProjectivePoint -= [ProjectivePoint];
            Pseudoscalar *= [Scalar];
            Pseudoscalar += [Pseudoscalar];
            Pseudoscalar -= [Pseudoscalar];
        }
        negated [
            Direction, EvenMultivector, Line, Motor, OddMultivector, Plane, ProjectivePoint, Pseudoscalar,
            Rotor, UnitLine, UnitPlane
        ]
        converted {
            EvenMultivector from [Line, Motor, Rotor, Translator, UnitLine];
            Line from [UnitLine];
            Motor from [Rotor, Translator, UnitLine];
            OddMultivector from [Direction, Plane, Point, ProjectivePoint, UnitPlane];
            Plane from [UnitPlane];
            ProjectivePoint from [Direction, Point];
        }
    }
}

mod pga2d {
    use super::*;

    mod types {
        pub(super) use pga_motor::pga2d::*;
        pub(super) type Scalar<T> = T;
    }

    operators! {
        preset "pga2d";
        values [
            Motor, EvenMultivector, Rotor, Translator, Bivector, Line, UnitLine, Point, Direction,
            OddMultivector, Pseudoscalar
        ]
        binary {
            Bivector & [Bivector, Line, UnitLine];
            Bivector * [Scalar];
            Bivector + [Bivector];
            Bivector - [Bivector];
            Bivector / [Scalar];
            Bivector ^ [Line, UnitLine];
            Bivector | [Bivector, Line, UnitLine];
            Direction & [Direction, Line, Point, UnitLine];
            Direction * [Scalar];
            Direction + [Direction];
            Direction - [Direction];
            Direction / [Scalar];
            Direction ^ [Line, UnitLine];
            Direction | [Line, UnitLine];
            EvenMultivector * [EvenMultivector, Line, Motor, OddMultivector, Scalar, UnitLine];
            EvenMultivector + [EvenMultivector];
            EvenMultivector - [EvenMultivector];
            EvenMultivector / [Scalar];
            Line & [Bivector, Direction, Point];
            Line * [EvenMultivector, Line, Motor, Point, Rotor, Scalar, Translator, UnitLine];
            Line + [Line];
            Line - [Line];
            Line / [Scalar];
            Line ^ [Bivector, Direction, Line, Point, UnitLine];
            Line | [Bivector, Direction, Line, Point, UnitLine];
            Motor * [EvenMultivector, Line, Motor, OddMultivector, Rotor, Scalar, Translator, UnitLine];
            Motor + [Motor];
            Motor - [Motor];
            Motor >> [
                Bivector, Direction, EvenMultivector, Line, Motor, OddMultivector, Point, Rotor, Translator,
                UnitLine
            ];
            OddMultivector * [EvenMultivector, Motor, OddMultivector, Scalar];
            OddMultivector + [OddMultivector];
            OddMultivector - [OddMultivector];
            OddMultivector / [Scalar];
            Point & [Direction, Line, Point, UnitLine];
            Point * [Line, Point, UnitLine];
            Point + [Direction];
            Point - [Direction, Point];
            Point ^ [Line, UnitLine];
            Point | [Line, Point, UnitLine];
            Pseudoscalar * [Scalar];
            Pseudoscalar + [Pseudoscalar];
            Pseudoscalar - [Pseudoscalar];
            Pseudoscalar / [Scalar];
            Rotor * [Line, Motor, Rotor, Translator, UnitLine];
            Rotor >> [Direction, Line, Motor, Point, Rotor, Translator, UnitLine];
            Translator * [Line, Motor, Rotor, Translator, UnitLine];
            Translator >> [Direction, Line, Motor, Point, Rotor, Translator, UnitLine];
            UnitLine & [Bivector, Direction, Point];
            UnitLine * [EvenMultivector, Line, Motor, Point, Rotor, Translator, UnitLine];
            UnitLine ^ [Bivector, Direction, Line, Point, UnitLine];
            UnitLine | [Bivector, Direction, Line, Point, UnitLine];
        }
        assigning {
            Bivector *= [Scalar];
            Bivector += [Bivector];
            Bivector -= [Bivector];
            Direction *= [Scalar];
            Direction += [Direction];
            Direction -= [Direction];
            EvenMultivector *= [Scalar];
            EvenMultivector += [EvenMultivector];
            EvenMultivector -= [EvenMultivector];
            Line *= [Scalar];
            Line += [Line];
            Line -= [Line];
            OddMultivector *= [Scalar];
            OddMultivector += [OddMultivector];
            OddMultivector -= [OddMultivector];
            Pseudoscalar *= [Scalar];
            Pseudoscalar += [Pseudoscalar];
            Pseudoscalar -= [Pseudoscalar];
        }
        negated [Bivector, Direction, EvenMultivector, Line, Motor, OddMultivector, Pseudoscalar, Rotor, UnitLine]
        converted {
            Bivector from [Direction, Point];
            EvenMultivector from [Bivector, Motor, Rotor, Translator];
            Line from [UnitLine];
            Motor from [Rotor, Translator];
            OddMultivector from [Line, UnitLine];
        }
    }
}
