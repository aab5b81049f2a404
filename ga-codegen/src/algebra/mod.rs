//! What multiplies to what: signatures, and later blades, bases and Cayley tables. Exact signs, no symbols yet.

mod signature;

pub use signature::Signature;
