//! Both methods against the truth on every family.

use families::drawn::numbers::integer;
use proptest::prelude::*;

use super::*;
use crate::numeric::dyadic::Dyadic;

fn check(generators: &[[f64; 3]], p0: [f64; 2]) -> Result<(), TestCaseError> {
    let truth = brute_force::height(generators, p0).expect("finite");
    let found = [by_kernel::height(generators, p0, &mut ()), by_slope_selection::height(generators, p0, 7, &mut ())];
    for height in found.map(|height| height.expect("finite")) {
        match (&truth, &height) {
            (Height::OverQ(truth), Height::OverQ(height)) => prop_assert_eq!(truth, height),
            (Height::BesideQ(_), Height::BesideQ(u)) => {
                let along = |v: [f64; 2]| {
                    let [x, y] = v.map(|c| Dyadic::from_f64(c).to_rational());
                    &u[0] * x + &u[1] * y
                };
                let magnitude = |v: Rational| if v < Rational::ZERO { -v } else { v };
                let reach = generators.iter().fold(Rational::ZERO, |sum, v| sum + magnitude(along([v[0], v[1]])));
                prop_assert!(along(p0) > reach, "{:?} does not separate", u);
            }
            _ => return Err(TestCaseError::fail(format!("{truth:?}, but {height:?}"))),
        }
    }
    Ok(())
}

/// A random point, a corner of Q, the middle of two corners, and neighbours in the last place.
fn check_around(generators: &[[f64; 3]], signs: &[bool], p0: [f64; 2]) -> Result<(), TestCaseError> {
    check(generators, p0)?;
    let corner = |flip: usize| {
        let signed = generators.iter().zip(signs.iter().cycle()).enumerate();
        signed.fold([0.0; 2], |[x, y], (i, (v, &sign))| {
            let sign = if sign != (i == flip) { 1.0 } else { -1.0 };
            [x + sign * v[0], y + sign * v[1]]
        })
    };
    let (first, second) = (corner(usize::MAX), corner(0));
    check(generators, first)?;
    check(generators, [f64::midpoint(first[0], second[0]), f64::midpoint(first[1], second[1])])?;
    check(generators, [first[0].next_up(), first[1]])?;
    check(generators, [0.0, first[1]])
}

fn several(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<[f64; 3]>> {
    proptest::collection::vec([coordinate.clone(), coordinate.clone(), coordinate], 0..8)
}

fn signs() -> impl Strategy<Value = Vec<bool>> {
    proptest::collection::vec(any::<bool>(), 8)
}

properties! {
    #![proptest_config(crate::property_cases::config(600))]

    #[test]
    fn random_bodies(g in several(-1.0..1.0f64), signs in signs(), p0 in [-3.0..3.0f64, -3.0..3.0]) {
        check_around(&g, &signs, p0)?;
    }

    #[test]
    fn lattice_bodies(g in several(integer(2)), signs in signs(), p0 in [integer(2), integer(2)]) {
        check_around(&g, &signs, p0)?;
    }

    #[test]
    fn bodies_of_all_magnitudes(
        g in several((integer(2), prop_oneof![Just(1e-300), Just(1e300), Just(1.0)]).prop_map(|(v, s)| v * s)),
        signs in signs(),
        p0 in [integer(2), integer(2)],
    ) {
        check_around(&g, &signs, p0)?;
    }

    #[test]
    fn bodies_in_a_vertical_plane(
        g in proptest::collection::vec((integer(2), -1.0..1.0f64), 0..7),
        d in [integer(2), integer(2)],
        signs in signs(),
        t in integer(2),
    ) {
        let g: Vec<[f64; 3]> = g.into_iter().map(|(x, z)| [x * d[0], x * d[1], z]).collect();
        check_around(&g, &signs, d.map(|c| c * t))?;
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let error = height(&[[0.0, f64::NAN, 1.0]], [0.0; 2], &mut ()).expect_err("a generator");
    assert_eq!(error.to_string(), "generator 0, coordinate 1 is NaN, not a finite number");
    let error = height(&[[0.0, 1.0, 1.0]], [0.0, f64::INFINITY], &mut ()).expect_err("the point");
    assert_eq!(error.to_string(), "p0's coordinate 1 is inf, not a finite number");
}
