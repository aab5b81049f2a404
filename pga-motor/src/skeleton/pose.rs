//! One pose of a skeleton.

use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

use crate::Motor;

/// A pose: for each joint of a skeleton, in its order, where the joint's frame stands relative to its parent's.
///
/// It is a slice of motors of fixed length, so it can be indexed, iterated and handed to
/// [`local_to_model`](super::local_to_model) as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose<T> {
    locals: Vec<Motor<T>>,
}

impl<T> Pose<T> {
    /// The local motors, for a caller who wants the buffer back.
    pub fn into_locals(self) -> Vec<Motor<T>> {
        self.locals
    }
}

impl<T> From<Vec<Motor<T>>> for Pose<T> {
    fn from(locals: Vec<Motor<T>>) -> Self {
        Self { locals }
    }
}

impl<T> FromIterator<Motor<T>> for Pose<T> {
    fn from_iter<I: IntoIterator<Item = Motor<T>>>(locals: I) -> Self {
        Self { locals: locals.into_iter().collect() }
    }
}

impl<T> Deref for Pose<T> {
    type Target = [Motor<T>];

    fn deref(&self) -> &[Motor<T>] {
        &self.locals
    }
}

impl<T> DerefMut for Pose<T> {
    fn deref_mut(&mut self) -> &mut [Motor<T>] {
        &mut self.locals
    }
}
