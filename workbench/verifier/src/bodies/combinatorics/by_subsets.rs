//! Faces of any dimension, counted subset by subset.
//!
//! In the coordinates of its span the zonotope has as many vertices as the hyperplanes g_i^⊥ cut space into regions,
//! and the number of regions grows, hyperplane by hyperplane, by the regions into which the earlier ones cut the new
//! one. The edges parallel to g_i are the vertices of the projection along g_i. A facet is the zonotope of all the
//! generators in a hyperplane that they span.

use std::collections::BTreeMap;

use dashu_int::IBig;

use super::{Counts, directions, modulo};
use crate::exact::linear::{Echelon, Vector, dot};
use crate::exact::subsets::subsets;

/// The numbers of faces of the zonotope of segments along distinct lines that span a space of dimension `rank`.
pub(crate) fn counts(rank: usize, lines: &[Vector]) -> Option<Counts> {
    let along = |line: &Vector| directions(&modulo(lines, line));
    let edges = match rank {
        0 => 0,
        2 => 2 * lines.len() as u64,
        _ => lines.iter().map(|line| regions(rank - 1, &along(line))).sum(),
    };
    let mut facet_sizes = BTreeMap::new();
    match rank {
        0 => {}
        1 => {
            facet_sizes.insert(1, 2);
        }
        2 => {
            facet_sizes.insert(2, 2 * lines.len() as u64);
        }
        _ => {
            for u in normals(rank, lines) {
                let in_facet: Vec<Vector> = lines.iter().filter(|line| dot(&u, line) == IBig::ZERO).cloned().collect();
                let axis = u.iter().position(|component| *component != IBig::ZERO).expect("a normal is not zero");
                let drop =
                    |line: &Vector| (0..rank).filter(|&other| other != axis).map(|other| line[other].clone()).collect();
                let flat: Vec<Vector> = in_facet.iter().map(drop).collect();
                let size = usize::try_from(regions(rank - 1, &directions(&flat))).ok()?;
                *facet_sizes.entry(size).or_default() += 2;
            }
        }
    }
    Some(Counts { vertices: regions(rank, lines), edges, facet_sizes })
}

/// The number of regions between the hyperplanes orthogonal to distinct directions.
fn regions(dimension: usize, lines: &[Vector]) -> u64 {
    match (dimension, lines.len()) {
        (_, 0) => 1,
        (1, _) => 2,
        (2, count) => 2 * count as u64,
        (_, count) => {
            (0..count).fold(1, |sum, i| sum + regions(dimension - 1, &directions(&modulo(&lines[..i], &lines[i]))))
        }
    }
}

/// A normal for each hyperplane that some of the directions span.
fn normals(rank: usize, lines: &[Vector]) -> Vec<Vector> {
    let spanned = subsets(lines.len(), rank - 1).filter_map(|subset| {
        let span = Echelon::spanned(rank, subset.iter().map(|&index| &lines[index]));
        <[Vector; 1]>::try_from(span.complement(rank)).ok()
    });
    directions(&spanned.flatten().collect::<Vec<_>>())
}
