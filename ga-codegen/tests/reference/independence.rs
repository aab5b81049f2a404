//! That the reference shares no code with what it is to check.

use std::fs;
use std::path::Path;

#[test]
fn the_reference_takes_the_signature_from_the_crate_and_nothing_else() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/reference");
    let mut files = 0;
    for entry in fs::read_dir(&folder).expect("the folder of the reference") {
        let path = entry.expect("a file of the reference").path();
        let text = fs::read_to_string(&path).expect("a file of text");
        let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        for line in lines.filter(|line| line.contains("crate::") || line.contains("super::super")) {
            assert_eq!(line.trim(), "use crate::algebra::Signature;", "{}", path.display());
        }
        files += 1;
    }
    assert!(files >= 8, "found {files} files");
}
