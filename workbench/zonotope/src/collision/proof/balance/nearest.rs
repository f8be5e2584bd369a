//! The coefficients of a proof's basis as doubles beside their exact values.
//!
//! A proof does not rest on the numbers that it gives for its basis: those off the basis imply them. The methods leave
//! them as floating point has them, since their last digits depend on a sum over all generators that is more precise
//! than any decision needs. An answer that is handed to others has them rounded here, so that a reader may hold them
//! against what the rest implies.
//!
//! The rest that all coefficients leave as they stand is tiny. Known to about twice the digits of a double it gives the
//! corrections of the basis in plain doubles, with a bound. Where that bound leaves more than the nearest double and
//! its neighbours to choose from, the exact rest gives them in pairs of doubles ([`from_exact_rest`]); where that is in
//! doubt, or the basis does not span the space, rationals answer.

use std::array;

use super::from_exact_rest;
use super::solve::left_over;
use crate::lad::of_generators::seam::frame::Frame;
use crate::numeric::Rational;
use crate::numeric::bounded::Bounded;
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{cross, dot, sum_norm};
use crate::numeric::tolerance::{DETERMINANT_OF_IMAGES, LONG_SUM, MODERATE_SIZES, PRODUCT_UNDERFLOW, UNIT};
use crate::zonotope::location::{Gauge, Location, Witness};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::{Placed, Query, padded};

/// The coefficients of a witness's basis, each the nearest double or the one beside it; `None` if its generators are
/// dependent or nothing solves the equation. O(n).
fn nearest<const D: usize, P: Standing>(query: &Query<'_, D, P>, witness: &Witness) -> Option<Vec<f64>> {
    in_doubles(query, witness).or_else(|| {
        if !witness.coefficients.iter().all(|c| c.is_finite()) {
            return None;
        }
        let in_pairs = query.in_dimension::<3>().and_then(|query| from_exact_rest::nearest(&query, witness));
        in_pairs.or_else(|| Some(exact_basis(query, witness)?.iter().map(|value| value.to_f64().value()).collect()))
    })
}

/// The coefficients of the basis, exactly; `None` if its generators are dependent or nothing solves the equation. O(n)
/// exact additions.
pub(super) fn exact_basis<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    Witness { coefficients, basis }: &Witness,
) -> Option<Vec<Rational>> {
    let (mut left, mut start) = (query.exact(), 0);
    for body in query.parts() {
        let rows = body.generators();
        let places = start..start + rows.len();
        let own: Vec<usize> = basis.iter().filter(|b| places.contains(b)).map(|b| b - start).collect();
        let centred = Query::of_finite([0.0; D], [0.0; D], rows);
        let rest = left_over(&centred, &array::from_fn(|_| Dyadic::zero()), &coefficients[places.clone()], &own);
        let moved = body.exact_image(rest);
        left = array::from_fn(|k| &left[k] + &moved[k]);
        start = places.end;
    }
    let column = |&b: &usize| {
        let (body, v) = query.located(b);
        body.exact_image(v.map(Dyadic::from_f64)).map(|c| c.to_rational()).to_vec()
    };
    let columns: Vec<_> = basis.iter().map(column).collect();
    exact_linear::solve(&columns, &left.map(|c| c.to_rational()))
}

/// p − Σ c v over all generators, in at most three dimensions. O(n).
fn rest<const D: usize, P: Standing>(query: &Query<'_, D, P>, coefficients: &[f64]) -> [BoundedDoubleDouble; D] {
    let [first, second] = query.parts();
    let (own, others) = coefficients.split_at(first.generators().len());
    let sum = |body: &Placed<'_, D, P>, coefficients: &[f64]| {
        let sum = match body.in_dimension::<3>() {
            Some(body) => combined_sum(body.rows(), coefficients),
            None => {
                let rows: Vec<[f64; 3]> = body.generators().iter().map(padded).collect();
                combined_sum(Rows::new(&rows), coefficients)
            }
        };
        body.pair_image(array::from_fn(|k| sum[k]))
    };
    let (own, others) = (sum(first, own), sum(second, others));
    let p = query.displacement_pairs();
    array::from_fn(|k| p[k] - own[k] - others[k])
}

