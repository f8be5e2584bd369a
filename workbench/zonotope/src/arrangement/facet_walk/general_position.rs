//! The four neighbours of a facet of generators in general position.

use thiserror::Error;

use super::by_scan::ScanWalk;
use super::error::WalkError;
use super::facet::FacetName;
use super::interface::FacetWalk;
use super::to_ray::LocatedWalk;

/// Why a facet's neighbours are not four parallelograms.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum GeneralPositionError {
    /// There is no walk on this body, or no such facet.
    #[error(transparent)]
    Walk(#[from] WalkError),
    /// A generator is zero.
    #[error("generator {generator} is zero, so the generators are not in general position")]
    Zero {
        /// Its index.
        generator: usize,
    },
    /// Two generators are parallel.
    #[error("generators {} and {} are parallel, so they are not in general position", .generators[0], .generators[1])]
    Parallel {
        /// Their indices.
        generators: [usize; 2],
    },
    /// Three generators are in a plane.
    #[error(
        "generators {}, {} and {} are in one plane, so they are not in general position",
        .generators[0], .generators[1], .generators[2]
    )]
    Coplanar {
        /// Their indices.
        generators: [usize; 3],
    },
}

/// The four facets that have an edge in common with a facet [i, j, s], of generators in general position:
/// counter-clockwise seen from outside, from the one across the edge that the boundary runs along in the direction of
/// v_i. The third and the fourth are across the edges that are parallel to those of the first two. O(n log n).
///
/// Whether all generators are in general position is not decided: zero and parallel ones are found wherever they are,
/// coplanar ones along this facet or a neighbour.
///
/// # Errors
/// [`GeneralPositionError::Zero`], [`GeneralPositionError::Parallel`], [`GeneralPositionError::Coplanar`] if such
/// generators are found; [`GeneralPositionError::Walk`] if a number is not finite, the body is flat or the name is that
/// of no facet.
///
/// # Example
/// ```
/// use zonotope::arrangement::facet_walk::{FacetName, NormalSense::{Against, Along}, adjacent_facets};
/// let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let neighbours = adjacent_facets(&cube, FacetName::new(0, 1, Along))?;
/// let sides = [(0, 2, Along), (1, 2, Along), (0, 2, Against), (1, 2, Against)];
/// assert_eq!(neighbours, sides.map(|(i, j, s)| FacetName::new(i, j, s)));
/// # Ok::<(), zonotope::arrangement::facet_walk::GeneralPositionError>(())
/// ```
pub fn adjacent_facets(generators: &[[f64; 3]], facet: FacetName) -> Result<[FacetName; 4], GeneralPositionError> {
    let mut walk = ScanWalk::new(generators)?;
    let classes = walk.classes();
    if let Some(generator) = (0..generators.len()).find(|&generator| classes.class_of(generator).is_none()) {
        return Err(GeneralPositionError::Zero { generator });
    }
    if let Some(class) = classes.all().find(|&class| classes.members(class).len() > 1) {
        return Err(GeneralPositionError::Parallel { generators: first_members(classes.members(class)) });
    }
    walk.place_at(facet)?;
    refuse_coplanar(&walk)?;
    let mut neighbours = [facet; 4];
    for (edge, neighbour) in neighbours.iter_mut().enumerate() {
        walk.place_at(facet)?;
        walk.step(edge)?;
        refuse_coplanar(&walk)?;
        *neighbour = walk.facet();
    }
    Ok(neighbours)
}

/// Refuses a facet along more than two generators.
fn refuse_coplanar(walk: &ScanWalk) -> Result<(), GeneralPositionError> {
    let along = walk.cycle().half();
    if along.len() == 2 {
        return Ok(());
    }
    let members = along.iter().map(|directed| walk.classes().first_member(directed.class));
    Err(GeneralPositionError::Coplanar { generators: first_members(members) })
}

/// The least indices of generators, of which there are enough.
fn first_members<const N: usize>(members: impl Iterator<Item = usize>) -> [usize; N] {
    let mut members: Vec<usize> = members.collect();
    members.sort_unstable();
    std::array::from_fn(|k| members[k])
}
