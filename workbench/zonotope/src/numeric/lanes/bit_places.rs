//! The places of the bits that are set in a word: how a pass reports a few of the many items that it reads.

/// Items whose bits fill a word.
pub(crate) const WORD: usize = 64;

/// The places of the bits that are set, counted from `first`, in ascending order; `room` is what they are written to.
#[inline(always)]
pub(crate) fn places_of(mut bits: u64, first: u32, room: &mut [u32; WORD]) -> &[u32] {
    let mut count = 0;
    while bits != 0 {
        room[count % WORD] = first + bits.trailing_zeros();
        bits &= bits - 1;
        count += 1;
    }
    &room[..count]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_listed_in_ascending_order() {
        let mut room = [0; WORD];
        assert_eq!(places_of(0, 7, &mut room), [0; 0]);
        assert_eq!(places_of(1 << 63 | 0b101, 64, &mut room), [64, 66, 127]);
        assert!(places_of(u64::MAX, 0, &mut room).iter().copied().eq(0..64));
    }
}
