//! The entities and kernels of 2D projective geometric algebra: the preset `pga2d` of `ga-codegen`, where they are defined.

ga_macros::algebra! {
    preset pga2d;
    scalar crate::scalar;
    export pga2d;
}
