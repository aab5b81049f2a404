//! Addresses of buffers: data in the address itself, and files beside the file.

use alloc::string::String;
use alloc::vec::Vec;

use super::error::GltfReason;
use super::place::quote;

/// What an address is before anything is done about it.
pub(super) fn data(uri: &str) -> Option<Result<Vec<u8>, GltfReason>> {
    let rest = uri.get(..5).filter(|scheme| scheme.eq_ignore_ascii_case("data:")).and(uri.get(5..))?;
    let fault = |expected| GltfReason::Uri { expected, found: quote(uri) };
    let Some((head, text)) = rest.split_once(',') else {
        return Some(Err(fault("a comma before the data of a data address")));
    };
    let is_base64 = head.rsplit(';').next().is_some_and(|last| last.eq_ignore_ascii_case("base64"));
    Some(if is_base64 {
        decode_base64(text).ok_or_else(|| fault("data of base 64"))
    } else {
        decode_percent(text).ok_or_else(|| fault("two hexadecimal digits after every percent sign"))
    })
}

/// The path of a file in the folder of the glTF file, or below it, that an address names.
///
/// Refused are addresses with a scheme, absolute ones, and ones that go up, whatever is escaped in them.
pub(super) fn path_beside(uri: &str) -> Result<String, GltfReason> {
    let expected = "the path of a file beside the glTF file or below its folder";
    let fault = || GltfReason::Uri { expected, found: quote(uri) };
    let path = decode_percent(uri).and_then(|bytes| String::from_utf8(bytes).ok()).ok_or_else(fault)?;
    // A colon is that of a scheme or of a drive. Where backslashes do not part folders, no exporter puts them into names.
    let is_odd = path.is_empty() || path.contains([':', '\\', '\0']);
    let leaves = path.starts_with('/') || path.split('/').any(|part| part == "..");
    if is_odd || leaves { Err(fault()) } else { Ok(path) }
}

/// Bytes from base 64 with or without padding, `None` for anything else.
fn decode_base64(text: &str) -> Option<Vec<u8>> {
    let digits = text.trim_end_matches('=');
    if text.len() - digits.len() > 2 || digits.len() % 4 == 1 {
        return None;
    }
    let mut bytes = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    for group in digits.as_bytes().chunks(4) {
        let mut word = 0u32;
        for (place, &digit) in group.iter().enumerate() {
            word |= sextet(digit)? << (18 - 6 * place);
        }
        // The first byte of the four is empty; of the others, one fewer than there were digits.
        bytes.extend_from_slice(&word.to_be_bytes()[1..group.len()]);
    }
    Some(bytes)
}

fn sextet(digit: u8) -> Option<u32> {
    let value = match digit {
        b'A'..=b'Z' => digit - b'A',
        b'a'..=b'z' => digit - b'a' + 26,
        b'0'..=b'9' => digit - b'0' + 52,
        b'+' | b'-' => 62,
        b'/' | b'_' => 63,
        _ => return None,
    };
    Some(value.into())
}

/// Bytes from text in which some are escaped as `%20`.
fn decode_percent(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let mut digit = || rest.next().and_then(|digit| char::from(digit).to_digit(16));
        bytes.push(if byte == b'%' { u8::try_from(digit()? * 16 + digit()?).ok()? } else { byte });
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64_is_decoded_to_the_last_byte() {
        // The examples of RFC 4648, section 10, with padding and without.
        for (text, bytes) in [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmFy", "foobar")] {
            assert_eq!(decode_base64(text).as_deref(), Some(bytes.as_bytes()));
            assert_eq!(decode_base64(text.trim_end_matches('=')).as_deref(), Some(bytes.as_bytes()));
        }
        assert_eq!(decode_base64("+/-_").as_deref(), Some(&[0xfb, 0xff, 0xbf][..]));
        for text in ["Z", "Zm9vY", "Zm 9", "Z===", "Zg=v", "ä"] {
            assert_eq!(decode_base64(text), None, "{text}");
        }
    }

    #[test]
    fn paths_stay_below_the_folder() {
        let path = |uri| path_beside(uri).ok();
        assert_eq!(path("walk.bin").as_deref(), Some("walk.bin"));
        assert_eq!(path("./data/my%20walk.bin").as_deref(), Some("./data/my walk.bin"));
        assert_eq!(path("a..b/c.bin").as_deref(), Some("a..b/c.bin"));
        for uri in [
            "",
            "/etc/passwd",
            "../walk.bin",
            "data/../../walk.bin",
            "%2e%2e/walk.bin",
            "..%2Fwalk.bin",
            "%2Fetc/passwd",
            "file:///etc/passwd",
            "https://example.org/walk.bin",
            "C:/walk.bin",
            "..\\walk.bin",
            "walk%00.bin",
            "walk%zz.bin",
            "walk%2",
            "walk%ff.bin",
        ] {
            assert_eq!(path(uri), None, "{uri}");
        }
    }
}
