//! Checks anybody's code against a definition in geometric algebra.
//!
//! A [`Check`] holds a definition, such as `m >> p`, and strategies for what its names stand for. It hands random
//! values to your function and compares the answer with the definition, worked out on the naive
//! [`reference`](mod@crate::reference), which shares no code with the generator. Where they differ it shrinks the
//! values and reports a [`Counterexample`]: the inputs as blades, both results, and the first coefficient that differs.
//!
//! Here is a reflection of a point in a plane, written by hand with one wrong sign, and the line that finds it:
//!
//! ```
//! use ga_codegen::check::{Check, strategies::{planes, points}};
//! use ga_codegen::{algebra::Signature, reference::Multivector};
//!
//! const PGA3D: Signature = Signature::new(3, 0, 1);
//!
//! /// The mirror image of a point in the unit plane a x + b y + c z + d = 0.
//! fn mirror(plane: &Multivector<f64>, point: &Multivector<f64>) -> [(&'static str, f64); 4] {
//!     let [a, b, c, d] = ["e1", "e2", "e3", "e0"].map(|word| plane.coefficient(word));
//!     let [x, y, z] = ["e032", "e013", "e021"].map(|word| point.coefficient(word));
//!     let twice = 2.0 * (a * x + b * y + c * z - d); // + d was meant
//!     [("e123", 1.0), ("e032", x - twice * a), ("e013", y - twice * b), ("e021", z - twice * c)]
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let check = Check::new(PGA3D, "a * p * a")?.input("a", planes()).input("p", points());
//! let error = check.run(|[a, p]| mirror(a, p)).expect_err("a wrong sign");
//! assert_eq!(
//!     error.to_string(),
//!     "expected the value of `a * p * a`, found another at
//!     a = e0 + e1
//!     p = e123
//! expected: 2 e023 + e123
//! found:    -2 e023 + e123
//! first difference: expected 2 in e023, found -2 (allowed: 2.66e-15)"
//! );
//! # Ok(())
//! # }
//! ```
//!
//! In a test it is one line, `.assert(|[a, p]| mirror(a, p))` in place of `.run`.
//!
//! # Definitions
//!
//! An expression of [`expand`](fn@crate::expand)'s grammar: `*`, `^`, `&`, `|`, `>>`, `~`, `dual(x)`, `grade(x, 2)` and so
//! on. `e` and digits is a blade, its generators in any order; every other name is an input.
//!
//! In floating point it may be `exp(...)`, `log(...)`, `normalize(...)` or `sqrt(...)` of such an expression. Inputs outside
//! the function's domain are an error, [`Undefined`], never a pass: -1 has no logarithm, nor has what is no unit, and 0
//! has no norm to divide by.
//!
//! ```
//! use ga_codegen::check::strategies::pga2d::{PGA2D, bivectors};
//! use ga_codegen::check::{Check, CheckError, DomainError};
//! use ga_codegen::reference::Multivector;
//!
//! /// The motion that a bivector generates.
//! fn exp(bivector: &Multivector<f64>) -> Multivector<f64> {
//!     let norm = bivector.norm();
//!     let sinc = if norm == 0.0 { 1.0 } else { norm.sin() / norm };
//!     bivector.scale(sinc).add(&Multivector::scalar(PGA2D, norm.cos()))
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! Check::new(PGA2D, "exp(b)")?.input("b", bivectors()).assert(|[b]| exp(b));
//!
//! // A bivector is no unit, as a rule.
//! let error = Check::<f64>::new(PGA2D, "log(b)")?.input("b", bivectors()).run(|[b]| exp(b));
//! let Err(CheckError::Undefined(undefined)) = error else { panic!("expected an input without a logarithm") };
//! assert_eq!(undefined.reason, DomainError::Unit { blade: "1".to_owned() });
//! # Ok(())
//! # }
//! ```
//!
//! # Tolerance
//!
//! See [`Tolerance`]: exact for exact coefficients, such as [`Fraction`], derived from a running error bound for floats.
//!
//! # Determinism
//!
//! The same check sees the same values in every run, see [`Check::seed`]. Nothing is written to files.

mod closed_form;
mod coefficient;
mod counterexample;
mod definition;
mod fraction;
mod interpreter;
pub mod strategies;
mod tolerance;
mod undefined;

pub use coefficient::Coefficient;
pub use counterexample::{CheckError, Counterexample, Fault, InputError};
pub use definition::DefinitionError;
pub use fraction::Fraction;
pub use tolerance::{Difference, Tolerance};
pub use undefined::{DomainError, Undefined};

use std::cell::RefCell;
use std::mem::discriminant;
use std::panic::{AssertUnwindSafe, catch_unwind};

use proptest::strategy::{BoxedStrategy, Strategy};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

use crate::algebra::Signature;
use crate::reference::{Multivector, ReferenceError};
use coefficient::Running;
use definition::Definition;

