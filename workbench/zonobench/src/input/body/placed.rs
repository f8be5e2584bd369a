//! A body beside the pose that places it.

use std::path::Path;

use serde_json::{Value, json};
use zonotope::numeric::dyadic::Dyadic;

use super::zonotope::Body;
use crate::input::error::{InputError, Place, Problem};
use batch::json::{rows_to_json, vector_to_json};
use batch::placement::{Placement, doubles, nearest};

/// A body as its file has it, with the pose that places it.
///
/// The image under a pose of doubles has coordinates that are sums of products, which doubles seldom hold. So a
/// question takes body and pose as they are, and is answered for the exact image; what needs coordinates in doubles
/// takes the rounded image.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The body before it is placed.
    pub body: Body,
    /// The placement, if there is one.
    pub pose: Option<Placement>,
}

/// A placed body in exact numbers.
#[derive(Debug, Clone)]
pub struct ExactBody {
    /// The centre.
    pub center: Vec<Dyadic>,
    /// The generators.
    pub generators: Vec<Vec<Dyadic>>,
}

/// A placed body in doubles.
#[derive(Debug, Clone, PartialEq)]
pub struct RoundedBody {
    /// The body whose centre and generators are the nearest vectors of doubles.
    pub body: Body,
    /// The distance that a point of it may be from the exact image, and the other way round; 0 where they are equal.
    pub off: f64,
}

impl Placed {
    /// The number of coordinates.
    pub fn dimension(&self) -> usize {
        self.body.center.len()
    }

    /// The zonotope as a question has it.
    pub fn question(&self) -> Value {
        let Body { center, generators, .. } = &self.body;
        let mut zonotope = json!({"center": vector_to_json(center), "generators": rows_to_json(generators)});
        if let Some(pose) = &self.pose {
            zonotope["pose"] = pose.to_json();
        }
        zonotope
    }

    /// The exact image.
    pub fn exact(&self) -> ExactBody {
        let Body { center, generators, .. } = &self.body;
        let exact = |v: &[f64]| -> Vec<Dyadic> { v.iter().map(|&x| Dyadic::from_f64(x)).collect() };
        match self.pose.as_ref().map(Placement::exact) {
            None => ExactBody { center: exact(center), generators: generators.iter().map(|g| exact(g)).collect() },
            Some(pose) => ExactBody {
                center: pose.point(center),
                generators: generators.iter().map(|generator| pose.vector(generator)).collect(),
            },
        }
    }

    /// The image in doubles; an error where it leaves their range.
    pub fn rounded(&self, file: &Path) -> Result<RoundedBody, InputError> {
        if self.pose.is_none() {
            return Ok(RoundedBody { body: self.body.clone(), off: 0.0 });
        }
        let ExactBody { center, generators } = self.exact();
        let mut off = Dyadic::zero();
        let mut round = |exact: &Vec<Dyadic>| -> Result<Vec<f64>, InputError> {
            let rounded = nearest(exact);
            if !rounded.iter().all(|x| x.is_finite()) {
                let problem = Problem::Shape("the pose puts the body beyond the range of doubles".to_owned());
                return Err(problem.at(file, Place::Path("pose".to_owned())));
            }
            for (x, exact) in rounded.iter().zip(exact) {
                off = &off + &(&Dyadic::from_f64(*x) - exact).abs();
            }
            Ok(rounded)
        };
        let center = round(&center)?;
        let generators = generators.iter().map(round).collect::<Result<_, _>>()?;
        let body = Body { center, generators, is_rounded: self.body.is_rounded };
        // Above the sum of all that was rounded off, as the conversion is off by less than a part in 10^12.
        let off = if off.is_zero() { 0.0 } else { (off.to_f64() * (1.0 + 1e-12)).next_up() };
        Ok(RoundedBody { body, off })
    }

    /// The centre, and whether doubles hold it.
    pub fn center(&self) -> (Vec<f64>, bool) {
        let center = match &self.pose {
            None => return (self.body.center.clone(), true),
            Some(pose) => pose.exact().point(&self.body.center),
        };
        (nearest(&center), doubles(&center).is_some())
    }

    /// The largest reach of the image from its centre along an axis, as the nearest generators tell.
    pub fn reach(&self) -> f64 {
        match &self.pose {
            None => self.body.reach(),
            Some(_) => {
                let generators = self.exact().generators.iter().map(|generator| nearest(generator)).collect();
                Body { center: self.body.center.clone(), generators, is_rounded: true }.reach()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(matrix: [[f64; 2]; 2], translation: [f64; 2]) -> Placed {
        let body = Body { center: vec![1.0, 2.0], generators: vec![vec![0.5, 0.0], vec![0.1, 3.0]], is_rounded: false };
        let pose = Placement::new(matrix.map(|row| row.to_vec()).to_vec(), translation.to_vec());
        Placed { body, pose: Some(pose.expect("finite")) }
    }

    #[test]
    fn an_image_that_doubles_hold_is_not_off() {
        let quarter = placed([[0.0, -1.0], [1.0, 0.0]], [10.0, 0.0]);
        let RoundedBody { body, off } = quarter.rounded(Path::new("z.json")).expect("in range");
        assert_eq!((body.center, body.generators), (vec![8.0, 1.0], vec![vec![0.0, 0.5], vec![-3.0, 0.1]]));
        assert_eq!((off, quarter.center()), (0.0, (vec![8.0, 1.0], true)));
    }

    #[test]
    fn an_image_that_doubles_do_not_hold_says_how_far_it_is_off() {
        let file = Path::new("z.json");
        let third = placed([[1.0, 0.0], [0.0, 1.0 / 3.0]], [0.1, 0.0]);
        let RoundedBody { body, off } = third.rounded(file).expect("in range");
        assert_eq!(body.center[0], 1.1);
        assert!(off > 0.0 && off < 1e-15, "{off:?}");
        assert!(!third.center().1);
        let beyond = placed([[f64::MAX, 0.0], [0.0, 1.0]], [f64::MAX, 0.0]);
        let refused = beyond.rounded(file).expect_err("beyond the range").to_string();
        assert_eq!(refused, "z.json: pose: the pose puts the body beyond the range of doubles");
    }
}
