//! The fields of an input, taken with their types checked.

use zonotope::zonotope::Zonotope;

use super::limits::MAX_VECTORS;
use super::nearest::{did_you_mean, nearest};
use super::place::Place;
use super::placement::Placement;
use super::refusal::{Code, Refusal};
use crate::json::Tree;

/// An object that has all fields that it must have and none but those that it may have: the input, or a zonotope in it.
#[derive(Debug, Clone)]
pub struct Fields<'a> {
    object: &'a Tree,
    place: Place,
}

impl<'a> Fields<'a> {
    /// Checks that the input is an object with the expected fields and no others but optional ones.
    pub(super) fn of_input(input: &'a Tree, expected: &[&str], optional: &[&str]) -> Result<Self, Refusal> {
        Self::at(input, expected, optional, Place::default())
    }

    fn at(object: &'a Tree, expected: &[&str], optional: &[&str], place: Place) -> Result<Self, Refusal> {
        let name = if place == Place::default() { "input".to_owned() } else { place.to_string() };
        let Tree::Object(fields) = object else {
            return Err(Refusal::bad_input(format!("`{name}` is {}, not an object", object.describe())));
        };
        let whole = if place == Place::default() { "the input".to_owned() } else { format!("`{name}`") };
        let is_known = |name: &str| expected.contains(&name) || optional.contains(&name);
        let mut unknown = fields.iter().map(|(name, _)| name.as_str()).filter(|name| !is_known(name));
        if let Some(missing) = expected.iter().find(|name| object.field(name).is_none()) {
            let misspelt = unknown.find(|name| nearest(name, [*missing]).is_some());
            let near = misspelt.map_or_else(String::new, |name| format!("; did you misspell it `{name}`?"));
            return Err(Refusal::bad_input(format!("missing field `{missing}` in {whole}{near}")));
        }
        if let Some(extra) = unknown.next() {
            let absent = optional.iter().copied().filter(|name| object.field(name).is_none());
            let near = did_you_mean(extra, absent);
            return Err(Refusal::bad_input(format!("extra field `{extra}` in {whole}{near}")));
        }
        Ok(Self { object, place })
    }

