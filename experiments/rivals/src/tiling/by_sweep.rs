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
//! use rivals::tiling::tiling;
//! // The diagonals of a cube, one longer: two pairs have parallel projections, so 4 of the 6 pairs have a tile.
//! let generators = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.5]];
//! let tiling = tiling(&generators).unwrap();
//! assert_eq!((tiling.vertices().len(), tiling.edges().len(), tiling.tiles().len()), (9, 12, 4));
//! ```

use super::{Corner, CornerIndex, Edge, EdgeIndex, Tile, TileIndex, Tiling, TilingError};
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::separator;
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

/// A generator turned to point up: y > 0, else x < 0, else z > 0.
struct Upward {
    generator: usize,
    vector: [f64; 3],
}

/// The point at which the lines of two upward generators cross.
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
    let left_side = separator(&dual, 0, 0, &mut ()).expect("every tiling has a left side");
    let upward = |generator: usize| Upward::of(generators, generator);
    // the steps of the left side of Q from the top; a line that leans to the left meets the vertical lines far below
    let steps: Vec<Upward> = left_side.generators.into_iter().map(upward).collect();
    let is_pole = |vector: &[f64; 3]| vector[0] == 0.0 && vector[1] == 0.0 && vector[2] != 0.0;
    let poles: Vec<Upward> = (0..generators.len()).map(upward).filter(|pole| is_pole(&pole.vector)).collect();
    refuse_parallel([&steps, &poles])?;
    let crossings = crossings(&steps)?;
    let mut sweep = Sweep::start(&steps, &poles);
    for crossing in crossings {
        sweep.pass(crossing, &steps);
    }
    Ok(sweep.tiling)
}

impl Upward {
    fn of(generators: &[[f64; 3]], generator: usize) -> Self {
        let vector = generators[generator];
        let [x, y, z] = vector;
        let is_reversed = y < 0.0 || (y == 0.0 && (x > 0.0 || (x == 0.0 && z < 0.0)));
        Self { generator, vector: if is_reversed { vector.map(|c| -c) } else { vector } }
    }

    fn exact(&self) -> [Dyadic; 3] {
        self.vector.map(Dyadic::from_f64)
    }

    /// The cross product with another one.
    fn cross(&self, other: &Self) -> [Dyadic; 3] {
        let ([a, b, c], [x, y, z]) = (self.exact(), other.exact());
        [&b * &z - &c * &y, &c * &x - &a * &z, &a * &y - &b * &x]
    }
}

fn refuse_parallel(runs: [&[Upward]; 2]) -> Result<(), TilingError> {
    // equal lines are neighbours on the left side
    let pairs = runs.into_iter().flat_map(|run| run.windows(2));
    let parallel = pairs.filter(|pair| pair[0].cross(&pair[1]).iter().all(Dyadic::is_zero)).map(|pair| {
        let [a, b] = [pair[0].generator, pair[1].generator];
        [a.min(b), a.max(b)]
    });
    match parallel.min() {
        Some([first, second]) => Err(TilingError::Parallel { first, second }),
        None => Ok(()),
    }
}

/// The crossings of all pairs, by x and then y.
fn crossings(steps: &[Upward]) -> Result<Vec<Crossing>, TilingError> {
    let mut crossings = Vec::new();
    for (j, second) in steps.iter().enumerate() {
        for (i, first) in steps[..j].iter().enumerate() {
            let [x, y, w] = first.cross(second);
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
        let mut generators: Vec<usize> = lines.map(|&step| steps[step].generator).collect();
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
    fn start(steps: &[Upward], poles: &[Upward]) -> Self {
        let all = steps.iter().chain(poles);
        let zero = || [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        let top = all.fold(zero(), |sum, upward| {
            let v = upward.exact();
            [0, 1, 2].map(|axis| &sum[axis] + &v[axis])
        });
        let mut sweep = Self {
            tiling: Tiling {
                vertices: vec![Corner { exact_point: top }],
                edges: Vec::new(),
                tiles: Vec::new(),
                left_side: Vec::new(),
                left_generators: steps.iter().map(|upward| upward.generator).collect(),
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
        self.tiling.edges.push(Edge { generator: upward.generator, upper, lower, left, right: None });
        EdgeIndex(self.tiling.edges.len() as u32 - 1)
    }

    /// Moves the chain over the tile of a crossing.
    fn pass(&mut self, crossing: Crossing, steps: &[Upward]) {
        let above = crossing.steps.map(|step| self.position[step]).into_iter().min().expect("two lines cross");
        let [first, second] = [self.order[above], self.order[above + 1]];
        assert!(crossing.steps.contains(&first) && crossing.steps.contains(&second), "neighbours cross");
        let index = TileIndex(self.tiling.tiles.len() as u32);
        let [top, left, bottom] = [0, 1, 2].map(|below| self.corners[above + below]);
        let [upper_left, lower_left] = [self.edges[above], self.edges[above + 1]];
        for edge in [upper_left, lower_left] {
            self.tiling.edges[edge.0 as usize].right = Some(index);
        }
        let right = self.corner_below(top, &steps[second]);
        let upper_right = self.edge(&steps[second], top, right, Some(index));
        let lower_right = self.edge(&steps[first], right, bottom, Some(index));
        let mut generators = [first, second].map(|step| steps[step].generator);
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
