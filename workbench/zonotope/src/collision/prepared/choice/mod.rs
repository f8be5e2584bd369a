//! The right structure for repeated queries: a caller says how many bytes may be held and about how many queries will
//! be asked, and gets the one that costs least.
//!
//! Costs are those of a model ([`plans`]): the generators read in building, and by a query that is not clear. The
//! model's constants were measured and have their names in `costs`; nothing is timed when a structure is chosen, so
//! that the choice is the same wherever it is made.
//!
//! | structure | bytes of n generators | by the model it is right for |
//! |---|---|---|
//! | [`Rows`](Kind::Rows) | 24 n | up to some dozen queries, and where nothing else fits |
//! | [`Blocks`](Kind::Blocks) | 48 n | more queries of up to 500 generators, some dozen of more |
//! | [`DirectionTree`](Kind::DirectionTree) | 34 n + 2^15 | from 85 queries of 4,096 generators, 60 of 2^16 |
//! | [`Cutting`](Kind::Cutting) | 24 n + 800 m | no size that was measured |
//! | [`Facets`](Kind::Facets) | 12 n² | from 30 queries of 4 generators, 1,500 of 16, 140,000 of 64 |
//!
//! A budget between 34 and 48 bytes a generator holds a tree and no blocks.
//!
//! # Cuttings
//!
//! A query by a cutting takes the time of some 160,000 readings at n = 1,024, however large m is, since each of its
//! decisions is a search in exact sums; a scan takes a quarter of that, a tree a sixth. What is left of its cost grows
//! with log² n, and that of a tree with √n. So the model lets a cutting overtake the tree from n = 2^22 on, in
//! terabytes, and after 2 · 10^10 queries; that is far beyond the sizes of the measurement, and no reason to build one.
//! The structure of Lemma 5.3 is there for what it shows, and to be asked for by its [`Kind`].
//!
//! # Example
//! ```
//! use zonotope::{Status, Zonotope, collision::prepared::{QueryStructure, choice::Kind}};
//! // the cube [−1, 1]³: three facets tell everything
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
//! let structure = QueryStructure::new(cube, 10_000, 1_000_000)?;
//! assert_eq!((structure.which(), structure.status([1.0, 0.5, 0.0])?), (Kind::Facets, Status::Boundary));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod costs;
mod structure;

#[cfg(test)]
mod tests;

pub use costs::{Kind, Plan, plans};
pub use structure::{ChoiceError, QueryStructure};
