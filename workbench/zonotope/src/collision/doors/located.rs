//! The answer of a body: a status with a proof of constant size, whose coefficients are written when they are asked
//! for.

use crate::collision::Query;
use crate::zonotope::location::{Coefficients, Gauge, Location, Separation, SignRule, Status};
use crate::zonotope::pose::{AtRest, Standing};

/// The place of a displacement relative to the bodies that it was asked about, with a proof that was not written out.
///
/// Most callers want the status and perhaps a direction: a separating one, or that of the nearest facet. Near the
/// boundary, where a proof of a member is a [`SignRule`], the answer has constant size. [`expand`](Self::expand) has
/// the proof that a verifier takes as it stands, with a coefficient for each generator.
#[derive(Debug, Clone)]
pub struct Located<'q, const D: usize, P = AtRest> {
    query: Query<'q, D, P>,
    location: Location<D, Coefficients>,
}

impl<'q, const D: usize, P: Standing> Located<'q, D, P> {
    #[inline]
    pub(super) fn new(query: Query<'q, D, P>, location: Location<D, Coefficients>) -> Self {
        Self { query, location }
    }

    /// Whether the displacement lies inside, on the boundary or outside. O(1).
    #[inline]
    pub fn status(&self) -> Status {
        self.location.status()
    }

    /// Whether the displacement is in the closed body, or the closed bodies meet. O(1).
    #[inline]
    pub fn is_member(&self) -> bool {
        self.location.is_member()
    }

    /// The direction that separates, if the displacement lies outside. O(1).
    pub fn separation(&self) -> Option<&Separation<D>> {
        match &self.location {
            Location::Outside(separation) => Some(separation),
            Location::Inside(_) | Location::Boundary(_) => None,
        }
    }

    /// The rule of the coefficients, if that is the proof of a member: near the boundary, nearly always. O(1).
    pub fn rule(&self) -> Option<&SignRule> {
        match &self.location {
            Location::Inside(Coefficients::BySigns(rule)) | Location::Boundary(Coefficients::BySigns(rule)) => {
                Some(rule)
            }
            _ => None,
        }
    }

    /// A coefficient in [−1, 1] for each generator, those of the first body first, which combine to the displacement,
    /// if it is a member: those of [`expand`](Self::expand). O(n).
    pub fn coefficients(&self) -> Option<Vec<f64>> {
        match self.expand() {
            Location::Inside(witness) | Location::Boundary(witness) => Some(witness.coefficients),
            Location::Outside(_) => None,
        }
    }

    /// The location with the proof that a verifier takes as it stands: a coefficient for each generator, those of the
    /// basis as [`Witness::with_nearest_basis`](crate::collision::Witness::with_nearest_basis) has them, or a
    /// separating direction. O(n) for a member: a pass over the generators, and a slower one for the last digits.
    pub fn expand(&self) -> Location<D> {
        self.location.clone().written_for(&self.query).with_nearest_basis(&self.query)
    }
}

impl<const D: usize, P: Standing> Gauge<D, Located<'_, D, P>> {
    /// The gauge with the proof that a verifier takes as it stands, that of [`Located::expand`]. O(n) for a member.
    pub fn expand(&self) -> Gauge<D> {
        Gauge { value: self.value, error: self.error, location: self.location.expand() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interop::verifier::check_location;
    use crate::zonotope::Zonotope;

    #[test]
    fn an_answer_has_one_of_the_three_proofs() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
        let statuses = [(0.5, Status::Inside), (1.0 - 1e-9, Status::Inside), (1.0, Status::Boundary)];
        for (height, status) in statuses.into_iter().chain([(1.0f64.next_up(), Status::Outside)]) {
            let point = [0.25, -0.5, height];
            let located = cube.locate(point).expect("finite");
            assert_eq!((located.status(), located.is_member()), (status, status != Status::Outside));
            let expanded = located.expand();
            assert_eq!(expanded.status(), status);
            let query = Query::of_point(point, &cube).expect("finite");
            assert_eq!(check_location(&query, &expanded).proof().map(drop), Ok(()));
            match &expanded {
                Location::Outside(separation) => assert_eq!(located.separation(), Some(separation)),
                Location::Inside(witness) | Location::Boundary(witness) => {
                    assert_eq!(located.separation(), None);
                    assert_eq!(located.coefficients().as_ref(), Some(&witness.coefficients));
                    // the point is the sum of the axes with its own coordinates
                    assert_eq!(witness.coefficients, point);
                }
            }
            assert_eq!(located.coefficients().is_some(), located.is_member());
        }
    }

    #[test]
    fn near_the_boundary_a_rule_says_what_is_written() {
        let generators: Vec<[f64; 3]> =
            (0..60u32).map(|i| [i * i % 101, i * i % 83, i * 7 % 61].map(|c| f64::from(c) / 60.0 - 0.6)).collect();
        let body = Zonotope::new([0.0; 3], generators.clone()).expect("finite");
        let point = body.support([0.3, 0.2, 0.9]).point().map(|c| c * (1.0 - 1e-7));
        let located = body.locate(point).expect("finite");
        let rule = located.rule().expect("the point is near a facet");
        let coefficients = located.coefficients().expect("the point is inside");
        let along = |v: &[f64; 3]| v[0] * rule.direction[0] + v[1] * rule.direction[1] + v[2] * rule.direction[2];
        for (i, (v, c)) in generators.iter().zip(&coefficients).enumerate() {
            assert!(rule.basis.contains(&i) || *c == rule.factor.copysign(along(v)), "{i}");
        }
        let far = body.locate([0.0, 0.1, 0.0]).expect("finite");
        assert!(far.is_member() && far.rule().is_none());
        let outside = body.locate(point.map(|c| c * 2.0)).expect("finite");
        assert!(outside.rule().is_none() && outside.coefficients().is_none());
    }
}
