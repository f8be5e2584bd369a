//! Zonotopes in an input.

use zonotope::zonotope::Zonotope;

use crate::fields::Fields;
use crate::refusal::Refusal;

/// The zonotope whose centre and generators are fields.
pub(super) fn zonotope<const D: usize>(fields: &Fields<'_>) -> Result<Zonotope<D>, Refusal> {
    let center = fields.vector::<D>("center")?;
    let generators = fields.vectors::<D>("generators")?;
    Ok(Zonotope::new(center, generators).expect("what is not finite was refused when the question was read"))
}
