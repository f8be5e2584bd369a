//! Faults of a data file, each as one line that names the file and the place.

use std::fmt;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// A complaint about a data file: the file, the place in it, and what is wrong there.
#[derive(Debug, Error)]
#[error("{}", on_one_line(&format!("{}: {}{problem}", .file.display(), .place.prefix())))]
pub struct InputError {
    /// The file as the caller named it.
    pub file: PathBuf,
    /// The place in the file.
    pub place: Place,
    /// The fault there.
    pub problem: Problem,
}

/// A place in a data file; lines, columns and positions count from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of the file.
    Line(u64),
    /// A cell of a table, or a character of a line of JSON.
    Cell {
        /// Line of the file.
        line: u64,
        /// Column of the table, or of the line's characters.
        column: u64,
    },
    /// A value inside a JSON document, as a path such as `points[3][1]` (indices from 0, as in the document's own
    /// notation).
    Path(String),
}

impl Place {
    fn prefix(&self) -> String {
        match self {
            Self::File => String::new(),
            place => format!("{place}: "),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("the file"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Cell { line, column } => write!(f, "line {line}, column {column}"),
            Self::Path(path) => f.write_str(path),
        }
    }
}

/// The fault at a place of a data file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Problem {
    /// The file cannot be opened or read.
    #[error("cannot be read: {0}")]
    Unreadable(#[from] std::io::Error),
    /// The path is that of a folder.
    #[error("is a folder, not a file")]
    Folder,
    /// The file is larger than the reader takes.
    #[error("is too large: more than {limit} bytes")]
    TooManyBytes {
        /// The limit in bytes.
        limit: u64,
    },
    /// The file holds more points or values than the reader takes.
    #[error("is too large: more than {limit} {what}")]
    TooMany {
        /// The quantity that is counted.
        what: &'static str,
        /// The limit.
        limit: usize,
    },
    /// There is no point in the file.
    #[error("holds no points")]
    Empty,
    /// There is no zonotope in the file: neither a centre nor a generator.
    #[error("holds no zonotope")]
    NoBody,
    /// The name has no extension, so that it says nothing about the format.
    #[error("the format cannot be told from the name; say --format {FORMATS}")]
    UnknownFormat,
    /// The extension is that of no format that is read.
    #[error("files that end in .{0} are not read; if it holds one of the formats that are, say --format {FORMATS}")]
    UnreadFormat(String),
    /// The extension is that of a known format that is not read, and whose content no other reader takes.
    #[error("files that end in .{0} are not read; export the points as CSV, or the mesh as STL or PLY")]
    ForeignFormat(String),
    /// The first bytes are those of a known format that is not read.
    #[error("is {0}, which is not read; export the points as CSV, or the mesh as STL or PLY")]
    ForeignContent(String),
    /// The content is that of another format than the one in which it is to be read.
    #[error("holds {found}, not {named}: {option} {found} reads it as such, and so does a name that ends in .{found}")]
    OtherFormat {
        /// The format of the content.
        found: String,
        /// The format that the name or an option tells.
        named: String,
        /// The option that names the format of the file.
        option: &'static str,
    },
    /// Triangles are wanted, and the format has none.
    #[error("the format {0} holds no triangles; {MESHES}")]
    NoTriangles(String),
    /// Triangles are wanted, and the mesh has none.
    #[error("holds vertices and no faces; {MESHES}; `zonobench enclose` makes a body around points")]
    NoFaces,
    /// A cell that should hold a number holds something else.
    #[error("'{0}' is not a number")]
    NotANumber(String),
    /// A row of JSON has no field that the points of other rows have.
    #[error("there is no field '{0}', which other points have")]
    NoField(String),
    /// A cell that should hold a number is empty.
    #[error("the cell is empty")]
    EmptyCell,
    /// A cell holds NaN, an infinity, or a word for a missing number.
    #[error("'{0}' is not a finite number")]
    NotFinite(String),
    /// A number is missing or not finite, where the command can leave such points out.
    #[error("{0}; --skip-nan leaves such points out")]
    Missing(Box<Problem>),
    /// A cell holds a number beyond the range of a double.
    #[error("'{0}' is outside the range of a double")]
    OutOfRange(String),
    /// A number has a decimal comma.
    #[error("'{0}' has a comma where a decimal point is expected")]
    DecimalComma(String),
    /// Spaces separate the cells, and commas may do so as well.
    #[error("'{0}' may be one number with a decimal comma or two numbers; separate the cells by semicolons or tabs")]
    CommaBesideSpaces(String),
    /// A cell between commas joins two numbers, so that the commas may be decimal ones.
    #[error("'{0}' is not a number; if commas are decimal ones, separate the cells by semicolons or tabs")]
    BetweenCommas(String),
    /// All commas of a table may be decimal ones or separate thousands.
    #[error("the comma of '{0}' may be a decimal one or separate thousands; write decimal points, or no thousands")]
    AmbiguousComma(String),
    /// Some numbers of a table have decimal commas, others decimal points.
    #[error("'{0}' has a decimal comma, but another number of the table has a decimal point")]
    CommasAndPoints(String),
    /// The thousands of a number are separated.
    #[error("'{0}' has separators of thousands; write numbers without them")]
    Thousands(String),
    /// The first line counts the points, but wrongly.
    #[error("a line counts {counted} points, but {found} follow")]
    Count {
        /// The number in the line.
        counted: u64,
        /// The rows that follow.
        found: u64,
    },
    /// A row has another length than the first one.
    #[error("the row has {found} cells, not {expected}")]
    Ragged {
        /// Cells in this row.
        found: usize,
        /// Cells in the first row.
        expected: usize,
    },
    /// A row between commas has twice the cells of the first one.
    #[error(
        "the row has {found} cells, not {expected}; if its commas are decimal ones, separate the cells by semicolons"
    )]
    TwiceAsMany {
        /// Cells in this row.
        found: usize,
        /// Cells in the first row.
        expected: usize,
    },
    /// A named column does not exist.
    #[error(
        "there is no column '{name}'; the columns are {available}{near}",
        near = batch::did_you_mean(name, available.split(", "))
    )]
    NoSuchColumn {
        /// The name asked for.
        name: String,
        /// The names of the header.
        available: String,
    },
    /// Two columns have the name of a coordinate.
    #[error("two columns are named '{0}'; choose with --columns by number")]
    TwoColumns(String),
    /// Points of the plane are wanted, but the columns are those of points of space.
    #[error("has the columns x, y and z, so its points are in space; choose two columns with --columns")]
    ThirdCoordinate,
    /// A text stands beside numbers and above one, in a column that is read.
    #[error("'{text}' is not a number, but below it is one; if this line is a header, {option} {skip} leaves it out")]
    TextAboveNumber {
        /// The text.
        text: String,
        /// The lines to skip: this one and those above it.
        skip: u64,
        /// The option that leaves lines out.
        option: &'static str,
    },
    /// The first row may be a header or data: the chosen cells are numbers, another one is text above a number.
    #[error(
        "'{text}' stands beside numbers and above one; if this line is a header, --skip {skip} leaves it out, and \
         --no-header reads it as data"
    )]
    HeaderOrData {
        /// The text.
        text: String,
        /// The lines to skip: this one and those above it.
        skip: u64,
    },
    /// The first row is 0, 1, 2, … in whole numbers, as other rows are.
    #[error(
        "the first row ({row}) may number the columns or be a point; --skip {skip} leaves it out, and --no-header \
         reads it as data"
    )]
    NumbersOrData {
        /// The cells.
        row: String,
        /// The lines to skip: this one and those above it.
        skip: u64,
    },
    /// A numbered column does not exist.
    #[error("there is no column {number}; the row has {cells} cells")]
    NoColumnNumber {
        /// The number asked for.
        number: usize,
        /// Cells in the row.
        cells: usize,
    },
    /// The file has too many or too few columns for the coordinates to be guessed.
    #[error("has {cells} column(s); {}", choice(*cells, wanted, columns))]
    ChooseColumns {
        /// Cells in the first row.
        cells: usize,
        /// The number that there should be.
        wanted: &'static str,
        /// The columns that may hold coordinates, as `--columns` takes them.
        columns: Vec<String>,
    },
    /// The cells between commas may be the halves of numbers with decimal commas, so columns are not to be chosen yet.
    #[error(
        "has {cells} columns; if their commas are decimal ones, separate the cells by semicolons or tabs, else {}",
        choice(*cells, wanted, &numbered(*cells))
    )]
    HalvesOrColumns {
        /// Cells in the first row.
        cells: usize,
        /// The number that there should be.
        wanted: &'static str,
    },
    /// The rows of a table have one cell, and points need more.
    #[error("has 1 column, and points of the plane or of space need two or three; {0}")]
    OneColumn(String),
    /// A row of numbers holds a text as well, so that only some of the columns can be coordinates.
    #[error("'{text}' is text; choose {wanted} of the {cells} columns with --columns")]
    TextAmongNumbers {
        /// The text.
        text: String,
        /// Cells in the row.
        cells: usize,
        /// The number of columns that there should be.
        wanted: &'static str,
    },
    /// Points of another dimension are needed.
    #[error("holds points with {found} coordinates, not {wanted}{hint}")]
    Dimension {
        /// The coordinates of the points in the file.
        found: usize,
        /// The coordinates of the points that are needed.
        wanted: usize,
        /// The columns that were read where others could have been, with the option that chooses them, in words.
        hint: String,
    },
    /// The bytes are not text.
    #[error("is not UTF-8 text")]
    NotText,
    /// The text has an encoding that is not read.
    #[error("is {0}; UTF-8 is read, and UTF-16 with a byte order mark")]
    Encoding(String),
    /// The text is not JSON.
    #[error("is not JSON: {0}")]
    NotJson(String),
    /// The JSON has another shape than a set of points.
    #[error("{0}")]
    Shape(String),
    /// A mesh cannot be parsed.
    #[error("is not {format}: {complaint}")]
    Mesh {
        /// The name of the format.
        format: String,
        /// The message of its reader.
        complaint: String,
    },
    /// The file is no array, or none that is read.
    #[error("is not npy: {0}")]
    Array(String),
    /// A whole number has more digits than a double holds.
    #[error("{0} is not a double: reading it would round it")]
    NotADouble(String),
    /// The table cannot be parsed.
    #[error("cannot be parsed as a table: {0}")]
    Table(String),
}

