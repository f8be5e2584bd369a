//! The exact proof that a displacement is on the facet of two generators.
//!
//! Let u = ± v_a × v_b, exactly, and S the sum of the generators off the plane of the two, with the signs of their
//! products with u. Then p is in the plane of the facet just when u · (p − S) = 0, the sign of one determinant, and on
//! the facet if the generators in its plane combine to p − S with coefficients in [−1, 1]. Those of all but two
//! may be any doubles, as the two make up for what is left of a vector of their plane. So a contact takes one exact sum
//! and one exact determinant, where a search in exact arithmetic takes hundreds of operations. At an edge
//! or a corner of the facet some coefficients are exactly 1 or −1: there the two are solved for exactly.

use super::facet_plane::{Plane, Split};
use crate::collision::proof::vectors::{SumErrors, Vectors, minus};
use crate::lad::of_generators::guess::facet_coefficients::facet_coefficients;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::linear::{cross, dot};
use crate::numeric::reused::Reused;
use crate::tally::Rung;
use crate::zonotope::location::{Proof, Witness};

/// A share of more than this is taken to be 1: then others are solved for exactly, and there is no proof if it is not.
const NEARLY_ONE: f64 = 1.0 - 1e-9;

/// The proof, from the computed normal u of two generators, which is a × b or, if it is reversed, its opposite; which
/// of the two cannot be read off u, as its square underflows where the generators are short. The signs are written
/// anew: of a generator near the plane of the facet there may be a share. O(n).
pub(super) fn touching(
    query: &dyn KernelQuery,
    vectors: &Vectors<'_>,
    pair: [usize; 2],
    u: &[f64; 3],
    is_reversed: bool,
    signs: &mut [f64],
    errors: &SumErrors<'_>,
) -> Option<Proof> {
    let Split { members, sum, third } = Plane { query, vectors, pair, u, is_reversed }.split(signs)?;
    let [a, b] = pair.map(|i| query.exact_generator(i));
    let (normal, left) = (exact_linear::cross(&a, &b), exact_linear::difference(&query.exact(), &sum));
    if !exact_linear::dot(&normal, &left).is_zero() {
        return None;
    }
    let rounded = left.each_ref().map(Dyadic::to_f64);
    let mut pair = pair;
    if members.len() > 2 {
        let [a, b] = pair.map(|i| vectors.value(i));
        let duals = [cross(&b, u), cross(u, &a)];
        let own = [dot(&a, &duals[0]), dot(&b, &duals[1])];
        let plane = |v: &[f64; 3]| [dot(v, &duals[0]) / own[0], dot(v, &duals[1]) / own[1]];
        let in_plane: Reused<[f64; 2]> = members.iter().map(|&i| plane(&vectors.value(i))).collect();
        let shares = facet_coefficients(&in_plane, plane(&rounded)).ok()?;
        // coordinates in the plane may leave the range of doubles
        if shares.iter().any(|share| share.is_nan()) {
            return None;
        }
        for (&i, &share) in members.iter().zip(&shares) {
            signs[i] = if share.abs() > NEARLY_ONE { share.signum() } else { share };
        }
        pair = pair_of_edge(vectors, pair, &members, signs);
    }
    let others = members.iter().copied().filter(|i| !pair.contains(i));
    let touched = Touched { query, vectors, pair, third, others, signs };
    // what the generators off the plane leave is exact, and those of the facet are taken off one by one
    let errors = errors.after(members.len());
    let [first, second] = touched.coefficients(&rounded, &errors).or_else(|| touched.exact_coefficients(left))?;
    let witness = Witness::with_basis(signs.to_vec(), [pair[0], pair[1], third], [first, second, signs[third]]);
    Some(Proof::boundary(witness, Rung::ScaledSigns))
}

