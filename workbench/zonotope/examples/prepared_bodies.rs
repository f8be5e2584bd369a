//! Prepared bodies: a body that is asked again and again is laid out once, for points, other bodies and poses alike.

use std::collections::BTreeMap;

use zonotope::{Pose, Status, Zonotope, zonotope::PreparedBody};

/// The generators of the body.
const COUNT: usize = 400;

/// The points along each axis of a grid around it.
const POINTS: usize = 12;

/// Asks, prints and asserts.
pub fn main() {
    let coordinate = |i: usize, step: usize| ((i * step) % 101) as f64 / 50.0 - 1.0;
    let generator = |i: usize| [coordinate(i, 17), coordinate(i, 29), coordinate(i, 43)];
    let body = Zonotope::new([0.0; 3], (0..COUNT).map(generator).collect()).expect("the coordinates are finite");
    let prepared = PreparedBody::new(body.clone());

    let reach = body.bounding_box().high[0];
    let place = |i: usize| reach * (2.0 * i as f64 / (POINTS - 1) as f64 - 1.0);
    let mut counts: BTreeMap<Status, usize> = BTreeMap::new();
    for (x, y) in (0..POINTS).flat_map(|x| (0..POINTS).map(move |y| (x, y))) {
        let point = [place(x), place(y), 0.25];
        let location = prepared.locate(point).expect("the point is finite");
        *counts.entry(location.status()).or_default() += 1;
        // the layout changes the time and nothing else
        assert_eq!(location.status(), body.locate(point).expect("the point is finite").status());
    }
    println!("{counts:?}");

    // how much preparation pays off depends on the number of questions; the methods are the same
    let often = body.prepared_for(10_000);
    let inner = body.center();
    assert!(often.contains(inner).expect("the point is finite") && often.intersects(&prepared));
    assert!(counts[&Status::Inside] > 0 && counts[&Status::Outside] > 0);

    // a pose turns and moves the prepared body, and nothing is copied
    let beyond = Pose::from_axis_angle([0.0, 0.0, 1.0], 0.5, [3.0 * reach, 0.0, 0.0]).expect("the pose is finite");
    assert!(!prepared.at(&beyond).intersects(&prepared));
    assert!(prepared.at(&Pose::IDENTITY).intersects(&prepared));
}
