//! What each structure for repeated queries costs: bytes, and the reading of so many generators.
//!
//! The unit of time is the reading of one generator in a pass over the blocks of 2^16 of them, 0.2 ns on the machine of
//! the measurements. A query is one that is not clear: the gauge of a point within 3e-8 of the boundary of a random
//! body, without a proof. Constants were measured side by side in one run, of 3 to 2^18 generators, of facets up to 64
//! and of cuttings up to 1,024; those of a cutting beyond that are an extrapolation. Queries were measured within a
//! factor of two of the model, and so was building, but for blocks of a dozen generators and of 2^18, which took a
//! fifth and six times of it: there the time goes into memory.

use crate::collision::prepared::by_cutting::PreparedByCutting;
use crate::collision::prepared::by_facets::PreparedByFacets;
use crate::zonotope::{PreparedBody, Zonotope};

/// A structure for repeated queries about one body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// The body as it is, read by every query.
    Rows,
    /// [`PreparedBody`](crate::zonotope::PreparedBody): the same in blocks.
    Blocks,
    /// [`DirectionTree`](crate::collision::prepared::DirectionTree).
    DirectionTree,
    /// [`PreparedByCutting`](crate::collision::prepared::by_cutting::PreparedByCutting) with a space of m.
    Cutting {
        /// The number m.
        space: u64,
    },
    /// [`PreparedByFacets`](crate::collision::prepared::PreparedByFacets).
    Facets,
}

/// What a structure costs for a body of so many generators, by the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
    /// The structure.
    pub kind: Kind,
    /// The bytes that it holds at most, the generators included, but for bodies like none that were measured.
    pub bytes: u64,
    /// Generators read in building it.
    pub build: f64,
    /// Generators read by a query.
    pub query: f64,
}

impl Plan {
    /// Generators read in building the structure and answering queries.
    pub fn total(&self, queries: u64) -> f64 {
        self.build + self.query * queries as f64
    }
}

/// Bytes of a generator: three doubles.
const GENERATOR_BYTES: u64 = 24;

/// A query that reads all generators: of few, so much for each and beside that; of many, the same.
const ROWS_QUERY_OF_SMALL_BODIES: [f64; 2] = [160.0, 1_500.0];
const ROWS_QUERY_OF_LARGE_BODIES: [f64; 2] = [15.0, 23_000.0];

/// The same from blocks.
const BLOCKS_QUERY_OF_SMALL_BODIES: [f64; 2] = [145.0, 1_400.0];
const BLOCKS_QUERY_OF_LARGE_BODIES: [f64; 2] = [14.0, 21_000.0];

/// Laying out blocks: for each generator, and beside that.
const BLOCKS_BUILD: [f64; 2] = [20.0, 25_000.0];

/// A tree: for each generator in building, and beside that; for each √n in a query, and beside that; and bytes. A query
/// about few generators reads them all.
const TREE_BUILD: [f64; 2] = [750.0, 60_000.0];
const TREE_QUERY: [f64; 2] = [350.0, 20_000.0];
const TREE_BYTES: u64 = 34;
const TREE_OWN_BYTES: u64 = 1 << 15;

/// All facets: for each pair of generators and each generator in building; for each pair in a query, and beside that.
const FACETS_BUILD: f64 = 2_500.0;
const FACETS_QUERY: [f64; 2] = [4.1, 100.0];

/// A cutting: for each unit of m and each bit of n in building; for each pair of bits of n in a query, for each
/// generator that crosses a trapezoid, and beside that; and bytes for each unit of m, on the family that needs most.
const CUTTING_BUILD: f64 = 15_000.0;
const CUTTING_STEPS: [f64; 2] = [1_150.0, 25_000.0];
const CUTTING_READS: f64 = 10.0;
const CUTTING_BYTES: u64 = 800;

/// The plans for a body of n generators that fit into so many bytes, that of the least total for so many queries first;
/// of equal ones that which is first in the order of [`Kind`]. Of cuttings only the best is listed.
///
/// For more bytes the least total is never more; for more queries the cost of a query is never more, and that of
/// building never less.
pub fn plans(n: u64, budget: u64, queries: u64) -> Vec<Plan> {
    let by_total = |a: &Plan, b: &Plan| a.total(queries).total_cmp(&b.total(queries)).then(a.kind.cmp(&b.kind));
    let fits = |plan: &Plan| plan.bytes <= budget;
    let powers = (0..u64::BITS).map(|k| 1u64 << k).take_while(|r| *r <= n.max(1));
    let best_cutting = powers.map(|r| cutting(n, r)).filter(fits).min_by(by_total);
    let others = [rows(n), blocks(n), direction_tree(n), facets(n)].into_iter().filter(fits);
    let mut plans: Vec<Plan> = others.chain(best_cutting).collect();
    plans.sort_by(by_total);
    plans
}

/// The body alone.
pub(super) fn rows(n: u64) -> Plan {
    let bytes = times(n, GENERATOR_BYTES).saturating_add(size_of::<Zonotope<3>>() as u64);
    Plan {
        kind: Kind::Rows,
        bytes,
        build: 0.0,
        query: at(ROWS_QUERY_OF_SMALL_BODIES, n as f64).min(at(ROWS_QUERY_OF_LARGE_BODIES, n as f64)),
    }
}

fn blocks(n: u64) -> Plan {
    let bytes = times(n.div_ceil(8).saturating_mul(8), 2 * GENERATOR_BYTES);
    let bytes = bytes.saturating_add(size_of::<PreparedBody>() as u64);
    let n = n as f64;
    Plan {
        kind: Kind::Blocks,
        bytes,
        build: at(BLOCKS_BUILD, n),
        query: at(BLOCKS_QUERY_OF_SMALL_BODIES, n).min(at(BLOCKS_QUERY_OF_LARGE_BODIES, n)),
    }
}

fn direction_tree(n: u64) -> Plan {
    let bytes = times(n, TREE_BYTES).saturating_add(TREE_OWN_BYTES);
    let n = n as f64;
    let query = at(ROWS_QUERY_OF_SMALL_BODIES, n).min(at(TREE_QUERY, n.sqrt()));
    Plan { kind: Kind::DirectionTree, bytes, build: at(TREE_BUILD, n), query }
}

fn facets(n: u64) -> Plan {
    let pairs = times(n, n.saturating_sub(1)) / 2;
    let bytes = times(n.saturating_add(pairs), GENERATOR_BYTES).saturating_add(size_of::<PreparedByFacets>() as u64);
    let (pairs, n) = (pairs as f64, n as f64);
    Plan { kind: Kind::Facets, bytes, build: FACETS_BUILD * pairs * n, query: at(FACETS_QUERY, pairs) }
}

fn cutting(n: u64, r: u64) -> Plan {
    let space = times(n, r);
    let own = size_of::<PreparedByCutting>() as u64;
    let bytes = times(n, GENERATOR_BYTES).saturating_add(times(space, CUTTING_BYTES)).saturating_add(own);
    let bits = f64::from(u64::BITS - n.leading_zeros());
    let query = at(CUTTING_STEPS, bits * bits) + CUTTING_READS * n as f64 / r as f64;
    Plan { kind: Kind::Cutting { space }, bytes, build: CUTTING_BUILD * space as f64 * bits, query }
}

/// So much for each of some things, and beside that.
fn at([each, beside]: [f64; 2], count: f64) -> f64 {
    each * count + beside
}

/// A product that does not fit 64 bits is beyond every budget.
fn times(a: u64, b: u64) -> u64 {
    a.saturating_mul(b)
}
