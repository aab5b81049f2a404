//! The published check: which parts of a motor are there, and what their trits add up to.

use super::Trit;
use crate::{EvenMultivector, Real};

/// A part of a motor that has a published trit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// The scalar.
    Identity,
    /// The Euclidean bivector: e23, e31, e12.
    Rotation,
    /// The ideal bivector: e01, e02, e03.
    Translation,
}

impl Component {
    /// Every component, in the order of the trits.
    pub const ALL: [Self; 3] = [Self::Identity, Self::Rotation, Self::Translation];

    /// The published trit: identity -1, rotation 0, translation +1.
    ///
    /// ```
    /// use pga_motor::gf3::Component;
    ///
    /// let described = Component::ALL.map(|component| (component.name(), component.trit().name()));
    /// assert_eq!(described, [("Identity", "MINUS"), ("Rotation", "ERGODIC"), ("Translation", "PLUS")]);
    /// ```
    pub const fn trit(self) -> Trit {
        match self {
            Self::Identity => Trit::Minus,
            Self::Rotation => Trit::Ergodic,
            Self::Translation => Trit::Plus,
        }
    }

    /// The component of a trit.
    pub const fn of_trit(trit: Trit) -> Self {
        match trit {
            Trit::Minus => Self::Identity,
            Trit::Ergodic => Self::Rotation,
            Trit::Plus => Self::Translation,
        }
    }

    /// The component that a coefficient belongs to, by an entry of an entity's `TRIT_LABELS`; `None` where it has no
    /// label, as e0123.
    ///
    /// ```
    /// use pga_motor::f64::Motor;
    /// use pga_motor::gf3::Component;
    ///
    /// let components = Motor::TRIT_LABELS.map(Component::of_label);
    /// assert_eq!(components[0], Some(Component::Identity));
    /// assert_eq!(components[1..4], [Some(Component::Rotation); 3]);
    /// assert_eq!(components[4..7], [Some(Component::Translation); 3]);
    /// assert_eq!(components[7], None);
    /// ```
    pub const fn of_label(label: Option<i8>) -> Option<Self> {
        let Some(label) = label else { return None };
        match Trit::from_value(label) {
            Some(trit) => Some(Self::of_trit(trit)),
            None => None,
        }
    }

    /// The published name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Identity => "Identity",
            Self::Rotation => "Rotation",
            Self::Translation => "Translation",
        }
    }
}

/// What the magnitude of a coefficient must exceed to be there; absolute, for coefficients as they stand in the motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances<T> {
    /// For e01, e02, e03: half a translation, in the caller's unit of length.
    pub translation: T,
    /// For e23, e31, e12: the sine of half an angle. No weight depends on it.
    pub rotation: T,
    /// For the scalar: the cosine of half an angle.
    pub identity: T,
}

impl<T: Real> Tolerances<T> {
    /// The published ones: any translation or rotation but 0 counts, and a scalar beyond 0.01. So a turn within 1.1
    /// degrees of half a turn counts as half a turn.
    ///
    /// Of computed motors rounding errors count as well; say then how large they may be.
    pub fn published() -> Self {
        Self { translation: T::ZERO, rotation: T::ZERO, identity: T::from_ratio(1, 100) }
    }
}

/// Which parts of a motor are there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Presence {
    /// Any of e01, e02, e03.
    pub translation: bool,
    /// Any of e23, e31, e12.
    pub rotation: bool,
    /// The scalar.
    pub identity: bool,
}

impl Presence {
    /// The parts of a motor, or of anything that converts to an even element, with a coefficient whose magnitude
    /// exceeds the tolerance. NaN exceeds nothing.
    ///
    /// That is no decomposition of the motion: the slide of half a turn about an axis through the origin is in e0123
    /// alone, which belongs to no part, and the ideal bivector of a turn about another axis says where that is.
    ///
    /// ```
    /// use pga_motor::f64::Rotor;
    /// use pga_motor::gf3::{Presence, Tolerances};
    ///
    /// let turn = Presence::of(Rotor::about_z(1.0), Tolerances::published());
    /// assert_eq!(turn, Presence { translation: false, rotation: true, identity: true });
    /// ```
    pub fn of<T: Real>(motor: impl Into<EvenMultivector<T>>, tolerances: Tolerances<T>) -> Self {
        let coefficients = motor.into().to_array();
        let is_there = |component: Component, tolerance: T| {
            let labels = EvenMultivector::<T>::TRIT_LABELS.into_iter().map(Component::of_label);
            coefficients.iter().zip(labels).any(|(c, label)| label == Some(component) && c.abs() > tolerance)
        };
        Self {
            translation: is_there(Component::Translation, tolerances.translation),
            rotation: is_there(Component::Rotation, tolerances.rotation),
            identity: is_there(Component::Identity, tolerances.identity),
        }
    }

    /// Whether that part is there.
    pub const fn has(self, component: Component) -> bool {
        match component {
            Component::Identity => self.identity,
            Component::Rotation => self.rotation,
            Component::Translation => self.translation,
        }
    }

    /// The published weight of a part: its trit where it is there, else 0; so 0 for the rotation in any case.
    pub const fn weight(self, component: Component) -> Trit {
        if self.has(component) { component.trit() } else { Trit::Ergodic }
    }

    /// The sum of the weights modulo 3.
    pub fn sum(self) -> Trit {
        Component::ALL.into_iter().map(|component| self.weight(component)).sum()
    }

    /// Whether the sum of the weights is 0 modulo 3: where translation and identity are both there, or both not.
    pub fn is_conserved(self) -> bool {
        self.sum() == Trit::Ergodic
    }
}

/// The published check of a motor: whether the weights of its parts, translation +1 where it is there, rotation 0,
/// identity
/// -1 where it is there, have the sum 0 modulo 3.
///
/// It checks presence and nothing else, see the [truth table](crate::gf3#the-published-check). The identity, turns
/// about axes through the origin and half turns about other axes fail it, though nothing is wrong with them.
///
/// ```
/// use pga_motor::f64::{Direction, Motor, Point, Translator};
/// use pga_motor::gf3::{Tolerances, verify_motor_gf3};
///
/// let step = Translator::from_vector(Direction::Y);
/// assert!(verify_motor_gf3(step, Tolerances::published()));
///
/// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
/// let half_turn = Motor::from_screw(axis, std::f64::consts::PI, 0.0).unwrap();
/// assert!(!verify_motor_gf3(half_turn, Tolerances::published()));
/// ```
pub fn verify_motor_gf3<T: Real>(motor: impl Into<EvenMultivector<T>>, tolerances: Tolerances<T>) -> bool {
    Presence::of(motor, tolerances).is_conserved()
}
