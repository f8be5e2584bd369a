//! Coefficients for one point by a linear program in rationals: the last resort, for problems with few directions.

use super::body::Body;
use crate::numeric::Rational;
use crate::numeric::exact_linear::rational;
use crate::numeric::exact_linear::simplex::{Column, maximize};

impl<const D: usize> Body<'_, D> {
    /// Coefficients, rounded to doubles, for which enlarging the basis by the residual costs least.
    pub(super) fn rational_coefficients(&self, point: &[f64; D]) -> Vec<f64> {
        let coordinates = &self.scaled.coordinates;
        let count = self.generators.len();
        let mut columns = Vec::with_capacity(2 * (count + self.basis.len()) + 1);
        let mut add = |limited: usize, along: &dyn Fn(usize) -> Rational, gain: &Rational| {
            let inequalities = (0..=count).map(|i| Rational::from(u8::from(i == limited))).collect();
            let equalities = coordinates.iter().map(|&a| along(a)).collect();
            columns.push(Column { inequalities, equalities, gain: gain.clone() });
        };
        let index = |i: usize| self.scaled.directions[i].index;
        let along = |i: usize, a: usize| rational(self.problem.directions()[index(i)][a]);
        let weight = |i: usize| rational(self.problem.weights()[index(i)]);
        for (i, &c) in self.coefficients.iter().enumerate() {
            add(i, &|a| rational(c) * along(i, a), &Rational::ZERO);
            add(i, &|a| -rational(c) * along(i, a), &Rational::ZERO);
        }
        for &b in &self.basis {
            add(usize::MAX, &|a| along(b, a), &-weight(b));
            add(usize::MAX, &|a| -along(b, a), &-weight(b));
        }
        // The last variable is the share of the point that is reached. Enlarging the basis alone reaches the whole
        // point for less than `cost`, so the optimum reaches it.
        let whole = self.magnitudes_in_basis(&self.residual(point, &[]));
        let cost = self.basis.iter().zip(whole).fold(Rational::ONE, |sum, (&b, x)| sum + weight(b) * x);
        add(count, &|a| rational(self.center[a]) - rational(point[a]), &cost);
        let bounds = vec![Rational::ONE; count + 1];
        let mut work = self.exact_work.get();
        let optimum = maximize(&columns, &bounds, coordinates.len(), &mut work);
        self.exact_work.set(work);
        let Ok(optimum) = optimum else { return vec![0.0; count] };
        let pairs = optimum.solution.chunks_exact(2).take(count);
        pairs.map(|pair| (&pair[0] - &pair[1]).to_f64_fast().clamp(-1.0, 1.0)).collect()
    }
}
