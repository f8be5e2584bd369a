//! The fields of an object that holds a zonotope: those that are read, those that could change the body and are
//! refused by name, and those of which a line tells that they are not read.

use std::path::Path;

use crate::input::error::{InputError, Place, Problem};
use batch::json::Tree;
use batch::names::POINT;

pub(super) use batch::names::{CENTERS, GENERATORS as LIST, MATRIX};

/// The name of the placement.
pub(super) const POSE: &str = "pose";

/// Names, in small letters and digits, that other tools give to a centre, to generators, to placements, and to what
/// makes more than a zonotope of them: constraints, factors in {−1, 1}, dependent factors.
const MEANT: &str = "\
    center centre c x centers centres centroid origin offset translation translate translated shift position pos \
    location loc t mid middle midpoint mean mu p q point base cen ctr cent x0 c0 p0 xc displacement move moved \
    generators generator g gens gen gs genmat generatormatrix matrix m basis axes axis directions dirs gi grest gc \
    gb gd z v vectors coefficients coeffs halfaxes halfextents extents pose poses rotation rotate rot r orientation \
    quaternion quat transform transformation transforms tf frame scale scaling scalefactor factor stretch motion \
    map linearmap affine turn angle degrees a b ac ab bc bb aeq beq ae be e ec expmat h constraints constraint \
    halfspaces radius inflation margin order placement placed place tx ty tz dx dy dz rx ry rz inflate expand grow \
    dilate dilation mirror mirrored reflect reflected flip thickness s theta phi psi yaw pitch roll heading bearing \
    azimuth elevation euler rpy xyz unit units halfspace";

/// The beginnings of words that say, alone or within a longer name, that a body is turned, moved, scaled or measured.
const MOVING: &str = "rot scal angle yaw pitch roll heading posi pose orient quat offset half size len transl transf";

/// Names of what is drawn or derived, whose numbers say nothing about the body.
const DERIVED: &str = "color colour colors colours rgb rgba vertices faces facets edges bbox boundingbox area volume";

/// An object with fields, and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Holder<'a> {
    pub(super) file: &'a Path,
    pub(super) object: &'a Tree,
    /// The path of the object in the document, with a dot at its end; empty for the document itself.
    pub(super) path: &'a str,
}

impl<'a> Holder<'a> {
    /// The field, unless it is absent or null.
    pub(super) fn field(&self, name: &str) -> Option<&'a Tree> {
        self.object.field(name).filter(|value| **value != Tree::Null)
    }

    /// The path of a field.
    pub(super) fn path_of(&self, name: &str) -> String {
        format!("{}{name}", self.path)
    }

    /// The complaint about a field.
    pub(super) fn wrong(&self, name: &str, problem: impl Into<String>) -> InputError {
        Problem::Shape(problem.into()).at(self.file, Place::Path(self.path_of(name)))
    }

    /// The name of the generators, if there are any: only one of two names.
    pub(super) fn generators(&self) -> Result<Option<&'static str>, InputError> {
        self.one_of(&[LIST, MATRIX])
    }

    /// The name of the centre, if there is one: only one of its names.
    pub(super) fn center(&self) -> Result<Option<&'static str>, InputError> {
        let has_point = self.field(MATRIX).is_some() && self.field(LIST).is_none();
        let names = [CENTERS[0], CENTERS[1], CENTERS[2], POINT];
        self.one_of(if has_point { &names } else { &CENTERS })
    }

    fn one_of(&self, names: &[&'static str]) -> Result<Option<&'static str>, InputError> {
        let mut found = names.iter().copied().filter(|name| self.field(name).is_some());
        match (found.next(), found.next()) {
            (Some(first), Some(second)) => {
                Err(self.wrong(second, format!("stands beside `{first}`, which means the same; leave one of them out")))
            }
            (first, _) => Ok(first),
        }
    }

    /// Refuses by name the fields that could change the body, and gives back the names of the others that are not read:
    /// of all fields but those that are known. Numbers under any name may be a centre or generators of so many
    /// coordinates.
    pub(super) fn unread(&self, known: &[&str], dimension: Option<usize>) -> Result<Vec<String>, InputError> {
        let Tree::Object(fields) = self.object else { return Ok(Vec::new()) };
        let mut unread = Vec::new();
        for (name, value) in
            fields.iter().filter(|(name, value)| !known.contains(&name.as_str()) && *value != Tree::Null)
        {
            if is_old_matrix_of_cora(name, value) {
                let problem = "this is the matrix [c G] of CORA: write its first column as `c` and the other columns \
                               as `G`, or the matrix as a table of numbers, which the options \
                               --columns-are-generators and --center-first are for";
                return Err(self.wrong(name, problem));
            }
            if !is_empty(value)
                && !is_label(value)
                && (is_meant(name) || dimension.is_some_and(|count| is_like_vectors(name, value, count)))
            {
                let problem = "this field could change the body, and it is not read: the centre is `center`, the \
                               generators are `generators` or the columns of `G`, the placement is `pose`; leave out \
                               what says nothing about the body";
                return Err(self.wrong(name, problem));
            }
            unread.push(self.path_of(name));
        }
        Ok(unread)
    }
}

/// Whether a field beside points could move them, scale them or hold others, by its name and its value.
pub(in crate::input) fn could_change_points(name: &str, value: &Tree) -> bool {
    let is_other = name == "columns" || name.to_lowercase().starts_with("points");
    !is_empty(value) && (is_other || (!is_label(value) && is_meant(name)))
}

/// The name in small letters and digits.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn is_meant(name: &str) -> bool {
    let moves = |word: &str| MOVING.split_whitespace().any(|stem| word.starts_with(stem));
    is_among(MEANT, name) || words(name).iter().any(|word| moves(word))
}