/// What an implementation may answer: a multivector, or words with their coefficients.
pub trait Answer<T> {
    /// The answer as a multivector.
    ///
    /// # Errors
    /// A word that is no blade of the signature.
    fn into_multivector(self, signature: Signature) -> Result<Multivector<T>, ReferenceError>;
}

impl<T> Answer<T> for Multivector<T> {
    fn into_multivector(self, _: Signature) -> Result<Self, ReferenceError> {
        Ok(self)
    }
}

impl<T: Coefficient, W: AsRef<str>, const N: usize> Answer<T> for [(W, T); N] {
    fn into_multivector(self, signature: Signature) -> Result<Multivector<T>, ReferenceError> {
        Multivector::from_blades(signature, self)
    }
}

impl<T: Coefficient, W: AsRef<str>> Answer<T> for Vec<(W, T)> {
    fn into_multivector(self, signature: Signature) -> Result<Multivector<T>, ReferenceError> {
        Multivector::from_blades(signature, self)
    }
}

/// Names that one strategy gives values to.
struct Group<T: Coefficient> {
    names: Vec<String>,
    values: BoxedStrategy<Vec<Multivector<T>>>,
}

/// A definition, and what its names stand for. See the [module](self) for an example.
pub struct Check<T: Coefficient> {
    definition: Definition,
    groups: Vec<Group<T>>,
    tolerance: Option<Tolerance>,
    cases: u32,
    seed: u64,
}

impl<T: Coefficient> Check<T> {
    /// A check of this definition.
    ///
    /// # Errors
    /// A text that is no expression, a blade that the signature does not have, a signature of too many dimensions; with
    /// its column.
    ///
    /// ```
    /// use ga_codegen::{algebra::Signature, check::Check};
    ///
    /// let error = Check::<f64>::new(Signature::new(3, 0, 1), "m * p * m)").err().expect("one parenthesis too many");
    /// assert_eq!(error.to_string(), "expected parentheses in pairs, found one without its other at column 10");
    /// ```
    pub fn new(signature: Signature, definition: &str) -> Result<Self, DefinitionError> {
        let definition = Definition::parse(signature, definition)?;
        Ok(Self { definition, groups: Vec::new(), tolerance: None, cases: 256, seed: 0 })
    }

    /// Values for a name of the definition. The function under test gets its inputs in the order of these calls.
    pub fn input(self, name: &str, values: impl Strategy<Value = Multivector<T>> + 'static) -> Self {
        self.inputs([name], values.prop_map(|value| [value]))
    }

    /// Values for several names at once, for such as depend on each other: a motor and its negative.
    pub fn inputs<const N: usize>(
        mut self,
        names: [&str; N],
        values: impl Strategy<Value = [Multivector<T>; N]> + 'static,
    ) -> Self {
        let names = names.map(str::to_owned).to_vec();
        self.groups.push(Group { names, values: values.prop_map(Vec::from).boxed() });
        self
    }

    /// How far the answer may be off; without it, exact for exact coefficients and derived for floats.
    pub fn tolerance(mut self, tolerance: Tolerance) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// The number of cases, without it 256.
    pub fn cases(mut self, cases: u32) -> Self {
        self.cases = cases;
        self
    }

    /// The seed of the random values, without it 0.
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// Compares a function with the definition.
    ///
    /// # Errors
    /// A [`Counterexample`], as small as shrinking makes it; inputs at which the definition has no value, likewise; inputs
    /// that do not fit the definition; strategies that reject nearly everything. A panic of the function counts as a wrong
    /// answer.
    pub fn run<const N: usize, A: Answer<T>>(
        &self,
        function: impl Fn([&Multivector<T>; N]) -> A,
    ) -> Result<(), CheckError<T>> {
        let names: Vec<&String> = self.groups.iter().flat_map(|group| &group.names).collect();
        self.check_names(&names)?;
        if names.len() != N {
            return Err(InputError::Count { inputs: names.len(), parameters: N }.into());
        }
        if let Some(function) = self.definition.function.filter(|_| T::from_f64(0.0).is_none()) {
            return Err(InputError::Function { function: function.name().to_owned() }.into());
        }
        let worst = RefCell::new(None);
        let strategies: Vec<_> = self.groups.iter().map(|group| group.values.clone()).collect();
        let outcome = self.runner().run(&strategies, |values| {
            let inputs: Vec<_> = names.iter().map(|name| (*name).clone()).zip(values.into_iter().flatten()).collect();
            let Err(error) = self.case(inputs, &function) else { return Ok(()) };
            let mut worst = worst.borrow_mut();
            // Where shrinking leads to an error of another kind, it goes back.
            if worst.as_ref().is_some_and(|other| discriminant(other) != discriminant(&error)) {
                return Ok(());
            }
            *worst = Some(error);
            Err(TestCaseError::fail("a difference"))
        });
        match (outcome, worst.into_inner()) {
            (Ok(()), _) => Ok(()),
            (Err(TestError::Fail(..)), Some(error)) => Err(error),
            (Err(TestError::Fail(reason, _) | TestError::Abort(reason)), _) => {
                Err(CheckError::Exhausted(reason.to_string()))
            }
        }
    }

