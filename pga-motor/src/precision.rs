//! The types with their scalar filled in, for each precision; and tests.

macro_rules! aliases {
    ($float:ident: $($name:ident)*) => {
        $(
            #[doc = concat!("[`", stringify!($name), "`](super::", stringify!($name), ")")]
            #[doc = concat!("of `", stringify!($float), "`.")]
            pub type $name = super::$name<$float>;
        )*
    };
    ($float:ident in $module:ident: $($name:ident)*) => {
        $(
            #[doc = concat!("[`", stringify!($name), "`](super::", stringify!($module), "::", stringify!($name), ")")]
            #[doc = concat!("of `", stringify!($float), "`.")]
            pub type $name = super::$module::$name<$float>;
        )*
    };
}

pub(crate) use aliases;

/// Tests that are the same in both precisions: names of tests, and the generic functions that they are.
#[cfg(test)]
macro_rules! in_both_precisions {
    ($($name:ident: $generic:ident;)*) => {
        $(
            #[test]
            fn $name() {
                $generic::<f32>();
                $generic::<f64>();
            }
        )*
    };
}

#[cfg(test)]
pub(crate) use in_both_precisions;
