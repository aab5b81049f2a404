//! The types with their scalar filled in, for each precision.

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
