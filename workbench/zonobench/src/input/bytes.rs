//! A file's bytes, up to a limit that is checked before they are read.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::error::{InputError, Place, Problem};

/// The largest file that is read.
pub const MAX_FILE_BYTES: u64 = 256 << 20;

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The content of `file` (`-`: standard input).
pub(super) fn read_limited(file: &Path) -> Result<Vec<u8>, InputError> {
    read_at_most(file, MAX_FILE_BYTES).map_err(|problem| problem.at(file, Place::File))
}

fn read_at_most(file: &Path, limit: u64) -> Result<Vec<u8>, Problem> {
    if file == Path::new("-") {
        return take(io::stdin().lock(), 0, limit);
    }
    let opened = File::open(file)?;
    let metadata = opened.metadata()?;
    if metadata.is_dir() {
        return Err(Problem::Unreadable(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory")));
    }
    if metadata.len() > limit {
        return Err(Problem::TooManyBytes { limit });
    }
    take(opened, metadata.len(), limit)
}

/// The text of a content: the content without its byte order mark.
pub(super) fn text(content: &[u8]) -> &[u8] {
    content.strip_prefix(BYTE_ORDER_MARK).unwrap_or(content)
}

/// Reads to the end; pipes have no length to be checked beforehand, so reading itself stops one byte past the limit.
fn take(source: impl Read, expected: u64, limit: u64) -> Result<Vec<u8>, Problem> {
    let mut content = Vec::with_capacity(usize::try_from(expected).unwrap_or(0));
    source.take(limit + 1).read_to_end(&mut content)?;
    if content.len() as u64 > limit {
        return Err(Problem::TooManyBytes { limit });
    }
    Ok(content)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_exact_and_the_mark_is_dropped() {
        assert_eq!(take(&b"12345"[..], 0, 5).expect("five bytes fit"), b"12345");
        assert!(matches!(take(&b"123456"[..], 0, 5), Err(Problem::TooManyBytes { limit: 5 })));
        assert_eq!(text(&take(&b"\xef\xbb\xbfx"[..], 4, 9).expect("fits")), b"x");
        assert_eq!(text(b"x"), b"x");
    }

    #[test]
    fn an_endless_source_stops_at_the_limit() {
        assert!(matches!(take(io::repeat(b'1'), 0, 1000), Err(Problem::TooManyBytes { limit: 1000 })));
    }
}
