//! Facets that the library names by two generators, among those of the definition.

use dashu_ratio::RBig;
use zonotope::arrangement::facet_walk::FacetName;

use crate::definitions::space::{Body, Facet, Vector};

/// The facet of the definition that a name stands for.
pub(crate) fn named_facet<'f>(facets: &'f [Facet], body: &Body, name: FacetName) -> Option<&'f Facet> {
    let [a, b] = [name.first, name.second].map(|index| body.generators.get(index));
    let normal = a?.cross(b?);
    let outward = if name.normal.sign() < 0 { normal.to(&Vector::at([0; 3])) } else { normal };
    facets.iter().find(|facet| facet.normal.cross(&outward).is_zero() && facet.normal.dot(&outward) > RBig::ZERO)
}

/// The facets that share an edge, two corners, with a facet.
pub(crate) fn neighbours_of<'f>(facets: &'f [Facet], facet: &Facet) -> Vec<&'f Facet> {
    let shared = |other: &Facet| other.corners.iter().filter(|corner| facet.corners.contains(corner)).count();
    facets.iter().filter(|other| other.normal != facet.normal && shared(other) == 2).collect()
}