/// A generator in doubles, the coordinates beyond D 0, with a bound of its length |v|_1 of which 4 u bounds the error.
fn vector<const D: usize, P: Standing>(query: &Query<'_, D, P>, index: usize) -> ([f64; 3], f64) {
    let (body, v) = query.located(index);
    let v = padded(v);
    match body.standing().pose().and_then(Frame::of) {
        None => (v, sum_norm(&v)),
        Some(frame) => frame.image_with_length(&v),
    }
}

/// The coefficients of a basis that spans the space, each the nearest double or a neighbour of it, if doubles tell.
fn in_doubles<const D: usize, P: Standing>(query: &Query<'_, D, P>, witness: &Witness) -> Option<Vec<f64>> {
    const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    if D > 3 || witness.basis.len() != D {
        return None;
    }
    let pairs = rest(query, &witness.coefficients);
    let rest = [0, 1, 2].map(|k| pairs.get(k).map_or(Bounded::exact(0.0), BoundedDoubleDouble::rounded));
    let vector = |k: usize| witness.basis.get(k).map_or((AXES[k], 1.0), |&index| vector(query, index));
    let [(a, first), (b, second), (c, third)] = [vector(0), vector(1), vector(2)];
    let normals = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let determinant = dot(&a, &normals[0]);
    let volume = first * second * third;
    let least = determinant.abs() - DETERMINANT_OF_IMAGES * volume - PRODUCT_UNDERFLOW;
    // false for NaN as well
    let is_spanning = least > 0.0 && [first, second, third].iter().all(|length| MODERATE_SIZES.contains(length));
    if !is_spanning {
        return None;
    }
    let values = rest.map(|c| c.value);
    let (size, error) = (sum_norm(&values), rest[0].error + rest[1].error + rest[2].error);
    let nearest = |((&index, normal), length): ((&usize, &[f64; 3]), f64)| {
        let step = dot(&values, normal) / determinant;
        // how far the product with the normal is off, then the quotient
        let rounding = DETERMINANT_OF_IMAGES * (volume / length);
        let along = error * (sum_norm(normal) + rounding) + size * rounding + PRODUCT_UNDERFLOW;
        let off = (along + step.abs() * DETERMINANT_OF_IMAGES * volume) / least + 4.0 * UNIT * step.abs();
        let off = off * LONG_SUM + PRODUCT_UNDERFLOW;
        let start = witness.coefficients[index];
        let value = (start + step).clamp(-1.0, 1.0);
        let is_beside = value.next_down() <= start + (step - off) && start + (step + off) <= value.next_up();
        is_beside.then_some(value)
    };
    witness.basis.iter().zip(&normals).zip([first, second, third]).map(nearest).collect()
}

impl Witness {
    /// The same proof with each coefficient of the basis the double nearest to its exact value; where two are as near
    /// but for rounding, perhaps the other one. O(n): a pass in doubles, exact additions where that leaves a doubt.
    ///
    /// Answers of bodies ([`Zonotope::locate`](crate::Zonotope::locate) and its like) are already so; those of single
    /// methods are not. A witness that proves nothing is given back as another that proves nothing.
    pub fn with_nearest_basis<const D: usize, P: Standing>(mut self, query: &Query<'_, D, P>) -> Self {
        let n = query.len();
        let is_basis = self.coefficients.len() == n && self.basis.iter().all(|&b| b < n);
        if !is_basis || self.basis.is_empty() {
            return self;
        }
        let values = nearest(query, &self);
        for (&b, value) in self.basis.iter().zip(values.unwrap_or_default()) {
            self.coefficients[b] = value;
        }
        self
    }
}

impl<const D: usize> Location<D> {
    /// The same location, the proof of a member as [`Witness::with_nearest_basis`] has it.
    pub fn with_nearest_basis<P: Standing>(self, query: &Query<'_, D, P>) -> Self {
        match self {
            Self::Inside(witness) => Self::Inside(witness.with_nearest_basis(query)),
            Self::Boundary(witness) => Self::Boundary(witness.with_nearest_basis(query)),
            Self::Outside(separation) => Self::Outside(separation),
        }
    }
}

