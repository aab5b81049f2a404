//! What is read, and how, and for everything that is not, the exact message.

mod builder;
mod clips;
mod files;
mod refused;
mod skeletons;
mod sparse;
