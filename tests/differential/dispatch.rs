//! From the exported list of kernels to a table that maps a kernel's name to the compiled function on coefficients.

/// A compiled kernel on the coefficients of its inputs, those of all parameters in one row.
pub(crate) struct CompiledKernel<T> {
    pub(crate) name: &'static str,
    pub(crate) call: fn(&[T]) -> Output<T>,
}

/// What a kernel returned.
pub(crate) struct Output<T> {
    /// The fields of the output in their order.
    pub(crate) fields: Vec<T>,
    /// `relation_errors()` of the output; empty for a type without relations.
    pub(crate) relation_errors: Vec<T>,
}

/// Stands in for the method of that name on types that have no relations; the inherent method goes before it.
pub(crate) trait WithoutRelations<T>: Sized {
    fn relation_errors(self) -> [T; 0] {
        []
    }
}

impl<T, E> WithoutRelations<T> for E {}

/// Takes an entity off the front of a row of coefficients.
pub(crate) fn take<T: Copy, const N: usize, E: From<[T; N]>>(row: &mut &[T]) -> E {
    let (front, rest) = row.split_first_chunk().expect("a coefficient for every field");
    *row = rest;
    E::from(*front)
}

/// Takes a plain scalar off the front of a row of coefficients.
pub(crate) fn take_scalar<T: Copy>(row: &mut &[T]) -> T {
    let (front, rest) = row.split_first().expect("a coefficient for the scalar");
    *row = rest;
    *front
}

/// The callback of `pga3d_kernels!` and `pga2d_kernels!`: a function `table` with every kernel of the list, taken from
/// the modules that the caller names `compiled` and `scalar`.
macro_rules! dispatch {
    (@take $row:ident Scalar) => { $crate::dispatch::take_scalar($row) };
    (@take $row:ident $entity:ident) => { $crate::dispatch::take::<T, _, compiled::$entity<T>>($row) };
    (@fields $value:ident Scalar) => { vec![$value] };
    (@fields $value:ident $entity:ident) => { $value.to_array().to_vec() };
    (@errors $value:ident Scalar) => { Vec::new() };
    (@errors $value:ident $entity:ident) => { $value.relation_errors().to_vec() };
    ($(fn $name:ident($($parameter:ident: $entity:ident),*) -> $output:ident;)*) => {
        pub(crate) fn table<T: scalar::Real>() -> Vec<$crate::dispatch::CompiledKernel<T>> {
            #[allow(unused_imports)]
            use $crate::dispatch::WithoutRelations as _;
            vec![$(
                $crate::dispatch::CompiledKernel {
                    name: stringify!($name),
                    call: |row: &[T]| {
                        let row = &mut { row };
                        $(let $parameter = dispatch!(@take row $entity);)*
                        assert!(row.is_empty(), "a field for every coefficient");
                        let value = compiled::kernels::$name($($parameter),*);
                        $crate::dispatch::Output {
                            fields: dispatch!(@fields value $output),
                            relation_errors: dispatch!(@errors value $output),
                        }
                    },
                }
            ),*]
        }
    };
}
