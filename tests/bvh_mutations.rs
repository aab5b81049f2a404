//! Whatever is done to a BVH file, it is read or refused: never a panic, and never a pose that kinematics chokes on.

use pga_motor::Motor;
use pga_motor::import::bvh;
use pga_motor::skeleton::local_to_model;
use proptest::prelude::*;
use proptest::sample::{Index, select};

const VALID: &str = include_str!("data/marionette.bvh");

/// Pieces that mean something to the format, or to a careless reader of it.
const PIECES: &[&str] = &[
    "HIERARCHY",
    "ROOT",
    "JOINT x",
    "End Site",
    "OFFSET",
    "CHANNELS",
    "MOTION",
    "Frames:",
    "Frame Time:",
    "{",
    "}",
    ":",
    "Xposition",
    "Zrotation",
    "\n",
    "\r",
    "\t",
    " ",
    "0",
    "1",
    "-1",
    "6",
    "99999999999",
    "184467440737095516160",
    "NaN",
    "-inf",
    "1e999",
    "1e308",
    "1e-999",
    "0x10",
    "1,5",
    "\u{feff}",
    "\0",
    "\u{85}",
    "é",
    "𝕛",
];

#[derive(Clone, Debug)]
enum Mutation {
    Insert(Index, &'static str),
    Remove(Index, usize),
    /// Takes a range of lines and puts it somewhere else as well.
    Repeat(Index, usize, Index),
    Swap(Index, Index),
    Truncate(Index),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let index = any::<Index>;
    prop_oneof![
        4 => (index(), select(PIECES)).prop_map(|(at, piece)| Mutation::Insert(at, piece)),
        3 => (index(), 1..30_usize).prop_map(|(at, length)| Mutation::Remove(at, length)),
        2 => (index(), 1..12_usize, index()).prop_map(|(from, lines, to)| Mutation::Repeat(from, lines, to)),
        2 => (index(), index()).prop_map(|(a, b)| Mutation::Swap(a, b)),
        1 => index().prop_map(Mutation::Truncate),
    ]
}

fn mutate(text: &str, mutation: &Mutation) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    match mutation {
        Mutation::Insert(at, piece) => {
            let at = at.index(characters.len() + 1);
            characters.splice(at..at, piece.chars());
        }
        Mutation::Remove(at, length) => {
            let at = at.index(characters.len() + 1);
            characters.drain(at..characters.len().min(at + length));
        }
        Mutation::Truncate(at) => characters.truncate(at.index(characters.len() + 1)),
        Mutation::Repeat(from, count, to) => {
            let from = from.index(lines.len() + 1);
            let piece = lines[from..lines.len().min(from + count)].to_vec();
            let to = to.index(lines.len() + 1);
            lines.splice(to..to, piece);
            return lines.concat();
        }
        Mutation::Swap(a, b) if !lines.is_empty() => {
            let [a, b] = [a, b].map(|index| index.index(lines.len()));
            lines.swap(a, b);
            return lines.concat();
        }
        Mutation::Swap(..) => {}
    }
    characters.into_iter().collect()
}

/// Reads the text; where that succeeds, every frame must pose the skeleton, and where it fails, the line must exist.
fn read(text: &str) -> Result<(), TestCaseError> {
    let file = match bvh::parse::<f32>(text) {
        Ok(file) => file,
        Err(error) => {
            let lines = text.split(['\n', '\r']).count();
            prop_assert!((1..=lines).contains(&error.line()), "{error}");
            return Ok(());
        }
    };
    let mut locals = vec![Motor::IDENTITY; file.skeleton().len()];
    let mut model = locals.clone();
    for frame in 0..file.frame_count() {
        prop_assert!(file.pose_into(frame, &mut locals).is_ok());
        prop_assert!(local_to_model(file.skeleton(), &locals, &mut model).is_ok());
    }
    prop_assert!(file.pose_into(file.frame_count(), &mut locals).is_err());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_are_read_or_refused(mutations in prop::collection::vec(mutation(), 1..5)) {
        let text = mutations.iter().fold(VALID.to_owned(), |text, mutation| mutate(&text, mutation));
        read(&text)?;
    }

    #[test]
    fn words_in_any_order_are_read_or_refused(pieces in prop::collection::vec(select(PIECES), 0..40)) {
        read(&pieces.join(" "))?;
        read(&format!("HIERARCHY ROOT a {{ OFFSET 0 0 0 {} }} MOTION\nFrames: 0\nFrame Time: 1", pieces.join(" ")))?;
    }
}

#[test]
fn the_file_to_mutate_is_valid() {
    assert!(bvh::parse::<f64>(VALID).is_ok());
}
