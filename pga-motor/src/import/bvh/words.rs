//! Words, names and lines of the text, with their line numbers.

use alloc::borrow::ToOwned;
use alloc::string::String;

use super::error::{BvhError, BvhReason, quote};
use crate::Real;

/// A word of the file: a brace, or what stands between white space and braces.
#[derive(Clone, Copy)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    /// Counted from 1.
    pub(super) line: usize,
}

/// A line of the file that is not blank.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) text: &'a str,
    /// Counted from 1.
    pub(super) number: usize,
}

impl<'a> Line<'a> {
    /// The words of the line; braces mean nothing here.
    pub(super) fn words(self) -> impl Iterator<Item = Word<'a>> + Clone {
        self.text.split_whitespace().map(move |text| Word { text, line: self.number })
    }
}

/// What is still to be read. Lines end in `\n`, `\r\n` or `\r`.
#[derive(Clone)]
pub(super) struct Words<'a> {
    rest: &'a str,
    line: usize,
    /// The last line on which something was found.
    last_line: usize,
}

impl Word<'_> {
    /// Keywords are written in capitals by some programs and not by others.
    pub(super) fn is(&self, keyword: &str) -> bool {
        self.text.eq_ignore_ascii_case(keyword)
    }

    pub(super) fn unexpected(&self, expected: &str) -> BvhError {
        let reason = BvhReason::UnknownKeyword { expected: expected.to_owned(), found: quote(self.text) };
        BvhError::new(self.line, reason)
    }

    /// The word as a finite number. `what` says what for, should it be none.
    pub(super) fn number<T: Real>(&self, what: impl FnOnce() -> String) -> Result<T, BvhError> {
        let fault = |reason| BvhError::new(self.line, reason);
        let Ok(number) = self.text.parse::<f64>() else {
            return Err(fault(BvhReason::NotANumber { what: what(), found: quote(self.text) }));
        };
        let number = T::from_f64(number);
        if number.is_finite() {
            Ok(number)
        } else {
            Err(fault(BvhReason::NotFinite { what: what(), found: quote(self.text) }))
        }
    }

    /// The word as a whole number from 0 up.
    pub(super) fn count(&self, what: &str) -> Result<usize, BvhError> {
        self.text.parse().map_err(|_| {
            BvhError::new(self.line, BvhReason::NotACount { what: what.to_owned(), found: quote(self.text) })
        })
    }
}

impl<'a> Words<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { rest: text.trim_start_matches('\u{feff}'), line: 1, last_line: 1 }
    }

    /// The next word without taking it.
    pub(super) fn peek(&self) -> Option<Word<'a>> {
        self.clone().next()
    }

    /// The next word; an error that names what should have come where the file ends.
    pub(super) fn expect(&mut self, expected: &str) -> Result<Word<'a>, BvhError> {
        self.next().ok_or_else(|| self.truncated(expected))
    }

    /// The next word, without taking it, if it stands on the same line as the last one.
    pub(super) fn peek_on_line(&self) -> Option<Word<'a>> {
        self.peek().filter(|word| word.line == self.last_line)
    }

    /// What stands between here and the end of the line, or a brace before it, without white space around: a name may have
    /// white space within. May be empty.
    pub(super) fn name(&mut self) -> &'a str {
        let end = self.rest.find(['\r', '\n', '{', '}']).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        name.trim()
    }

    /// What stands between here and the end of the line; of the next line that is not blank, if there is nothing.
    pub(super) fn line(&mut self) -> Option<Line<'a>> {
        self.skip_white_space();
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.find(['\r', '\n']).unwrap_or(self.rest.len());
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        self.last_line = self.line;
        Some(Line { text, number: self.line })
    }

    /// The last line on which something was found, counted from 1.
    pub(super) fn last_line(&self) -> usize {
        self.last_line
    }

    /// The error of a file that ends here.
    pub(super) fn truncated(&self, expected: &str) -> BvhError {
        BvhError::new(self.last_line, BvhReason::Truncated { expected: expected.to_owned() })
    }

    fn skip_white_space(&mut self) {
        let rest = self.rest.trim_start();
        let skipped = &self.rest[..self.rest.len() - rest.len()];
        // A line ends at every `\n`, and at every `\r` that has none after it.
        let mut characters = skipped.chars().peekable();
        while let Some(character) = characters.next() {
            self.line += usize::from(character == '\n' || (character == '\r' && characters.peek() != Some(&'\n')));
        }
        self.rest = rest;
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        self.skip_white_space();
        let is_brace = |character| matches!(character, '{' | '}');
        let end = match self.rest.chars().next()? {
            first if is_brace(first) => 1,
            _ => self.rest.find(|c: char| is_brace(c) || c.is_whitespace()).unwrap_or(self.rest.len()),
        };
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        self.last_line = self.line;
        Some(Word { text, line: self.line })
    }
}