    fn value(&self, name: &str) -> &'a Tree {
        self.object.field(name).expect("the fields of an object were checked to be there")
    }

    /// The list under an expected name.
    fn list(&self, name: &str) -> Result<&'a [Tree], Refusal> {
        list(self.value(name), &self.place.field(name))
    }

    /// The object under `name`, which has the expected fields and no others but optional ones.
    pub(super) fn object(&self, name: &str, expected: &[&str], optional: &[&str]) -> Result<Self, Refusal> {
        Self::at(self.value(name), expected, optional, self.place.field(name))
    }

    /// The objects in the list under `name`, each with the expected fields and no others.
    pub(super) fn objects(&self, name: &str, expected: &[&str]) -> Result<Vec<Self>, Refusal> {
        let place = self.place.field(name);
        let at = |(index, object)| Self::at(object, expected, &[], place.element(index));
        (0..).zip(self.limited(name)?).map(at).collect()
    }

    /// Whether there is a field that may be absent.
    pub(super) fn has(&self, name: &str) -> bool {
        self.object.field(name).is_some()
    }

    /// Whether what stands under a name has one of some fields.
    pub(super) fn has_one_of(&self, name: &str, fields: &[&str]) -> bool {
        fields.iter().any(|field| self.value(name).field(field).is_some())
    }

    /// Whether there is a pose.
    pub(super) fn has_pose(&self) -> bool {
        self.has("pose")
    }

    /// The place of a field.
    pub(super) fn place_of(&self, name: &str) -> Place {
        self.place.field(name)
    }

    /// The placement by the pose; the identity if there is none.
    pub(super) fn placement(&self, dimension: usize) -> Result<Placement, Refusal> {
        let pose = self.object.field("pose").map(|pose| placement_of(pose, self.place.field("pose"), dimension));
        pose.unwrap_or_else(|| Ok(Placement::identity(dimension)))
    }

    /// The rows of the square matrix under `name`.
    fn square(&self, name: &str, dimension: usize) -> Result<Vec<Vec<f64>>, Refusal> {
        let (rows, place) = (self.list(name)?, self.place.field(name));
        if rows.len() != dimension {
            let message = format!("{place} has {} rows, not {dimension}", rows.len());
            return Err(Refusal::new(Code::DimensionMismatch, message));
        }
        let row = |(index, row)| {
            let place = place.element(index);
            all_coordinates(list_of_numbers(row, &place)?, &place, dimension)
        };
        (0..).zip(rows).map(row).collect()
    }

    /// The number of coordinates of the vector under `name`.
    pub(super) fn dimension(&self, name: &str) -> Result<usize, Refusal> {
        self.list(name).map(<[Tree]>::len)
    }

    /// The vector under `name`.
    pub(super) fn vector<const D: usize>(&self, name: &str) -> Result<[f64; D], Refusal> {
        coordinates(self.list(name)?, &self.place.field(name))
    }

    /// The vectors under `name`.
    pub(super) fn vectors<const D: usize>(&self, name: &str) -> Result<Vec<[f64; D]>, Refusal> {
        let rows = self.limited(name)?;
        let place = self.place.field(name);
        (0..).zip(rows).map(|(index, row)| vector_at(row, &place, index)).collect()
    }

    /// The vector under `name`, of a number of coordinates that is no constant.
    pub(super) fn vector_of(&self, name: &str, dimension: usize) -> Result<Vec<f64>, Refusal> {
        all_coordinates(self.list(name)?, &self.place.field(name), dimension)
    }

    /// The vectors under `name`, of a number of coordinates that is no constant.
    pub(super) fn vectors_of(&self, name: &str, dimension: usize) -> Result<Vec<Vec<f64>>, Refusal> {
        let place = self.place.field(name);
        let rows = (0..).zip(self.limited(name)?);
        let row = |(index, row)| {
            let place = place.element(index);
            all_coordinates(list_of_numbers(row, &place)?, &place, dimension)
        };
        rows.map(row).collect()
    }

    /// The text under `name`.
    pub(super) fn text(&self, name: &str) -> Result<&'a str, Refusal> {
        let value = self.value(name);
        let place = self.place.field(name);
        value.text().ok_or_else(|| Refusal::bad_input(format!("`{place}` is {}, not a string", value.describe())))
    }

    /// The text under a name that may be absent.
    pub(super) fn optional_text(&self, name: &str) -> Result<Option<&'a str>, Refusal> {
        if self.object.field(name).is_some() { self.text(name).map(Some) } else { Ok(None) }
    }

    /// The number under `name`.
    pub(super) fn number(&self, name: &str) -> Result<f64, Refusal> {
        number(self.value(name), &self.place.field(name))
    }

    /// The numbers under `name`.
    pub(super) fn numbers(&self, name: &str) -> Result<Vec<f64>, Refusal> {
        let place = self.place.field(name);
        (0..).zip(self.limited(name)?).map(|(index, value)| number(value, &place.element(index))).collect()
    }

    /// The whole number under `name`.
    pub(super) fn count(&self, name: &str) -> Result<u64, Refusal> {
        whole(self.value(name), &self.place.field(name), 0)
    }

    /// The whole number from 1 on under a name that may be absent.
    pub(super) fn optional_count(&self, name: &str) -> Result<Option<u64>, Refusal> {
        self.object.field(name).map(|value| whole(value, &self.place.field(name), 1)).transpose()
    }

    /// The lists of three whole numbers from 0 under `name`, each below 2^32.
    pub(super) fn triples(&self, name: &str) -> Result<Vec<[u32; 3]>, Refusal> {
        let (rows, place) = (self.limited(name)?, self.place.field(name));
        let triple = |(index, row)| {
            let place = place.element(index);
            let numbers = list(row, &place)?;
            let number = |(index, value)| {
                let (place, number) = (place.element(index), whole(value, &place.element(index), 0)?);
                u32::try_from(number)
                    .map_err(|_| Refusal::bad_input(format!("{place} is {number}, above all positions")))
            };
            let numbers: Vec<u32> = (0..).zip(numbers).map(number).collect::<Result<_, _>>()?;
            let count = numbers.len();
            let message = || format!("{place} has {count} corners, not 3");
            numbers.try_into().map_err(|_| Refusal::new(Code::DimensionMismatch, message()))
        };
        (0..).zip(rows).map(triple).collect()
    }

    /// The truth under a name that may be absent, which is false then.
    pub(super) fn flag(&self, name: &str) -> Result<bool, Refusal> {
        match self.object.field(name) {
            None => Ok(false),
            Some(Tree::Bool(value)) => Ok(*value),
            Some(other) => {
                let place = self.place.field(name);
                Err(Refusal::bad_input(format!("`{place}` is {}, not true or false", other.describe())))
            }
        }
    }

    /// The number of coordinates of the first vector under `name`, if there is any.
    pub(super) fn dimension_of_first(&self, name: &str) -> Result<Option<usize>, Refusal> {
        let first = self.list(name)?.first();
        first.map(|row| list(row, &self.place.field(name).element(0)).map(<[Tree]>::len)).transpose()
    }

    /// The whole numbers under `name`, which count from 1.
    pub(super) fn ranks(&self, name: &str) -> Result<Vec<u64>, Refusal> {
        let place = self.place.field(name);
        (0..).zip(self.limited(name)?).map(|(index, value)| whole(value, &place.element(index), 1)).collect()
    }

    /// The zonotope whose centre and generators are fields.
    pub(super) fn zonotope<const D: usize>(&self) -> Result<Zonotope<D>, Refusal> {
        let center = self.vector::<D>("center")?;
        let generators = self.vectors::<D>("generators")?;
        Ok(Zonotope::new(center, generators).expect("what is not finite was refused when the question was read"))
    }

    /// The zonotope whose centre and generators are fields, where its pose puts it: doubles must hold the image.
    pub(super) fn image<const D: usize>(&self) -> Result<Zonotope<D>, Refusal> {
        self.placement(D)?.image(&self.zonotope()?).ok_or_else(|| image_not_held(&self.place_of("pose"), D))
    }

    /// The list under `name`, if it is not too long.
    fn limited(&self, name: &str) -> Result<&'a [Tree], Refusal> {
        let rows = self.list(name)?;
        if rows.len() > MAX_VECTORS {
            let message = format!("{} {}, at most {MAX_VECTORS} are taken", rows.len(), self.place.field(name));
            return Err(Refusal::new(Code::TooLarge, message));
        }
        Ok(rows)
    }
}

