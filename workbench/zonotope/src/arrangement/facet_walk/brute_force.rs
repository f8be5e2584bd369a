//! A walk over the facets, by the list of all of them: the truth the methods are held to.
//!
//! # Source
//! The definitions: faces are signs of all generators along a direction, and two facets are neighbours if they share an
//! edge.
//!
//! # Method
//! 1. Two generators that are not parallel span a plane, and the generators in it are along two facets. The others have
//!    their signs along the normal.
//! 2. The edges of a facet are its generators and their opposites, in the order of their angles. Along an edge the
//!    other generators of the facet have their signs along the direction in the facet away from it.
//! 3. Two facets are neighbours across an edge if the signs of that edge are the same.
//! 4. A ray leaves through the facets at which it meets the plane of a facet first.
//!
//! # Complexity
//! n generators: O(n³) time and space for the list, in exact numbers; a step is a look into a list.
//!
//! # Numerics
//! Everything is exact.
//!
//! # Checked by
//! Every edge is found at two facets; the face lattice on all families.
//!
//! # Example
//! ```
//! use zonotope::arrangement::facet_walk::brute_force::BruteForceWalk;
//! use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, NormalSense};
//! let mut cube = BruteForceWalk::new(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
//! assert_eq!(cube.facets().len(), 6);
//! assert_eq!(cube.neighbour(0)?, FacetName::new(0, 2, NormalSense::Along));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::error::WalkError;
use super::facet::{FacetEdge, FacetName, NormalSense};
use super::interface::FacetWalk;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, exact, is_zero, negated, sum};
use crate::numeric::non_finite::NonFinite;

/// The signs of all classes along a face, 0 along it.
type Signs = Vec<i8>;

/// All facets, with their neighbours.
#[derive(Debug, Clone)]
pub struct BruteForceWalk {
    count: usize,
    /// Parallel generators together, in the order of their first ones, and whether each points against the first.
    classes: Vec<Vec<(usize, bool)>>,
    /// By class: the first generator, and the sum of all turned like it.
    vectors: Vec<[ExactVector; 2]>,
    facets: Vec<Facet>,
    at: usize,
}

#[derive(Debug, Clone)]
struct Facet {
    name: FacetName,
    normal: ExactVector,
    signs: Signs,
    /// The classes of the edges counter-clockwise, and whether they are directed against the first generator.
    edges: Vec<(usize, bool)>,
    neighbours: Vec<usize>,
}

impl BruteForceWalk {
    /// A walk over the facets of the zonotope of some generators, which starts at the facet of the first two that are
    /// not parallel. O(n³).
    ///
    /// # Errors
    /// [`WalkError`] if a coordinate is not finite or the generators do not span space.
    pub fn new(generators: &[[f64; 3]]) -> Result<Self, WalkError> {
        NonFinite::check_list("generator", generators)?;
        let (mut classes, mut vectors) = (Vec::<Vec<(usize, bool)>>::new(), Vec::<[ExactVector; 2]>::new());
        for (generator, v) in generators.iter().map(|&v| exact(v)).enumerate().filter(|(_, v)| !is_zero(v)) {
            match vectors.iter().position(|[first, _]| is_zero(&cross(first, &v))) {
                Some(class) => {
                    let [first, total] = &mut vectors[class];
                    let is_reversed = dot(first, &v).sign().is_lt();
                    *total = sum(total, &if is_reversed { negated(v) } else { v });
                    classes[class].push((generator, is_reversed));
                }
                None => {
                    vectors.push([v.clone(), v]);
                    classes.push(vec![(generator, false)]);
                }
            }
        }
        let mut walk = Self { count: generators.len(), classes, vectors, facets: Vec::new(), at: 0 };
        walk.list_facets();
        if walk.facets.len() < 3 {
            return Err(WalkError::Flat { rank: walk.classes.len().min(2) });
        }
        walk.join();
        Ok(walk)
    }

    /// The facets, in the order of the generators of their names.
    pub fn facets(&self) -> Vec<FacetName> {
        self.facets.iter().map(|facet| facet.name).collect()
    }

    /// The facets through which a ray from the centre leaves.
    pub fn exits(&self, direction: [f64; 3]) -> Vec<FacetName> {
        let direction = exact(direction);
        // the planes are met at h / (u · p)
        let met = self.facets.iter().filter_map(|facet| {
            let slope = dot(&facet.normal, &direction);
            let height = self.vectors.iter().fold(Dyadic::zero(), |h, [_, v]| h + dot(&facet.normal, v).abs());
            slope.sign().is_gt().then_some((height, slope, facet.name))
        });
        let mut first: Vec<(Dyadic, Dyadic, FacetName)> = Vec::new();
        for (height, slope, name) in met {
            let order = first.first().map_or(Ordering::Less, |(h, s, _)| (&height * s).cmp(&(h * &slope)));
            if order.is_lt() {
                first.clear();
            }
            if order.is_le() {
                first.push((height, slope, name));
            }
        }
        first.into_iter().map(|(_, _, name)| name).collect()
    }

    fn sign_along(&self, class: usize, direction: &ExactVector) -> i8 {
        dot(&self.vectors[class][0], direction).sign() as i8
    }

