//! Rigid motions as motors.
