//! Sampled placements of a body that turns, and the volume of their convex hull: no convex volume around all placements
//! is smaller.

use zonotope::Pose;
use zonotope::hull::in_space::solid_hull;
use zonotope::motion::space_time::Sweep;
use zonotope::zonotope::Zonotope;

/// Equal parts of the motion at whose ends the body is placed.
const SAMPLES: u32 = 48;

/// A body of more generators has too many choices of signs.
const MOST_GENERATORS: usize = 12;

/// A body and its sweep, by the schedule that turns and translates it at constant rate.
#[derive(Debug, Clone)]
pub struct Placements<'a> {
    body: &'a Zonotope<3>,
    sweep: &'a Sweep,
}

impl<'a> Placements<'a> {
    /// The placements of a body.
    pub fn of(body: &'a Zonotope<3>, sweep: &'a Sweep) -> Self {
        Self { body, sweep }
    }

    /// The body at a time from 0 to 1, rounded.
    pub fn placed_at(&self, time: f64) -> Zonotope<3> {
        let (point, axis, gone) = (self.sweep.axis_point(), self.sweep.axis(), self.sweep.translation());
        let pose = Pose::from_axis_angle(axis, time * self.sweep.angle(), [0.0; 3]).expect("the axis is not zero");
        let rows = pose.matrix();
        let image = |v: [f64; 3]| rows.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
        let center = self.body.center();
        let turned = image([0, 1, 2].map(|k| center[k] - point[k]));
        let center = [0, 1, 2].map(|k| point[k] + turned[k] + time * gone[k]);
        let generators = self.body.generators().iter().map(|g| image(*g)).collect();
        Zonotope::new(center, generators).expect("a placement of a finite body is finite")
    }

    /// The volume of the convex hull of sampled placements; `None` for flat ones, and for bodies of many generators.
    pub fn hull_volume(&self) -> Option<f64> {
        if self.body.generators().len() > MOST_GENERATORS {
            return None;
        }
        let times = (0..=SAMPLES).map(|i| f64::from(i) / f64::from(SAMPLES));
        let points: Vec<[f64; 3]> = times.flat_map(|time| sign_points(&self.placed_at(time))).collect();
        solid_hull(&points).ok()?.map(|hull| hull.volume(&points))
    }
}

/// The points of a body with every choice of signs: its vertices are among them.
fn sign_points(body: &Zonotope<3>) -> Vec<[f64; 3]> {
    let both = |point: [f64; 3], g: &[f64; 3]| [1.0, -1.0].map(|sign| [0, 1, 2].map(|k| point[k] + sign * g[k]));
    let add = |points: Vec<[f64; 3]>, g: &[f64; 3]| points.into_iter().flat_map(|point| both(point, g)).collect();
    body.generators().iter().fold(vec![body.center()], add)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_translation_is_the_swept_box() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
        let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 0.0, [10.0, 0.0, 0.0]).expect("a sweep");
        assert_eq!(Placements::of(&cube, &sweep).hull_volume(), Some(48.0));
        let turn = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 2.0, [0.0; 3]).expect("a sweep");
        let hull = Placements::of(&cube, &turn).hull_volume().expect("a cube has a volume");
        assert!((12.4..4.0 * std::f64::consts::PI).contains(&hull), "{hull}");
    }
}
