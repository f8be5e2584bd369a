//! Standard output, whose losses are never taken for success: closed, full or without a reader, it says so.

#[cfg(target_os = "linux")]
use std::fs;
use std::io::{self, BufWriter, StdoutLock, Write};
#[cfg(target_os = "linux")]
use std::path::Path;

/// Standard output that a command prints on. Every complaint of the system names it; lines are whole when they are
/// flushed, as [`StandardOutput::finish`] does at the end.
#[derive(Debug)]
pub struct StandardOutput(BufWriter<StdoutLock<'static>>);

impl StandardOutput {
    /// Standard output, unless it is closed.
    pub fn open() -> io::Result<Self> {
        check_standard_output()?;
        Ok(Self(BufWriter::new(io::stdout().lock())))
    }

    /// Prints all of a content.
    pub fn print(content: &[u8]) -> io::Result<()> {
        let mut output = Self::open()?;
        output.write_all(content)?;
        output.finish()
    }

    /// Hands everything to the system: what is lost only at the end of the program is told to nobody.
    pub fn finish(mut self) -> io::Result<()> {
        self.flush()
    }
}

impl Write for StandardOutput {
    fn write(&mut self, content: &[u8]) -> io::Result<usize> {
        self.0.write(content).map_err(named)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush().map_err(named)
    }
}

/// A complaint that names standard output, of the same kind.
pub(crate) fn named(error: io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("standard output: cannot be written: {error}"))
}

/// Refuses standard output that nothing is open for, where that can be told.
///
/// A program whose standard output is closed finds the null device in its place before it begins, open for reading as
/// well, so that what it writes vanishes with every sign of success. Somebody who wants that opens the device for
/// writing alone, as shells do.
pub fn check_standard_output() -> io::Result<()> {
    #[cfg(target_os = "linux")]
    {
        const OPEN_FOR_BOTH: u32 = 2;
        const ACCESS: u32 = 3;
        let is_null = fs::read_link("/proc/self/fd/1").is_ok_and(|device| device == Path::new("/dev/null"));
        let described = fs::read_to_string("/proc/self/fdinfo/1").unwrap_or_default();
        let flags = described.lines().find_map(|line| line.strip_prefix("flags:"));
        let flags = flags.and_then(|flags| u32::from_str_radix(flags.trim(), 8).ok()).unwrap_or_default();
        if is_null && flags & ACCESS == OPEN_FOR_BOTH {
            let complaint = "standard output is closed, or is the null device open for reading as well; `>/dev/null` \
                             drops what is written";
            return Err(io::Error::other(complaint));
        }
    }
    Ok(())
}
