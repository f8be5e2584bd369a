//! A body that is read once and asked about many points: `member` without reading and writing.

use serde_json::{Value, json};
use zonotope::DEFAULT_SEED;
use zonotope::collision::{Location, Query, Separation};
use zonotope::zonotope::Zonotope;

use super::{Task, locate};
use crate::fields::Fields;
use crate::pictures::{Part, Sheet, Table, Width, index};
use crate::refusal::{Code, Refusal};

/// A body of space that is held between questions.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldBody(Zonotope<3>);

impl HeldBody {
    pub(crate) const KIND: &str = "body";
    pub(crate) const FIELDS: [&str; 2] = ["center", "generators"];

    pub(crate) fn read(fields: &Fields<'_>) -> Result<Self, Refusal> {
        fields.zonotope().map(Self)
    }

    /// The body.
    pub fn body(&self) -> &Zonotope<3> {
        &self.0
    }

    /// The result of `member` for a point.
    pub(crate) fn locate(&self, point: [f64; 3]) -> Result<Sheet, Refusal> {
        let not_finite = |error| Refusal::new(Code::NonFinite, format!("point: {error}"));
        let question = Query::of_point(point, &self.0).map_err(not_finite)?;
        let method = Task::Locate.method::<3>(None, question.len())?;
        let (_, location) = locate(method, &question, DEFAULT_SEED)?;
        let (name, proof, basis) = match location {
            Location::Inside(ref witness) | Location::Boundary(ref witness) => {
                let coefficients = Table::Floats(Width::Single, witness.coefficients.clone());
                ("coefficients", Part::Table(coefficients), Table::indices(witness.basis.iter().copied().map(index)))
            }
            Location::Outside(ref separation) => {
                let direction: Value = match separation {
                    Separation::Rounded(direction) => json!(direction),
                    Separation::Exact(direction) => direction.iter().map(ToString::to_string).collect(),
                };
                ("separating_direction", Part::Plain(direction), Table::indices([]))
            }
        };
        Ok(Sheet::new([
            ("member", Part::Plain(location.is_member().into())),
            ("status", Part::Plain(location.status().name().into())),
            (name, proof),
            ("basis", Part::Table(basis)),
        ]))
    }
}
