//! The allowances of a guess: the band of lines whose kinks are rounded off, and the size of the cell.

use super::sample::Sample;

/// The error that a guess is to allow for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Aim {
    /// The number of lines in a band that is thin enough if the minimum hardly moved when the band became so thin;
    /// `thinnest` is the number of lines in the thinnest band.
    pub(crate) thickness: f64,
    pub(crate) thinnest: f64,
    /// The number of lines for which the lines at hand stand.
    pub(crate) population: usize,
    /// Lines of generators longer than this stand for themselves alone.
    pub(crate) longest: f64,
    /// The standard deviations of the gradient that a cell allows for: of the part that lines of the band and lines
    /// outside the sample contribute.
    pub(crate) deviations: f64,
}

/// The least number of lines in the thinnest band.
const THINNEST_BAND_LINES: f64 = 10.0;

/// The part of all lines that a band holds when it is thin enough.
const BAND_SHARE: f64 = 0.16;

/// The size of the cell of a sample, in standard deviations of the gradient of the lines that are not in the sample.
pub(crate) const SAMPLE_DEVIATIONS: f64 = 2.7;

impl Aim {
    /// The error that a guess from some lines is to allow for.
    pub(crate) fn new(len: usize, population: usize, deviations: f64) -> Self {
        let thinnest = THINNEST_BAND_LINES.max((len as f64).sqrt());
        let thickness = thinnest.max(BAND_SHARE * len as f64);
        Self { thickness, thinnest, population, longest: f64::INFINITY, deviations }
    }

    /// [`Aim::new`] for a sample of a population of generators, with a thin band if the lengths are uneven.
    pub(crate) fn of_sample(sample: &Sample, population: usize) -> Self {
        let aim = Self { longest: sample.longest, ..Self::new(sample.vectors.len(), population, SAMPLE_DEVIATIONS) };
        if sample.longest < f64::INFINITY { aim.thin() } else { aim }
    }

    /// The aim with a band as thin as can be: where generators are uneven, a wide band hides what is in it.
    pub(crate) fn thin(self) -> Self {
        Self { thickness: self.thinnest, ..self }
    }
}
