//! Proofs of a location by the facet that two generators span, whether or not the ray leaves the body there.
//!
//! | file | where it proves |
//! |---|---|
//! | [`in_doubles`] | away from the boundary; it hands over to the two others where doubles leave a doubt |
//! | [`in_pairs`] | near the boundary, in pairs of doubles |
//! | [`contact`] | on the facet, exactly; [`facet_plane`] has the generators in its plane |

mod contact;
mod facet_plane;
pub(crate) mod in_doubles;
mod in_pairs;
