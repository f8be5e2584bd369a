//! Lists whose memory a thread keeps for its next question.
//!
//! A question about a few hundred generators writes some twenty short lists, and asking the heap for each takes longer
//! than a pass over it. So the memory of a list that is dropped waits, emptied and not cleared, for the next list of
//! its kind on that thread. This is the workspace of all questions: nobody has to make one, hand it on or share it
//! among threads, and whoever asks again finds it warm. An answer that holds such lists gives them back when it is
//! dropped.

use std::mem;
use std::ops::{Deref, DerefMut};
use std::slice;

/// Lists of one kind that wait at most: a search with all its cells, and some answers to it, hold no more.
const WAITING_LISTS: usize = 32;

/// The memory of a longer list, in bytes, goes back to the heap: a pass over what it holds outweighs the heap by far.
const LONGEST_KEPT: usize = 1 << 16;

/// What lists are made of whose memory a thread keeps.
pub(crate) trait Kept: Sized + 'static {
    /// What is done with the lists that wait; nothing where the thread is ending.
    fn among_waiting<R>(act: impl FnOnce(&mut Vec<Vec<Self>>) -> R) -> Option<R>;
}

/// Lets threads keep the memory of lists of these kinds.
macro_rules! keep_lists_of {
    ($($kind:ty),+ $(,)?) => {$(
        impl $crate::numeric::reused::Kept for $kind {
            fn among_waiting<R>(act: impl FnOnce(&mut Vec<Vec<Self>>) -> R) -> Option<R> {
                thread_local! {
                    static WAITING: std::cell::RefCell<Vec<Vec<$kind>>> = const {
                        std::cell::RefCell::new(Vec::new())
                    };
                }
                WAITING.try_with(|waiting| act(&mut waiting.borrow_mut())).ok()
            }
        }
    )+};
}

pub(crate) use keep_lists_of;

keep_lists_of!(u32, u64, usize, f64, [f64; 2], [f64; 3], (usize, f64));

/// A list in memory of the thread, to which the memory returns when the list is dropped.
#[derive(Debug, PartialEq)]
pub(crate) struct Reused<T: Kept>(Vec<T>);

impl<T: Kept> Reused<T> {
    /// A list that is likely to stay empty: it has no memory, and takes what it needs from the heap.
    pub(crate) const fn new() -> Self {
        Self(Vec::new())
    }

    /// An empty list with room for so many.
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        let mut list = T::among_waiting(Vec::pop).flatten().unwrap_or_default();
        list.reserve(capacity);
        Self(list)
    }
}

impl<T: Kept> Drop for Reused<T> {
    fn drop(&mut self) {
        let mut list = mem::take(&mut self.0);
        if list.capacity() == 0 || list.capacity() * size_of::<T>() > LONGEST_KEPT {
            return;
        }
        // before the lists that wait are borrowed: an item may hold a list itself
        list.clear();
        T::among_waiting(|waiting| {
            if waiting.len() < WAITING_LISTS {
                waiting.push(list);
            }
        });
    }
}

impl<T: Kept> Default for Reused<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Kept + Clone> Clone for Reused<T> {
    fn clone(&self) -> Self {
        self.0.iter().cloned().collect()
    }
}

impl<T: Kept> FromIterator<T> for Reused<T> {
    #[inline]
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut items = items.into_iter();
        let Some(first) = items.next() else { return Self::new() };
        let mut list = Self::with_capacity(1 + items.size_hint().0);
        list.0.push(first);
        list.0.extend(items);
        list
    }
}

impl<'a, T: Kept> IntoIterator for &'a Reused<T> {
    type Item = &'a T;
    type IntoIter = slice::Iter<'a, T>;

    #[inline]
    fn into_iter(self) -> slice::Iter<'a, T> {
        self.0.iter()
    }
}

impl<T: Kept> Deref for Reused<T> {
    type Target = Vec<T>;

    #[inline(always)]
    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T: Kept> DerefMut for Reused<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}

/// One item in memory of the thread, as a box has it in memory of the heap.
#[derive(Debug)]
pub(crate) struct ReusedBox<T: Kept>(Reused<T>);

impl<T: Kept> ReusedBox<T> {
    pub(crate) fn new(item: T) -> Self {
        let mut list = Reused::with_capacity(1);
        list.push(item);
        Self(list)
    }
}

impl<T: Kept> Deref for ReusedBox<T> {
    type Target = T;

    #[inline(always)]
    fn deref(&self) -> &T {
        &self.0[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Item(#[expect(dead_code, reason = "it is what an item may hold")] Reused<Item>);

    keep_lists_of!(i16, i32, i64, Item);

    fn waiting<T: Kept>() -> usize {
        T::among_waiting(|waiting| waiting.len()).expect("the thread is alive")
    }

    #[test]
    fn the_memory_of_a_dropped_list_is_that_of_the_next_one() {
        let list: Reused<i16> = (0..1000).collect();
        let memory = list.as_ptr();
        drop(list);
        assert_eq!(waiting::<i16>(), 1);
        let next = Reused::<i16>::with_capacity(10);
        assert!(next.is_empty() && next.capacity() >= 1000 && next.as_ptr() == memory);
        assert_eq!(waiting::<i16>(), 0);
    }

    #[test]
    fn a_list_within_a_list_waits_as_well() {
        let inner: Reused<Item> = [Item(Reused::default())].into_iter().collect();
        let outer: Reused<Item> = [Item(inner)].into_iter().collect();
        drop(outer);
        assert_eq!(waiting::<Item>(), 2);
    }

    #[test]
    fn neither_long_lists_nor_many_are_kept() {
        let many: Vec<Reused<i16>> = (0..2 * WAITING_LISTS).map(|_| Reused::with_capacity(4)).collect();
        drop(many);
        assert_eq!(waiting::<i16>(), WAITING_LISTS);
        for _ in 0..WAITING_LISTS {
            mem::forget(Reused::<i16>::with_capacity(4));
        }
        drop(Reused::<i16>::with_capacity(LONGEST_KEPT));
        assert_eq!(waiting::<i16>(), 0);
    }

    #[test]
    fn the_longest_list_that_is_kept_has_the_limit_in_bytes() {
        let longest = LONGEST_KEPT / size_of::<i32>();
        drop(Reused::<i32>::with_capacity(longest + 1));
        assert_eq!(waiting::<i32>(), 0);
        drop(Reused::<i32>::with_capacity(longest));
        assert_eq!(waiting::<i32>(), 1);
    }

    #[test]
    fn a_list_of_known_length_takes_its_memory_at_once() {
        let list: Reused<i64> = (0..1000).collect();
        assert_eq!(list.capacity(), 1000);
    }
}
