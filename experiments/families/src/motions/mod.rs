//! Families of moving bodies: inputs of everything that is asked about motion.
//!
//! In each of the nine scenes two bodies move past each other, and the second one is moved aside, so that they come as
//! near each other as is asked for; in `fast_boxes` everything is drawn at random, so that some of the pairs
//! collide, and `crafted_motions` are drawn from short lists.
//!
//! | family | motion |
//! | --- | --- |
//! | `links` | a robot's link turns a quarter above a box |
//! | `two_turning_links` | two links turn about joints of their own, one above the other |
//! | `both_spinning` | two bodies spin about axes of their own |
//! | `swing_180` | a box on an arm swings half a turn past a cube |
//! | `swing_360` | the same for a whole turn |
//! | `thin_bars` | a thin bar passes another one while it turns |
//! | `orbit` | a box circles a prism |
//! | `ring` | a long link goes round a body, its side to it |
//! | `spinning_prism` | a prism of ten generators spins beside a plate, always as near |
//! | `fast_boxes` | random boxes, turning several times while they fly past each other |
//! | `crafted_motions` | what random draws miss: grazing, whole turns, thin bodies, axes through a body and far away |
//! | `parry_317`, `rapier_js_258` | collisions of public reports, which a library missed |

mod arms;
mod around;
mod catalog;
mod crafted;
mod family;
mod fast;
mod reported;
mod shapes;
mod spinning;

pub use catalog::{SCENES, find};
pub use family::{BodyRow, Course, MotionFamily, MovingPair};
