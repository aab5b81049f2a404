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

/// A file of one joint with these channels, and what follows `MOTION`.
fn file(channels: &str, motion: &str) -> String {
    format!("HIERARCHY\nROOT a\n{{\nOFFSET 0 0 0\nCHANNELS {channels}\n}}\nMOTION\n{motion}\n")
}

fn error(text: &str) -> String {
    bvh::parse::<f64>(text).expect_err("a file that is refused").to_string()
}

#[test]
fn hierarchies_of_any_depth_are_read_or_refused() {
    let nested = |depth: usize, closed: usize| {
        let open = "JOINT j { OFFSET 0 1 0\n".repeat(depth - 1);
        let close = "}".repeat(closed);
        format!("HIERARCHY ROOT a {{ OFFSET 0 0 0\n{open}{close}\nMOTION\nFrames: 0\nFrame Time: 1\n")
    };
    assert_eq!(bvh::parse::<f64>(&nested(60_000, 60_000)).map(|file| file.skeleton().len()).ok(), Some(60_000));
    error(&nested(100_000, 100_000));
    error(&nested(100_000, 99_999));
    error(&nested(100_000, 0));
}

#[test]
fn declared_counts_take_no_memory() {
    for count in ["4294967296", "18446744073709551615", "18446744073709551616"] {
        error(&file("1 Xrotation", &format!("Frames: {count}\nFrame Time: 1\n0")));
        error(&file("0", &format!("Frames: {count}\nFrame Time: 1\n")));
        error(&file(&format!("{count} Xrotation"), "Frames: 0\nFrame Time: 1"));
    }
}

#[test]
fn long_lines_words_and_numbers_are_read_or_refused_in_little_time() {
    let many = 1 << 18;
    let numbers = "1 ".repeat(many);
    let channels = format!("{many} {}", "Xrotation ".repeat(many));
    let long = bvh::parse::<f64>(&file(&channels, &format!("Frames: 1\nFrame Time: 1\n{numbers}")));
    assert_eq!(long.map(|file| file.channels(0).len()).ok(), Some(many));
    for text in ["1".repeat(many), "{".repeat(many), "x".repeat(many), "\n".repeat(many), "}\r".repeat(many), numbers] {
        for refused in [
            text.clone(),
            format!("HIERARCHY ROOT {text}"),
            format!("HIERARCHY ROOT a {{ OFFSET {text}"),
            file(&text, ""),
            file("1 Xrotation", &format!("Frames: 1\nFrame Time: 1\n{text}")),
        ] {
            assert!(error(&refused).len() < 400);
        }
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused_wherever_they_stand() {
    for number in ["NaN", "inf", "-inf", "infinity", "1e999", "-1e999"] {
        error(&file("1 Xrotation", &format!("Frames: 1\nFrame Time: 1\n{number}")));
        error(&file("1 Xrotation", &format!("Frames: 1\nFrame Time: {number}\n0")));
        error(&file("0", "Frames: 0\nFrame Time: 1").replace("OFFSET 0", &format!("OFFSET {number}")));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes);
        read(&text)?;
        read(&file(&text, "Frames: 1\nFrame Time: 1\n0"))?;
        read(&file("1 Xrotation", &text))?;
    }
}
