//! Skeletons and motion from files of other programs. Every reader takes text or bytes that it does not trust: whatever they
//! are, it answers with the data or with a typed error, and what it allocates is proportional to what it was given, or bounded
//! by a constant that its documentation names.

pub mod bvh;
#[cfg(feature = "gltf")]
pub mod gltf;
