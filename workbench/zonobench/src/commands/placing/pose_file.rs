//! A pose from a file.

use std::path::Path;

use anyhow::anyhow;

use crate::commands::usage::tell;
use crate::input::PoseDocument;
use batch::json::Tree;
use batch::placement::Placement;
use batch::read_pose;

/// The pose of a file, for a body of the dimension: an object as it stands in a question, or the rows of a matrix,
/// which is square, or has the translation as its last column, perhaps with a last row 0, …, 0, 1.
pub(super) fn read(file: &Path, dimension: usize, option: &str) -> anyhow::Result<Placement> {
    let name = || format!("{option} {}", file.display());
    let rows = match PoseDocument::read(file, tell)? {
        PoseDocument::Rows(rows) => rows,
        PoseDocument::Object(object) => {
            let pose = object.field("pose").filter(|pose| matches!(pose, Tree::Object(_))).unwrap_or(&object);
            return read_pose(pose, dimension).map_err(|refusal| anyhow!("{}: {}", name(), refusal.message));
        }
    };
    of_rows(&rows, dimension).ok_or_else(|| {
        let width = rows.first().map_or(0, Vec::len);
        let (count, more) = (rows.len(), dimension + 1);
        anyhow!(
            "{}: {count} rows with {width} numbers; a pose of {dimension} dimensions is a matrix of {dimension} × \
             {dimension}, of {dimension} × {more}, or of {more} × {more} with the last row 0, …, 0, 1",
            name()
        )
    })
}

fn of_rows(rows: &[Vec<f64>], dimension: usize) -> Option<Placement> {
    let (body, last) = rows.split_at_checked(dimension)?;
    let is_homogeneous = match last {
        [] => true,
        [last] => last.len() == dimension + 1 && last[..dimension].iter().all(|x| *x == 0.0) && last[dimension] == 1.0,
        _ => false,
    };
    let width = body.first()?.len();
    let fits = is_homogeneous && (width == dimension + 1 || (width == dimension && last.is_empty()));
    if !fits || body.iter().any(|row| row.len() != width) {
        return None;
    }
    let matrix = body.iter().map(|row| row[..dimension].to_vec()).collect();
    let translation = body.iter().map(|row| row.get(dimension).copied().unwrap_or_default()).collect();
    Placement::new(matrix, translation)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_with_and_without_a_translation() {
        let shear = [[1.0, 0.5], [0.0, 1.0]].map(|row| row.to_vec());
        let pose = of_rows(&shear, 2).expect("a square matrix");
        assert_eq!((pose.matrix(), pose.translation()), (&shear[..], &[0.0, 0.0][..]));
        let wide = [vec![1.0, 0.5, 7.0], vec![0.0, 1.0, 8.0]];
        let moved = of_rows(&wide, 2).expect("with a translation");
        assert_eq!((moved.matrix(), moved.translation()), (&shear[..], &[7.0, 8.0][..]));
        let whole = [&wide[..], &[vec![0.0, 0.0, 1.0]]].concat();
        assert_eq!(of_rows(&whole, 2), Some(moved));
        let projective = [&wide[..], &[vec![0.0, 0.5, 1.0]]].concat();
        for wrong in [&projective[..], &wide[..1], &[vec![1.0], vec![0.0]], &[], &[&shear[..], &shear[..1]].concat()] {
            assert_eq!(of_rows(wrong, 2), None, "{wrong:?}");
        }
    }
}
