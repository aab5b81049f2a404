//! A definition block of any text is expanded or refused with an error.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    // What Rust itself cannot split into tokens never reaches the macro.
    if let Ok(tokens) = text.parse() {
        let _ = ga_codegen::expand(tokens);
    }
});
