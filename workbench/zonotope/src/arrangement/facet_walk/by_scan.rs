//! A walk over the facets, by one pass over all generators a step.
//!
//! # Source
//! Lemma 5.6 asks for less than this takes; this is the plain way that it competes with.
//!
//! # Method
//! 1. Across an edge of direction w the normal u turns about w, towards w × u. A generator v comes along the facet
//!    where the normal is orthogonal to it.
//! 2. One pass in doubles finds the generators that may be the first.
//! 3. Of these the first are chosen exactly: with a and b turned to have positive products with u, a comes before b
//!    just if det(w, a, b) > 0, and with it if the determinant is 0.
//!
//! # Complexity
//! n generators: a step or a neighbour O(n), in one vector pass and a few determinants; as many determinants as
//! generators where these are all nearly in one plane with the facet. Preprocessing O(n log n), to find parallel
//! generators; space O(n).
//!
//! # Numerics
//! All decisions are exact. The pass only leaves out what comes later for certain.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on all families; [`by_dynamic_hull`](super::by_dynamic_hull) on long walks.
//!
//! # Example
//! ```
//! use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, NormalSense, ScanWalk};
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let mut walk = ScanWalk::new(&cube)?;
//! assert_eq!(walk.facet(), FacetName::new(0, 1, NormalSense::Along));
//! walk.step(0)?;
//! assert_eq!(walk.facet(), FacetName::new(0, 2, NormalSense::Along));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::classes::{Class, Classes};
use super::edge_cycle::{Directed, EdgeCycle};
use super::error::WalkError;
use super::facet::{FacetEdge, FacetName, NormalSense};
use super::interface::FacetWalk;
use super::to_ray::{LocatedWalk, facet_center, next_center, walk_to};
use crate::numeric::exact_linear::{ExactVector, exact, rounded_direction};
use crate::numeric::lanes::body_sums::laid_out;
use crate::numeric::lanes::first_orthogonal;
use crate::numeric::lanes::rows::LaidOut;
use crate::numeric::linear::{cross, max_norm};
use crate::numeric::orientation::in_space::{Direction as Vector, determinant_sign_of_rows};
use crate::numeric::tolerance::LARGEST_OF_ROUNDED_NORMAL;

/// A walk that reads all generators at every step.
#[derive(Debug, Clone)]
pub struct ScanWalk {
    classes: Classes,
    /// The upward directions of the classes, scaled.
    vectors: LaidOut,
    cycle: EdgeCycle,
    /// The centre of the facet relative to that of the body, once it was needed.
    center: Option<ExactVector>,
}

impl ScanWalk {
    /// A walk over the facets of the zonotope of some generators, which starts at the facet of the first two that are
    /// not parallel. O(n log n).
    ///
    /// # Errors
    /// [`WalkError`] if a coordinate is not finite, the generators do not span space, or there are too many.
    pub fn new(generators: &[[f64; 3]]) -> Result<Self, WalkError> {
        let classes = Classes::new(generators)?;
        let [first, second] = classes.first_two();
        let (cycle, _) = EdgeCycle::named(&classes, FacetName::new(first, second, NormalSense::Along))?;
        let scaled: Vec<[f64; 3]> = classes.all().map(|class| scaled(classes.upward(class))).collect();
        Ok(Self { vectors: laid_out(&scaled), classes, cycle, center: None })
    }

    /// The facet beyond an edge of this one.
    fn beyond(&self, edge: Directed) -> EdgeCycle {
        let classes = &self.classes;
        let [a, b] = self.cycle.spanning().map(|directed| directed.vector(classes));
        let along = edge.vector(classes);
        let [normal, tangent] = rounded_frame(&a, &b, &along);
        let mut first: SmallVec<[(Class, [f64; 3]); 2]> = SmallVec::new();
        let mut is_reversed = false;
        for candidate in first_orthogonal(self.vectors.blocks(), &normal, &tangent) {
            // the last octet is filled up with zeros
            if candidate >= classes.lines().len() {
                continue;
            }
            let class = candidate as Class;
            let upward = classes.upward(class);
            let side = determinant_sign_of_rows(&a, &b, upward);
            if side.is_eq() {
                continue;
            }
            let outward = if side.is_lt() { upward.map(|c| -c) } else { *upward };
            let order = first.first().map(|(_, best)| determinant_sign_of_rows(&along, &outward, best));
            match order {
                Some(Ordering::Less) => continue,
                Some(Ordering::Equal) => {}
                Some(Ordering::Greater) | None => {
                    first.clear();
                    is_reversed = side.is_lt();
                }
            }
            first.push((class, outward));
        }
        let (class, _) = *first.first().expect("generators that span space are not all along the facet");
        let all = first.iter().map(|(class, _)| *class).chain([edge.class]).collect();
        EdgeCycle::of_plane(classes, all, [edge, Directed { class, is_reversed }])
    }
}

/// A direction with its largest coordinate in [1, 2).
fn scaled(direction: &[f64; 3]) -> [f64; 3] {
    Vector::new(*direction).scaled()
}

/// The cross product of two directions, and that of a third one with it, in doubles and scaled: with vectors whose
/// coordinates are below 2 their products are as near as the pass wants them.
fn rounded_frame(a: &[f64; 3], b: &[f64; 3], along: &[f64; 3]) -> [[f64; 3]; 2] {
    let [near_a, near_b, near_along] = [a, b, along].map(scaled);
    let normal = cross(&near_a, &near_b);
    let size = max_norm(&normal);
    if size < LARGEST_OF_ROUNDED_NORMAL {
        let [a, b, along] = [a, b, along].map(|direction| exact(*direction));
        let normal = cross(&a, &b);
        let tangent = cross(&along, &normal);
        return [rounded_direction(&normal), rounded_direction(&tangent)];
    }
    let normal = normal.map(|coordinate| coordinate / size);
    let tangent = cross(&near_along, &normal);
    let size = max_norm(&tangent);
    [normal, tangent.map(|coordinate| coordinate / size)]
}

impl FacetWalk for ScanWalk {
    fn facet(&self) -> FacetName {
        self.cycle.name(&self.classes)
    }

    fn edges(&self) -> Vec<FacetEdge> {
        self.cycle.edges(&self.classes)
    }

    fn step(&mut self, edge: usize) -> Result<(), WalkError> {
        let cycle = self.beyond(self.cycle.edge(edge)?);
        if let Some(center) = self.center.take() {
            self.center = next_center(&self.classes, &center, [&self.cycle, &cycle], edge);
        }
        self.cycle = cycle;
        Ok(())
    }

    fn neighbour(&mut self, edge: usize) -> Result<FacetName, WalkError> {
        Ok(self.beyond(self.cycle.edge(edge)?).name(&self.classes))
    }

    fn place_at(&mut self, facet: FacetName) -> Result<(), WalkError> {
        let (cycle, _) = EdgeCycle::named(&self.classes, facet)?;
        self.cycle = cycle;
        self.center = None;
        Ok(())
    }

    fn walk_to(&mut self, direction: [f64; 3]) -> Result<u64, WalkError> {
        walk_to(self, direction)
    }
}

impl LocatedWalk for ScanWalk {
    fn classes(&self) -> &Classes {
        &self.classes
    }

    fn cycle(&self) -> &EdgeCycle {
        &self.cycle
    }

    fn located(&mut self) -> &ExactVector {
        self.center.get_or_insert_with(|| facet_center(&self.classes, &self.cycle))
    }
}
