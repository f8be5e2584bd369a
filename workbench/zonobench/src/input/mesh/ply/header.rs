//! The header of PLY: which elements follow, and which properties they have.

use std::fmt;

use super::super::content::{Misplaced, broken};
use crate::input::error::Place;

/// The encoding of the elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl Kind {
    fn parse(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::Signed(1),
            "uchar" | "uint8" => Self::Unsigned(1),
            "short" | "int16" => Self::Signed(2),
            "ushort" | "uint16" => Self::Unsigned(2),
            "int" | "int32" => Self::Signed(4),
            "uint" | "uint32" => Self::Unsigned(4),
            "float" | "float32" => Self::Float(4),
            "double" | "float64" => Self::Float(8),
            _ => return None,
        })
    }

    /// Whether a word with this number may stand for the type in a text: for integers a whole one in its range. Texts
    /// have numbers of any precision for floats, and words for missing ones.
    pub(super) fn has(self, number: Option<f64>) -> bool {
        let (low, high) = match self {
            Self::Float(_) => return true,
            Self::Signed(bytes) => (-2_f64.powi(8 * bytes as i32 - 1), 2_f64.powi(8 * bytes as i32 - 1)),
            Self::Unsigned(bytes) => (0.0, 2_f64.powi(8 * bytes as i32)),
        };
        number.is_some_and(|number| number.fract() == 0.0 && low <= number && number < high)
    }

    /// The bytes of a number.
    pub(super) fn bytes(self) -> usize {
        let (Self::Signed(bytes) | Self::Unsigned(bytes) | Self::Float(bytes)) = self;
        bytes
    }

    /// The number in so many bytes, exactly.
    pub(super) fn read(self, bytes: &[u8], encoding: Encoding) -> f64 {
        let mut wide = [0; 8];
        wide[..bytes.len()].copy_from_slice(bytes);
        if encoding == Encoding::BigEndian {
            wide[..bytes.len()].reverse();
        }
        let unused_bits = 64 - 8 * bytes.len() as u32;
        match self {
            Self::Signed(_) => ((i64::from_le_bytes(wide) << unused_bits) >> unused_bits) as f64,
            Self::Unsigned(_) => u64::from_le_bytes(wide) as f64,
            Self::Float(4) => f64::from(f32::from_le_bytes([wide[0], wide[1], wide[2], wide[3]])),
            Self::Float(_) => f64::from_le_bytes(wide),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Signed(1) => "char",
            Self::Signed(2) => "short",
            Self::Signed(_) => "int",
            Self::Unsigned(1) => "uchar",
            Self::Unsigned(2) => "ushort",
            Self::Unsigned(_) => "uint",
            Self::Float(4) => "float",
            Self::Float(_) => "double",
        })
    }
}

/// A property of an element: a number, or a list of numbers behind their count.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// The type of the count of a list.
    pub(super) count: Option<Kind>,
}

/// Elements of one kind: their number and their properties.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

/// The entries of the header.
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The byte behind the header.
    pub(super) end: usize,
    /// The number of its lines.
    pub(super) lines: u64,
}

impl Header {
    /// Reads the header. The first line tells how lines end, so that the byte behind the last one is data.
    pub(super) fn read(content: &[u8]) -> Result<Self, Misplaced> {
        let (mut end, mut line) = (0, 0);
        let (mut encoding, mut elements) = (None, Vec::<Element>::new());
        let ending: &[u8] = match content.iter().position(|byte| matches!(byte, b'\r' | b'\n')) {
            Some(at) if content[at..].starts_with(b"\r\n") => b"\r\n",
            Some(at) => &content[at..=at],
            None => b"\n",
        };
        loop {
            line += 1;
            let at = |complaint: &str| (broken("PLY", complaint), Place::Line(line));
            let rest = &content[end..];
            let Some(length) = rest.windows(ending.len()).position(|window| window == ending) else {
                return Err(at(if line == 1 {
                    "does not begin with the line `ply`"
                } else {
                    "the header does not end"
                }));
            };
            // Bytes that are no UTF-8 stand in comments.
            let text = String::from_utf8_lossy(&rest[..length]);
            end += length + ending.len();
            let words: Vec<&str> = text.split_ascii_whitespace().collect();
            match (line, words.as_slice()) {
                (1, ["ply"]) => {}
                (1, _) => return Err(at("does not begin with the line `ply`")),
                (_, [] | ["comment" | "obj_info", ..]) => {}
                (_, ["end_header"]) => break,
                (_, ["format", form, "1.0"]) => {
                    encoding = Some(match *form {
                        "ascii" => Encoding::Text,
                        "binary_little_endian" => Encoding::LittleEndian,
                        "binary_big_endian" => Encoding::BigEndian,
                        _ => return Err(at("an unknown form of numbers")),
                    });
                }
                (_, ["element", name, count]) => {
                    let count = count.parse().map_err(|_| at("an element without a count"))?;
                    elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new() });
                }
                (_, ["property", rest @ ..]) => {
                    let property = property(rest).ok_or_else(|| at("a property of no type that PLY has"))?;
                    let element = elements.last_mut().ok_or_else(|| at("a property of no element"))?;
                    element.properties.push(property);
                }
                _ => return Err(at(&format!("the header has a line '{}'", text.trim().escape_debug()))),
            }
        }
        let encoding = encoding.ok_or((broken("PLY", "the header names no format"), Place::File))?;
        Ok(Self { encoding, elements, end, lines: line })
    }
}

fn property(words: &[&str]) -> Option<Property> {
    let (kind, count, name) = match words {
        ["list", count, kind, name] => (kind, Some(Kind::parse(count)?), name),
        [kind, name] => (kind, None, name),
        _ => return None,
    };
    let is_whole = !matches!(count, Some(Kind::Float(_)));
    is_whole.then_some(Property { name: (*name).to_owned(), kind: Kind::parse(kind)?, count })
}
