//! The height of the upper hull over a point, from all directions that can decide it: the truth the methods are held
//! to.
//!
//! # Source
//! The definitions of support function and projection.
//!
//! # Method
//! 1. p_0 is in Q iff |u · p_0| ≤ Σ |u · v'_j| for every u across or along some v'_i, and for the axes when all v'_i
//!    are zero.
//! 2. The height is the least Σ |a x + b y + c| − (x, y) · p_0 over the crossings of lines a x + b y + c = 0; if none
//!    cross, over one point of each line; if there are no lines, at the origin.
//!
//! # Complexity
//! O(n³) rational operations.
//!
//! # Shapes
//! `generators`: n × 3, any order, duplicates allowed, n up to about 50; `p0`: x first.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::collision::upper_hull::{Height, brute_force};
//! // the segment from −(1, 1, 3) to (1, 1, 3)
//! let segment = [[1.0, 1.0, 3.0]];
//! assert_eq!(brute_force::height(&segment, [0.5, 0.5]).unwrap(), Height::OverQ("3/2".parse().unwrap()));
//! assert!(matches!(brute_force::height(&segment, [0.5, 0.0]).unwrap(), Height::BesideQ(_)));
//! ```

use super::{Height, HeightError, validate};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The height of the upper hull over a point.
///
/// # Errors
/// [`HeightError`] names the first coordinate that is not finite.
pub fn height(generators: &[[f64; 3]], p0: [f64; 2]) -> Result<Height, HeightError> {
    validate(generators, p0)?;
    let rational = |c: f64| Dyadic::from_f64(c).to_rational();
    let p0 = p0.map(rational);
    let lines: Vec<[Rational; 3]> = generators.iter().map(|v| v.map(rational)).collect();
    let level = |u: &[Rational; 2]| &u[0] * &p0[0] + &u[1] * &p0[1];
    let reach = |u: &[Rational; 2]| sum(lines.iter().map(|[a, b, _]| abs(&u[0] * a + &u[1] * b)));
    let (zero, one) = (Rational::ZERO, Rational::ONE);
    let axes = [[one.clone(), zero.clone()], [zero.clone(), one]];
    let directions = lines.iter().flat_map(|[a, b, _]| [[-b.clone(), a.clone()], [a.clone(), b.clone()]]).chain(axes);
    let both = directions.flat_map(|[x, y]| [[-x.clone(), -y.clone()], [x, y]]);
    if let Some(u) = both.into_iter().find(|u| level(u) > reach(u)) {
        return Ok(Height::BesideQ(u));
    }
    let value = |[x, y]: [Rational; 2]| sum(lines.iter().map(|[a, b, c]| abs(a * &x + b * &y + c))) - level(&[x, y]);
    let height = candidates(&lines).into_iter().map(value).min().expect("there is a candidate");
    Ok(Height::OverQ(height))
}

/// Points one of which is a minimiser.
fn candidates(lines: &[[Rational; 3]]) -> Vec<[Rational; 2]> {
    let mut crossings = Vec::new();
    for (j, [d, e, f]) in lines.iter().enumerate() {
        for [a, b, c] in &lines[..j] {
            let w = a * e - b * d;
            if w != Rational::ZERO {
                crossings.push([(b * f - c * e) / &w, (c * d - a * f) / w]);
            }
        }
    }
    if !crossings.is_empty() {
        return crossings;
    }
    let square = |[a, b, _]: &[Rational; 3]| a * a + b * b;
    let proper = lines.iter().filter(|line| square(line) != Rational::ZERO);
    let feet = proper.map(|line| [0, 1].map(|axis| -(&line[axis] * &line[2]) / square(line)));
    feet.chain([[Rational::ZERO, Rational::ZERO]]).collect()
}

fn sum(terms: impl Iterator<Item = Rational>) -> Rational {
    terms.fold(Rational::ZERO, |sum, term| sum + term)
}

fn abs(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}
