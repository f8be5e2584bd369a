//! The vector instructions that a pass runs on, chosen when the program runs.
//!
//! A pass is compiled once for each set of instructions; `dispatch!` calls the one for the level of the machine. A pass
//! is written for eight logical lanes whatever the level is, adds the lanes up in one fixed order and never fuses a
//! product with a sum, so its result has the same bits at every level.

use fearless_simd::Level;

/// The level of the machine; the library that detects it looks once and remembers.
#[inline(always)]
pub(crate) fn level() -> Level {
    Level::new()
}

/// All levels that the machine has.
#[cfg(test)]
pub(crate) fn levels() -> Vec<Level> {
    let level = level();
    let mut levels = vec![Level::baseline(), level];
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        levels.extend(level.as_sse2().map(Level::Sse2));
        levels.extend(level.as_sse4_2().map(Level::Sse4_2));
        levels.extend(level.as_avx2().map(Level::Avx2));
    }
    levels
}
