//! Gauge and separating plane: how many times a body must be taken to hold a point, and the plane that parts them.

use zonotope::{Separation, Zonotope};

/// Asks, prints and asserts.
pub fn main() {
    let generators = vec![[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]];
    let body = Zonotope::new([1.0, 0.0, 0.0], generators).expect("the coordinates are finite");
    let point = [1.0, 6.0, 0.5];

    // along y the body reaches 2 from its centre, and the point is 6 away
    let gauge = body.gauge(point).expect("the point is finite");
    println!("the body must be taken {} times, within {}", gauge.value, gauge.error);
    assert!((gauge.value - 3.0).abs() <= gauge.error);

    let Some(&Separation::Rounded(normal)) = gauge.location.separation() else {
        unreachable!("a point of gauge above 1 is outside, and here with room for a plane of doubles");
    };
    let along = |v: [f64; 3]| v.iter().zip(normal).map(|(a, b)| a * b).sum::<f64>();
    let reach = body.support(normal).value();
    println!("{normal:?} · x = {reach} touches the body, and the point is at {}", along(point));
    assert!(along(point) > reach);

    // the body taken so many times touches the point, up to the rounding of the gauge
    let larger = |factor: f64| {
        let scaled = body.generators().iter().map(|g| g.map(|c| factor * c)).collect();
        Zonotope::new(body.center(), scaled).expect("the coordinates are finite")
    };
    assert_eq!(larger(gauge.value * (1.0 + 1e-9)).contains(point), Ok(true));
    assert_eq!(larger(gauge.value * (1.0 - 1e-9)).contains(point), Ok(false));
}