impl<const D: usize> Gauge<D> {
    /// The same gauge, the proof of a member as [`Witness::with_nearest_basis`] has it.
    pub fn with_nearest_basis<P: Standing>(self, query: &Query<'_, D, P>) -> Self {
        Self { location: self.location.with_nearest_basis(query), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;
    use crate::collision::by_lad::locate;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn a_basis_may_be_in_any_order() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let first = Zonotope::new([0.0; 3], axes[..1].to_vec()).expect("finite");
        let second = Zonotope::new([0.25, 0.5, 0.75], axes[1..].to_vec()).expect("finite");
        let query = Query::of_placed(first.at(&Pose::default()), second.at(&Pose::default()));
        for basis in [vec![0, 1, 2], vec![2, 1, 0], vec![1, 2, 0], vec![2], vec![1, 1]] {
            let coefficients: Vec<f64> = (0..3).map(|i| if basis.contains(&i) { 0.0 } else { 0.5 }).collect();
            let witness = Witness { coefficients, basis: basis.clone() }.with_nearest_basis(&query);
            if basis.len() == 3 {
                assert_eq!(witness.coefficients, [0.25, 0.5, 0.75], "{basis:?}");
            }
        }
    }

    /// Doubles suffice mostly, but not for coefficients much smaller than the others.
    #[test]
    fn doubles_know_them() {
        let random = &mut Pcg64Mcg::seed_from_u64(3);
        for n in [3, 6, 40, 245, 900] {
            let (mut asked, mut proved) = (0, 0);
            for i in 0..60 {
                let rows: Vec<[f64; 3]> = (0..n).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect();
                let share = [0.2, 0.7, 1.0][i % 3];
                let p = rows.iter().fold([0.0; 3], |sum, v| {
                    let c = share * random.random_range(-1.0..1.0);
                    [0, 1, 2].map(|k| sum[k] + c * v[k])
                });
                let query = Query::new([0.0; 3], p, &rows).expect("finite");
                let body = Zonotope::new([0.5; 3], rows.clone()).expect("finite");
                let pose = Pose::from_axis_angle([1.0, 2.0, 3.0], f64::from(i as u32), p).expect("an axis");
                let posed = Query::of_placed(body.at(&Pose::IDENTITY), body.at(&pose));
                let plain = witness(&locate(&query, &mut ())).map(|witness| compared(&query, witness));
                let placed = witness(&locate(&posed, &mut ())).map(|witness| compared(&posed, witness));
                for is_known in plain.into_iter().chain(placed) {
                    (asked, proved) = (asked + 1, proved + usize::from(is_known));
                }
            }
            assert!(asked >= 60 && 4 * proved >= 3 * asked, "{n}: {proved} of {asked}");
        }
    }

    fn witness<const D: usize>(location: &Location<D>) -> Option<&Witness> {
        match location {
            Location::Inside(witness) | Location::Boundary(witness) => Some(witness),
            Location::Outside(_) => None,
        }
    }

    /// Whether doubles tell the coefficients, which are then the nearest ones or beside these.
    fn compared<P: Standing>(query: &Query<'_, 3, P>, witness: &Witness) -> bool {
        let exact = exact_basis(query, witness).expect("the witness is one");
        let exact: Vec<f64> = exact.iter().map(|value| value.to_f64().value()).collect();
        let proved = in_doubles(query, witness);
        for (own, exact) in proved.iter().flatten().zip(&exact) {
            assert!((exact.next_down()..=exact.next_up()).contains(own), "{own} {exact}");
        }
        proved.is_some()
    }

    #[test]
    fn a_witness_by_hand() {
        let rows = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0], [1.0, 1.0, 1.0]];
        let query = Query::new([0.0; 3], [1.0; 3], &rows).expect("finite");
        let rough = Witness { coefficients: vec![0.3, 0.3, 0.3, 0.0], basis: vec![0, 1, 2] };
        let nearest = rough.with_nearest_basis(&query);
        assert_eq!(nearest.coefficients, [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0]);
        assert_eq!(Location::<3>::Inside(nearest).status(), Status::Inside);
        // what is no witness stays what it is
        let none = Witness { coefficients: vec![0.3], basis: vec![7] };
        assert_eq!(none.clone().with_nearest_basis(&query), none);
    }

    /// Witnesses with rows that are well conditioned or not, whose coefficients are off by much or little.
    fn asked(random: &mut Pcg64Mcg, round: usize) -> (Vec<[f64; 3]>, [f64; 3], Vec<f64>) {
        let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
        let scale = [1.0, 1e-6, 1e6][round % 3];
        let thin = [1.0, 1e-3, 1e-6][round / 3 % 3];
        let (a, b, c) = (vector(), vector(), vector());
        let third = [0, 1, 2].map(|k| a[k] - b[k] + thin * c[k]);
        let mut rows = vec![a, b, third];
        rows.extend((0..round % 4).map(|_| vector()));
        let rows: Vec<[f64; 3]> = rows.into_iter().map(|v| v.map(|c| scale * c)).collect();
        let size = [1.0, 1e-4][round / 9 % 2];
        let mut coefficients: Vec<f64> = rows.iter().map(|_| random.random_range(-1.0..1.0f64)).collect();
        coefficients[1] *= size;
        coefficients[2] *= size;
        let p = rows.iter().zip(&coefficients).fold([0.0; 3], |sum, (v, c)| [0, 1, 2].map(|k| sum[k] + c * v[k]));
        let off = 10f64.powi(-random.random_range(1..17));
        for c in &mut coefficients[..if round.is_multiple_of(5) { 3 } else { 1 }] {
            *c += off * random.random_range(-1.0..1.0f64);
        }
        (rows, p, coefficients)
    }

    #[test]
    fn values_that_doubles_give_are_the_nearest_or_beside_them_however_far_the_start_is_off() {
        let random = &mut Pcg64Mcg::seed_from_u64(101);
        let mut known = 0;
        for round in 0..900 {
            let (rows, p, coefficients) = asked(random, round);
            let query = Query::new([0.0; 3], p, &rows).expect("finite");
            let witness = Witness { coefficients, basis: vec![0, 1, 2] };
            if let Some(own) = in_doubles(&query, &witness) {
                let exact = exact_basis(&query, &witness).expect("the rows are independent");
                if exact.iter().all(|value| *value >= Rational::NEG_ONE && *value <= Rational::ONE) {
                    for (own, exact) in own.iter().zip(exact.iter().map(|value| value.to_f64().value())) {
                        assert!(
                            (exact.next_down()..=exact.next_up()).contains(own),
                            "{own} {exact} {rows:?} {witness:?}"
                        );
                    }
                    known += 1;
                }
            }
        }
        assert!(known > 200, "{known}");
    }

    #[test]
    fn doubles_know_coefficients_that_are_off_by_some_roundings() {
        let random = &mut Pcg64Mcg::seed_from_u64(102);
        for round in 0..200 {
            let scale = [1.0, 1e-9, 1e9][round % 3];
            let rows: Vec<[f64; 3]> = (0..5)
                .map(|i| {
                    [0, 1, 2]
                        .map(|k| scale * (0.2 * random.random_range(-1.0..1.0f64) + if i == k { 1.0 } else { 0.0 }))
                })
                .collect();
            let mut coefficients: Vec<f64> = (0..5).map(|_| random.random_range(0.5..0.99f64)).collect();
            let p = rows.iter().zip(&coefficients).fold([0.0; 3], |sum, (v, c)| [0, 1, 2].map(|k| sum[k] + c * v[k]));
            for (c, sign) in coefficients.iter_mut().zip([1.0, -1.0, 1.0]) {
                *c += sign * [5.0, 40.0][round % 2] * UNIT;
            }
            let query = Query::new([0.0; 3], p, &rows).expect("finite");
            let witness = Witness { coefficients, basis: vec![0, 1, 2] };
            assert!(compared(&query, &witness), "{rows:?} {witness:?}");
            // in the plane, of the same rows without their last coordinates
            let rows: Vec<[f64; 2]> = rows.iter().take(2).map(|v| [v[0], v[1]]).collect();
            let coefficients = witness.coefficients[..2].to_vec();
            let p = [0, 1].map(|k| 0.75 * rows[0][k] - 0.6 * rows[1][k]);
            let query = Query::new([0.0; 2], p, &rows).expect("finite");
            let start = Witness { coefficients: vec![0.75, -0.6], basis: vec![0, 1] };
            let own = in_doubles(&query, &start).expect("both are known");
            assert!((own[0] - 0.75).abs() < 1e-15 && (own[1] + 0.6).abs() < 1e-15, "{own:?} {coefficients:?}");
        }
    }

    #[test]
    fn nothing_is_told_in_doubles_of_fewer_or_dependent_generators() {
        let random = &mut Pcg64Mcg::seed_from_u64(103);
        for _ in 0..100 {
            let [a, b] = [0, 1].map(|_| [0, 1, 2].map(|_| f64::from(random.random_range(-(1 << 30)..1 << 30))));
            let rows = [a, b, [0, 1, 2].map(|k| a[k] + b[k]), [1.0, 2.0, 4.0]];
            let p = [0, 1, 2].map(|k| 0.5 * a[k] + 0.25 * b[k]);
            let query = Query::new([0.0; 3], p, &rows).expect("finite");
            let witness = |basis: &[usize]| Witness { coefficients: vec![0.5, 0.25, 0.0, 0.0], basis: basis.to_vec() };
            assert_eq!(in_doubles(&query, &witness(&[0, 1, 2])), None);
            assert_eq!(nearest(&query, &witness(&[0, 1, 2])), None);
            // nothing is left and nothing lost, and still they are dependent
            let none = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
            let zero = Witness { coefficients: vec![0.0; 4], basis: vec![0, 1, 2] };
            assert_eq!(in_doubles(&none, &zero), None, "{rows:?}");
            assert_eq!(in_doubles(&query, &witness(&[0, 1])), None);
            assert_eq!(nearest(&query, &witness(&[0, 1])), Some(vec![0.5, 0.25]));
            // nothing solves the equation
            let beside = Query::new([0.0; 3], [p[0], p[1], p[2] + 1.0], &rows).expect("finite");
            assert_eq!(nearest(&beside, &witness(&[0, 1])), None);
        }
    }

    #[test]
    fn coefficients_of_two_bodies_are_solved_for_with_the_generators_of_both() {
        let turned =
            Pose::new([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 2.0]], [1.0, 0.5, -0.25]).expect("finite");
        let first = Zonotope::new([0.0; 3], vec![[1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.25]]).expect("finite");
        let second = Zonotope::new([0.25, 0.5, 0.75], vec![[0.0, 0.25, 1.0], [1.0, 0.0, 1.0]]).expect("finite");
        let query = Query::of_placed(first.at(&Pose::IDENTITY), second.at(&turned));
        for basis in [vec![0, 1, 3], vec![1, 3, 4], vec![2, 4], vec![4], vec![0, 2, 4]] {
            let coefficients = [0.5, -0.25, 0.125, 0.75, -0.5];
            let witness = Witness { coefficients: coefficients.to_vec(), basis: basis.clone() };
            let Some(own) = exact_basis(&query, &witness) else { continue };
            // Σ c v over all generators is the displacement
            let mut all = coefficients.map(exact_linear::rational);
            for (&b, value) in basis.iter().zip(own) {
                all[b] = value;
            }
            let p = query.exact();
            for (k, own) in p.iter().enumerate() {
                let sum = (0..5).fold(Rational::ZERO, |sum, i| {
                    let (body, v) = query.located(i);
                    sum + &all[i] * body.exact_image(v.map(Dyadic::from_f64))[k].to_rational()
                });
                assert_eq!(sum, own.to_rational(), "{basis:?}");
            }
            let pairs = rest(&query, &coefficients);
            for (k, (own, left)) in p.iter().zip(pairs).enumerate() {
                let sum = (0..5).fold(own.clone(), |sum, i| {
                    let (body, v) = query.located(i);
                    sum - Dyadic::from_f64(coefficients[i]) * body.exact_image(v.map(Dyadic::from_f64))[k].clone()
                });
                let rounded = left.rounded();
                assert!((sum - Dyadic::from_f64(rounded.value)).abs() <= Dyadic::from_f64(rounded.error + 1e-30));
            }
        }
        let spanning = Witness { coefficients: vec![0.5, 0.0, 0.0, 0.25, 0.0], basis: vec![1, 2, 4] };
        assert!(exact_basis(&query, &spanning).is_some());
    }

    #[test]
    fn what_names_no_generators_stays_as_it_is() {
        let rows = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
        let query = Query::new([0.0; 3], [1.0; 3], &rows).expect("finite");
        for (count, basis) in [(3, vec![0, 3]), (2, vec![0]), (4, vec![1]), (3, vec![]), (2, vec![7]), (0, vec![])] {
            let witness = Witness { coefficients: vec![0.25; count], basis };
            assert_eq!(witness.clone().with_nearest_basis(&query), witness);
        }
    }
}
