//! A move or a turn as it is written on the command line.

use std::f64::consts::FRAC_1_SQRT_2;
use std::str::FromStr;

use anyhow::{bail, ensure};

use crate::input::OptionNames;
use batch::placement::Placement;

/// The numbers by which a body is moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Shift(Vec<f64>);

impl FromStr for Shift {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        numbers(text).map(Self).ok_or_else(|| "a move is finite numbers with commas between".to_owned())
    }
}

impl Shift {
    /// The placement that moves a body of the dimension.
    pub(super) fn placement(&self, dimension: usize, option: &str) -> anyhow::Result<Placement> {
        let found = self.0.len();
        ensure!(found == dimension, "{option}: {found} numbers for a body with {dimension} coordinates");
        let matrix = Placement::identity(dimension).matrix().to_vec();
        Ok(Placement::new(matrix, self.0.clone()).expect("the numbers are finite and counted"))
    }
}

/// An axis through the origin, none in the plane, and an angle in degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn {
    axis: Option<[f64; 3]>,
    degrees: f64,
}

impl FromStr for Turn {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "a turn is an axis, x, y, z or three numbers, and degrees: z,30 or 1,1,0,30; in the plane 30";
        let named = text.split_once(',').and_then(|(name, rest)| {
            let axis = ["x", "y", "z"].iter().position(|axis| name.trim().eq_ignore_ascii_case(axis))?;
            Some((std::array::from_fn(|other| f64::from(u8::from(other == axis))), rest))
        });
        let (axis, rest) = named.map_or((None, text), |(axis, rest)| (Some(axis), rest));
        let turn = match (axis, numbers(rest).as_deref()) {
            (axis, Some(&[degrees])) => Self { axis, degrees },
            (None, Some(&[x, y, z, degrees])) => Self { axis: Some([x, y, z]), degrees },
            _ => return Err(wrong().to_owned()),
        };
        match turn.axis {
            Some([0.0, 0.0, 0.0]) => Err("the axis of a turn is not zero".to_owned()),
            _ => Ok(turn),
        }
    }
}

impl Turn {
    /// The placement that turns a body of the dimension: a rotation but for the rounding of its entries, exact for
    /// quarter turns about the axes of the coordinates.
    pub(super) fn placement(&self, dimension: usize, options: OptionNames) -> anyhow::Result<Placement> {
        let OptionNames { turn, pose, .. } = options;
        let (sin, cos) = sine_and_cosine(self.degrees);
        let matrix = match (dimension, self.axis) {
            (2, None | Some([0.0, 0.0, 1.0])) => vec![vec![cos, -sin], vec![sin, cos]],
            (2, Some(_)) => bail!("{turn}: in the plane a turn is about no axis: give the degrees alone"),
            (3, None) => bail!("{turn}: in space a turn is about an axis: z,30 or 1,1,0,30"),
            (3, Some(axis)) => about(unit(axis), sin, cos),
            (other, _) => bail!("{turn}: a body with {other} coordinates is turned by {pose}"),
        };
        // A sum with 0 makes a negative zero a zero.
        let matrix = matrix.into_iter().map(|row| row.into_iter().map(|entry| entry + 0.0).collect()).collect();
        Ok(Placement::new(matrix, vec![0.0; dimension]).expect("sines and cosines are finite"))
    }
}

/// The matrix of the turn about a unit vector u: cos I + (1 − cos) u uᵀ + sin [u]×.
fn about(u: [f64; 3], sin: f64, cos: f64) -> Vec<Vec<f64>> {
    let [x, y, z] = u;
    let across = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let entry = |i: usize, j: usize| if i == j { cos + (1.0 - cos) * u[i] * u[i] } else { (1.0 - cos) * u[i] * u[j] };
    (0..3).map(|i| (0..3).map(|j| entry(i, j) + sin * across[i][j]).collect()).collect()
}

/// The vector divided by its length; it is not zero.
fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let scaled = v.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    scaled.map(|x| x / length)
}

/// A degree in radians, as the sum of two doubles.
const RADIANS: [f64; 2] = [0.017453292519943295, 2.9486522708701687e-19];

