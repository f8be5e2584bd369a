//! The generators as a walk sees them: in classes of parallel ones, each class a line of the dual arrangement.

use std::sync::Arc;

use super::error::WalkError;
use super::tilted_line::{TiltedLine, points_up};
use crate::arrangement::dynamic_hull::{SiteIndex, SortedSites, TooManySites};
use crate::numeric::exact_linear::{ExactVector, exact, negated};
use crate::numeric::orientation::in_space::determinant_sign_of_rows;
use crate::zonotope::Directions;

/// A class of parallel generators, by its index: the index of its line among the sites.
pub(super) type Class = u32;

/// The class of a zero generator.
const NO_CLASS: Class = Class::MAX;

/// The classes of generators that span space, sorted by slope.
#[derive(Debug, Clone)]
pub(super) struct Classes {
    generators: Vec<[f64; 3]>,
    directions: Directions<3>,
    lines: Arc<SortedSites<TiltedLine>>,
    /// By generator.
    class_of: Vec<Class>,
    /// By class: the sum of its generators, turned to point up, where it has more than one.
    sums: Vec<Option<Box<ExactVector>>>,
}

impl Classes {
    /// The classes of generators. O(n log n).
    pub(super) fn new(generators: &[[f64; 3]]) -> Result<Self, WalkError> {
        if u32::try_from(generators.len()).is_err() {
            return Err(TooManySites { count: generators.len() }.into());
        }
        let directions = Directions::new(generators)?;
        let lines: Vec<TiltedLine> = directions.representatives().iter().filter_map(|&v| TiltedLine::of(v)).collect();
        let rank = rank(&lines);
        if rank < 3 {
            return Err(WalkError::Flat { rank });
        }
        let mut class_of = vec![NO_CLASS; generators.len()];
        for class in 0..lines.len() {
            directions.members(class).iter().for_each(|member| class_of[member.generator] = class as Class);
        }
        let sum = |(class, &representative): (usize, &[f64; 3])| {
            let is_several = directions.members(class).len() > 1;
            is_several.then(|| {
                let sum = directions.exact_sum(class, generators);
                Box::new(if points_up(representative) == Some(true) { sum } else { negated(sum) })
            })
        };
        let sums = directions.representatives().iter().enumerate().map(sum).collect();
        let lines = Arc::new(SortedSites::new(&lines)?);
        Ok(Self { generators: generators.to_vec(), directions, lines, class_of, sums })
    }

    /// The generators in the order of the input.
    pub(super) fn generators(&self) -> &[[f64; 3]] {
        &self.generators
    }

    /// The least indices of two generators that are not parallel.
    pub(super) fn first_two(&self) -> [usize; 2] {
        let mut first = self.all().map(|class| self.first_member(class));
        let mut least =
            [first.next(), first.next()].map(|member| member.expect("generators that span space have three classes"));
        least.sort_unstable();
        for member in first {
            if member < least[1] {
                least[1] = member;
                least.sort_unstable();
            }
        }
        least
    }

    /// All classes.
    pub(super) fn all(&self) -> impl Iterator<Item = Class> + use<> {
        0..self.lines.len() as Class
    }

    /// The lines of all classes.
    pub(super) fn lines(&self) -> &Arc<SortedSites<TiltedLine>> {
        &self.lines
    }

    /// The line of a class.
    #[inline]
    pub(super) fn line(&self, class: Class) -> &TiltedLine {
        self.lines.site(SiteIndex(class)).expect("a class has a line")
    }

    /// The direction of a class that points up.
    #[inline]
    pub(super) fn upward(&self, class: Class) -> &[f64; 3] {
        self.line(class).upward()
    }

    /// The place of a class among all in the order of their slopes.
    #[inline]
    pub(super) fn place(&self, class: Class) -> u32 {
        self.lines.place(SiteIndex(class)).expect("a class has a line")
    }

    /// The generators of a class, in ascending order.
    pub(super) fn members(&self, class: Class) -> impl ExactSizeIterator<Item = usize> {
        self.directions.members(class as usize).iter().map(|member| member.generator)
    }

    /// The least index of the generators of a class.
    #[inline]
    pub(super) fn first_member(&self, class: Class) -> usize {
        self.directions.members(class as usize)[0].generator
    }

    /// The class of a generator; `None` of a zero one, or if there is no such generator.
    pub(super) fn class_of(&self, generator: usize) -> Option<Class> {
        self.class_of.get(generator).copied().filter(|&class| class != NO_CLASS)
    }

    /// Whether a generator points up; so does no zero one.
    #[inline]
    pub(super) fn points_up(&self, generator: usize) -> bool {
        points_up(self.generators[generator]) == Some(true)
    }

    /// The sum of the generators of a class, turned to point up: half of an edge.
    pub(super) fn half_edge(&self, class: Class) -> ExactVector {
        match &self.sums[class as usize] {
            Some(sum) => (**sum).clone(),
            None => exact(*self.upward(class)),
        }
    }

    /// How many bytes are held, the digits of long numbers not.
    pub(super) fn bytes(&self) -> usize {
        let by_generator = size_of::<[f64; 3]>() + size_of::<Class>() + size_of::<(usize, bool)>();
        let by_class = size_of::<[f64; 3]>() + size_of::<usize>() + size_of::<Option<Box<ExactVector>>>();
        let sums = self.sums.iter().flatten().count() * size_of::<ExactVector>();
        self.lines.bytes() + self.generators.len() * by_generator + self.sums.len() * by_class + sums
    }
}

/// The dimension of the span of generators that are not parallel.
fn rank(lines: &[TiltedLine]) -> usize {
    let [first, second, rest @ ..] = lines else { return lines.len() };
    let is_beside =
        |line: &TiltedLine| determinant_sign_of_rows(first.upward(), second.upward(), line.upward()).is_ne();
    if rest.iter().any(is_beside) { 3 } else { 2 }
}
