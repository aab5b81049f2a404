//! Matrices of rigid motions of the plane. See [`rigid`](crate::rigid).

use super::{Direction, EvenMultivector, Motor, Rotor, Translator, kernels};
use crate::{NotRigid, Real, Scalar, rigid};

impl<T: Scalar> Motor<T> {
    /// The columns of the 3 x 3 matrix that acts on column vectors (x, y, 1): where the axes' directions and the origin
    /// go.
    pub fn to_columns(self) -> [[T; 3]; 3] {
        let (x, y) = (self.transform_direction(Direction::X), self.transform_direction(Direction::Y));
        let origin = self.transform_origin();
        [[x.x, x.y, T::ZERO], [y.x, y.y, T::ZERO], [origin.x, origin.y, T::ONE]]
    }
}

impl<T: Real> Motor<T> {
    /// The motion of a rigid 3 x 3 matrix, given by columns: where the axes' directions and the origin go. Of m and -m,
    /// which are the same motion, it is the one whose scalar part is not negative.
    ///
    /// Accurate at every angle, half turns included.
    ///
    /// # Errors
    /// A matrix that is not finite, not affine, scales, shears or mirrors, by more than 1e-4 in `f32` or 1e-6 in `f64`.
    ///
    /// ```
    /// use pga_motor::NotRigid;
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let half_turn = Motor::about(Point::new(1.0, 2.0), std::f64::consts::PI);
    /// let columns = [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [2.0, 4.0, 1.0]];
    /// assert!((Motor::from_columns(columns)? - half_turn).norm() < 1e-15);
    /// assert_eq!(Motor::from_columns(columns)?.to_columns(), columns);
    /// # Ok::<(), NotRigid>(())
    /// ```
    pub fn from_columns(columns: [[T; 3]; 3]) -> Result<Self, NotRigid> {
        let checked = columns.map(|column| column.map(T::to_f64));
        rigid::check_columns(checked, rigid::tolerance::<T>())?;
        let [x, y, _] = checked.map(direction);
        rigid::check_orientation(x.cross(y))?;
        let [x, y, origin] = columns.map(direction);
        Ok(Self::from_rotor_translator(rotor([x, y]), Translator::from_vector(origin)))
    }
}

fn direction<T: Scalar>([x, y, _]: [T; 3]) -> Direction<T> {
    Direction::new(x, y)
}

/// The rotor that turns the coordinate axes to the given ones, with a scalar part that is not negative. Where that is
/// more than a quarter turn, what is left to a half turn is taken and the half turn added, so nothing cancels.
fn rotor<T: Real>([x, y]: [Direction<T>; 2]) -> Rotor<T> {
    let rotor = if x.x + y.y < T::ZERO {
        kernels::rotor_mul_rotor(near_rotor([-x, -y]), Rotor::new(T::ZERO, -T::ONE))
    } else {
        near_rotor([x, y])
    };
    if rotor.s < T::ZERO { -rotor } else { rotor }
}

/// The rotor of a turn by at most a quarter: proportional to 1 + cosine - sine e12, each the mean of two entries.
fn near_rotor<T: Real>([x, y]: [Direction<T>; 2]) -> Rotor<T> {
    let two = T::from_ratio(2, 1);
    EvenMultivector { s: two + (x.x + y.y), e12: y.x - x.y, ..EvenMultivector::ZERO }.over_norm().rotor()
}

#[cfg(test)]
mod tests;
