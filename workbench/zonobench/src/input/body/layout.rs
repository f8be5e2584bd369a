//! Which vectors of a table or of an array are generators: its rows or its columns, and whether the first is the
//! centre.

use super::OptionNames;
use super::zonotope::Body;
use crate::input::error::{InputError, Place, Problem, on_one_line};
use crate::input::names::{Order, bodies};
use std::path::Path;

/// The layout of the vectors of a body in a table, in an array, or in a list of lists.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Layout {
    /// Whether the columns are the vectors; the rows are if not.
    pub columns_are_generators: bool,
    /// Whether the first vector is the centre.
    pub center_first: bool,
    /// The number of lines that are left out at the start of a table; told from its cells if absent.
    pub skip: Option<u64>,
}

impl Layout {
    /// Whether nothing is said of the vectors.
    pub(super) fn is_plain(self) -> bool {
        !self.columns_are_generators && !self.center_first
    }

    /// The order of named columns: whether they are coordinates or vectors.
    pub(super) fn order(self) -> Order {
        if self.columns_are_generators { Order::AsTheyStand } else { Order::Coordinates }
    }

    /// The body of rows with the names of their columns, if they have names, and the place of these. What is not plain
    /// is told in a line.
    pub(super) fn body(
        self,
        file: &Path,
        (names, place): (&[String], Place),
        rows: Vec<Vec<f64>>,
        options: OptionNames,
        tell: &mut dyn FnMut(&str),
    ) -> Result<Body, InputError> {
        let named = Named::of(names);
        let is_default = self.is_plain();
        if let (true, Named::AmongOthers(index)) = (is_default, named) {
            let problem = format!(
                "the column '{}' is named as a centre or a generator, but not all others are named as generators, g1, \
                 g2, …; {} and {} say how the table is to be read, and so does another name",
                on_one_line(&names[index]),
                options.columns_are_generators,
                options.center_first
            );
            return Err(Problem::Shape(problem).at(file, place));
        }
        // Names of the columns say which way the vectors lie, whatever the options say of their order.
        let by_columns = self.columns_are_generators || matches!(named, Named::Generators { .. });
        let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
        let mut vectors = if by_columns { transposed(file, &rows)? } else { rows };
        let center = match named {
            Named::Generators { center } if by_columns => center.or(self.center_first.then_some(0)),
            _ => self.center_first.then_some(0),
        };
        let center = center.filter(|&index| index < vectors.len()).map(|index| vectors.remove(index));
        let read = |vectors: &str| {
            let generators = if vectors.is_empty() { "generators" } else { vectors };
            let center = if center.is_some() { "the centre and " } else { "" };
            format!("{center}{generators}")
        };
        if !self.columns_are_generators && by_columns {
            tell(&format!("its columns are read as {}, as their names say", read("")));
        } else if is_default && count < width {
            tell(&format!(
                "its rows, {count} with {width} numbers, are read as generators; {} reads the columns, {} the first of \
                 them as the centre",
                options.columns_are_generators, options.center_first
            ));
        }
        super::body(file, center, vectors)
    }
}

/// The meaning of a header for the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Named {
    /// Nothing about bodies, or there is none.
    Nothing,
    /// All columns are generators but for one that may be the centre.
    Generators { center: Option<usize> },
    /// One, by its place, is called a centre or a generator, and others are not.
    AmongOthers(usize),
}

impl Named {
    fn of(names: &[String]) -> Self {
        let centers = bodies::centers(names);
        let are_generators =
            |centers: &[usize]| (0..names.len()).all(|k| centers.contains(&k) || bodies::is_generator(&names[k]));
        match *centers.as_slice() {
            [] if !names.is_empty() && are_generators(&[]) => Self::Generators { center: None },
            [center] if are_generators(&centers) => Self::Generators { center: Some(center) },
            [center, ..] => Self::AmongOthers(center),
            [] => {
                let numbered = names.iter().position(|name| bodies::is_numbered_vector(name));
                numbered.map_or(Self::Nothing, Self::AmongOthers)
            }
        }
    }
}

