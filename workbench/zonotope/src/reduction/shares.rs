//! The proof of containment by shares: every generator of the inner zonotope in terms of the generators of the outer.
//!
//! A generator v is written as γ b + Σ c_l f_l, with one generator b of the outer body and a frame of at most D others,
//! f_l. If the magnitudes of the coefficients of each outer generator add up to at most 1 over all v, then a point
//! Σ δ_i v_i with |δ_i| ≤ 1 is a combination of outer generators with coefficients of at most 1, so it lies in the
//! outer body. The coefficients in the frame are not listed: what a share leaves of a generator determines them.

use thiserror::Error;

use crate::numeric::Rational;
use crate::numeric::exact_linear::{rational, solve};
use crate::zonotope::Zonotope;

/// A generator of the outer body and the coefficient with which it stands for a generator of the inner one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Which generator of the outer body, from 0; none of the frame.
    pub generator: usize,
    /// Its coefficient.
    pub coefficient: f64,
}

/// A share for each generator of the inner body, and the frame that takes what the shares leave.
#[derive(Debug, Clone, PartialEq)]
pub struct Shares {
    /// By generator of the inner body; `None` leaves all of it to the frame.
    pub shares: Vec<Option<Share>>,
    /// The generators of the outer body that are the frame: independent, so at most D.
    pub frame: Vec<usize>,
}

/// What is wrong with a proof by shares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ShareFlaw {
    /// The centres differ, or there is not one share for each generator.
    #[error("the shares belong to other bodies")]
    OtherBodies,
    /// A share or the frame names a generator that is not there, or one twice.
    #[error("a share or the frame names a wrong generator")]
    Index,
    /// What the share leaves of a generator is no combination of the frame.
    #[error("what is left of generator {0} is not in the span of the frame")]
    OffFrame(usize),
    /// The coefficients of an outer generator add up to more than 1.
    #[error("the coefficients of generator {0} of the outer body add up to more than 1")]
    Overdrawn(usize),
}

impl Shares {
    /// Every generator stands for itself.
    pub(super) fn each_its_own(count: usize) -> Self {
        let own = |generator| Some(Share { generator, coefficient: 1.0 });
        Self { shares: (0..count).map(own).collect(), frame: Vec::new() }
    }

    /// Checks in rationals that the outer body contains the inner one. O(n D²) rational operations.
    ///
    /// # Errors
    /// The first [`ShareFlaw`] that is found.
    pub fn check<const D: usize>(&self, inner: &Zonotope<D>, outer: &Zonotope<D>) -> Result<(), ShareFlaw> {
        let generators = outer.generators();
        if inner.center() != outer.center() || self.shares.len() != inner.generators().len() {
            return Err(ShareFlaw::OtherBodies);
        }
        let is_twice = |at: usize| self.frame[..at].contains(&self.frame[at]);
        if (0..self.frame.len()).any(|at| self.frame[at] >= generators.len() || is_twice(at)) {
            return Err(ShareFlaw::Index);
        }
        let columns: Vec<Vec<Rational>> = self.frame.iter().map(|&f| generators[f].map(rational).to_vec()).collect();
        let mut drawn = vec![Rational::ZERO; generators.len()];
        let magnitude = |value: Rational| if value < Rational::ZERO { -value } else { value };
        for (index, (generator, share)) in inner.generators().iter().zip(&self.shares).enumerate() {
            let mut left = generator.map(rational);
            if let Some(Share { generator, coefficient }) = *share {
                if generator >= generators.len() || self.frame.contains(&generator) || !coefficient.is_finite() {
                    return Err(ShareFlaw::Index);
                }
                let factor = rational(coefficient);
                for (left, b) in left.iter_mut().zip(generators[generator]) {
                    *left -= &factor * rational(b);
                }
                drawn[generator] += magnitude(factor);
            }
            let coefficients = solve(&columns, &left).ok_or(ShareFlaw::OffFrame(index))?;
            for (&f, c) in self.frame.iter().zip(coefficients) {
                drawn[f] += magnitude(c);
            }
        }
        match drawn.iter().position(|sum| *sum > Rational::ONE) {
            Some(generator) => Err(ShareFlaw::Overdrawn(generator)),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_worked_out_by_hand() {
        // (2, 1) and (2, −1) are half of (4, 0) each, and the box [−1, 1] along y takes what is left: 1/2 of (0, 2)
        // each
        let inner = Zonotope::new([0.0; 2], vec![[2.0, 1.0], [2.0, -1.0]]).unwrap();
        let outer = Zonotope::new([0.0; 2], vec![[4.0, 0.0], [0.0, 2.0]]).unwrap();
        let half = Some(Share { generator: 0, coefficient: 0.5 });
        let shares = Shares { shares: vec![half; 2], frame: vec![1] };
        assert_eq!(shares.check(&inner, &outer), Ok(()));
        let narrow = Zonotope::new([0.0; 2], vec![[4.0, 0.0], [0.0, 2f64.next_down()]]).unwrap();
        assert_eq!(shares.check(&inner, &narrow), Err(ShareFlaw::Overdrawn(1)));
        assert_eq!(Shares { frame: vec![], ..shares.clone() }.check(&inner, &outer), Err(ShareFlaw::OffFrame(0)));
        assert_eq!(Shares { frame: vec![0], ..shares.clone() }.check(&inner, &outer), Err(ShareFlaw::Index));
        assert_eq!(Shares { shares: vec![half], frame: vec![1] }.check(&inner, &outer), Err(ShareFlaw::OtherBodies));
        let wider = Zonotope::new([0.0; 2], vec![[4.0, 0.0], [0.0, 2.0], [1.0, 0.0]]).unwrap();
        let more = Some(Share { generator: 0, coefficient: 0.6 });
        let shares = Shares { shares: vec![more, half], frame: vec![1, 2] };
        assert_eq!(shares.check(&inner, &wider), Err(ShareFlaw::Overdrawn(0)));
    }
}