/// The two generators of the facet that make up for what the others leave: where all shares but one are at their ends,
/// the point is on an edge, and only that one may be between its ends.
fn pair_of_edge(vectors: &Vectors<'_>, pair: [usize; 2], members: &[usize], shares: &[f64]) -> [usize; 2] {
    let mut between = members.iter().copied().filter(|&i| shares[i].abs() < 1.0);
    let (Some(only), None) = (between.next(), between.next()) else { return pair };
    let v = vectors.value(only);
    let area = |i: usize| {
        let normal = cross(&v, &vectors.value(i));
        dot(&normal, &normal)
    };
    if area(pair[0]) > area(pair[1]) { [only, pair[0]] } else { [only, pair[1]] }
}

/// A facet that p is in the plane of, with the shares of all its generators but two.
struct Touched<'a, I> {
    query: &'a dyn KernelQuery,
    vectors: &'a Vectors<'a>,
    pair: [usize; 2],
    /// A generator off the plane of the facet.
    third: usize,
    /// The generators of the facet beside the two.
    others: I,
    /// Signs of the generators off the plane, shares of the others.
    signs: &'a [f64],
}

impl<I: Iterator<Item = usize> + Clone> Touched<'_, I> {
    /// The coefficients of the two for a sum of the facet's generators, if they are certainly in (−1, 1).
    fn coefficients(&self, sum: &[f64; 3], errors: &[f64; 3]) -> Option<[f64; 2]> {
        let start = minus(*sum, -self.signs[self.third], &self.vectors.value(self.third));
        let rest = self.others.clone().fold(start, |rest, i| minus(rest, self.signs[i], &self.vectors.value(i)));
        match self.vectors.coefficients([self.pair[0], self.pair[1], self.third], &rest, errors)? {
            [Some(first), Some(second), _] => Some([first, second]),
            _ => None,
        }
    }

    /// The same, exactly, if they are in [−1, 1].
    fn exact_coefficients(&self, sum: ExactVector) -> Option<[f64; 2]> {
        let rest = self.others.clone().fold(sum, |rest, i| {
            let share = Dyadic::from_f64(self.signs[i]);
            exact_linear::difference(&rest, &exact_linear::multiple(&share, &self.query.exact_generator(i)))
        });
        let [a, b] = self.pair.map(|i| self.query.exact_generator(i));
        let normal = exact_linear::cross(&a, &b);
        let square = exact_linear::dot(&normal, &normal);
        let coefficient = |dual: &ExactVector| {
            let numerator = exact_linear::dot(&rest, dual);
            let is_within = !square.is_zero() && numerator.clone().abs() <= square;
            is_within.then(|| numerator.ratio(&square).clamp(-1.0, 1.0))
        };
        Some([coefficient(&exact_linear::cross(&b, &normal))?, coefficient(&exact_linear::cross(&normal, &a))?])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
    use crate::interop::verifier::check_location;
    use crate::numeric::bounded;
    use crate::zonotope::location::Status;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The proof that a pair gives, checked exactly.
    fn proved(generators: &[[f64; 3]], p: [f64; 3], pair: [usize; 2]) -> Option<&'static str> {
        let query = Query::new([0.0; 3], p, generators).expect("finite");
        let location = location_by_pair(&query, &crate::numeric::bounded::exact(p), pair)?.location.written(&query);
        assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{generators:?} {p:?} {pair:?}");
        Some(location.status().name())
    }

    /// Generators that are lost in a sum as they are taken off it one by one, and as they are put back.
    #[test]
    fn a_facet_of_a_thousand_short_generators_beside_two_long_ones() {
        let mut random = Pcg64Mcg::seed_from_u64(59);
        let (high, tiny) = (1.0 + 2f64.powi(-10), 2f64.powi(-60));
        let mut prism = vec![[high, 1.0, 0.0]];
        prism.extend((0..1000).map(|k| [0.49 * f64::EPSILON, -tiny * f64::from(k % 7), 0.0]));
        prism.extend([[-1.0 - 2f64.powi(-9), 1.0, 0.0], [0.0, 0.0, 1.0]]);
        let last = prism.len() - 2;
        for _ in 0..400 {
            let below = [1.0, 1.0 - f64::EPSILON / 2.0, 1.0 - 4.0 * f64::EPSILON][random.random_range(0..3)];
            let part = [0, 1].map(|_| f64::EPSILON * f64::from(random.random_range(-2000_i32..2000)));
            let p = [part[0], (2.0 + part[1]) * below, below];
            proved(&prism, p, [0, last]);
            proved(&prism, [-p[0], p[1], p[2]], [last, 0]);
        }
    }

    #[test]
    fn contacts_of_an_octagon_worked_out_by_hand() {
        let body =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.5, 0.0, 0.25]];
        // the top is an octagon around (0.5, 0, 1.25)
        for (x, y) in [(0.0, 0.0), (2.5, 0.5), (-2.0, 0.25), (0.0, 2.75)] {
            assert_eq!(proved(&body, [0.5 + x, y, 1.25], [0, 1]), Some("boundary"), "{x} {y}");
            assert_eq!(proved(&body, [-0.5 - x, -y, -1.25], [3, 1]), Some("boundary"), "{x} {y}");
        }
        // edges and corners of it
        for (x, y) in [(3.0, 1.0), (3.0, 0.25), (-3.0, -1.0), (1.0, 3.0), (0.5, 3.0), (2.0, 2.0), (-2.5, 1.5)] {
            assert_eq!(proved(&body, [0.5 + x, y, 1.25], [0, 1]), Some("boundary"), "{x} {y}");
        }
        // beside it, in its plane
        assert_eq!(proved(&body, [5.5, 0.0, 1.25], [0, 1]), None);
        assert_eq!(proved(&body, [0.5 + 3.0, 1.25, 1.25], [0, 1]), None);
        // a unit in the last place above and below
        assert_ne!(proved(&body, [0.5, 0.0, 1.25f64.next_up()], [0, 1]), Some("boundary"));
        assert_ne!(proved(&body, [0.5, 0.0, 1.25f64.next_down()], [0, 1]), Some("boundary"));
    }

    /// The last generator of the plane z = 0 is 4e-14 off the facet of the third one: it is given a share before it is
    /// known that no shares prove the point, and has its sign here all the same.
    #[test]
    fn a_generator_near_the_facet_counts_with_its_sign() {
        let near = [-2.0, -2.000_000_000_000_02, 0.0];
        let body = [[3.0, 2.0, 0.0], [1.0, 0.0, 0.0], [2.0, 2.0, 0.0], [-2.0, -2.0, 0.0], near, [0.0, 0.0, 1.0]];
        for n in 3..5 {
            let own = [&body[..n], &body[4..]].concat();
            let last = own.len() - 1;
            for pair in (0..last).map(|i| [i, last]) {
                assert_ne!(proved(&own, [4.0, 2.0, 0.0], pair), Some("boundary"), "{own:?} {pair:?}");
            }
            let query = Query::new([0.0; 3], [4.0, 2.0, 0.0], &own).expect("finite");
            let located = crate::collision::by_lad::locate(&query, &mut ());
            assert_eq!(located.status(), brute_force::locate(&query).status(), "{own:?}");
        }
    }

    #[test]
    fn contacts_of_lattices_are_found_and_nothing_else_is() {
        let random = &mut Pcg64Mcg::seed_from_u64(4);
        let mut found = 0;
        for round in 0..200 {
            let n = 4 + round % 7;
            let body: Vec<[f64; 3]> =
                (0..n).map(|_| [0, 1, 2].map(|_| f64::from(random.random_range(-3..4)))).collect();
            let pair = [random.random_range(0..n), random.random_range(0..n)];
            let u = cross(&body[pair[0]], &body[pair[1]]);
            // a point of the facet: those of its plane have quarters for coefficients
            let mut coefficient = |v: &[f64; 3]| {
                let along = dot(v, &u);
                if along == 0.0 { f64::from(random.random_range(-3..4)) / 4.0 } else { along.signum() }
            };
            let p = body.iter().fold([0.0; 3], |sum, v| minus(sum, -coefficient(v), v));
            let status = brute_force::locate(&Query::new([0.0; 3], p, &body).expect("finite")).status().name();
            let answer = proved(&body, p, pair);
            assert!(answer.is_none() || answer == Some(status), "{answer:?} {status} {body:?} {p:?}");
            found += u32::from(answer == Some("boundary"));
        }
        assert!(found > 120, "{found}");
    }

    /// A body whose coordinates have thirty digits: products of three of them are rounded in doubles, sums are not.
    fn long_lattice(random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let mut vector = || [0, 1, 2].map(|_| f64::from(random.random_range(-(1 << 30)..1 << 30)));
        let (a, b, c, d) = (vector(), vector(), vector(), vector());
        let of = |s: f64, t: f64| [0, 1, 2].map(|k| s * a[k] + t * b[k]);
        vec![a, b, c, d, of(1.0, 1.0), of(2.0, -1.0), of(-3.0, 2.0), of(1.0, 3.0)]
    }

    /// The signs of generators along the normal of the first two, exactly.
    fn exact_signs(body: &[[f64; 3]]) -> Vec<f64> {
        let normal = exact_linear::cross(&exact_linear::exact(body[0]), &exact_linear::exact(body[1]));
        let sign = |v: &[f64; 3]| exact_linear::dot(&exact_linear::exact(*v), &normal).sign() as i8;
        body.iter().map(|v| f64::from(sign(v))).collect()
    }

    fn combined(body: &[[f64; 3]], coefficients: &[f64]) -> [f64; 3] {
        body.iter().zip(coefficients).fold([0.0; 3], |sum, (v, c)| minus(sum, -c, v))
    }

    #[test]
    fn generators_of_a_facet_are_told_from_their_exact_products() {
        let random = &mut Pcg64Mcg::seed_from_u64(41);
        for round in 0..120 {
            let body = long_lattice(random);
            let mut shares = exact_signs(&body);
            for share in shares.iter_mut().filter(|share| **share == 0.0) {
                *share = f64::from(random.random_range(-3..4)) / 4.0;
            }
            let p = combined(&body, &shares);
            let (pair, p) = [([0, 1], p), ([1, 0], p), ([0, 1], p.map(|c| -c)), ([4, 7], p)][round % 4];
            assert_eq!(proved(&body, p, pair), Some("boundary"), "{body:?} {shares:?}");
        }
    }

    /// A generator that is off the plane of the facet by less than doubles tell has the sign of its exact product.
    #[test]
    fn generators_that_doubles_cannot_place_have_their_exact_signs() {
        let random = &mut Pcg64Mcg::seed_from_u64(42);
        let mut doubtful = 0;
        for round in 0..200 {
            let mut whole = |most: f64| [0, 1, 2].map(|_| 4.0 * (most * random.random_range(-1.0..1.0f64)).round());
            let (a, small) = (whole(2f64.powi(48)), whole(2f64.powi(28)));
            let b = [0, 1, 2].map(|k| a[k] + small[k]);
            let of = |s: f64, t: f64| [0, 1, 2].map(|k| s * a[k] + t * b[k]);
            let mut body = vec![a, b, whole(2f64.powi(48)), whole(2f64.powi(48)), of(1.0, 1.0), of(2.0, -1.0)];
            for v in &mut body[4..] {
                v[round % 3] += f64::from(random.random_range(0..2) * 2 - 1);
            }
            let mut shares = exact_signs(&body);
            let u = cross(&body[0], &body[1]);
            doubtful += body[4..].iter().zip(&shares[4..]).filter(|(v, share)| dot(v, &u).signum() != **share).count();
            (shares[0], shares[1]) = (0.25, -0.5);
            let p = combined(&body, &shares);
            let (pair, p) = [([0, 1], p), ([1, 0], p), ([0, 1], p.map(|c| -c))][round % 3];
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let vectors = Vectors::of(&query).expect("it has no matrix");
            let product = cross(&body[pair[0]], &body[pair[1]]);
            for is_reversed in [false, true] {
                let u = if is_reversed { product.map(|c| -c) } else { product };
                let exact = bounded::exact(p);
                let sizes = body.iter().fold([0.0; 3], |sum: [f64; 3], v| [0, 1, 2].map(|k| sum[k] + v[k].abs()));
                let errors = SumErrors { p: &exact, sizes: sizes.map(|c| 2.0 * c), count: body.len() };
                let mut signs = vec![1.0; body.len()];
                let proof = touching(&query, &vectors, pair, &u, is_reversed, &mut signs, &errors);
                if dot(&u, &p) < 0.0 {
                    // the other side of the body
                    assert!(proof.is_none(), "{body:?}");
                    continue;
                }
                let proof = proof.expect("the point is on the facet");
                assert_eq!(proof.location.status(), Status::Boundary);
                assert_eq!(
                    check_location(&query, &proof.location.written(&query)).proof().map(drop),
                    Ok(()),
                    "{body:?} {p:?}"
                );
            }
        }
        assert!(doubtful > 20, "{doubtful}");
    }

    /// Shares of thirds are no doubles: on an edge, the generator of the edge is one of the two that are solved for.
    #[test]
    fn points_of_edges_are_proved_whatever_generator_the_edge_has() {
        let plane = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [3.0, 3.0, 0.0], [6.0, -3.0, 0.0], [3.0, 6.0, 0.0]];
        let body = [&plane[..], &[[1.0, 1.0, 7.0], [0.0, 2.0, 5.0]]].concat();
        let mut count = 0;
        for edge in 0..5 {
            let normal = [-plane[edge][1], plane[edge][0]];
            for side in [1.0, -1.0] {
                let mut shares = [1.0; 7];
                for (share, v) in shares.iter_mut().zip(&plane) {
                    *share = side * f64::copysign(1.0, v[0] * normal[0] + v[1] * normal[1]);
                }
                shares[edge] = 0.0;
                let start = combined(&body, &shares);
                for part in [-2.0, -1.0, 0.0, 1.0, 2.0] {
                    let p = minus(start, -part / 3.0, &plane[edge]);
                    for pair in (0..5).flat_map(|i| (0..i).flat_map(move |j| [[i, j], [j, i]])) {
                        assert_eq!(proved(&body, p, pair), Some("boundary"), "{edge} {side} {part} {pair:?}");
                        count += 1;
                    }
                    let beyond = [0, 1].map(|k| p[k] + side * normal[k] / 64.0);
                    assert_ne!(proved(&body, [beyond[0], beyond[1], p[2]], [0, 1]), Some("boundary"), "{edge} {side}");
                }
            }
        }
        assert_eq!(count, 1000);
    }

    #[test]
    fn points_of_a_facets_plane_beside_it_are_not_proved() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for p in [[1.5, 0.0, 1.0], [0.0, -1.5, 1.0], [1.0f64.next_up(), 1.0, 1.0], [-2.0, 2.0, 1.0]] {
            assert_eq!(proved(&cube, p, [0, 1]), None, "{p:?}");
        }
        assert_eq!(proved(&cube, [1.0, -1.0, 1.0], [0, 1]), Some("boundary"));
    }

    /// In the middle of a facet doubles know the two coefficients.
    #[test]
    fn coefficients_away_from_their_ends_are_known_in_doubles() {
        let body = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.25, 0.5, 1.0], [1.0, 1.0, 0.0]];
        let p = [0.5 + 0.25 + 0.5, -0.5 + 0.5 + 0.5, 1.0];
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let vectors = Vectors::of(&query).expect("it has no matrix");
        let signs = [1.0, 1.0, 1.0, 0.5];
        let others = [3usize].into_iter();
        let touched = Touched { query: &query, vectors: &vectors, pair: [0, 1], third: 2, others, signs: &signs };
        let sum = minus(p, 1.0, &body[2]);
        let errors = [1e-12; 3];
        let own = touched.coefficients(&sum, &errors).expect("both are far from their ends");
        assert!((own[0] - 0.5).abs() < 1e-9 && (own[1] + 0.25).abs() < 1e-9, "{own:?}");
        assert_eq!(touched.coefficients(&sum, &[1.0; 3]), None);
    }
}