/// The number of coordinates up to which poses are taken whatever their image is.
pub(super) const SPACE: usize = 3;

/// The refusal of a pose under which a body has an image that no doubles hold, where these are needed: from four
/// dimensions on in all kinds, below that by some.
pub(super) fn image_not_held(pose: &Place, dimension: usize) -> Refusal {
    let needed = match dimension > SPACE {
        true => "from four dimensions on other images are not taken",
        false => "this kind takes no other image",
    };
    let advice = "round the image to doubles and ask about it without a pose";
    Refusal::new(Code::BadInput, format!("{pose}: no doubles equal the image of the body, and {needed}; {advice}"))
}

fn list<'a>(value: &'a Tree, place: &Place) -> Result<&'a [Tree], Refusal> {
    value.list().ok_or_else(|| Refusal::bad_input(format!("`{place}` is {}, not a list", value.describe())))
}

fn vector_at<const D: usize>(row: &Tree, place: &Place, index: usize) -> Result<[f64; D], Refusal> {
    if let Some(vector) = plain_vector(row) {
        return Ok(vector);
    }
    let place = place.element(index);
    coordinates(list_of_numbers(row, &place)?, &place)
}

/// The list that one of several vectors is.
fn list_of_numbers<'a>(row: &'a Tree, place: &Place) -> Result<&'a [Tree], Refusal> {
    row.list().ok_or_else(|| Refusal::bad_input(format!("{place} is {}, not a list", row.describe())))
}

