//! Calls of bodies on a cube, and every method on a cube: dimensions that other tests do not reach, and refusals.

use zonotope::Zonotope;
use zonotope::collision::{Method, MethodError, Query, Status};

fn cube<const D: usize>() -> Zonotope<D> {
    let axis = |k: usize| std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
    Zonotope::new([0.0; D], (0..D).map(axis).collect()).expect("finite")
}

fn asked_of_a_cube<const D: usize>() {
    let body = cube::<D>();
    for (factor, status) in [(0.5, Status::Inside), (1.0, Status::Boundary), (1.5, Status::Outside)] {
        let mut point = [0.25; D];
        point[D - 1] = factor;
        assert_eq!(body.locate(point).expect("finite").status(), status, "{D} dimensions");
        assert_eq!(body.contains(point), Ok(factor <= 1.0), "{D} dimensions");
        let gauge = body.gauge(point).expect("finite");
        assert!((gauge.value - factor).abs() <= gauge.error, "{D} dimensions");
        let other = body.translated(point.map(|c| 2.0 * c)).expect("finite");
        assert_eq!(body.intersection(&other).status(), status, "{D} dimensions");
        assert_eq!(body.intersects(&other), factor <= 1.0, "{D} dimensions");
    }
    let mut point = [0.0; D];
    point[D - 1] = f64::INFINITY;
    let place = format!("the end's coordinate {} is inf, not a finite number", D - 1);
    assert_eq!(body.contains(point).map_err(|error| error.to_string()), Err(place));
    assert!(body.locate(point).is_err() && body.gauge(point).is_err());
}

#[test]
fn a_cube_answers_in_one_to_six_dimensions() {
    asked_of_a_cube::<1>();
    asked_of_a_cube::<2>();
    asked_of_a_cube::<3>();
    asked_of_a_cube::<4>();
    asked_of_a_cube::<5>();
    asked_of_a_cube::<6>();
}

#[test]
fn the_space_of_dimension_zero_is_one_point() {
    let body = Zonotope::<0>::new([], vec![[]]).expect("finite");
    assert_eq!(body.contains([]), Ok(true));
    assert!(body.intersects(&body));
}

/// A point with all coordinates 3 against the cube [−2, 2]^D: the gauge is 1.5.
fn every_method_agrees<const D: usize>() {
    let generators: Vec<[f64; D]> =
        (0..D).map(|axis| std::array::from_fn(|other| if other == axis { 2.0 } else { 0.0 })).collect();
    let [outside, inside] = [[3.0; D], [1.0; D]];
    for method in Method::ALL {
        for (point, is_inside) in [(outside, false), (inside, true)] {
            let question = Query::new([0.0; D], point, &generators).expect("finite");
            let found = method.locate(&question, 1, &mut ());
            let refused = MethodError::Dimension { method, dimension: D };
            if !method.dimensions().contains(&D) {
                assert_eq!(found, Err(refused));
                continue;
            }
            match found.expect("the method works in this dimension") {
                Some(location) => assert_eq!(location.status().name() == "inside", is_inside, "{method:?}"),
                None => assert!(!method.always_locates(), "{method:?}"),
            }
            match method.gauge(&question, &mut ()) {
                Ok(gauge) => assert!(method.measures() && gauge.value == if is_inside { 0.5 } else { 1.5 }),
                Err(error) => assert_eq!((error, method.measures()), (MethodError::NoGauge(method), false)),
            }
        }
    }
}

#[test]
fn methods_agree_where_they_work_and_say_where_they_do_not() {
    every_method_agrees::<1>();
    every_method_agrees::<2>();
    every_method_agrees::<3>();
    every_method_agrees::<4>();
    every_method_agrees::<5>();
    every_method_agrees::<8>();
}
