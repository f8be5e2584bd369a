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
mod widened;

use super::bisectors::Frame;
use super::centered_zonogon::CenteredZonogon;
use super::half_turn::HalfTurn;

pub(crate) use exact::round_outward as round_outward_exactly;
pub(crate) use widened::Outward;

/// Z(O) rounded outward, for the centre and the sides of a walk around it. O(h).
pub(crate) fn round_outward(half_turn: &HalfTurn, frame: &Frame) -> Outward {
    streaming::round_outward(half_turn, frame)
        .unwrap_or_else(|| round_outward_exactly(&CenteredZonogon::of(half_turn), frame))
}
