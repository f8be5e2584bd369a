//! SHA-256, by which an answer names the data that it was computed from and a manifest names its files.

use std::io::{self, BufRead};

use sha2::{Digest, Sha256};

/// The SHA-256 of some bytes, in hexadecimal.
pub fn sha256(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The SHA-256 of all that a reader gives, in hexadecimal.
pub fn sha256_of_reader(mut reader: impl BufRead) -> io::Result<String> {
    let mut digest = Sha256::new();
    loop {
        let read = reader.fill_buf()?;
        if read.is_empty() {
            return Ok(digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect());
        }
        digest.update(read);
        let length = read.len();
        reader.consume(length);
    }
}
