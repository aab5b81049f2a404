//! Pairs of motors, in any algebra.

use proptest::prelude::*;

use crate::check::Coefficient;
use crate::reference::Multivector;

/// A motor and its negative.
pub(super) fn antipodal<T: Coefficient>(
    motors: impl Strategy<Value = Multivector<T>> + Clone,
) -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    motors.prop_map(|motor| [motor.clone(), motor.neg()])
}

/// Two motors: any, equal, antipodal, and by a step from equal or antipodal.
pub(super) fn pairs<T: Coefficient>(
    motors: impl Strategy<Value = Multivector<T>> + Clone,
    steps: impl Strategy<Value = Multivector<T>> + Clone,
) -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    prop_oneof![
        3 => [motors.clone(), motors.clone()],
        1 => motors.clone().prop_map(|motor| [motor.clone(), motor]),
        1 => antipodal(motors.clone()),
        1 => (motors, steps, any::<bool>()).prop_map(|(motor, step, negative)| {
            let near = motor.geometric(&step);
            [motor, if negative { near.neg() } else { near }]
        }),
    ]
}
