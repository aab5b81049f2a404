//! Operators between types for which no kernel of their own is worth it.

use super::{EvenMultivector, Line, Motor, OddMultivector, Rotor, Translator, UnitLine};
use crate::Scalar;
use crate::products::convert_and;
use core::ops::{Mul, Shr};

convert_and! {
    Mul mul {
        EvenMultivector as EvenMultivector, Rotor as EvenMultivector => EvenMultivector;
        Rotor as EvenMultivector, EvenMultivector as EvenMultivector => EvenMultivector;
        EvenMultivector as EvenMultivector, Translator as EvenMultivector => EvenMultivector;
        Translator as EvenMultivector, EvenMultivector as EvenMultivector => EvenMultivector;
        OddMultivector as OddMultivector, Rotor as EvenMultivector => OddMultivector;
        Rotor as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, Translator as EvenMultivector => OddMultivector;
        Translator as EvenMultivector, OddMultivector as OddMultivector => OddMultivector;
        OddMultivector as OddMultivector, Line as OddMultivector => EvenMultivector;
        Line as OddMultivector, OddMultivector as OddMultivector => EvenMultivector;
        OddMultivector as OddMultivector, UnitLine as OddMultivector => EvenMultivector;
        UnitLine as OddMultivector, OddMultivector as OddMultivector => EvenMultivector;
    }
    Shr shr {
        Rotor as Motor, EvenMultivector as EvenMultivector => EvenMultivector;
        Rotor as Motor, OddMultivector as OddMultivector => OddMultivector;
        Translator as Motor, EvenMultivector as EvenMultivector => EvenMultivector;
        Translator as Motor, OddMultivector as OddMultivector => OddMultivector;
    }
}
