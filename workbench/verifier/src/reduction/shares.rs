//! The proof that a zonotope contains another one with the same centre, by shares.
//!
//! Every generator v of the inner body is γ b + Σ x_l f_l, with one generator b of the outer body and a frame of
//! independent ones, f_l. If for each outer generator the magnitudes of its coefficients add up to at most 1 over all
//! v, every point of the inner body is one of the outer body.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Echelon, Vector, dot, solve};

/// A proof by shares, as it was written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shares {
    /// For each generator of the inner body, a generator of the outer one and its coefficient.
    pub shares: Vec<Option<(usize, f64)>>,
    /// The generators of the outer body that take what the shares leave.
    pub frame: Vec<usize>,
}

/// Checks that every inner generator is written in terms of outer ones, and none of these is used too much.
pub(super) fn check_shares(outer: &[Vector], inner: &[Vector], proof: &Shares) -> Result<(), String> {
    let Shares { shares, frame } = proof;
    if shares.len() != inner.len() {
        return Err(format!("certificate: {} shares for {} generators", shares.len(), inner.len()));
    }
    let named = shares.iter().flatten().map(|share| share.0).chain(frame.iter().copied());
    if let Some(wrong) = named.into_iter().find(|&generator| generator >= outer.len()) {
        return Err(format!("certificate: generator {wrong} of the enclosing body does not exist"));
    }
    check_finite("certificate", shares.iter().flatten().map(|share| &share.1))?;
    let frame_vectors: Vec<&Vector> = frame.iter().map(|&index| &outer[index]).collect();
    let duals = Duals::of(&frame_vectors).ok_or("certificate: the frame is dependent")?;
    let grid = Grid::at(Grid::of(shares.iter().flatten().map(|share| share.1)).exponent().min(0));
    let one = IBig::ONE << grid.exponent().unsigned_abs() as usize;
    // in units of 1 / (one · denominator)
    let mut used = vec![IBig::ZERO; outer.len()];
    for (index, (v, share)) in inner.iter().zip(shares).enumerate() {
        let mut rest: Vector = v.iter().map(|c| c * &one).collect();
        if let Some((generator, coefficient)) = *share {
            let units = grid.units(coefficient);
            rest.iter_mut().zip(&outer[generator]).for_each(|(rest, c)| *rest -= &units * c);
            used[generator] += (&units * &duals.denominator).abs();
        }
        let coefficients = duals.coefficients(&rest);
        for (axis, rest) in rest.iter().enumerate() {
            let sum: IBig = coefficients.iter().zip(&frame_vectors).map(|(x, f)| x * &f[axis]).sum();
            if sum != rest * &duals.denominator {
                return Err(format!("certificate: the share leaves a part of generator {index} off the frame"));
            }
        }
        frame.iter().zip(coefficients).for_each(|(&generator, x)| used[generator] += x.abs());
    }
    let whole = one * &duals.denominator;
    match used.iter().position(|used| *used > whole) {
        Some(generator) => Err(format!("certificate: generator {generator} of the enclosing body is used too much")),
        None => Ok(()),
    }
}

/// Vectors whose products with a vector of the span of a frame are its coefficients, times a positive denominator.
struct Duals {
    /// Over the coordinates that tell the vectors of the span apart.
    rows: Vec<Vector>,
    axes: Vec<usize>,
    denominator: IBig,
}

impl Duals {
    fn of(frame: &[&Vector]) -> Option<Self> {
        let dimension = frame.first().map_or(0, |vector| vector.len());
        let span = Echelon::spanned(dimension, frame.iter().copied());
        let axes = span.pivots();
        if axes.len() != frame.len() {
            return None;
        }
        let columns: Vec<Vector> = axes.iter().map(|&axis| frame.iter().map(|f| f[axis].clone()).collect()).collect();
        let columns: Vec<&Vector> = columns.iter().collect();
        let unit = |place: usize| -> Vector { (0..frame.len()).map(|k| IBig::from(i32::from(k == place))).collect() };
        let solved: Option<Vec<(Vector, IBig)>> = (0..frame.len()).map(|place| solve(&columns, &unit(place))).collect();
        let solved = solved?;
        let denominator: IBig = solved.iter().map(|(_, denominator)| denominator).product();
        let scaled = |(row, own): (Vector, IBig)| row.into_iter().map(|c| c * (&denominator / &own)).collect();
        Some(Self { rows: solved.into_iter().map(scaled).collect(), axes, denominator })
    }

    fn coefficients(&self, v: &Vector) -> Vec<IBig> {
        let kept: Vector = self.axes.iter().map(|&axis| v[axis].clone()).collect();
        self.rows.iter().map(|row| dot(row, &kept)).collect()
    }
}
