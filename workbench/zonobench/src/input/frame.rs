//! Points from a table in JSON: an object whose fields are the columns, `{"x": [1, …], "y": [2, …]}`, each a list or an
//! object with a field for each row; or one with the names under `columns` and the rows under `data`.

use std::path::Path;

use super::columns::Columns;
use super::error::{InputError, Place, Problem};
use super::geojson::MOVED_BY;
use super::names::{self, bodies};
use super::parsed::number;
use super::points::{Points, Wanted};
use super::reading::{Reading, Skipping, columns_of};
use batch::json::Tree;

/// A table of which each cell is a value of JSON.
pub(super) struct Frame<'a> {
    names: Vec<String>,
    cells: Cells<'a>,
    rows: usize,
}

/// The cells of a table, row by row or column by column.
enum Cells<'a> {
    Rows(&'a [Tree]),
    Columns(Vec<&'a Tree>),
}

impl<'a> Frame<'a> {
    /// The table that a document is, if it is one.
    pub(super) fn of(document: &'a Tree) -> Option<Self> {
        let Tree::Object(fields) = document else { return None };
        if let (Some(names), Some(rows)) = (document.field("columns"), document.field("data").and_then(Tree::list)) {
            let names: Vec<String> = names.list()?.iter().map(name).collect::<Option<_>>()?;
            let is_table = rows.iter().all(|row| row.list().is_some_and(|row| row.len() == names.len()));
            return is_table.then_some(Self { names, cells: Cells::Rows(rows), rows: rows.len() });
        }
        let rows = length(&fields.first()?.1)?;
        let first = &fields[0].1;
        let has_same_rows = |column: &Tree| match (first, column) {
            (Tree::Object(first), Tree::Object(column)) => first.iter().zip(column).all(|(a, b)| a.0 == b.0),
            _ => first.list().is_some() == column.list().is_some(),
        };
        let is_table = fields.iter().all(|(_, column)| length(column) == Some(rows) && has_same_rows(column));
        let names = fields.iter().map(|(name, _)| name.clone()).collect();
        let cells = Cells::Columns(fields.iter().map(|(_, column)| column).collect());
        is_table.then_some(Self { names, cells, rows })
    }

    /// Whether a field of the document is part of the table: the rows with their names and numbers, or a column. Two or
    /// three numbers under the name of a move or a scale may be its coordinates rather than a column.
    pub(super) fn holds(&self, name: &str) -> bool {
        match self.cells {
            Cells::Rows(_) => ["columns", "data", "index"].contains(&name),
            Cells::Columns(_) => !((2..=3).contains(&self.rows) && MOVED_BY.contains(&name)),
        }
    }

    /// The columns of coordinates: the chosen ones, or those with their names; `None` if there are no such names.
    fn chosen(&self, columns: Option<&Columns>, wanted: Wanted) -> Result<Option<Vec<usize>>, Problem> {
        match columns {
            Some(columns) => names::chosen(&self.names, columns, &self.names.join(", ")).map(Some),
            None => Ok(names::of_coordinates(&self.names, wanted)?.or_else(|| {
                let may_be = self.rows > 0 && may_be_coordinates(&self.names, wanted) && self.holds_numbers();
                may_be.then(|| (0..self.names.len()).collect())
            })),
        }
    }

    /// Whether the first row holds nothing but numbers.
    fn holds_numbers(&self) -> bool {
        (0..self.names.len()).all(|column| matches!(self.cell(0, column), Tree::Number(_)))
    }

    fn cell(&self, row: usize, column: usize) -> &'a Tree {
        match &self.cells {
            Cells::Rows(rows) => &rows[row].list().expect("each row was looked at")[column],
            Cells::Columns(columns) => match columns[column] {
                Tree::Object(cells) => &cells[row].1,
                cells => &cells.list().expect("each column was looked at")[row],
            },
        }
    }

    /// Reads the points; `None` if no columns are named as coordinates.
    pub(super) fn points(
        &self,
        file: &Path,
        columns: Option<&Columns>,
        wanted: Wanted,
        skipping: &mut Skipping,
    ) -> Result<Option<Reading>, InputError> {
        let at_file = |problem: Problem| problem.at(file, Place::File);
        let Some(chosen) = self.chosen(columns, wanted).map_err(at_file)? else { return Ok(None) };
        let mut points = Points::of_dimension(chosen.len()).expect("no more columns are chosen than are read");
        for row in 0..self.rows {
            let coordinate = |&column: &usize| {
                let place = || Place::Path(format!("{}[{row}]", self.names[column]));
                number(self.cell(row, column)).map_err(|problem| problem.at(file, place()))
            };
            match chosen.iter().map(coordinate).collect::<Result<Vec<f64>, _>>() {
                Err(error) if skipping.passes_over(&error.problem, points.len()) => {}
                point => points.push(&point?).map_err(at_file)?,
            }
        }
        let mut reading = Reading::of(points, columns_of(&self.names, &chosen));
        if columns.is_none() {
            let used: Vec<String> = chosen.iter().map(|&column| self.names[column].clone()).collect();
            reading.notes.extend(names::in_another_order(&used));
        }
        Ok(Some(reading))
    }
}