/// The words of a name such as `mesh_scale` or `meshScale`, in small letters.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_small = false;
    for letter in name.chars() {
        if !letter.is_alphanumeric() || (was_small && letter.is_uppercase()) {
            words.push(String::new());
        }
        was_small = letter.is_lowercase();
        if letter.is_alphanumeric() {
            words.last_mut().expect("there is a word from the beginning").extend(letter.to_lowercase());
        }
    }
    words
}

/// Whether a value is a name, such as that of a frame or of a unit, which moves nothing: a text of words without a
/// number at its beginning or signs of a formula.
fn is_label(value: &Tree) -> bool {
    let is_of_words = |text: &str| text.chars().all(|c| c.is_alphanumeric() || " _-/.:".contains(c));
    let begins = |text: &str| text.chars().next().is_none_or(|c| c.is_alphabetic() || "_/".contains(c));
    value.text().is_some_and(|text| is_of_words(text) && begins(text))
}

/// Whether a field is the property of a zonotope of CORA that holds its centre and its generators in one matrix.
fn is_old_matrix_of_cora(name: &str, value: &Tree) -> bool {
    let is_row = |row: &Tree| row.list().is_some_and(|row| matches!(row.first(), Some(Tree::Number(_))));
    name == "Z" && value.list().is_some_and(|rows| !rows.is_empty() && rows.iter().all(is_row))
}

fn is_among(names: &str, name: &str) -> bool {
    let name = plain(name);
    names.split_whitespace().any(|other| other == name)
}

/// Whether a value holds nothing: constraints may be there without being any.
fn is_empty(value: &Tree) -> bool {
    match value {
        Tree::Null => true,
        Tree::List(elements) => elements.iter().all(is_empty),
        Tree::Object(fields) => fields.iter().all(|(_, value)| is_empty(value)),
        _ => false,
    }
}

/// Whether a value looks like a vector of so many coordinates, or like some of them by rows or columns.
fn is_like_vectors(name: &str, value: &Tree, dimension: usize) -> bool {
    let numbers = |value: &Tree| {
        let all = value.list().filter(|all| all.iter().all(|number| matches!(number, Tree::Number(_))));
        all.map(<[Tree]>::len)
    };
    if let Tree::Object(fields) = value {
        return fields.iter().any(|(inner, value)| is_meant(inner) || is_like_vectors(inner, value, dimension));
    }
    let Some(elements) = value.list().filter(|_| !is_among(DERIVED, name)) else { return false };
    let rows: Option<Vec<usize>> = elements.iter().map(numbers).collect();
    match rows {
        Some(rows) => rows.len() == dimension || rows.iter().all(|&row| row == dimension),
        None => numbers(value) == Some(dimension),
    }
}
