//! Section 1: arrangements of the sphere and of the plane.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::upper_hull::line_value;
use crate::instances::bodies::bodies;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "central-projection",
    place: Place { section: "1", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Spherical arrangements can be mapped to hyperplane arrangements by a projective map",
    code: &["zonotope::arrangement"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3"]),
    ..Claim::LISTED
};

/// Projected from the centre to the plane z = 1, a crossing of circles on the upper half of the sphere is on the line
/// of a generator, above or below it, just when it was on its circle, before or behind it.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 102);
    let (mut crossings, mut sides, mut seen) = (0, 0, 0);
    for instance in bodies(&mut random, 60) {
        let body = instance.body();
        let upper: Vec<_> = body.normals().into_iter().filter(|normal| normal.0[2] > RBig::ZERO).collect();
        seen += usize::from(!upper.is_empty());
        for normal in upper {
            let [x, y, z] = &normal.0;
            let point = Point::new(x / z, y / z);
            for generator in &body.generators {
                let side = |value: RBig| value.cmp(&RBig::ZERO);
                let (on_sphere, in_plane) = (side(generator.dot(&normal)), side(line_value(generator, &point)));
                if on_sphere != in_plane {
                    return Verdict::Refuted(format!("{}: {normal} and {generator}", instance.name));
                }
                sides += usize::from(on_sphere != Ordering::Equal);
            }
            crossings += 1;
        }
    }
    Verdict::Holds(format!(
        "{crossings} crossings of great circles above the equator, of {seen} bodies, keep their lines in the plane z = \
         1, and their side of {sides} others"
    ))
}
