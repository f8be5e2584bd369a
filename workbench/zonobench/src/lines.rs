//! Lines of bounded length, for JSON Lines.

use std::io::{self, BufRead};

use batch::Line;

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Numbers the lines of a stream from 1, leaving out blank ones; keeps no more than `limit` bytes of any.
pub struct Lines<R> {
    source: R,
    limit: usize,
    number: u64,
}

impl<R: BufRead> Lines<R> {
    /// The lines of `source`.
    pub fn new(source: R, limit: usize) -> Self {
        Self { source, limit, number: 0 }
    }

    /// The next line, blank or not, without its end; `None` at the end of the stream.
    fn next_raw(&mut self) -> io::Result<Option<Line>> {
        let mut content = Vec::new();
        let mut fits = true;
        let mut any = false;
        loop {
            let buffer = self.source.fill_buf()?;
            if buffer.is_empty() {
                break;
            }
            any = true;
            let end = buffer.iter().position(|&byte| byte == b'\n');
            let part = &buffer[..end.unwrap_or(buffer.len())];
            fits &= content.len() + part.len() <= self.limit;
            if fits {
                content.extend_from_slice(part);
            } else {
                content = Vec::new();
            }
            let used = end.map_or(buffer.len(), |end| end + 1);
            self.source.consume(used);
            if end.is_some() {
                break;
            }
        }
        let line = if fits { Line::Content(content) } else { Line::TooLong };
        Ok(any.then_some(line))
    }
}

impl<R: BufRead> Iterator for Lines<R> {
    type Item = io::Result<(u64, Line)>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let mut line = match self.next_raw() {
                Ok(Some(line)) => line,
                Ok(None) => return None,
                Err(error) => return Some(Err(error)),
            };
            self.number += 1;
            if let Line::Content(content) = &mut line {
                if self.number == 1 && content.starts_with(BYTE_ORDER_MARK) {
                    content.drain(..BYTE_ORDER_MARK.len());
                }
                if content.trim_ascii().is_empty() {
                    continue;
                }
            }
            return Some(Ok((self.number, line)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    fn lines(text: &[u8], limit: usize) -> Vec<(u64, Line)> {
        // A buffer of three bytes makes every line span several reads.
        let source = BufReader::with_capacity(3, text);
        Lines::new(source, limit).map(|line| line.expect("memory is readable")).collect()
    }

    fn content(text: &str) -> Line {
        Line::Content(text.as_bytes().to_vec())
    }

    #[test]
    fn blank_lines_count_but_are_left_out() {
        assert_eq!(lines(b"\xef\xbb\xbfone\r\n\r\n  \ntwo", 9), [(1, content("one\r")), (4, content("two"))]);
        assert_eq!(lines(b"", 9), []);
        assert_eq!(lines(b"\n\n", 9), []);
    }

    #[test]
    fn long_lines_are_dropped_and_the_next_one_is_read() {
        assert_eq!(
            lines(b"12345678\n1234567\nx\n", 7),
            [(1, Line::TooLong), (2, content("1234567")), (3, content("x"))]
        );
    }
}
