//! A sum of blades of any text is read or refused, and what was read is printed and read again as the same.
#![no_main]

use ga_codegen::algebra::Signature;
use ga_codegen::reference::Multivector;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let signature = Signature::new(3, 0, 1);
    if let Ok(multivector) = Multivector::<f64>::parse(signature, text) {
        let again = Multivector::<f64>::parse(signature, &multivector.to_string());
        assert_eq!(again.expect("what is printed can be read"), multivector, "{multivector}");
    }
});
