//! The bodies of a question and what is known of their motions before a direction is chosen.
//!
//! | file | content |
//! |---|---|
//! | `body` | a body as the methods read it: its generators, its centre, its reach along several directions at once |
//! | `rates` | bounds of the speed and of the bend of a body's motion along a direction |
//! | `margin` | the distance by which a motion at constant rate may differ from its arcs |

pub(super) mod body;
pub(super) mod margin;
pub(super) mod rates;