/// The number of columns of points of the plane.
pub(super) const TWO: &str = "two";

/// The advice where the columns of the coordinates are not plain, with some of those that may hold them.
fn choice(cells: usize, wanted: &str, columns: &[String]) -> String {
    match (cells, columns) {
        (0 | 1, _) => format!("points need {wanted}"),
        (_, [] | [_]) => format!("choose {wanted} with --columns"),
        (_, [x, y, z, ..]) if wanted != TWO => {
            format!("choose {wanted} with --columns, such as --columns {x},{y},{z} or --columns {x},{y}")
        }
        (_, [x, y, ..]) => format!("choose {wanted} with --columns, such as --columns {x},{y}"),
    }
}

/// The columns of a row of so many cells, by their numbers.
pub(super) fn numbered(cells: usize) -> Vec<String> {
    (1..=cells).map(|number| number.to_string()).collect()
}

/// The formats that hold triangles, in words.
const MESHES: &str = "a mesh is an OBJ, PLY, STL or OFF file with faces";

/// The names of the formats, as messages list them.
const FORMATS: &str = "csv, xyz, geojson, json, npy, obj, ply, stl or off";

/// A text without line breaks, tabs and other control characters: they are spelled out.
pub fn on_one_line(text: &str) -> String {
    let spelled = |c: char| if c.is_control() { c.escape_debug().collect() } else { String::from(c) };
    text.chars().map(spelled).collect()
}

