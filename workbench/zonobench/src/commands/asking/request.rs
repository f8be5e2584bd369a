//! The record of the question in an answer: the options, the columns that were read, the data's SHA-256.

use clap::ValueEnum;
use serde_json::{Map, Value};
use thiserror::Error;

use super::{Asking, Directions, EPSILON, Objective, PointOptions};
use crate::input::{Column, Columns, Format, Reading};
use batch::json::{Tree, to_json, vector_to_json};

/// The question that an answer records.
#[derive(Debug, Clone)]
pub(crate) struct Recorded {
    /// The options that ask it again of the same data, whatever defaults and guesses the first reading rested on.
    pub(crate) asking: Asking,
    /// The SHA-256 of the data.
    pub(crate) sha256: String,
    /// The first field that no request has.
    pub(crate) unknown: Option<String>,
}

/// The command whose answers record requests.
const COMMAND: &str = "enclose";

/// The fields of a request.
const FIELDS: [&str; 10] = [
    "command",
    "objective",
    "format",
    "columns",
    "skip",
    "skip_nan",
    "directions",
    "epsilon",
    "max_generators",
    "sha256",
];

/// A `request` that cannot be read.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("the answer's `request` has no readable `{0}`")]
pub(crate) struct RecordError(pub(crate) &'static str);

impl Asking {
    /// The `request` of an answer about the points that were read.
    pub(crate) fn record(&self, reading: &Reading, objective: Objective) -> anyhow::Result<Value> {
        let mut request = Map::new();
        request.insert("command".to_owned(), COMMAND.into());
        let objective_name = objective.to_possible_value().expect("no objective is hidden from the command line");
        request.insert("objective".to_owned(), objective_name.get_name().into());
        insert_points(&mut request, &self.points, reading);
        if objective != Objective::Area {
            match &self.directions {
                Some(directions) => {
                    let vectors = directions.vectors(reading.points.dimension())?;
                    let vectors = vectors.iter().map(|vector| vector_to_json(vector)).collect();
                    request.insert("directions".to_owned(), vectors);
                }
                None => {
                    request.insert("epsilon".to_owned(), to_json(self.epsilon.unwrap_or(EPSILON)));
                    if let Some(most) = self.max_generators {
                        request.insert("max_generators".to_owned(), most.into());
                    }
                }
            }
        }
        request.insert("sha256".to_owned(), reading.sha256.clone().into());
        Ok(Value::Object(request))
    }
}

/// The record of points that are a part of a question: how they were read, and the SHA-256 of their file.
pub(crate) fn record_points(options: &PointOptions, reading: &Reading) -> Value {
    let mut record = Map::new();
    insert_points(&mut record, options, reading);
    record.insert("sha256".to_owned(), reading.sha256.clone().into());
    Value::Object(record)
}

/// The reading of the points.
fn insert_points(request: &mut Map<String, Value>, options: &PointOptions, reading: &Reading) {
    if let Some(format) = reading.format {
        request.insert("format".to_owned(), format.to_string().into());
    }
    if !reading.columns.is_empty() {
        let column = |column: &Column| match column {
            Column::Number(number) => Value::from(*number),
            Column::Name(name) => Value::from(name.as_str()),
        };
        request.insert("columns".to_owned(), reading.columns.iter().map(column).collect());
    }
    if let Some(skip) = options.told_skip() {
        request.insert("skip".to_owned(), skip.into());
    }
    if options.skip_nan {
        request.insert("skip_nan".to_owned(), true.into());
    }
}

/// The fields of the record of a file with points.
pub(crate) const POINT_FIELDS: [&str; 5] = ["format", "columns", "skip", "skip_nan", "sha256"];

/// The reading of the points of a record.
pub(crate) fn recorded_points(record: &Tree) -> Result<PointOptions, RecordError> {
    Ok(PointOptions {
        columns: field(record, "columns", columns)?,
        format: field(record, "format", |value| Format::from_str(value.text()?, false).ok())?,
        skip: field(record, "skip", |value| value.index().and_then(|lines| u64::try_from(lines).ok()))?,
        no_header: false,
        skip_nan: field(record, "skip_nan", truth)?.unwrap_or(false),
    })
}

/// A value that is true or false.
pub(crate) fn truth(value: &Tree) -> Option<bool> {
    match value {
        Tree::Bool(truth) => Some(*truth),
        _ => None,
    }
}

/// The field of a record as it is read; none where the record has none.
pub(crate) fn field<T>(
    record: &Tree,
    name: &'static str,
    read: fn(&Tree) -> Option<T>,
) -> Result<Option<T>, RecordError> {
    record.field(name).map(|value| read(value).ok_or(RecordError(name))).transpose()
}

impl Recorded {
    /// The question that an answer records; `None` if it records none.
    pub(crate) fn of(answer: &Tree) -> Option<Result<Self, RecordError>> {
        answer.field("request").map(recorded)
    }
}

fn recorded(request: &Tree) -> Result<Recorded, RecordError> {
    let asking = Asking {
        points: recorded_points(request)?,
        objective: field(request, "objective", |value| Objective::from_str(value.text()?, false).ok())?,
        directions: field(request, "directions", directions)?,
        epsilon: field(request, "epsilon", |value| value.float().filter(|&epsilon| 0.0 < epsilon && epsilon < 1.0))?,
        max_generators: field(request, "max_generators", |value| {
            value.index().filter(|&most| most > 0).and_then(|most| u64::try_from(most).ok())
        })?,
    };
    let sha256 = field(request, "sha256", |value| value.text().map(str::to_owned))?;
    field(request, "command", |value| value.text().filter(|command| *command == COMMAND).map(str::to_owned))?;
    let unknown = match request {
        Tree::Object(fields) => fields.iter().map(|(name, _)| name).find(|name| !FIELDS.contains(&name.as_str())),
        _ => None,
    };
    Ok(Recorded { asking, sha256: sha256.ok_or(RecordError("sha256"))?, unknown: unknown.cloned() })
}

fn columns(value: &Tree) -> Option<Columns> {
    let column = |value: &Tree| match value {
        Tree::Text(name) => Some(Column::Name(name.clone())),
        other => other.index().filter(|&number| number > 0).map(Column::Number),
    };
    let columns: Vec<Column> = value.list()?.iter().map(column).collect::<Option<_>>()?;
    Columns::new(columns).ok()
}

fn directions(value: &Tree) -> Option<Directions> {
    let component = |value: &Tree| value.float().filter(|number| number.is_finite());
    let vector = |value: &Tree| value.list()?.iter().map(component).collect::<Option<Vec<f64>>>();
    Some(Directions::Vectors(value.list()?.iter().map(vector).collect::<Option<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Points;
    use batch::json::{MAX_VALUES, read};

    fn record(asking: &Asking, objective: Objective) -> String {
        let columns = vec![Column::Name("y".into()), Column::Number(3)];
        let points = Points::Plane(vec![[1.0, 2.0]]);
        let (faces, left_out, notes) = (Vec::new(), Vec::new(), Vec::new());
        let format = Some(Format::Csv);
        let reading = Reading {
            points,
            faces,
            columns,
            left_out,
            skipped: Vec::new(),
            notes,
            losses: None,
            format,
            sha256: "ab".into(),
        };
        asking.record(&reading, objective).expect("the axes are directions").to_string()
    }

    #[test]
    fn what_is_recorded_asks_the_same_question_again() {
        let area = record(&Asking::default(), Objective::Area);
        let expected = r#"{"command":"enclose","objective":"area","format":"csv","columns":["y",3],"sha256":"ab"}"#;
        assert_eq!(area, expected);
        let along_axes = Asking { directions: Some(Directions::Axes), ..Asking::default() };
        let without_first =
            Asking { points: PointOptions { skip: Some(1), ..PointOptions::default() }, ..Asking::default() };
        let few = Asking { max_generators: Some(6), ..Asking::default() };
        let finite = Asking { points: PointOptions { skip_nan: true, ..PointOptions::default() }, ..Asking::default() };
        for (asking, fields) in [
            (finite, "\"skip_nan\":true"),
            (along_axes, "\"directions\":[[1.0,0.0],[0.0,1.0]]"),
            (Asking::default(), "\"epsilon\":0.001"),
            (without_first, "\"skip\":1"),
            (few, "\"max_generators\":6"),
        ] {
            let text = record(&asking, Objective::Length);
            assert!(text.contains(fields), "{text}");
            let request = read(text.as_bytes(), MAX_VALUES).expect("JSON");
            let again = recorded(&request).expect("a record is readable");
            assert_eq!((again.sha256.as_str(), again.unknown), ("ab", None));
            assert_eq!(record(&again.asking, Objective::Length), text);
        }
    }

    #[test]
    fn a_record_that_cannot_be_read_names_the_field() {
        let complaint = |text: &str| recorded(&read(text.as_bytes(), MAX_VALUES).expect("JSON")).map(|_| ());
        assert_eq!(complaint(r#"{"sha256":"ab"}"#), Ok(()));
        assert_eq!(complaint("{}"), Err(RecordError("sha256")));
        for (name, value) in [
            ("command", "\"weigh\""),
            ("columns", "[0]"),
            ("columns", "7"),
            ("format", "\"x\""),
            ("skip", "-1"),
            ("skip_nan", "1"),
            ("objective", "1"),
            ("directions", "[1]"),
            ("epsilon", "2"),
        ] {
            assert_eq!(complaint(&format!(r#"{{"{name}":{value},"sha256":"ab"}}"#)), Err(RecordError(name)), "{value}");
        }
    }

    #[test]
    fn a_field_that_no_request_has_is_told() {
        let text = r#"{"command":"enclose","weights":[1,2],"sha256":"ab","padding":1}"#;
        let recorded = recorded(&read(text.as_bytes(), MAX_VALUES).expect("JSON")).expect("a record is readable");
        assert_eq!(recorded.unknown.as_deref(), Some("weights"));
    }
}
