//! A zonotope from a file.

use std::path::{Path, PathBuf};

use super::bytes::read_limited;
use super::document::{number, parse};
use super::error::{InputError, Place, Problem};
use super::{Format, push_limited, table};
use crate::json::Tree;

/// A zonotope of any dimension: every vector has as many coordinates as the centre, at least one, all finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The centre; the origin where the file has none.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
}

/// A file with a zonotope.
#[derive(Debug, Clone)]
pub struct BodySource {
    /// The file; `-` is standard input.
    pub file: PathBuf,
    /// Its format; told from the extension if absent.
    pub format: Option<Format>,
}

impl BodySource {
    /// Reads the zonotope: rows of a table are generators; a document is a list of generators, or an object with `generators`
    /// and perhaps a `center`.
    pub fn read(&self) -> Result<Body, InputError> {
        let file = &self.file;
        let format = self
            .format
            .or_else(|| Format::of_extension(file))
            .ok_or_else(|| Problem::UnknownFormat.at(file, Place::File))?;
        let content = read_limited(file)?;
        match format {
            Format::Csv => body(file, None, table::rows(file, &content)?),
            Format::Json => document(file, &parse(file, &content)?),
            other => {
                let problem = format!("the format {other} holds no zonotopes; csv and json do");
                Err(Problem::Shape(problem).at(file, Place::File))
            }
        }
    }
}

fn document(file: &Path, document: &Tree) -> Result<Body, InputError> {
    let misshapen = |problem: String, place: Place| Problem::Shape(problem).at(file, place);
    let (rows, path) = match (document.list(), document.field("generators").and_then(Tree::list)) {
        (Some(rows), _) => (rows, ""),
        (None, Some(rows)) => (rows, "generators"),
        (None, None) => {
            let found = document.describe();
            let problem =
                format!("expected a list of generators, or an object with a list `generators`, found {found}");
            return Err(misshapen(problem, Place::File));
        }
    };
    let mut generators = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        let row = vector(file, row, &format!("{path}[{index}]"))?;
        push_limited(&mut generators, row).map_err(|problem| problem.at(file, Place::File))?;
    }
    let center = document.field("center").map(|center| vector(file, center, "center")).transpose()?;
    body(file, center, generators)
}

fn vector(file: &Path, value: &Tree, path: &str) -> Result<Vec<f64>, InputError> {
    let components = value.list().ok_or_else(|| {
        Problem::Shape(format!("expected a vector, found {}", value.describe())).at(file, Place::Path(path.to_owned()))
    })?;
    let component =
        |(index, value)| number(value).map_err(|problem| problem.at(file, Place::Path(format!("{path}[{index}]"))));
    components.iter().enumerate().map(component).collect()
}

fn body(file: &Path, center: Option<Vec<f64>>, generators: Vec<Vec<f64>>) -> Result<Body, InputError> {
    let Some(dimension) = center.as_ref().or(generators.first()).map(Vec::len).filter(|&dimension| dimension > 0)
    else {
        return Err(Problem::NoBody.at(file, Place::File));
    };
    if let Some(index) = generators.iter().position(|generator| generator.len() != dimension) {
        let problem = Problem::Ragged { found: generators[index].len(), expected: dimension };
        return Err(problem.at(file, Place::Path(format!("generators[{index}]"))));
    }
    Ok(Body { center: center.unwrap_or_else(|| vec![0.0; dimension]), generators })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, content: &str) -> Result<Body, String> {
        let file = Path::new(name);
        let read = match Format::of_extension(file) {
            Some(Format::Csv) => table::rows(file, content.as_bytes()).and_then(|rows| body(file, None, rows)),
            _ => parse(file, content.as_bytes()).and_then(|tree| document(file, &tree)),
        };
        read.map_err(|error| error.to_string())
    }

    #[test]
    fn tables_and_documents_hold_the_same_body() {
        let square = Body { center: vec![0.0, 0.0], generators: vec![vec![1.0, 0.0], vec![0.0, 2.0]] };
        assert_eq!(read("z.csv", "1,0\n0,2\n"), Ok(square.clone()));
        assert_eq!(read("z.csv", "x;y\n1;0\n\n0;2"), Ok(square.clone()));
        assert_eq!(read("z.json", "[[1,0],[0,2]]"), Ok(square.clone()));
        assert_eq!(read("z.json", r#"{"generators":[[1,0],[0,2]],"name":"a square"}"#), Ok(square.clone()));
        let moved = read("z.json", r#"{"center":[5,6],"generators":[[1,0],[0,2]]}"#);
        assert_eq!(moved, Ok(Body { center: vec![5.0, 6.0], ..square }));
        let point = read("z.json", r#"{"center":[5,6,7],"generators":[]}"#);
        assert_eq!(point, Ok(Body { center: vec![5.0, 6.0, 7.0], generators: vec![] }));
        assert_eq!(read("z.csv", "7\n8\n").map(|body| body.generators), Ok(vec![vec![7.0], vec![8.0]]));
    }

    #[test]
    fn complaints_name_the_place() {
        assert_eq!(read("z.csv", "1,0\n0,north\n"), Err("z.csv: line 2, column 2: 'north' is not a number".into()));
        assert_eq!(read("z.csv", "1,0\n2\n"), Err("z.csv: line 2, column 2: the row has 1 cells, not 2".into()));
        assert_eq!(read("z.csv", ""), Err("z.csv: holds no zonotope".into()));
        assert_eq!(read("z.json", r#"{"generators":[]}"#), Err("z.json: holds no zonotope".into()));
        assert_eq!(
            read("z.json", r#"{"center":[1,2],"generators":[[1,2],[1,2,3]]}"#),
            Err("z.json: generators[1]: the row has 3 cells, not 2".into())
        );
        assert_eq!(
            read("z.json", r#"{"generators":[[1,"NaN"]]}"#),
            Err("z.json: generators[0][1]: 'NaN' is not a finite number".into())
        );
        assert_eq!(read("z.json", "[7]"), Err("z.json: [0]: expected a vector, found a number".into()));
    }
}
