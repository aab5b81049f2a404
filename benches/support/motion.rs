//! One motion in the types of every crate. All are made from the same numbers in double precision.

use glam::{Affine3A, DAffine3, DMat4, DQuat, DVec3, Mat4, Quat, Vec3};
use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitDualQuaternion, UnitQuaternion};
use pga_motor::batch::{Blocks, Lanewise};
use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
use ultraviolet::f32x8;

use super::COUNT;

/// Motions that differ with the index: turns about all axes, and places at most 2 away.
pub(super) fn motor(index: usize) -> Motor {
    let angle = index as f64 * 0.37;
    let rotor = Rotor::about_z(angle) * Rotor::about_y(0.5 * angle) * Rotor::about_x(0.25 * angle);
    Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(angle.sin(), angle.cos(), 1.0)))
}

/// Points at most 2 away from the origin.
pub(super) fn point(index: usize) -> Point {
    let i = index as f64;
    Point::new(i.sin(), i.cos(), (index % COUNT) as f64 / COUNT as f64)
}

/// A rigid motion as a crate has it, or several side by side.
pub(super) trait Motion: Copy + 'static {
    const NAME: &'static str;
    /// How many stand side by side.
    const LANES: usize = 1;
    type Point: Copy + 'static;

    /// From as many of ours as there are lanes.
    fn of(motors: &[Motor]) -> Self;
    fn point(points: &[Point]) -> Self::Point;
    /// This motion after the first.
    fn after(self, first: Self) -> Self;
    fn carry(self, point: Self::Point) -> Self::Point;
    /// Three for each lane.
    fn coordinates(point: Self::Point) -> Vec<f64>;
}

pub(super) fn motions<M: Motion>(motors: &[Motor]) -> Vec<M> {
    motors.chunks_exact(M::LANES).map(M::of).collect()
}

pub(super) fn points<M: Motion>(points: &[Point]) -> Vec<M::Point> {
    points.chunks_exact(M::LANES).map(M::point).collect()
}

pub(super) fn blocks<E: Lanewise>(items: Vec<E>) -> Blocks<E> {
    items.into_iter().collect()
}

/// The coordinates of a list of points.
pub(super) fn coordinates<'a, M: Motion>(points: impl IntoIterator<Item = &'a M::Point>) -> Vec<f64> {
    points.into_iter().flat_map(|point| M::coordinates(*point)).collect()
}

/// Where motions carry four points that tell any two of them apart, the origin before the others.
pub(super) fn images<M: Motion>(motions: &[M]) -> Vec<f64> {
    let probes = [Point::ORIGIN, Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0), Point::new(0.0, 0.0, 1.0)];
    let image = |probe: Point| {
        let probe = M::point(&vec![probe; M::LANES]);
        motions.iter().flat_map(move |motion| M::coordinates(motion.carry(probe)))
    };
    probes.into_iter().flat_map(image).collect()
}

/// glam's rotation and the translation that follows it, a pair without padding: compilers take what stands in a pair's padding into
/// their vectors, and where that reads as a subnormal number each product takes twenty times as long.
#[derive(Clone, Copy)]
#[repr(C)]
pub(super) struct Pair<Q, V, P> {
    pub(super) rotation: Q,
    pub(super) translation: V,
    padding: P,
}

pub(super) type SinglePair = Pair<Quat, Vec3, f32>;
/// As long as its parts anyway.
pub(super) type DoublePair = Pair<DQuat, DVec3, ()>;

impl<Q, V, P: Default> Pair<Q, V, P> {
    #[inline]
    pub(super) fn new(rotation: Q, translation: V) -> Self {
        Self { rotation, translation, padding: P::default() }
    }
}

/// The quaternion x, y, z, w of the rotation, and the translation that follows it.
fn parts(motor: Motor) -> ([f64; 4], [f64; 3]) {
    (motor.rotor().to_quaternion_xyzw(), motor.translator().vector().to_array())
}

