//! Stable hashes: seeds of cases and digests of answers. Written out here so that no library update can change a
//! recorded seed.

/// Offset and prime of the 64-bit Fowler-Noll-Vo hash, variant 1a.
const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0000_0100_0000_01b3;

/// A running 64-bit hash: FNV-1a over little-endian bytes, finished with SplitMix64's mixer. Not cryptographic.
#[derive(Clone, Copy, Debug)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(FNV_OFFSET)
    }
}

impl Digest {
    /// Adds bytes as they stand.
    #[must_use]
    pub fn bytes(mut self, bytes: &[u8]) -> Self {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(FNV_PRIME);
        }
        self
    }

    /// Adds one word.
    #[must_use]
    pub fn word(self, word: u64) -> Self {
        self.bytes(&word.to_le_bytes())
    }

    /// Adds the bits of floats; both zeros count as one number.
    #[must_use]
    pub fn floats<'a>(self, floats: impl IntoIterator<Item = &'a f64>) -> Self {
        floats.into_iter().fold(self, |digest, &x| digest.word((x + 0.0).to_bits()))
    }

    /// The hash of everything added.
    pub fn finish(self) -> u64 {
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

/// The seed of the thing called `id` under a master seed: never depends on threads, order or other cases.
pub fn seed_of(master: u64, id: &str) -> u64 {
    Digest::default().word(master).bytes(id.as_bytes()).finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_the_published_one() {
        // Test vectors of FNV-1a, before the final mixing.
        assert_eq!(Digest::default().bytes(b"").0, 0xcbf2_9ce4_8422_2325);
        assert_eq!(Digest::default().bytes(b"a").0, 0xaf63_dc4c_8601_ec8c);
        assert_eq!(Digest::default().bytes(b"foobar").0, 0x8594_4171_f739_67e8);
    }

    #[test]
    fn seeds_differ_by_master_and_by_id() {
        let seeds = [seed_of(1, "a"), seed_of(1, "b"), seed_of(2, "a")];
        assert!(seeds[0] != seeds[1] && seeds[0] != seeds[2] && seeds[1] != seeds[2]);
    }

    #[test]
    fn zeros_are_one_number() {
        assert_eq!(Digest::default().floats(&[0.0]).finish(), Digest::default().floats(&[-0.0]).finish());
        assert_ne!(Digest::default().floats(&[0.0]).finish(), Digest::default().floats(&[1.0]).finish());
    }
}
