//! The degree in e0, which products keep, and its law at run time.

use super::Trit;
use crate::{EvenMultivector, Scalar, pga2d};

/// The degree in e0, modulo 3, of an element whose coefficients other than 0 all have the same: 0 for a rotor, 1 for
/// what is ideal throughout, as a line at infinity. `None` for 0 and where degrees are mixed, as in most motors.
///
/// Where both factors have a degree and the product is not 0, it has the sum of theirs.
///
/// ```
/// use pga_motor::f64::{Line, Motor, Rotor};
/// use pga_motor::gf3::{Trit, e0_degree};
///
/// let turn = Motor::from(Rotor::about_z(1.0));
/// let infinite = Line::new(0.0, 0.0, 0.0, 1.0, 2.0, 3.0);
/// assert_eq!((e0_degree(turn), e0_degree(infinite)), (Some(Trit::Ergodic), Some(Trit::Plus)));
/// assert_eq!(e0_degree(turn * infinite), Some(Trit::Plus));
/// assert_eq!(e0_degree(infinite * infinite), None);
/// ```
pub fn e0_degree<T: Scalar>(element: impl Into<EvenMultivector<T>>) -> Option<Trit> {
    let coefficients = element.into().to_array();
    let degrees = EvenMultivector::<T>::NULL_DEGREES.map(|degree| Trit::of_integer(degree.into()));
    let mut present = coefficients.into_iter().zip(degrees).filter(|(c, _)| *c != T::ZERO).map(|(_, degree)| degree);
    let first = present.next()?;
    present.all(|degree| degree == first).then_some(first)
}

macro_rules! rescale {
    ($($module:ident: $($entity:ident $kernel:ident),*;)*) => {
        $($(
            impl<T: Scalar> $module::$entity<T> {
                /// The same with e0 replaced by `factor` e0: each coefficient times `factor` to the power of its
                /// blade's entry in [`Self::NULL_DEGREES`].
                ///
                /// That is a change of the unit of length, a scaling about the origin where `factor` is positive. It
                /// may be done before or after a product or a sandwich: `(a * b).rescale_e0(k)` is
                /// `a.rescale_e0(k) * b.rescale_e0(k)`.
                #[inline]
                pub fn rescale_e0(self, factor: T) -> Self {
                    $module::kernels::$kernel(self, factor)
                }
            }
        )*)*
    };
}

rescale! {
    crate:
        Motor motor_rescale_e0,
        EvenMultivector even_rescale_e0,
        OddMultivector odd_rescale_e0,
        Translator translator_rescale_e0,
        Line line_rescale_e0,
        UnitLine unit_line_rescale_e0,
        Plane plane_rescale_e0,
        UnitPlane unit_plane_rescale_e0,
        Point point_rescale_e0,
        ProjectivePoint projective_point_rescale_e0,
        Direction direction_rescale_e0;
    pga2d:
        Motor motor_rescale_e0,
        EvenMultivector even_rescale_e0,
        OddMultivector odd_rescale_e0,
        Translator translator_rescale_e0,
        Bivector bivector_rescale_e0,
        Line line_rescale_e0,
        UnitLine unit_line_rescale_e0,
        Point point_rescale_e0,
        Direction direction_rescale_e0;
}