/// The vector, if there is nothing to complain about: the only way that millions of rows take.
fn plain_vector<const D: usize>(row: &Tree) -> Option<[f64; D]> {
    let row: &[Tree; D] = row.list()?.try_into().ok()?;
    let mut vector = [0.0; D];
    for (slot, value) in vector.iter_mut().zip(row) {
        let Tree::Number(number) = value else { return None };
        *slot = *number;
    }
    Some(vector)
}

fn coordinates<const D: usize>(row: &[Tree], place: &Place) -> Result<[f64; D], Refusal> {
    let coordinates = all_coordinates(row, place, D)?;
    Ok(std::array::from_fn(|index| coordinates[index]))
}

fn all_coordinates(row: &[Tree], place: &Place, dimension: usize) -> Result<Vec<f64>, Refusal> {
    let numbers: Vec<f64> =
        row.iter().enumerate().map(|(index, value)| number(value, &place.element(index))).collect::<Result<_, _>>()?;
    if numbers.len() != dimension {
        let plural = if row.len() == 1 { "coordinate" } else { "coordinates" };
        let message = format!("{place} has {} {plural}, not {dimension}", row.len());
        return Err(Refusal::new(Code::DimensionMismatch, message));
    }
    Ok(numbers)
}

/// The placement of a `pose` as a question has it: an object with `matrix`, `translation` or both.
///
/// # Errors
/// A refusal that names the place in the pose.
pub fn read_pose(pose: &Tree, dimension: usize) -> Result<Placement, Refusal> {
    placement_of(pose, Place::default().field("pose"), dimension)
}

/// The placement of a pose at a place: a matrix, which is the identity if absent, and a translation, which is zero if
/// absent.
fn placement_of(pose: &Tree, place: Place, dimension: usize) -> Result<Placement, Refusal> {
    const KNOWN: [&str; 2] = ["matrix", "translation"];
    if let Tree::Object(fields) = pose
        && let Some((extra, _)) = fields.iter().find(|(name, _)| !KNOWN.contains(&name.as_str()))
    {
        let near = did_you_mean(extra, KNOWN);
        let message = format!("extra field `{extra}` in `{place}`{near}; a pose has `matrix`, `translation` or both");
        return Err(Refusal::bad_input(message));
    }
    let pose = Fields::at(pose, &[], &KNOWN, place)?;
    let has = |name: &str| pose.object.field(name).is_some();
    if !has("matrix") && !has("translation") {
        return Err(Refusal::bad_input(format!("`{}` has neither `matrix` nor `translation`", pose.place)));
    }
    let none = Placement::identity(dimension);
    let matrix = if has("matrix") { pose.square("matrix", dimension)? } else { none.matrix().to_vec() };
    let translation = if has("translation") {
        all_coordinates(pose.list("translation")?, &pose.place.field("translation"), dimension)?
    } else {
        none.translation().to_vec()
    };
    let not_finite = || Refusal::new(Code::NonFinite, format!("{} holds a number that is not finite", pose.place));
    Placement::new(matrix, translation).ok_or_else(not_finite)
}

fn number(value: &Tree, place: &Place) -> Result<f64, Refusal> {
    match value {
        Tree::Number(number) => Ok(*number),
        other => Err(Refusal::bad_input(format!("{place} is {}, not a number", other.describe()))),
    }
}

fn whole(value: &Tree, place: &Place, least: u64) -> Result<u64, Refusal> {
    let whole = value.index().map(|index| index as u64).filter(|&index| index >= least);
    whole.ok_or_else(|| {
        let found = match value {
            Tree::Number(number) => format!("{number:?}"),
            other => other.describe().to_owned(),
        };
        Refusal::bad_input(format!("{place} is {found}, not a whole number from {least}"))
    })
}
