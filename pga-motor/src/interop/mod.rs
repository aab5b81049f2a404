//! Conversions to and from the types of other crates, each behind a feature of the crate's name.

pub mod glam;