fn transposed(file: &Path, rows: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, InputError> {
    let width = rows.first().map_or(0, Vec::len);
    if let Some(index) = rows.iter().position(|row| row.len() != width) {
        let problem = Problem::Ragged { found: rows[index].len(), expected: width };
        return Err(problem.at(file, Place::Path(format!("[{index}]"))));
    }
    Ok((0..width).map(|column| rows.iter().map(|row| row[column]).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Centre and generators, or the complaint, with the lines that are told.
    fn read(layout: Layout, names: &[&str], rows: &[&[f64]]) -> (Result<Body, String>, Vec<String>) {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        let rows = rows.iter().map(|row| row.to_vec()).collect();
        let mut told = Vec::new();
        let read =
            layout.body(Path::new("z.csv"), (&names, Place::Line(1)), rows, OptionNames::OF_SECOND, &mut |line| {
                told.push(line.to_owned());
            });
        (read.map_err(|error| error.to_string()), told)
    }

    fn body(center: &[f64], generators: &[&[f64]]) -> Result<Body, String> {
        let generators = generators.iter().map(|generator| generator.to_vec()).collect();
        Ok(Body { center: center.to_vec(), generators, is_rounded: false })
    }

    const MATRIX: [&[f64]; 2] = [&[10.0, 1.0, 0.0], &[0.0, 0.0, 1.0]];

    #[test]
    fn a_header_that_names_centre_and_generators_is_read_as_it_is_meant() {
        let meant = body(&[10.0, 0.0], &[&[1.0, 0.0], &[0.0, 1.0]]);
        for names in [["center", "g1", "g2"], ["Centre", "G_1", "G_2"], ["c", "gen 1", "gen 2"]] {
            let (found, told) = read(Layout::default(), &names, &MATRIX);
            assert_eq!(found, meant, "{names:?}");
            assert_eq!(told, ["its columns are read as the centre and generators, as their names say"]);
        }
        let last: [&[f64]; 2] = [&[1.0, 0.0, 10.0], &[0.0, 1.0, 0.0]];
        assert_eq!(read(Layout::default(), &["g1", "g2", "c"], &last).0, meant);
        let around_origin = body(&[0.0, 0.0], &[&[10.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]]);
        let (found, told) = read(Layout::default(), &["g1", "g2", "g3"], &MATRIX);
        assert_eq!((found, told.len()), (around_origin, 1));
    }

    #[test]
    fn a_wide_table_without_a_header_says_how_it_is_read() {
        let (found, told) = read(Layout::default(), &[], &MATRIX);
        assert_eq!(found, body(&[0.0; 3], &MATRIX));
        assert!(told[0].contains("2 with 3 numbers") && told[0].contains("--columns-are-generators-b"), "{told:?}");
        for (names, rows) in [(&["a", "b", "c"][..], &[&[1.0, 2.0, 3.0][..]; 3]), (&[], &[&[1.0, 2.0, 3.0][..]; 3])] {
            let (found, told) = read(Layout::default(), names, rows);
            assert_eq!((found, told.len()), (body(&[0.0; 3], rows), 0), "{names:?}");
        }
    }

    #[test]
    fn options_say_which_vectors_are_meant() {
        let columns = Layout { columns_are_generators: true, ..Layout::default() };
        let both = Layout { center_first: true, ..columns };
        let rows = Layout { center_first: true, ..Layout::default() };
        let meant = body(&[10.0, 0.0], &[&[1.0, 0.0], &[0.0, 1.0]]);
        assert_eq!(read(both, &[], &MATRIX), (meant.clone(), vec![]));
        assert_eq!(read(columns, &["c", "g1", "g2"], &MATRIX).0, meant);
        assert_eq!(read(columns, &[], &MATRIX).0, body(&[0.0; 2], &[&[10.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]]));
        assert_eq!(read(rows, &[], &MATRIX).0, body(MATRIX[0], &MATRIX[1..]));
    }

    #[test]
    fn a_centre_among_columns_of_other_names_is_asked_about() {
        let matrix: [&[f64]; 2] = [&[10.0, 1.0], &[0.0, 0.0]];
        for names in [["c", "x1"], ["C", "A1"], ["mean", "pc1"], ["center", "centre"], ["Midpoint", "c1"], ["c", "a"]] {
            let (found, _) = read(Layout::default(), &names, &matrix);
            let complaint = found.expect_err("it may be meant in two ways");
            assert!(complaint.contains(&format!("line 1: the column '{}' is named as a centre", names[0])));
        }
        let (found, told) = read(Layout::default(), &["centroid", "g"], &matrix);
        assert_eq!((found, told.len()), (body(&[10.0, 0.0], &[&[1.0, 0.0]]), 1));
        let tall: [&[f64]; 3] = [&[10.0, 1.0, 0.0], &[0.0, 0.0, 1.0], &[0.0, 0.0, 1.0]];
        assert!(read(Layout::default(), &["c", "x1", "x2"], &tall).0.is_err());
    }
}