/// Whether names say nothing of what they name, and are as many as a table has columns whose names say nothing: two or
/// more, none of them a number, or that of a label, of a move or of a part of a body.
pub(super) fn may_be_coordinates(names: &[String], wanted: Wanted) -> bool {
    let says =
        |name: &String| name.parse::<f64>().is_ok() || names::is_label(name) || MOVED_BY.contains(&name.as_str());
    names.len() > 1 && wanted.takes_all(names.len(), true) && !names.iter().any(says) && !bodies::are_of_bodies(names)
}

/// The name of a column; pandas numbers those without one.
fn name(value: &Tree) -> Option<String> {
    value.text().map(str::to_owned).or_else(|| value.index().map(|number| number.to_string()))
}

fn length(column: &Tree) -> Option<usize> {
    match column {
        Tree::List(cells) => Some(cells.len()),
        Tree::Object(cells) => Some(cells.len()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::parsed::parse;
    use super::*;

    fn read(content: &str, columns: Option<&str>) -> Result<Option<(Points, Option<String>)>, String> {
        let file = Path::new("p.json");
        let document = parse(file, content.as_bytes()).expect("JSON");
        let columns = columns.map(|columns| columns.parse().expect("well formed"));
        let Some(frame) = Frame::of(&document) else { return Ok(None) };
        let reading = frame.points(file, columns.as_ref(), Wanted::Any, &mut Skipping::default());
        let reading = reading.map_err(|error| error.to_string())?;
        Ok(reading.map(|reading| (reading.points.clone(), reading.in_words())))
    }

    #[test]
    fn columns_may_be_lists_or_objects_or_named_apart() {
        let expected = Points::Plane(vec![[1.0, 2.0], [3.0, 4.0]]);
        for content in [
            r#"{"id":["a","b"],"Y":[2,4],"x":[1,3]}"#,
            r#"{"id":{"0":"a","1":"b"},"Y":{"0":2,"1":4},"x":{"0":1,"1":3}}"#,
            r#"{"columns":["id","Y","x"],"index":[0,1],"data":[["a",2,1],["b",4,3]]}"#,
        ] {
            let told = Some("x, Y; left out: id".to_owned());
            assert_eq!(read(content, None), Ok(Some((expected.clone(), told))), "{content}");
            assert_eq!(read(content, Some("3,2")).expect("points").expect("points").0, expected, "{content}");
            assert_eq!(read(content, Some("id,x")), Err("p.json: id[0]: 'a' is not a number".to_owned()), "{content}");
        }
        for content in [
            "[1]",
            r#"{"x":[1],"y":[1,2]}"#,
            r#"{"x":{"0":1},"y":{"1":2}}"#,
            r#"{"x":[1],"y":{"0":2}}"#,
            r#"{"x":[1],"n":7}"#,
            r#"{"center":[1,2],"generators":[[1,0],[0,1]]}"#,
            r#"{"columns":["x","y"],"data":[[1]]}"#,
            r#"{"0":[1,2],"1":[3,4]}"#,
        ] {
            assert_eq!(read(content, None), Ok(None), "{content}");
        }
    }
}