    /// As [`Check::run`], for a line in a test.
    ///
    /// # Panics
    /// With the text of the error, where [`Check::run`] gives one.
    #[track_caller]
    pub fn assert<const N: usize, A: Answer<T>>(&self, function: impl Fn([&Multivector<T>; N]) -> A) {
        if let Err(error) = self.run(function) {
            panic!("{error}");
        }
    }

    fn runner(&self) -> TestRunner {
        let config = Config { cases: self.cases, failure_persistence: None, ..Config::default() };
        let mut seed = [0; 32];
        seed[..8].copy_from_slice(&self.seed.to_le_bytes());
        TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
    }

    /// Every name of the definition has values once, and no other name has.
    fn check_names(&self, given: &[&String]) -> Result<(), InputError> {
        let known = &self.definition.names;
        for (position, name) in given.iter().enumerate() {
            if !known.contains(name) {
                return Err(InputError::Unknown { name: (*name).clone(), known: known.clone() });
            }
            if given[..position].contains(name) {
                return Err(InputError::Repeated { name: (*name).clone() });
            }
        }
        match known.iter().find(|name| !given.contains(name)) {
            Some(name) => Err(InputError::Missing { name: name.clone() }),
            None => Ok(()),
        }
    }

    fn case<const N: usize, A: Answer<T>>(
        &self,
        inputs: Vec<(String, Multivector<T>)>,
        function: impl Fn([&Multivector<T>; N]) -> A,
    ) -> Result<(), CheckError<T>> {
        let signature = self.definition.signature;
        if let Some((name, value)) = inputs.iter().find(|(_, value)| value.signature() != signature) {
            let (name, found) = (name.clone(), value.signature());
            return Err(InputError::Signature { name, expected: signature, found }.into());
        }
        let expected = match self.definition.value(&inputs)? {
            Ok(expected) => expected,
            Err(reason) => {
                let definition = self.definition.text.clone();
                return Err(CheckError::Undefined(Box::new(Undefined { definition, inputs, reason })));
            }
        };
        let references: Vec<_> = inputs.iter().map(|(_, value)| value).collect();
        let Ok(arguments) = <[&Multivector<T>; N]>::try_from(references) else {
            return Err(InputError::Count { inputs: inputs.len(), parameters: N }.into());
        };
        let tolerance = self.tolerance.unwrap_or_default();
        let (found, difference) = match answer(signature, || function(arguments)) {
            Err(fault) => (Err(fault), None),
            Ok(found) => match tolerance.difference(&expected, &found) {
                None => return Ok(()),
                difference => (Ok(found), difference),
            },
        };
        let definition = self.definition.text.clone();
        let expected = coefficient::values(&expected);
        Err(CheckError::Counterexample(Box::new(Counterexample { definition, inputs, expected, found, difference })))
    }
}

/// What the function under test answers, if it is a multivector of the signature.
fn answer<T: Coefficient, A: Answer<T>>(
    signature: Signature,
    function: impl FnOnce() -> A,
) -> Result<Multivector<T>, Fault> {
    let answer = caught(function).map_err(Fault::Panic)?;
    let found = answer.into_multivector(signature).map_err(Fault::Blade)?;
    if found.signature() == signature {
        Ok(found)
    } else {
        Err(Fault::Signature { expected: signature, found: found.signature() })
    }
}

/// What a function returns, or the text that it panicked with.
fn caught<V>(function: impl FnOnce() -> V) -> Result<V, String> {
    catch_unwind(AssertUnwindSafe(function)).map_err(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        text.or(payload.downcast_ref::<&str>().copied()).unwrap_or("no text").to_owned()
    })
}

/// The value of a definition with its error bound, if it has one.
type Valued<T> = Result<Multivector<Running<T>>, DomainError>;

impl Definition {
    /// The value of the definition on the reference.
    fn value<T: Coefficient>(&self, inputs: &[(String, Multivector<T>)]) -> Result<Valued<T>, InputError> {
        let value = |name| inputs.iter().find(|(other, _)| other == name).map(|(_, value)| coefficient::running(value));
        let values: Option<Vec<_>> = self.names.iter().map(value).collect();
        let values = values.expect("invariant: every name has a value, `check_names` has seen to it");
        let result = caught(|| {
            let argument = interpreter::evaluate(&self.expression, &values, self.signature)?;
            Ok(match self.function {
                None => Ok(argument),
                Some(function) => closed_form::apply(function, &argument),
            })
        });
        result.unwrap_or_else(|text| Ok(Err(DomainError::Panic(text))))
    }
}
