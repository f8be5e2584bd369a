//! The tiling of Q with all its vertices, edges and tiles, by sweeping the dual arrangement from left to right.
//!
//! # Statement
//! Input: n generators of R^3, no two parallel and no three with lines coplanar. Output: the [`Tiling`] of Q by the
//! facets of the upper hull, its vertices in space. Zero, vertical and level generators, and generators with parallel
//! projections, are ordinary input; no generators give a tiling of one vertex.
//!
//! # Source
//! Section 3 and the separators of Section 5.1: when L_k passes a vertex of the arrangement, two lines that are
//! neighbours on it change places, and the chain L'_k moves over the tile between them.
//!
//! # Method
//! 1. Find the crossings of all pairs of lines and sort them by x, then y.
//! 2. Begin with the left side of Q: its edges in the order in which a line left of all vertices meets the dual lines.
//! 3. At each crossing the two edges of its lines are neighbours on the chain. Make the tile to the right of them, with
//!    a new vertex and two new edges.
//!
//! # Complexity
//! n generators: O(n² log n) exact operations, for n (n − 1) / 2 tiles at most; space O(n²). The paper gives no
//! algorithm.
//!
//! # Shapes
//! `generators`: n × 3, any order; n up to some hundreds, since every tile is stored.
//!
//! # Numerics
//! Everything is exact: dual vertices are rational, points dyadic.
//!
//! # Errors
//! [`TilingError::Generators`] ⇔ a coordinate is not finite or n exceeds 32 bits. [`TilingError::Parallel`] ⇔ two
//! generators are parallel. [`TilingError::Coplanar`] ⇔ three generators, none vertical, are coplanar and their
//! projections are not parallel.
//!
//! # Checked by
//! The crate `verifier`, which builds the arrangement on its own; the separators.
//!
//! # Example
//! ```
//! use zonotope::arrangement::tiling::tiling;
//! // The diagonals of a cube, one longer: two pairs have parallel projections, so 4 of the 6 pairs have a tile.
//! let generators = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.5]];
//! let tiling = tiling(&generators).unwrap();
//! assert_eq!((tiling.vertices().len(), tiling.edges().len(), tiling.tiles().len()), (9, 12, 4));
//! ```

use super::{Corner, CornerIndex, Edge, EdgeIndex, Tile, TileIndex, Tiling, TilingError};
use crate::arrangement::dual::{DualArrangement, Upward};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{cross, exact, is_zero};

/// Where the lines of two upward generators cross.
struct Crossing {
    point: [Rational; 2],
    steps: [usize; 2],
}

/// The tiling of Q by the facets of the upper hull.
///
/// # Errors
/// [`TilingError`] when a coordinate is not finite or the generators are not in general position.
pub fn tiling(generators: &[[f64; 3]]) -> Result<Tiling, TilingError> {
    let dual = DualArrangement::new(generators)?;
    refuse_parallel(&dual)?;
    // the steps of the left side of Q from the top; a line that leans to the left meets the vertical lines far below
    let places = dual.lines().order_before_all();
    let steps: Vec<&Upward> =
        places.iter().rev().map(|&place| &dual.slanted[place as usize]).chain(&dual.level).collect();
    let crossings = crossings(&steps)?;
    let mut sweep = Sweep::start(&dual, &steps);
    for crossing in crossings {
        sweep.pass(crossing, &steps);
    }
    Ok(sweep.tiling)
}

fn refuse_parallel(dual: &DualArrangement) -> Result<(), TilingError> {
    let is_parallel = |a: &Upward, b: &Upward| is_zero(&cross(&exact(a.vector), &exact(b.vector)));
    // equal lines are neighbours in the order of places, and so are equal vertical ones
    let pairs = [&dual.slanted, &dual.level, &dual.poles].into_iter().flat_map(|run| run.windows(2));
    let parallel = pairs.filter(|pair| is_parallel(&pair[0], &pair[1])).map(|pair| {
        let [a, b] = [pair[0].generator as usize, pair[1].generator as usize];
        [a.min(b), a.max(b)]
    });
    match parallel.min() {
        Some([first, second]) => Err(TilingError::Parallel { first, second }),
        None => Ok(()),
    }
}

