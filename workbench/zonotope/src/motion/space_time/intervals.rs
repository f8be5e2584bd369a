//! A chain of volumes, one for each part of the angle: the more parts, the less lies between them and the sweep.

use super::parts::angle::{cosine_and_sine, covering};
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::volume::Volume;
use super::{Method, Sweep, SweepError};
use crate::zonotope::Zonotope;

/// Volumes that contain all placements together: the angle is cut into equal parts, and each part has its volume by a
/// method. At least one.
///
/// # Errors
/// [`SweepError::OutOfRange`] if a volume leaves the range of doubles.
pub fn volumes_of_intervals(
    sweep: &Sweep,
    body: &Zonotope<3>,
    count: u32,
    method: Method,
) -> Result<Vec<Zonotope<3>>, SweepError> {
    let angle = covering(sweep.angle);
    if count <= 1 || angle == 0.0 {
        return Ok(vec![method.volume(sweep, body)?]);
    }
    let start = |i: u32| if i == count { angle } else { angle * (f64::from(i) / f64::from(count)) };
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let at_rest = Sweep { translation: [0.0; 3], ..*sweep };
    (0..count)
        .map(|i| {
            // the difference is rounded, so that the part ends beyond the begin of the next one
            let part = Sweep { angle: (start(i + 1) - start(i)).next_up(), ..*sweep };
            if i == 0 {
                return method.volume(&part, body);
            }
            let turned = Volume::of_turned_body(&scaled, &plane, &cosine_and_sine(start(i)), &at_rest).finished()?;
            method.volume(&part, &turned)
        })
        .collect()
}
