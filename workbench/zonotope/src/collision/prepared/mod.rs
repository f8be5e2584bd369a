//! Problem: many queries about one body of space, which is prepared for them.
//!
//! | method | space | cost of a query | what it is |
//! |---|---|---|---|
//! | [`by_cutting`] | O(m), n ≤ m ≤ n² | O(n²/m + log² n) | Lemma 5.3 and Corollary 5.4 |

pub mod by_cutting;