/// The crossings of all pairs, by x and then y.
fn crossings(steps: &[&Upward]) -> Result<Vec<Crossing>, TilingError> {
    let mut crossings = Vec::new();
    for (j, second) in steps.iter().enumerate() {
        for (i, first) in steps[..j].iter().enumerate() {
            let [x, y, w] = cross(&exact(first.vector), &exact(second.vector));
            if !w.is_zero() {
                let w = w.to_rational();
                crossings.push(Crossing { point: [x.to_rational() / &w, y.to_rational() / w], steps: [i, j] });
            }
        }
    }
    crossings.sort_by(|a, b| a.point.cmp(&b.point).then(a.steps.cmp(&b.steps)));
    let concurrent = crossings.windows(2).filter(|pair| pair[0].point == pair[1].point);
    let generators = concurrent.map(|pair| {
        let lines = pair[0].steps.iter().chain(&pair[1].steps);
        let mut generators: Vec<usize> = lines.map(|&step| steps[step].generator as usize).collect();
        generators.sort_unstable();
        generators.dedup();
        [generators[0], generators[1], generators[2]]
    });
    match generators.min() {
        Some(generators) => Err(TilingError::Coplanar { generators }),
        None => Ok(crossings),
    }
}

/// The tiling left of the sweep line.
struct Sweep {
    tiling: Tiling,
    /// The chain from top to bottom.
    corners: Vec<CornerIndex>,
    edges: Vec<EdgeIndex>,
    /// The steps along the chain, and where each step is.
    order: Vec<usize>,
    position: Vec<usize>,
}

impl Sweep {
    fn start(dual: &DualArrangement, steps: &[&Upward]) -> Self {
        let all = steps.iter().copied().chain(&dual.poles);
        let zero = || [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        let top = all.fold(zero(), |sum, upward| {
            let v = exact(upward.vector);
            [0, 1, 2].map(|axis| &sum[axis] + &v[axis])
        });
        let mut sweep = Self {
            tiling: Tiling {
                vertices: vec![Corner { exact_point: top }],
                edges: Vec::new(),
                tiles: Vec::new(),
                left_side: Vec::new(),
                left_generators: steps.iter().map(|upward| upward.generator as usize).collect(),
            },
            corners: vec![CornerIndex(0)],
            edges: Vec::new(),
            order: (0..steps.len()).collect(),
            position: (0..steps.len()).collect(),
        };
        for upward in steps {
            let upper = sweep.corners[sweep.corners.len() - 1];
            let lower = sweep.corner_below(upper, upward);
            sweep.corners.push(lower);
            let edge = sweep.edge(upward, upper, lower, None);
            sweep.edges.push(edge);
        }
        sweep.tiling.left_side = sweep.corners.clone();
        sweep
    }

    /// A new vertex, one step below another.
    fn corner_below(&mut self, upper: CornerIndex, upward: &Upward) -> CornerIndex {
        let start = &self.tiling.vertices[upper.0 as usize].exact_point;
        let exact_point = [0, 1, 2].map(|axis| &start[axis] - &Dyadic::from_f64(upward.vector[axis]).scaled(1));
        self.tiling.vertices.push(Corner { exact_point });
        CornerIndex(self.tiling.vertices.len() as u32 - 1)
    }

    fn edge(&mut self, upward: &Upward, upper: CornerIndex, lower: CornerIndex, left: Option<TileIndex>) -> EdgeIndex {
        self.tiling.edges.push(Edge { generator: upward.generator as usize, upper, lower, left, right: None });
        EdgeIndex(self.tiling.edges.len() as u32 - 1)
    }

    /// Moves the chain over the tile of a crossing.
    fn pass(&mut self, crossing: Crossing, steps: &[&Upward]) {
        let above = crossing.steps.map(|step| self.position[step]).into_iter().min().expect("two lines cross");
        let [first, second] = [self.order[above], self.order[above + 1]];
        assert!(crossing.steps.contains(&first) && crossing.steps.contains(&second), "neighbours cross");
        let index = TileIndex(self.tiling.tiles.len() as u32);
        let [top, left, bottom] = [0, 1, 2].map(|below| self.corners[above + below]);
        let [upper_left, lower_left] = [self.edges[above], self.edges[above + 1]];
        for edge in [upper_left, lower_left] {
            self.tiling.edges[edge.0 as usize].right = Some(index);
        }
        let right = self.corner_below(top, steps[second]);
        let upper_right = self.edge(steps[second], top, right, Some(index));
        let lower_right = self.edge(steps[first], right, bottom, Some(index));
        let mut generators = [first, second].map(|step| steps[step].generator as usize);
        generators.sort_unstable();
        self.tiling.tiles.push(Tile {
            generators,
            corners: [top, left, bottom, right],
            edges: [upper_left, lower_left, lower_right, upper_right],
            exact_dual: crossing.point,
            above,
        });
        self.corners[above + 1] = right;
        (self.edges[above], self.edges[above + 1]) = (upper_right, lower_right);
        (self.order[above], self.order[above + 1]) = (second, first);
        (self.position[first], self.position[second]) = (above + 1, above);
    }
}