/// Sine and cosine of an angle in degrees: exact for multiples of 90, the sine of 30 degrees is a half, and
/// sine and cosine of 45 degrees are one number.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round();
    // For angles so large that their quarters are not counted exactly, the remainder of full turns is exact.
    let (quarters, rest) = if quarters.abs() < 1e9 {
        (quarters, degrees - 90.0 * quarters)
    } else {
        let within = degrees % 360.0;
        ((within / 90.0).round(), within - 90.0 * (within / 90.0).round())
    };
    let [radians, missing] = in_radians(rest);
    let (sin, cos) = (libm::sin(radians), libm::cos(radians));
    let (sin, cos) = if rest.abs() == 45.0 {
        (FRAC_1_SQRT_2.copysign(rest), FRAC_1_SQRT_2)
    } else {
        (sin + missing * cos, cos - missing * sin)
    };
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// An angle in degrees as the sum of two numbers of radians, the first the product rounded once.
fn in_radians(degrees: f64) -> [f64; 2] {
    let radians = degrees * RADIANS[0];
    [radians, libm::fma(degrees, RADIANS[0], -radians) + degrees * RADIANS[1]]
}

/// An angle in degrees in radians, rounded to nearest but for what doubles of two numbers do not hold.
pub(in crate::commands) fn radians_of(degrees: f64) -> f64 {
    let [radians, missing] = in_radians(degrees);
    radians + missing
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    let number = |cell: &str| cell.trim().parse().ok().filter(|number: &f64| number.is_finite());
    text.split(',').map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(turn: &str, dimension: usize) -> Vec<Vec<f64>> {
        let turn: Turn = turn.parse().expect("a turn");
        turn.placement(dimension, OptionNames::OF_FIRST).expect("a turn of this dimension").matrix().to_vec()
    }

    #[test]
    fn quarter_turns_are_exact() {
        let quarter = vec![vec![0.0, -1.0, 0.0], vec![1.0, 0.0, 0.0], vec![0.0, 0.0, 1.0]];
        for turn in ["z,90", "Z, -270", "0,0,5,90", "0,0,-1,-90", "z,360000000000090"] {
            assert_eq!(matrix(turn, 3), quarter, "{turn}");
        }
        assert_eq!(matrix("90", 2), [[0.0, -1.0], [1.0, 0.0]]);
        assert_eq!(matrix("z,180", 2), [[-1.0, 0.0], [0.0, -1.0]]);
        assert_eq!(matrix("x,90", 3), [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        let root = 0.5_f64.sqrt();
        assert_eq!(matrix("45", 2), [[root, -root], [root, root]]);
        assert_eq!((matrix("30", 2)[1][0], matrix("60", 2)[0][0]), (0.5, 0.5));
        assert_eq!(matrix("y,90", 3), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
    }

    #[test]
    fn other_turns_are_rotations_but_for_rounding() {
        for turn in ["1,2,3,17", "1e-300,1e-300,0,123.456", "x,-89.99", "0,1,1,1e15", "z,30"] {
            let rows = matrix(turn, 3);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            for (i, j) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)] {
                let off = dot(&rows[i], &rows[j]) - f64::from(u8::from(i == j));
                assert!(off.abs() < 1e-15, "{turn}: {off}");
            }
        }
    }

    #[test]
    fn degrees_are_radians_to_the_last_place() {
        use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI, TAU};
        assert_eq!([30.0, 90.0, 180.0, -360.0].map(radians_of), [FRAC_PI_6, FRAC_PI_2, PI, -TAU]);
        assert_eq!(radians_of(1e-3), 1.7453292519943296e-5);
    }

    #[test]
    fn what_is_no_motion_is_refused() {
        for wrong in ["", "z", "30,x", "1,2,30", "w,30", "z,1,2", "0,0,0,30", "z,inf"] {
            assert!(wrong.parse::<Turn>().is_err(), "{wrong}");
        }
        for wrong in ["", "1,,2", "1;2", "nan,0"] {
            assert!(wrong.parse::<Shift>().is_err(), "{wrong}");
        }
        let refused = |turn: &str, dimension| {
            let turn: Turn = turn.parse().expect("a turn");
            turn.placement(dimension, OptionNames::OF_SECOND).expect_err("not of this dimension").to_string()
        };
        assert!(refused("30", 3).contains("about an axis") && refused("x,30", 2).contains("no axis"));
        assert!(refused("z,30", 4).contains("--turn-b: a body with 4 coordinates is turned by --pose-b"));
        let shift: Shift = "1,2".parse().expect("numbers");
        let refused = shift.placement(3, OptionNames::OF_SECOND.shift).expect_err("not of this dimension").to_string();
        assert_eq!(refused, "--move-b: 2 numbers for a body with 3 coordinates");
    }
}
