//! The lists of the families of motions.

use super::family::MotionFamily;
use super::{arms, around, crafted, fast, reported, spinning};

/// The scenes in which bodies pass each other at a clearance, in the order in which reports list them.
pub static SCENES: &[MotionFamily] = &[
    arms::LINKS,
    arms::TWO_TURNING_LINKS,
    spinning::BOTH_SPINNING,
    arms::SWING_180,
    arms::SWING_360,
    fast::THIN_BARS,
    around::ORBIT,
    around::RING,
    spinning::SPINNING_PRISM,
];

/// The families beside the scenes.
static OTHERS: &[MotionFamily] = &[fast::FAST_BOXES, crafted::CRAFTED, reported::PARRY_317, reported::RAPIER_JS_258];

/// The family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static MotionFamily> {
    SCENES.iter().chain(OTHERS).find(|family| family.id == id)
}
