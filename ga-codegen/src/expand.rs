//! The whole pipeline on one page: parse, lower, compile (specify, factor, prove), emit.

use crate::compile::compile;
use crate::emit;
use crate::errors::Errors;
use crate::kernel::{self, Definition};
use crate::lower::lower;
use crate::syntax::parse;
use proc_macro2::TokenStream;

/// Expands a definition block into Rust: entities, kernels as functions, operators.
///
/// Nothing unproved is emitted: every program is evaluated back to polynomials or power series and compared with its
/// definition.
///
/// # Grammar
/// ```text
/// block     := item*
/// item      := "signature" "(" p "," q "," r ")" ";"
///            | "basis" ( BLADE | NAME "=" BLADE )* ";"
///            | DOC* "entity" NAME "{" component,* "}" ( ";" | "where" relation,+ ";" )?
///            | DOC* "kernel" NAME "(" ( "uniform"? NAME ":" ENTITY ),* ")" "->" ENTITY "=" expression
///                   ( "where" relation,+ )? ( "cost" MODEL,+ )? "packed"? ( "polynomial" PRECISION,+ )?
///                   ( "hoist" STRUCT "," PREPARE "," APPLY )? ";"
///            | "recipe" KERNEL MODEL "{" ( ROW "=" value ";" )* "}"
///            | "recipe" KERNEL "packed" "{" ( ( ROW | "out" four( FIELD | "_" ) ) "=" packed ";" )* "}"
///            | "preset" NAME ";"       the items of a preset, in place
///            | "scalar" PATH ";"       the module that has the traits Scalar and Real, where a kernel is packed also Four; emitted too
///                                      where it is not given
///            | "export" NAME ";"       exports the list of kernels as the macro NAME_kernels
/// component := FIELD ":" BLADE | BLADE | NUMBER ":" BLADE
/// relation  := polynomial "==" polynomial
/// packed    := four( COEFFICIENT | NUMBER ) | ROW | "(" packed ")" | packed four( "-"? LANE ) | "2" "*" packed
///            | packed "*" packed | packed ( "+" | "-" ) packed
/// four(x)   := "[" x "," x "," x "," x "]"
/// ```
/// - A blade is `1` or `e` with the indices of generators: see [`Signature`](crate::algebra::Signature) for their
///   squares. The basis lists every blade once, in any order and orientation (`e31` is -`e13`), under another name if wanted
///   (`i = e12`); without it blades are ascending.
/// - A component is a field of the struct, or a fixed number (`1: e123`, the weight of a point). `Scalar` is the entity
///   of plain numbers.
/// - A relation is a polynomial identity between the fields, or in a kernel between `parameter.field`s. It is rewritten at its
///   first monomial, and all of a kernel's relations must have unique normal forms; where they do not, write another
///   monomial first.
/// - Expressions have the operators `~` (reverse) and `-`; `*` (geometric product) and `/` (by a whole number); `+`, `-`; `>>`
///   (sandwich: `m >> x` is `m * x * ~m`); `&` (regressive product, join); `^` (outer product, meet); `|` (inner product), which
///   bind as in Rust, the first the tightest; and the functions `dual`, `undual`, `grade(x, k)`, `grade_involution`,
///   `clifford_conjugate`, `left_contraction`, `right_contraction`, `scalar_product`, `commutator`, `anticommutator`. Around the
///   whole definition may stand `exp` of a bivector, `log` of a parameter, `normalize` of what is a unit up to a Study number
///   (so that x ~x = 1 comes of it), or `sqrt` of a unit, the root next to the identity.
///
/// - A cost model is `flops` (the default), `fma` or `latency`, see [`CostModel`](crate::program::CostModel). A kernel is
///   emitted once for each of its models: under its name for the first, with `_MODEL` behind it for the others.
/// - A `packed` kernel is emitted on values of four lanes as well, as `NAME_packed`. Its operator calls that for numbers whose
///   `Four::IS_FAST`. The program must be given as a packed recipe. In one, `[a.s, a.x, 0, 1]` loads four coefficients or
///   numbers, `v[1, 1, 2, 3]` has in its lanes these lanes of v, negated where a minus stands before them, and
///   `out[x, y, _, _] = v` says which fields of the output the lanes of v are.
/// - `polynomial f32, f64` asks for versions of exp and log without roots, divisions, branches and library calls, for loops over
///   many: NAME_f32 and NAME_f64, and NAME_f32_holds and so on, which say for which inputs they hold.
/// - A kernel with `uniform` inputs, those that stay the same over many calls, is emitted in two parts as well: a function
///   from them to a struct, and one, linear in the other inputs, from the struct to the output.
/// - A recipe is what a search left behind, a program row by row. Expansion replays and proves it instead of searching.
///
/// # Limits
/// What is larger than this is refused at the token to blame, so that no block takes long, much memory or a deep stack. The
/// presets are far below:
/// - brackets nested 300 deep; 300 operators and parentheses around a part of an expression, or terms in a row;
/// - 2048 items, those of presets included; 4096 parts of a list or rows of a recipe; 4096 input coefficients of a kernel;
/// - 10000 operations of an emitted program;
/// - 5 million steps for each of three stages, names and relations, kernels, entities: terms that are multiplied, added,
///   rewritten or compared. Seconds, where nothing is optimised;
/// - 100 errors that are reported, the first ones of a stage.
///
/// # What comes out
/// A struct for every entity, with what its components and relations allow (a linear type adds, a type with a 1 has an
/// identity); a function for every kernel in a module `kernels`; `impl Mul` and so on for kernels whose definition is an
/// operator between their two parameters, `impl From` for those whose definition is their parameter.
///
/// # Errors
/// What is wrong with the block, by stage: first its syntax; if that is right, names, arities and relations, then the
/// relations' degrees in the unit of length; if those are right, meanings and proofs of the kernels, such as an output
/// that cannot hold the result. All errors of a stage are combined, each at the token to blame.
pub fn expand(input: TokenStream) -> syn::Result<TokenStream> {
    let definition = define(input)?;
    let compiled = compile(&definition)?;
    emit::rust(&definition, &compiled)
}

/// Parses a definition block and resolves its names.
///
/// # Errors
/// What is wrong with the block up to there, by stage as in [`expand`].
pub fn define(input: TokenStream) -> syn::Result<Definition> {
    let definition = lower(&parse(input)?)?;
    let mut errors = Errors::default();
    for (span, inhomogeneous) in kernel::check_relations(&definition) {
        errors.push(span, inhomogeneous);
    }
    errors.into_result(definition)
}
