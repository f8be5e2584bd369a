//! A zonotope from a file: a table of generators, a document, or an answer that holds a body.

mod document;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::bytes::{read_limited, text};
use super::document::parse;
use super::error::{InputError, Place, Problem, on_one_line};
use super::{Format, npy, table};
use crate::digest::sha256;

pub use document::body_of_answer;

/// A zonotope of any dimension: every vector has as many coordinates as the centre, at least one, all finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The centre; the origin where the file has none.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
    /// Whether the generators are rounded: products of directions and coefficients of an answer that no doubles equal.
    pub is_rounded: bool,
}

/// The content that a zonotope was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Origin {
    /// Its format.
    pub format: Format,
    /// Its SHA-256.
    pub sha256: String,
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
    /// Reads the zonotope, and tells which content of which format it was read from.
    pub fn read_with_origin(&self, tell: impl FnOnce(&str)) -> Result<(Body, Origin), InputError> {
        let format = self.told_format().map_err(|problem| problem.at(&self.file, Place::File))?;
        let content = read_limited(&self.file)?;
        let body = self.body(format, &content, tell)?;
        Ok((body, Origin { format, sha256: sha256(&content) }))
    }

    /// The format that was chosen, or that the name tells.
    fn told_format(&self) -> Result<Format, Problem> {
        let file = &self.file;
        if let Some(format) = self.format.or_else(|| Format::of_extension(file)) {
            return Ok(format);
        }
        let choice = "say csv, json or npy by --format, or by --body-format where points stand beside it";
        Err(match file.extension() {
            _ if file.is_dir() => Problem::Shape("is a folder, not a file".to_owned()),
            _ if file.as_os_str() != "-" && !file.exists() => Problem::Unreadable(ErrorKind::NotFound.into()),
            Some(extension) => Problem::Shape(format!(
                "files that end in .{} are not read as zonotopes; if it holds one, {choice}",
                on_one_line(&extension.to_string_lossy())
            )),
            None => Problem::Shape(format!("the format cannot be told from the name; {choice}")),
        })
    }

    /// Reads the zonotope.
    pub fn read(&self, tell: impl FnOnce(&str)) -> Result<Body, InputError> {
        self.read_with_origin(tell).map(|(body, _)| body)
    }

    /// The zonotope of a content: rows of a table or of an array are generators; a document is a list of generators, an
    /// object with `generators` and perhaps a `center`, or with the rows `G` of the matrix of generators and perhaps a
    /// centre `c`, or an answer that holds a body. What a reader may have meant otherwise is told in one line.
    fn body(&self, format: Format, content: &[u8], tell: impl FnOnce(&str)) -> Result<Body, InputError> {
        let file = &self.file;
        match format {
            Format::Csv => {
                let rows = table::rows(file, text(content))?;
                if rows.are_named_as_points() {
                    let (file, names) = (file.display(), rows.names.join(", "));
                    let advice = "`zonobench enclose` makes a body around points";
                    tell(&on_one_line(&format!("{file}: each row of {names} is read as a generator; {advice}")));
                }
                body(file, None, rows.numbers)
            }
            Format::Npy => body(file, None, npy::rows(file, content)?),
            Format::Json => document::body(file, &parse(file, text(content))?),
            other => {
                let problem = format!(
                    "the format {other} holds no zonotopes; csv, json and npy do, and `zonobench enclose {} --json \
                     body.json` makes one around its points",
                    file.display()
                );
                Err(Problem::Shape(problem).at(file, Place::File))
            }
        }
    }
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
    Ok(Body { center: center.unwrap_or_else(|| vec![0.0; dimension]), generators, is_rounded: false })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, content: &str) -> Result<Body, String> {
        let file = Path::new(name);
        let read = match Format::of_extension(file) {
            Some(Format::Csv) => table::rows(file, content.as_bytes()).and_then(|rows| body(file, None, rows.numbers)),
            _ => parse(file, content.as_bytes()).and_then(|tree| document::body(file, &tree)),
        };
        read.map_err(|error| error.to_string())
    }

    #[test]
    fn tables_and_documents_hold_the_same_body() {
        let generators = vec![vec![1.0, 0.0], vec![0.0, 2.0]];
        let square = Body { center: vec![0.0, 0.0], generators, is_rounded: false };
        assert_eq!(read("z.csv", "1,0\n0,2\n"), Ok(square.clone()));
        assert_eq!(read("z.csv", "x;y\n1;0\n\n0;2"), Ok(square.clone()));
        assert_eq!(read("z.json", "[[1,0],[0,2]]"), Ok(square.clone()));
        assert_eq!(read("z.json", r#"{"generators":[[1,0],[0,2]],"name":"a square"}"#), Ok(square.clone()));
        let moved = read("z.json", r#"{"center":[5,6],"generators":[[1,0],[0,2]]}"#);
        assert_eq!(moved, Ok(Body { center: vec![5.0, 6.0], ..square.clone() }));
        let point = read("z.json", r#"{"center":[5,6,7],"generators":[]}"#);
        assert_eq!(point, Ok(Body { center: vec![5.0, 6.0, 7.0], generators: vec![], is_rounded: false }));
        let matrix = read("z.json", r#"{"c":[5,6],"G":[[1,0],[0,2]]}"#);
        assert_eq!(matrix, Ok(Body { center: vec![5.0, 6.0], ..square }));
        let wide = read("z.json", r#"{"G":[[1,2,3],[4,5,6]]}"#).map(|body| body.generators);
        assert_eq!(wide, Ok(vec![vec![1.0, 4.0], vec![2.0, 5.0], vec![3.0, 6.0]]));
        assert_eq!(read("z.csv", "7\n8\n").map(|body| body.generators), Ok(vec![vec![7.0], vec![8.0]]));
    }

    #[test]
    fn answers_hold_bodies() {
        let zonogon = r#"{"id":"p","kind":"min_area","result":{"area":4,"center":[1,1],"generators":[[1,0],[0,1]]}}"#;
        let square =
            Body { center: vec![1.0, 1.0], generators: vec![vec![1.0, 0.0], vec![0.0, 1.0]], is_rounded: false };
        assert_eq!(read("a.json", zonogon), Ok(square.clone()));
        let along = |coefficients: &str| {
            let result = format!(r#"{{"status":"optimal","center":[1,1],"coefficients":{coefficients}}}"#);
            let request = r#"{"directions":[[1,0],[3,3],[0,0.1]]}"#;
            format!(r#"{{"kind":"min_length_dirs","request":{request},"result":{result}}}"#)
        };
        let exact = Body { generators: vec![vec![1.0, 0.0], vec![6.0, 6.0]], ..square.clone() };
        assert_eq!(read("a.json", &along("[1,2,0]")), Ok(exact));
        let rounded = Body { generators: vec![vec![1.0, 0.0], vec![0.0, 0.1 * 3.0]], is_rounded: true, ..square };
        assert_eq!(read("a.json", &along("[1,0,3]")), Ok(rounded));
    }

    #[test]
    fn answers_without_a_body_say_so() {
        let answers = [
            (
                r#"{"result":{"status":"infeasible","certificate":{}}}"#,
                "no zonotope along the directions contains the points",
            ),
            (r#"{"error":{"code":"empty","message":"there are no points"}}"#, "is a refusal: there are no points"),
            (r#"{"result":{"member":true}}"#, "holds no zonotope"),
            (r#"{"result":{"center":[0],"coefficients":[1]}}"#, "names no directions"),
            (r#"{"request":{"directions":[[1]]},"result":{"center":[0],"coefficients":[1,2]}}"#, "2 coefficients"),
            (r#"{"result":{"center":[0],"generators":[["x"]]}}"#, "result.generators[0][0]: 'x' is not a number"),
            (r#"{"c":[0,0],"G":[[1,2],[3]]}"#, "G[1]: the row has 1 cells, not 2"),
            (r#"{"c":[0,0,0],"G":[[1,2],[3,4]]}"#, "G: the matrix has 2 rows, not 3"),
        ];
        for (answer, complaint) in answers {
            let found = read("a.json", answer).expect_err("there is no body");
            assert!(found.starts_with("a.json: ") && found.contains(complaint), "{found}");
        }
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
