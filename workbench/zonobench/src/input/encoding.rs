//! The text of a file: UTF-8 or UTF-16, with or without byte order mark, lines that end in any of three ways.

use std::borrow::Cow;

use super::error::Problem;

/// The text of a content without its byte order mark, as UTF-8 where the mark says that it is UTF-16, each line ending
/// in a line feed. Bytes that are no UTF-8 stay as they are: they may stand where nothing is read.
pub(super) fn text(content: &[u8]) -> Result<Cow<'_, [u8]>, Problem> {
    let named = |name: &str| Err(Problem::Encoding(name.to_owned()));
    Ok(with_line_feeds(match content {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => return named("in UTF-32"),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(from_utf_16(rest, u16::from_le_bytes)?),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(from_utf_16(rest, u16::from_be_bytes)?),
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        _ if is_utf_16_without_mark(content) => return named("in UTF-16 without a byte order mark"),
        _ => Cow::Borrowed(content),
    }))
}

fn from_utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<Vec<u8>, Problem> {
    let (units, rest) = bytes.as_chunks::<2>();
    let text: Result<String, _> = char::decode_utf16(units.iter().map(|&bytes| unit(bytes))).collect();
    match (text, rest) {
        (Ok(text), []) => Ok(text.into_bytes()),
        _ => Err(Problem::Encoding("marked as UTF-16, which it is not throughout".to_owned())),
    }
}

/// Every other byte at the beginning is zero, as in a text of Latin letters.
fn is_utf_16_without_mark(content: &[u8]) -> bool {
    let begins = &content[..content.len().min(64)];
    let zeros = |parity: usize| begins.iter().skip(parity).step_by(2).filter(|&&byte| byte == 0).count();
    let pairs = begins.len() / 2;
    pairs >= 2 && ((zeros(0) == pairs && zeros(1) == 0) || (zeros(1) == pairs && zeros(0) == 0))
}

/// A carriage return without a line feed ends a line as well.
fn with_line_feeds(mut text: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    let is_alone = |text: &[u8], index: usize| text[index] == b'\r' && text.get(index + 1) != Some(&b'\n');
    if let Some(first) = (0..text.len()).find(|&index| is_alone(&text, index)) {
        let text = text.to_mut();
        (first..text.len()).for_each(|index| {
            if is_alone(text, index) {
                text[index] = b'\n';
            }
        });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_tell_the_encoding() {
        let wide = |mark: u16, order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            std::iter::once(mark).chain("x,é\r\n".encode_utf16()).flat_map(order).collect()
        };
        let expected = "x,é\r\n".as_bytes();
        for content in [wide(0xfeff, u16::to_le_bytes), wide(0xfeff, u16::to_be_bytes), "\u{feff}x,é\r\n".into()] {
            assert_eq!(text(&content).expect("a text"), expected);
        }
        let complaint = |content: &[u8]| text(content).expect_err("no text").to_string();
        for order in [u16::to_le_bytes, u16::to_be_bytes] {
            let unmarked: Vec<u8> = "1,2\n".encode_utf16().flat_map(order).collect();
            assert!(complaint(&unmarked).contains("UTF-16 without a byte order mark"));
        }
        assert!(complaint(b"\xff\xfe\0\0x\0\0\0").contains("UTF-32"));
        assert!(complaint(b"\xff\xfex").contains("UTF-16"));
        assert!(complaint(b"\xff\xfe\x00\xd8").contains("UTF-16"));
    }

    #[test]
    fn lines_end_in_any_of_three_ways() {
        assert_eq!(text(b"a\rb\r\nc\n\r").expect("a text"), &b"a\nb\r\nc\n\n"[..]);
        assert!(matches!(text(b"a\r\nb"), Ok(Cow::Borrowed(_))));
        assert_eq!(text(b"1,\xff\n").expect("a text"), &b"1,\xff\n"[..]);
    }
}
