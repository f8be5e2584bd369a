//! The vector instructions that a pass runs on, chosen when the program runs.
//!
//! A pass is compiled once for each set of instructions; `dispatch!` calls the one for the level of the machine. A pass
//! is written for eight logical lanes whatever the level is, adds the lanes up in one fixed order and never fuses a
//! product with a sum, so its result has the same bits at every level.

use fearless_simd::Level;

/// The level of the machine; the library that detects it looks once and remembers.
#[cfg(not(test))]
#[inline(always)]
pub(crate) fn level() -> Level {
    Level::new()
}

/// The level for passes over so few generators that the widest instructions cost more than they spare: 256 bits where
/// the machine has them.
#[inline(always)]
pub(crate) fn level_for_few() -> Level {
    let widest = level();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(narrower) = widest.as_avx2() {
        return Level::Avx2(narrower);
    }
    widest
}

#[cfg(test)]
pub(crate) use tests::{at_each_level, level, levels};

#[cfg(test)]
mod tests {
    //! Tests choose the level of their thread.

    use std::cell::Cell;

    use super::Level;

    thread_local! {
        static FORCED: Cell<Option<Level>> = const { Cell::new(None) };
    }

    pub(crate) fn level() -> Level {
        FORCED.get().unwrap_or_else(Level::new)
    }

    /// All levels that the machine has, the narrowest first.
    pub(crate) fn levels() -> Vec<Level> {
        let widest = Level::new();
        let mut levels = vec![Level::baseline()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        levels.extend(widest.as_avx2().map(Level::Avx2));
        levels.push(widest);
        levels
    }

    /// What a function returns at each level that the machine has.
    pub(crate) fn at_each_level<T>(mut compute: impl FnMut() -> T) -> Vec<T> {
        let results = levels().into_iter().map(|level| {
            FORCED.set(Some(level));
            compute()
        });
        let results = results.collect();
        FORCED.set(None);
        results
    }
}
