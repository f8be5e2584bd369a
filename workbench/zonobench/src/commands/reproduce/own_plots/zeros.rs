//! Curves on logarithmic axes, where values of 0 have no place: what is not drawn is said.

use figures::axes::Curve;

/// Curves that have a place on logarithmic axes.
pub(super) struct Placed {
    pub(super) curves: Vec<Curve>,
    /// The number of points that each curve lost.
    lost: Vec<usize>,
    /// The curves that have no other value than 0, in words.
    all_zero: Vec<String>,
}

/// The most curves that a caption names.
const NAMED_LIMIT: usize = 4;

impl Placed {
    /// Leaves out the points at 0, the lines that would run through some of them, and curves without other points.
    pub(super) fn of(curves: Vec<Curve>) -> Self {
        let mut placed = Self { curves: Vec::new(), lost: Vec::new(), all_zero: Vec::new() };
        for mut curve in curves {
            let count = curve.points.len();
            curve.points.retain(|point| !is_zero(point));
            if curve.points.is_empty() {
                placed.all_zero.push(format!("{} on {}", curve.name, curve.notes.join(", ")));
                continue;
            }
            if curve.fit.iter().any(is_zero) {
                curve.fit.clear();
            }
            placed.lost.push(count - curve.points.len());
            placed.curves.push(curve);
        }
        placed
    }

    /// Parts that are not drawn, in sentences; nothing if all is.
    pub(super) fn left_out(&self) -> String {
        let mut text = String::new();
        let lost: usize = self.lost.iter().sum();
        if lost > 0 {
            let points = if lost == 1 { "1 point at 0 is".to_owned() } else { format!("{lost} points at 0 are") };
            text.push_str(&format!(
                " A logarithmic axis has no place for 0: {points} not drawn, and the legend counts them; curves with a \
                 middle at 0 are not joined."
            ));
        }
        if !self.all_zero.is_empty() {
            let mut names = self.all_zero[..self.all_zero.len().min(NAMED_LIMIT)].join("; ");
            let others = self.all_zero.len().saturating_sub(NAMED_LIMIT);
            if others > 0 {
                names.push_str(&format!("; and {others} more"));
            }
            text.push_str(&format!(" Always 0, and not drawn for that: {names}."));
        }
        text
    }

    /// The curves, those that lost points with a note of how many.
    pub(super) fn into_curves(self) -> Vec<Curve> {
        let noted = |(mut curve, lost): (Curve, usize)| {
            if lost > 0 {
                curve.notes.push(format!("{lost} of {} at 0", lost + curve.points.len()));
            }
            curve
        };
        self.curves.into_iter().zip(self.lost).map(noted).collect()
    }
}

fn is_zero(point: &[f64; 2]) -> bool {
    point[1] == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use figures::axes::Look;

    fn curve(name: &str, values: &[f64]) -> Curve {
        let points: Vec<[f64; 2]> = (1..).zip(values).map(|(n, &value)| [f64::from(n), value]).collect();
        let notes = vec!["disc".to_owned()];
        Curve { name: name.to_owned(), notes, fit: points.clone(), points, look: Look::of_series(0) }
    }

    #[test]
    fn what_has_no_place_is_said() {
        let whole = Placed::of(vec![curve("a", &[1.0, 2.0])]);
        assert_eq!((whole.left_out().as_str(), whole.into_curves()), ("", vec![curve("a", &[1.0, 2.0])]));
        let some = Placed::of(vec![curve("a", &[1.0, 2.0]), curve("b", &[0.0, 3.0, 0.0])]);
        assert!(some.left_out().contains(": 2 points at 0 are not drawn"), "{}", some.left_out());
        let curves = some.into_curves();
        assert_eq!(curves[0], curve("a", &[1.0, 2.0]));
        assert_eq!((&curves[1].points[..], curves[1].fit.len()), (&[[2.0, 3.0]][..], 0));
        assert_eq!(curves[1].notes, ["disc", "2 of 3 at 0"]);
    }

    #[test]
    fn curves_that_are_always_0_are_named() {
        let zeros: Vec<Curve> = ["a", "b", "c", "d", "e", "f"].map(|name| curve(name, &[0.0])).into();
        let none = Placed::of(zeros);
        let expected = " Always 0, and not drawn for that: a on disc; b on disc; c on disc; d on disc; and 2 more.";
        assert_eq!((none.left_out().as_str(), none.into_curves().len()), (expected, 0));
    }
}