impl Problem {
    /// Whether a number is missing, not finite, or beyond the range of doubles, so that its point may be left out.
    pub(super) fn is_missing(&self) -> bool {
        matches!(self, Self::NotFinite(_) | Self::OutOfRange(_) | Self::EmptyCell | Self::NoField(_))
    }

    /// Whether the file cannot be read, or has another format than it is read in.
    pub fn is_of_file(&self) -> bool {
        matches!(self, Self::Unreadable(_) | Self::Folder | Self::ForeignContent(_) | Self::OtherFormat { .. })
    }

    /// The complaint about `file` at `place`.
    pub fn at(self, file: &Path, place: Place) -> InputError {
        InputError { file: file.to_path_buf(), place, problem: self.shortened() }
    }

    /// Cells quoted in a message stay on one line and are cut to a readable length.
    fn shortened(self) -> Self {
        const MESSAGE_LIMIT: usize = 60;
        let cut = |text: &str, longest: usize| {
            let ellipsis = if text.chars().count() > longest { "…" } else { "" };
            text.chars().take(longest).collect::<String>() + ellipsis
        };
        let tidy = |text: String| on_one_line(&cut(&text, MESSAGE_LIMIT));
        match self {
            Self::NoSuchColumn { name, available } => {
                Self::NoSuchColumn { name: tidy(name), available: on_one_line(&cut(&available, 4 * MESSAGE_LIMIT)) }
            }
            Self::TwoColumns(name) => Self::TwoColumns(tidy(name)),
            Self::TextAmongNumbers { text, cells, wanted } => {
                Self::TextAmongNumbers { text: tidy(text), cells, wanted }
            }
            Self::TextAboveNumber { text, skip, option } => Self::TextAboveNumber { text: tidy(text), skip, option },
            Self::HeaderOrData { text, skip } => Self::HeaderOrData { text: tidy(text), skip },
            Self::NotANumber(cell) => Self::NotANumber(tidy(cell)),
            Self::NotFinite(cell) => Self::NotFinite(tidy(cell)),
            Self::NoField(name) => Self::NoField(tidy(name)),
            Self::OutOfRange(cell) => Self::OutOfRange(tidy(cell)),
            Self::DecimalComma(cell) => Self::DecimalComma(tidy(cell)),
            Self::CommaBesideSpaces(cell) => Self::CommaBesideSpaces(tidy(cell)),
            Self::BetweenCommas(cell) => Self::BetweenCommas(tidy(cell)),
            Self::AmbiguousComma(cell) => Self::AmbiguousComma(tidy(cell)),
            Self::CommasAndPoints(cell) => Self::CommasAndPoints(tidy(cell)),
            Self::Thousands(cell) => Self::Thousands(tidy(cell)),
            Self::UnreadFormat(extension) => Self::UnreadFormat(tidy(extension)),
            Self::ForeignFormat(extension) => Self::ForeignFormat(tidy(extension)),
            Self::Array(complaint) => Self::Array(cut(&complaint, 8 * MESSAGE_LIMIT)),
            Self::Shape(complaint) => Self::Shape(cut(&complaint, 8 * MESSAGE_LIMIT)),
            Self::Missing(problem) => Self::Missing(Box::new(problem.shortened())),
            Self::Mesh { format, complaint } => {
                let words: Vec<&str> = complaint.split_whitespace().collect();
                Self::Mesh { format, complaint: cut(&words.join(" "), 2 * MESSAGE_LIMIT) }
            }
            other => other,
        }
    }
}
