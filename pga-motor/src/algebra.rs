//! The entities and kernels of 3D projective geometric algebra: the preset `pga3d` of `ga-codegen`, where they are defined.

ga_macros::algebra! {
    preset pga3d;
    scalar crate::scalar;
    export pga3d;
}
