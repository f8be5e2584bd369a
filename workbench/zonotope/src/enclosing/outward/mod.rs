//! Z(O) in doubles: generators rounded so that their zonogon contains Z(O) and so every point, and bounds of both
//! areas.
//!
//! Let γ_k be the half-edges of Z(O). Each is replaced by a generator g_k with |γ_k − g_k| ≤ ε_k in each coordinate.
//! Then Σ [−1, 1] γ_k ⊂ Σ [−1, 1] g_k ⊕ box(Σ ε_k), where box(a) is the box with half-widths a. So with the box's two
//! generators added the zonogon contains Z(O). It lies itself in Z(O) ⊕ box(2 Σ ε_k), which bounds its area.
//!
//! Many edges in an ordinary range are rounded one by one during the walk around Z(O), with one bound for all errors
//! ([`streaming`]). Where that bound is not precise enough, or sums of coordinates leave the range of doubles, errors
//! and areas are computed exactly ([`exact`]).

mod areas;
mod exact;
mod streaming;

use super::bisectors::Frame;
use super::boundary_vertex::BoundaryVertex;
use super::centered_zonogon::CenteredZonogon;
use super::half_turn::HalfTurn;
use crate::numeric::outward::axis_generators;
use crate::zonotope::Zonotope;

pub(crate) use exact::round_outward as round_outward_exactly;

/// A zonogon in doubles that contains Z(O), with bounds of both areas.
#[derive(Debug)]
pub(crate) struct Outward {
    /// The zonogon that contains Z(O).
    pub(crate) zonogon: Zonotope<2>,
    /// A lower bound of the area of Z(O).
    pub(crate) area_below: f64,
    /// An upper bound of the area of the zonogon.
    pub(crate) area_above: f64,
}

/// Z(O) rounded outward, for the centre and the sides of a walk around it. O(h).
pub(crate) fn round_outward(half_turn: &HalfTurn, frame: &Frame) -> Outward {
    streaming::round_outward(half_turn, frame)
        .unwrap_or_else(|| round_outward_exactly(&CenteredZonogon::of(half_turn), frame))
}

/// The zonogon of rounded half-edges, widened by the sums of their errors.
fn widened(center: [f64; 2], mut generators: Vec<[f64; 2]>, slack: [f64; 2]) -> Zonotope<2> {
    generators.extend(axis_generators(slack));
    Zonotope::new(center, generators).expect("half-edges of finite points are finite")
}

/// The factor 1 for a vertex of the hull and −1 for a reflected one.
#[inline(always)]
fn sense(vertex: BoundaryVertex) -> f64 {
    1.0 - 2.0 * f64::from(u8::from(vertex.reflected))
}
