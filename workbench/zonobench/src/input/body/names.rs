//! The fields of an object that holds a zonotope: those that are read, those that could change the body and are
//! refused by name, and those of which a line tells that they are not read.

use std::path::Path;

use crate::input::error::{InputError, Place, Problem};
use batch::json::Tree;

/// The names of the centre.
pub(super) const CENTERS: [&str; 3] = ["center", "centre", "c"];

/// The name of the centre beside a matrix G in pypolycontain.
const POINT: &str = "x";

/// The names of the generators: a list of vectors, or the rows of a matrix whose columns are the vectors.
pub(super) const LIST: &str = "generators";
pub(super) const MATRIX: &str = "G";

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
    dilate dilation mirror mirrored reflect reflected flip thickness";

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
            if !is_empty(value)
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

/// The name in small letters and digits.
fn plain(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn is_meant(name: &str) -> bool {
    is_among(MEANT, name)
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
