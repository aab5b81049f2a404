//! Laws that exp, log, roots, normalisation, interpolation and conversions keep, in space and in the plane, in both
//! precisions, at every angle and with translations of every size.
//!
//! Tolerances are derived, see `tolerance`. Each law prints how near its worst sample comes:
//! `cargo test --test laws -- --nocapture`.

mod carried;
mod conversion;
mod drift;
mod endpoints;
mod exponential;
mod interpolation;
mod law;
mod motion;
mod normalization;
mod not_finite;
mod roots;
mod samples;
mod scaling;
mod tie;
mod tolerance;
