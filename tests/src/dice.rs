//! Numbers in a fixed order without any pattern: the same ones for the same seed; or those that a list of bytes spells.

/// A generator of numbers (splitmix64).
pub struct Dice {
    state: u64,
    /// Bytes that come before all other numbers, the last one first.
    bytes: Vec<u8>,
}

impl Dice {
    /// The numbers of a seed.
    pub fn new(seed: u64) -> Self {
        Self { state: seed, bytes: Vec::new() }
    }

    /// The numbers that bytes spell, two bytes each, and those of a seed after them: a change of one byte changes one
    /// number. A fuzzer that learns which bytes lead where thereby steers the questions that are made of the numbers.
    pub fn of_bytes(bytes: &[u8]) -> Self {
        Self { state: bytes.len() as u64, bytes: bytes.iter().rev().copied().collect() }
    }

    fn next(&mut self) -> u64 {
        if let (Some(low), Some(high)) = (self.bytes.pop(), self.bytes.pop()) {
            return mixed(u64::from(u16::from_le_bytes([low, high])));
        }
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.state)
    }

    /// One of 0, 1, …, `range` − 1.
    pub fn below(&mut self, range: usize) -> usize {
        (self.next() >> 11) as usize % range.max(1)
    }

    /// Whether one of `of` equally likely things happens.
    pub fn one_in(&mut self, of: usize) -> bool {
        self.below(of) == 0
    }

    /// A number of [−1, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// One of a list, all equally likely.
    pub fn choose<'a, T>(&mut self, among: &'a [T]) -> &'a T {
        &among[self.below(among.len())]
    }
}

fn mixed(number: u64) -> u64 {
    let mixed = (number ^ (number >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}
