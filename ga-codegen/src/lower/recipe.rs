//! Recipes: which kernel, which cost model, and rows of sums and products.

use crate::kernel::Operator;
use crate::program::{CostModel, Recipe, RecipeTerm};
use crate::symbolic::Rational;
use crate::syntax::{Name, RawExpression, RawKind, RawRow};

/// The cost model of that name.
pub(super) fn cost_model(name: &Name) -> syn::Result<CostModel> {
    let known = CostModel::ALL.into_iter().find(|model| model.name() == name.text);
    known.ok_or_else(|| {
        let names = CostModel::ALL.map(|model| format!("`{model}`")).join(", ");
        syn::Error::new(name.span, format!("expected a cost model ({names}), found `{}`", name.text))
    })
}

/// A recipe with its rows resolved as far as they can be without the kernel.
pub(super) fn recipe(kernel: &Name, model: &Name, rows: &[RawRow]) -> syn::Result<Recipe> {
    let rows = rows.iter().map(|row| Ok((row.name.clone(), term(&row.value)?))).collect::<syn::Result<_>>()?;
    Ok(Recipe { kernel: kernel.text.clone(), model: cost_model(model)?, rows, span: kernel.span })
}

fn term(raw: &RawExpression) -> syn::Result<RecipeTerm> {
    let boxed = |inner: &RawExpression| term(inner).map(Box::new);
    let other = || syn::Error::new(raw.span, "expected sums and products of coefficients, rows and numbers");
    Ok(match &raw.kind {
        RawKind::Name(name) => RecipeTerm::Name(name.clone()),
        RawKind::Field(parameter, field) => RecipeTerm::Name(format!("{parameter}.{field}")),
        RawKind::Number(number) => RecipeTerm::Number(Rational::integer(*number)),
        RawKind::Negate(inner) => RecipeTerm::Neg(boxed(inner)?),
        RawKind::Quotient(numerator, denominator) => match (&numerator.kind, &denominator.kind) {
            (RawKind::Number(n), RawKind::Number(d)) => {
                let number = Rational::new(i128::from(*n), i128::from(*d)).map_err(|_| other())?;
                RecipeTerm::Number(number)
            }
            _ => return Err(other()),
        },
        RawKind::Binary(Operator::Geometric, two, inner) if matches!(two.kind, RawKind::Number(2)) => {
            RecipeTerm::Double(boxed(inner)?)
        }
        RawKind::Binary(Operator::Add, a, b) => RecipeTerm::Add(boxed(a)?, boxed(b)?),
        RawKind::Binary(Operator::Sub, a, b) => RecipeTerm::Sub(boxed(a)?, boxed(b)?),
        RawKind::Binary(Operator::Geometric, a, b) => RecipeTerm::Mul(boxed(a)?, boxed(b)?),
        RawKind::Binary(..) | RawKind::Reverse(_) | RawKind::Call(..) => return Err(other()),
    })
}