macro_rules! motions_of_precision {
    ($float:ident: $pair:ident $quaternion:ident $vector:ident $($matrix:ident)*) => {
        impl Motion for pga_motor::$float::Motor {
            const NAME: &'static str = "Motor";
            type Point = pga_motor::$float::Point;

            fn of(motors: &[Motor]) -> Self {
                Self::from(motors[0].to_array().map(|coefficient| coefficient as $float))
            }

            fn point(points: &[Point]) -> Self::Point {
                Self::Point::from(points[0].to_array().map(|coordinate| coordinate as $float))
            }

            #[inline]
            fn after(self, first: Self) -> Self {
                self * first
            }

            #[inline]
            fn carry(self, point: Self::Point) -> Self::Point {
                self.transform_point(point)
            }

            fn coordinates(point: Self::Point) -> Vec<f64> {
                point.to_array().map(f64::from).to_vec()
            }
        }

        impl Motion for $pair {
            const NAME: &'static str = concat!("glam ", stringify!($quaternion), ", ", stringify!($vector));
            type Point = $vector;

            fn of(motors: &[Motor]) -> Self {
                let (rotation, translation) = parts(motors[0]);
                let rotation = $quaternion::from_array(rotation.map(|part| part as $float));
                Self::new(rotation, $vector::from_array(translation.map(|part| part as $float)))
            }

            fn point(points: &[Point]) -> Self::Point {
                $vector::from_array(points[0].to_array().map(|coordinate| coordinate as $float))
            }

            #[inline]
            fn after(self, first: Self) -> Self {
                Self::new(self.rotation * first.rotation, self.carry(first.translation))
            }

            #[inline]
            fn carry(self, point: Self::Point) -> Self::Point {
                self.rotation * point + self.translation
            }

            fn coordinates(point: Self::Point) -> Vec<f64> {
                point.to_array().map(f64::from).to_vec()
            }
        }

        $(impl Motion for $matrix {
            const NAME: &'static str = concat!("glam ", stringify!($matrix));
            type Point = $vector;

            fn of(motors: &[Motor]) -> Self {
                let Pair { rotation, translation, .. } = $pair::of(motors);
                Self::from_rotation_translation(rotation, translation)
            }

            fn point(points: &[Point]) -> Self::Point {
                $pair::point(points)
            }

            #[inline]
            fn after(self, first: Self) -> Self {
                self * first
            }

            #[inline]
            fn carry(self, point: Self::Point) -> Self::Point {
                self.transform_point3(point)
            }

            fn coordinates(point: Self::Point) -> Vec<f64> {
                $pair::coordinates(point)
            }
        })*

        impl Motion for Isometry3<$float> {
            const NAME: &'static str = "nalgebra Isometry3";
            type Point = Point3<$float>;

            fn of(motors: &[Motor]) -> Self {
                let (rotation, translation) = parts(motors[0]);
                let quaternion = Quaternion::from(rotation.map(|part| part as $float));
                let [x, y, z] = translation.map(|part| part as $float);
                Self::from_parts(Translation3::new(x, y, z), UnitQuaternion::new_unchecked(quaternion))
            }

            fn point(points: &[Point]) -> Self::Point {
                Point3::from(points[0].to_array().map(|coordinate| coordinate as $float))
            }

            #[inline]
            fn after(self, first: Self) -> Self {
                self * first
            }

            #[inline]
            fn carry(self, point: Self::Point) -> Self::Point {
                self * point
            }

            fn coordinates(point: Self::Point) -> Vec<f64> {
                point.iter().copied().map(f64::from).collect()
            }
        }

        impl Motion for UnitDualQuaternion<$float> {
            const NAME: &'static str = "nalgebra UnitDualQuaternion";
            type Point = Point3<$float>;

            fn of(motors: &[Motor]) -> Self {
                Self::from_isometry(&Isometry3::of(motors))
            }

            fn point(points: &[Point]) -> Self::Point {
                Isometry3::<$float>::point(points)
            }

            #[inline]
            fn after(self, first: Self) -> Self {
                self * first
            }

            #[inline]
            fn carry(self, point: Self::Point) -> Self::Point {
                self * point
            }

            fn coordinates(point: Self::Point) -> Vec<f64> {
                Isometry3::<$float>::coordinates(point)
            }
        }
    };
}

