//! Directions by name: the axes, the corners of a net of cells, or the rows of a file.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context, bail};
use batch::nearest;
use zonotope::enclosing::min_total_length::direction_net::cell_corners;

use crate::input::{Format, PointSource, Wanted};

/// The source of directions.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Directions {
    /// The unit vectors of the coordinate axes.
    Axes,
    /// The corners of so many cells along each side of the faces of a cube.
    Net(usize),
    /// The rows of a file.
    File(PathBuf),
    /// The vectors themselves, as an answer records them.
    Vectors(Vec<Vec<f64>>),
}

/// The largest number of directions that a net may have, and of cells along a side.
const NET_LIMIT: usize = 1000;

impl FromStr for Directions {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "axes" {
            return Ok(Self::Axes);
        }
        let Some(cells) = text.strip_prefix("net:") else {
            return misspelt(text).map_or_else(|| Ok(Self::File(PathBuf::from(text))), Err);
        };
        match cells.parse() {
            Ok(cells) if (1..=NET_LIMIT).contains(&cells) => Ok(Self::Net(cells)),
            _ => Err(format!("a net has 1 to {NET_LIMIT} cells a side, as `net:2`")),
        }
    }
}

/// The complaint about a text that is nearly `axes` or a net and that no file is named.
fn misspelt(text: &str) -> Option<String> {
    if Path::new(text).exists() {
        return None;
    }
    let near = match text.split_once(':') {
        Some((name, cells)) => nearest(name, ["net"]).map(|net| format!("{net}:{cells}")),
        None => nearest(text, ["axes", "net"]).map(|name| name.replace("net", "net:2")),
    };
    near.map(|near| format!("there is no such file; did you mean `{near}`?"))
}

impl Directions {
    /// The file of the directions, if they come from one.
    pub(super) fn file(&self) -> Option<&Path> {
        if let Self::File(file) = self { Some(file) } else { None }
    }

    /// The directions for points with so many coordinates.
    pub(super) fn vectors(&self, dimension: usize) -> anyhow::Result<Vec<Vec<f64>>> {
        self.read(dimension).map(|(vectors, _)| vectors)
    }

    /// The directions for points with so many coordinates, with what is to be told of their file.
    pub(super) fn read(&self, dimension: usize) -> anyhow::Result<(Vec<Vec<f64>>, Option<String>)> {
        let vectors = match self {
            Self::Axes => axes(dimension),
            Self::Net(cells) => net(*cells, dimension)?,
            Self::Vectors(vectors) => match vectors.iter().find(|vector| vector.len() != dimension) {
                Some(vector) => bail!("directions with {} coordinates for points with {dimension}", vector.len()),
                None => vectors.clone(),
            },
            Self::File(file) => {
                if Format::of_extension(file).is_none() && file.is_file() {
                    let advice = "the name alone tells the format of directions; name the file .csv, .json or .npy";
                    bail!("--directions: {}: {advice}", file.display());
                }
                let reading = PointSource::of_file(file.clone()).read(Wanted::Any).context("--directions")?;
                let found = reading.points.dimension();
                if found != dimension {
                    bail!("{}: directions with {found} coordinates for points with {dimension}", file.display());
                }
                let remarks: Vec<String> = reading.remarks().into_iter().chain(reading.losses.clone()).collect();
                let remarks = (!remarks.is_empty()).then(|| format!("{}: {}", file.display(), remarks.join("; ")));
                return Ok((reading.points.rows().map(<[f64]>::to_vec).collect(), remarks));
            }
        };
        Ok((vectors, None))
    }
}

fn axes(dimension: usize) -> Vec<Vec<f64>> {
    let unit = |axis: usize| (0..dimension).map(|other| f64::from(u8::from(other == axis))).collect();
    (0..dimension).map(unit).collect()
}

fn net(cells: usize, dimension: usize) -> anyhow::Result<Vec<Vec<f64>>> {
    let faces = dimension.saturating_mul((cells + 1).saturating_pow(dimension as u32 - 1));
    if faces > 4 * NET_LIMIT {
        bail!("--directions net:{cells}: more than {NET_LIMIT} directions in {dimension} dimensions");
    }
    Ok(match dimension {
        1 => axes(1),
        2 => cell_corners::<2>(cells).iter().map(|v| v.to_vec()).collect(),
        3 => cell_corners::<3>(cells).iter().map(|v| v.to_vec()).collect(),
        _ => cell_corners::<4>(cells).iter().map(|v| v.to_vec()).collect(),
    })
}

/// The Euclidean length: what a unit of a direction costs if the total length is to be least.
pub(super) fn length(v: &[f64]) -> f64 {
    let largest = v.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    largest * v.iter().map(|x| (x / largest) * (x / largest)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_by_name() {
        assert_eq!("axes".parse(), Ok(Directions::Axes));
        assert_eq!("net:3".parse(), Ok(Directions::Net(3)));
        assert_eq!("a.csv".parse(), Ok(Directions::File("a.csv".into())));
        for wrong in ["net:", "net:0", "net:x", "net:1001"] {
            assert!(wrong.parse::<Directions>().is_err(), "{wrong}");
        }
        for (wrong, near) in
            [("nett:2", "net:2"), ("NET:3", "net:3"), ("axis", "axes"), ("Axes", "axes"), ("net", "net:2")]
        {
            let complaint = wrong.parse::<Directions>().expect_err("a name that is nearly another");
            assert_eq!(complaint, format!("there is no such file; did you mean `{near}`?"), "{wrong}");
        }
        assert_eq!("c:directions.csv".parse(), Ok(Directions::File("c:directions.csv".into())));
    }

    #[test]
    fn nets_and_lengths() {
        assert_eq!([1, 2, 3].map(|cells| net(cells, 2).expect("small").len()), [2, 4, 6]);
        assert_eq!(net(1, 3).expect("small").len(), 4);
        assert!(net(100, 4).is_err());
        assert_eq!((length(&[3.0, 4.0]), length(&[0.0]), length(&[1e300, 0.0])), (5.0, 0.0, 1e300));
    }
}
