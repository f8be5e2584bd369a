//! A file's bytes, up to a limit that is checked before they are read.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::error::{InputError, Place, Problem};

/// The largest file that is read.
pub const MAX_FILE_BYTES: u64 = 256 << 20;

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
        return Err(Problem::Folder);
    }
    if metadata.len() > limit {
        return Err(Problem::TooManyBytes { limit });
    }
    take(opened, metadata.len(), limit)
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
    fn the_limit_is_exact() {
        assert_eq!(take(&b"12345"[..], 0, 5).expect("five bytes fit"), b"12345");
        assert!(matches!(take(&b"123456"[..], 0, 5), Err(Problem::TooManyBytes { limit: 5 })));
    }

    #[test]
    fn an_endless_source_stops_at_the_limit() {
        assert!(matches!(take(io::repeat(b'1'), 0, 1000), Err(Problem::TooManyBytes { limit: 1000 })));
    }
}
