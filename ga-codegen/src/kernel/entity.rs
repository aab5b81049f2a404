//! Types of multivectors: which blades they have, which of the coefficients are free, and what holds between them.

use crate::algebra::{Blade, Sign};
use crate::symbolic::{Multivector, Overflow, Polynomial, Rational, Relation, Symbol};
use proc_macro2::Span;

/// What stands before a blade of an entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ComponentValue {
    /// A field of the struct.
    Field(String),
    /// A fixed number, such as the weight of a normalised point.
    Constant(Rational),
}

/// A blade of an entity and its coefficient.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Component {
    /// The coefficient.
    pub value: ComponentValue,
    /// The name of the blade.
    pub name: String,
    /// The blade in ascending order.
    pub blade: Blade,
    /// The orientation of the blade's name.
    pub sign: Sign,
}

/// A relation as it is written.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The relation.
    pub relation: Relation,
    /// Its text, such as `s s = 1 - e12 e12`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A type of multivectors. Its symbols are numbered by its fields, from 0.
#[derive(Clone, Debug)]
pub struct Entity {
    /// The name.
    pub name: String,
    /// Documentation lines.
    pub docs: Vec<String>,
    /// The components in the order of the struct's fields.
    pub components: Vec<Component>,
    /// What holds between the fields.
    pub statements: Vec<Statement>,
    /// Where the name stands.
    pub span: Span,
}

impl Entity {
    /// The built-in entity of plain numbers, emitted as the bare scalar type.
    pub const SCALAR: &'static str = "Scalar";

    /// The built-in scalar entity.
    pub fn scalar() -> Self {
        let value = ComponentValue::Field(String::new());
        Self {
            name: Self::SCALAR.to_owned(),
            docs: Vec::new(),
            components: vec![Component { value, name: "1".to_owned(), blade: Blade::SCALAR, sign: Sign::Plus }],
            statements: Vec::new(),
            span: Span::call_site(),
        }
    }

    /// Whether this is the built-in scalar.
    pub fn is_scalar(&self) -> bool {
        self.name == Self::SCALAR
    }

    /// Whether the type is a linear space: every coefficient free, nothing promised.
    pub fn is_linear(&self) -> bool {
        self.statements.is_empty() && self.fields().count() == self.components.len() && !self.is_scalar()
    }

    /// The components that are fields, with the fields' names.
    pub fn fields(&self) -> impl Iterator<Item = (&str, &Component)> {
        self.components.iter().filter_map(|component| match &component.value {
            ComponentValue::Field(name) => Some((name.as_str(), component)),
            ComponentValue::Constant(_) => None,
        })
    }

    /// The relations, over the entity's own symbols.
    pub fn relations(&self) -> Vec<Relation> {
        self.statements.iter().map(|statement| statement.relation.clone()).collect()
    }

    /// The multivector of an instance whose fields are these polynomials.
    pub fn multivector(&self, fields: &[Polynomial]) -> Multivector {
        let mut fields = fields.iter();
        let term = |component: &Component| {
            let value = match &component.value {
                ComponentValue::Field(_) => fields.next().cloned().unwrap_or_default(),
                ComponentValue::Constant(value) => Polynomial::constant(*value),
            };
            (component.blade, value.signed(component.sign))
        };
        Multivector::from_terms(self.components.iter().map(term).collect::<Vec<_>>())
    }

    /// The multivector of an instance whose fields are the symbols from `first` on.
    pub fn symbolic(&self, first: Symbol) -> Multivector {
        let fields: Vec<_> = (0..self.fields().count()).map(|i| Polynomial::symbol(first + i as Symbol)).collect();
        self.multivector(&fields)
    }

    /// The values that the relations' polynomials take on an instance with these fields.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn relation_values(&self, fields: &[Polynomial]) -> Result<Vec<Polynomial>, Overflow> {
        self.statements.iter().map(|statement| statement.relation.polynomial().substitute(fields)).collect()
    }
}
