//! lib

pub mod algebra;
pub mod emit;
mod expand;
pub mod factor;
pub mod kernel;
mod lower;
pub mod preset;
pub mod program;
pub mod proof;
pub mod reference;
pub mod symbolic;
mod syntax;

pub use expand::{Compiled, compile, define, expand};