motions_of_precision! { f32: SinglePair Quat Vec3 Affine3A Mat4 }
motions_of_precision! { f64: DoublePair DQuat DVec3 DAffine3 DMat4 }

impl Motion for ultraviolet::Isometry3 {
    const NAME: &'static str = "ultraviolet Isometry3";
    type Point = ultraviolet::Vec3;

    fn of(motors: &[Motor]) -> Self {
        let (rotation, translation) = parts(motors[0]);
        let rotation = ultraviolet::Rotor3::from_quaternion_array(rotation.map(|part| part as f32));
        Self::new(ultraviolet::Vec3::from(translation.map(|part| part as f32)), rotation)
    }

    fn point(points: &[Point]) -> Self::Point {
        points[0].to_array().map(|coordinate| coordinate as f32).into()
    }

    #[inline]
    fn after(self, first: Self) -> Self {
        self * first
    }

    #[inline]
    fn carry(self, point: Self::Point) -> Self::Point {
        self * point
    }

    fn coordinates(point: Self::Point) -> Vec<f64> {
        point.as_array().map(f64::from).to_vec()
    }
}

/// Arrays taken apart: for each element those of all lanes.
fn lanes<const N: usize>(items: [[f64; N]; 8]) -> [f32x8; N] {
    std::array::from_fn(|element| f32x8::from(items.map(|item| item[element] as f32)))
}

impl Motion for ultraviolet::Isometry3x8 {
    const NAME: &'static str = "ultraviolet Isometry3x8";
    const LANES: usize = 8;
    type Point = ultraviolet::Vec3x8;

    fn of(motors: &[Motor]) -> Self {
        let parts: [_; 8] = std::array::from_fn(|lane| parts(motors[lane]));
        let rotation = ultraviolet::Rotor3x8::from_quaternion_array(lanes(parts.map(|(rotation, _)| rotation)));
        Self::new(lanes(parts.map(|(_, translation)| translation)).into(), rotation)
    }

    fn point(points: &[Point]) -> Self::Point {
        lanes(std::array::from_fn(|lane| points[lane].to_array())).into()
    }

    #[inline]
    fn after(self, first: Self) -> Self {
        self * first
    }

    #[inline]
    fn carry(self, point: Self::Point) -> Self::Point {
        self * point
    }

    fn coordinates(point: Self::Point) -> Vec<f64> {
        let coordinates = [point.x, point.y, point.z].map(|coordinate| coordinate.to_array());
        (0..8).flat_map(|lane| coordinates.map(|coordinate| f64::from(coordinate[lane]))).collect()
    }
}

#[cfg(feature = "peers")]
pub(super) use peers::Peer;

#[cfg(feature = "peers")]
mod peers {
    use super::{Motion, Motor, Point};
    use geometric_algebra::{GeometricProduct, Transformation, ppga3d};

    /// The motor of the other crate of this algebra: the same one, with the same signs, in another order.
    pub(in super::super) type Peer = ppga3d::Motor;

    impl Motion for Peer {
        const NAME: &'static str = "geometric_algebra";
        type Point = ppga3d::Point;

        fn of(motors: &[Motor]) -> Self {
            let Motor { s, e23, e31, e12, e01, e02, e03, e0123 } = motors[0];
            Self::from([s, e23, e31, e12, e0123, e01, e02, e03].map(|coefficient| coefficient as f32))
        }

        fn point(points: &[Point]) -> Self::Point {
            let Point { x, y, z } = points[0];
            Self::Point::from([1.0, x, y, z].map(|coordinate| coordinate as f32))
        }

        #[inline]
        fn after(self, first: Self) -> Self {
            self.geometric_product(first)
        }

        #[inline]
        fn carry(self, point: Self::Point) -> Self::Point {
            self.transformation(point)
        }

        fn coordinates(point: Self::Point) -> Vec<f64> {
            let [_, x, y, z] = <[f32; 4]>::from(point).map(f64::from);
            vec![x, y, z]
        }
    }
}