    fn list_facets(&mut self) {
        for i in 0..self.classes.len() {
            for j in i + 1..self.classes.len() {
                let normal = cross(&self.vectors[i][0], &self.vectors[j][0]);
                let signs: Signs = (0..self.classes.len()).map(|class| self.sign_along(class, &normal)).collect();
                let is_named = |k: usize| signs[k] == 0 && k != i && k < j;
                if (0..j).any(is_named) {
                    continue;
                }
                for sense in [NormalSense::Along, NormalSense::Against] {
                    let is_along = sense == NormalSense::Along;
                    let normal = if is_along { normal.clone() } else { negated(normal.clone()) };
                    let name = FacetName::new(self.classes[i][0].0, self.classes[j][0].0, sense);
                    let signs = signs.iter().map(|sign| if is_along { *sign } else { -sign }).collect();
                    let edges = self.edges_around(&normal, i, &signs);
                    self.facets.push(Facet { name, normal, signs, edges, neighbours: Vec::new() });
                }
            }
        }
    }

    /// The edges of a facet counter-clockwise, from the one along its first class.
    fn edges_around(&self, normal: &ExactVector, first: usize, signs: &Signs) -> Vec<(usize, bool)> {
        let turn = |a: &ExactVector, b: &ExactVector| dot(normal, &cross(a, b)).sign();
        let others = (0..signs.len()).filter(|&class| signs[class] == 0 && class != first);
        let mut half: Vec<(usize, bool)> =
            others.map(|class| (class, turn(&self.vectors[first][0], &self.vectors[class][0]).is_lt())).collect();
        half.sort_by(|&a, &b| turn(&self.directed(b), &self.directed(a)));
        half.insert(0, (first, false));
        let opposite: Vec<(usize, bool)> = half.iter().map(|&(class, is_reversed)| (class, !is_reversed)).collect();
        [half, opposite].concat()
    }

    fn directed(&self, (class, is_reversed): (usize, bool)) -> ExactVector {
        let vector = self.vectors[class][0].clone();
        if is_reversed { negated(vector) } else { vector }
    }

    /// Finds the facets that share an edge.
    fn join(&mut self) {
        let mut sharing: BTreeMap<Signs, Vec<(usize, usize)>> = BTreeMap::new();
        for (index, facet) in self.facets.iter().enumerate() {
            for (edge, &(class, is_reversed)) in facet.edges.iter().enumerate() {
                // to the right of an edge that runs counter-clockwise
                let away = cross(&self.directed((class, is_reversed)), &facet.normal);
                let mut signs = facet.signs.clone();
                for other in (0..signs.len()).filter(|&other| facet.signs[other] == 0 && other != class) {
                    signs[other] = self.sign_along(other, &away);
                }
                sharing.entry(signs).or_default().push((index, edge));
            }
        }
        for facet in &mut self.facets {
            facet.neighbours = vec![usize::MAX; facet.edges.len()];
        }
        for pair in sharing.into_values() {
            if let [(a, edge), (b, other)] = pair[..] {
                self.facets[a].neighbours[edge] = b;
                self.facets[b].neighbours[other] = a;
            }
        }
    }

    fn next(&self, edge: usize) -> Result<usize, WalkError> {
        let here = &self.facets[self.at].neighbours;
        here.get(edge).copied().ok_or(WalkError::UnknownEdge { edge, count: here.len() })
    }

    /// The class of a generator, and whether it points against the first one of that.
    fn class_of(&self, generator: usize) -> Option<(usize, bool)> {
        self.classes.iter().enumerate().find_map(|(class, members)| {
            let (_, is_reversed) = members.iter().find(|(member, _)| *member == generator)?;
            Some((class, *is_reversed))
        })
    }
}

impl FacetWalk for BruteForceWalk {
    fn facet(&self) -> FacetName {
        self.facets[self.at].name
    }

    fn edges(&self) -> Vec<FacetEdge> {
        let edges = self.facets[self.at].edges.iter();
        edges.map(|&(class, is_reversed)| FacetEdge { generator: self.classes[class][0].0, is_reversed }).collect()
    }

    fn step(&mut self, edge: usize) -> Result<(), WalkError> {
        self.at = self.next(edge)?;
        Ok(())
    }

    fn neighbour(&mut self, edge: usize) -> Result<FacetName, WalkError> {
        Ok(self.facets[self.next(edge)?].name)
    }

    fn place_at(&mut self, facet: FacetName) -> Result<(), WalkError> {
        let FacetName { first, second, normal } = facet;
        if let Some(generator) = [first, second].into_iter().find(|&generator| generator >= self.count) {
            return Err(WalkError::UnknownGenerator { generator, count: self.count });
        }
        if first >= second {
            return Err(WalkError::NotAscending { first, second });
        }
        let pair = self.class_of(first).zip(self.class_of(second)).filter(|(a, b)| a.0 != b.0);
        let (a, b) = pair.ok_or(WalkError::NoPlane { first, second })?;
        let product = cross(&self.directed(a), &self.directed(b));
        let outward = if normal == NormalSense::Along { product } else { negated(product) };
        let is_along = |facet: &Facet, (class, _): (usize, bool)| facet.signs[class] == 0;
        let is_outward = |facet: &Facet| dot(&facet.normal, &outward).sign().is_gt();
        let is_here = |facet: &Facet| is_along(facet, a) && is_along(facet, b) && is_outward(facet);
        let found = self.facets.iter().position(is_here);
        self.at = found.expect("two generators that are not parallel are along two facets");
        Ok(())
    }

    fn walk_to(&mut self, direction: [f64; 3]) -> Result<u64, WalkError> {
        NonFinite::check_vector("the direction", &direction)?;
        let exit = *self.exits(direction).first().ok_or(WalkError::NoDirection)?;
        let steps = u64::from(exit != self.facet());
        self.place_at(exit)?;
        Ok(steps)
    }
}
