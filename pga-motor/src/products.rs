//! Operators between types for which no kernel of their own is worth it: one side is converted, then the kernel of what
//! it is converted to is used.

use crate::{EvenMultivector, Line, Motor, OddMultivector, Plane, Rotor, Scalar, Translator, UnitLine, UnitPlane};
use core::ops::{Mul, Shr};

/// `a as A, b as B => Output` is `A::from(a) * B::from(b)`, or another operator.
macro_rules! convert_and {
    ($($operator:ident $method:ident { $($a:ident as $own_a:ident, $b:ident as $own_b:ident => $output:ident;)* })*) => {
        $($(
            impl<T: Scalar> $operator<$b<T>> for $a<T> {
                type Output = $output<T>;
                #[inline]
                fn $method(self, other: $b<T>) -> $output<T> {
                    $operator::$method($own_a::from(self), $own_b::from(other))
                }
            }
        )*)*
    };
}

convert_and! {
    Mul mul {
        OddMultivector as OddMultivector, Rotor as EvenMultivector => OddMultivector;
        Rotor as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, Translator as EvenMultivector => OddMultivector;
        Translator as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, Line as EvenMultivector => OddMultivector;
        Line as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, UnitLine as EvenMultivector => OddMultivector;
        UnitLine as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, Plane as OddMultivector => EvenMultivector;
        Plane as OddMultivector, OddMultivector as OddMultivector => EvenMultivector;
        OddMultivector as OddMultivector, UnitPlane as OddMultivector => EvenMultivector;
        UnitPlane as OddMultivector, OddMultivector as OddMultivector => EvenMultivector;
    }
    Shr shr {
        Rotor as Motor, EvenMultivector as EvenMultivector => EvenMultivector;
        Rotor as Motor, OddMultivector as OddMultivector => OddMultivector;
        Translator as Motor, EvenMultivector as EvenMultivector => EvenMultivector;
        Translator as Motor, OddMultivector as OddMultivector => OddMultivector;
    }
}

pub(crate) use convert_and;
