//! Names of facets and of their edges.

/// A facet of a zonotope, by two generators along it that are not parallel: [i, j, s] of the batch interface.
///
/// Every facet has one name: `first` is the least index of a generator along it, `second` the least one of a generator
/// that is not parallel to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FacetName {
    /// The index i of the first generator.
    pub first: usize,
    /// The index j of the second generator, above the first.
    pub second: usize,
    /// The sign s of the outward normal s · (v_i × v_j).
    pub normal: NormalSense,
}

/// Which way the outward normal of a facet points along the cross product of the generators of its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NormalSense {
    /// As the cross product does: s = 1.
    Along,
    /// As its opposite does: s = −1.
    Against,
}

/// An edge of a facet, directed as the boundary of the facet runs counter-clockwise seen from outside of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FacetEdge {
    /// The least index of a generator along the edge.
    pub generator: usize,
    /// Whether the edge is directed against this generator.
    pub is_reversed: bool,
}

impl FacetName {
    /// The facet [i, j, s].
    pub fn new(first: usize, second: usize, normal: NormalSense) -> Self {
        Self { first, second, normal }
    }

    /// The facet on the other side of the centre.
    pub fn opposite(self) -> Self {
        let normal = match self.normal {
            NormalSense::Along => NormalSense::Against,
            NormalSense::Against => NormalSense::Along,
        };
        Self { normal, ..self }
    }
}

impl NormalSense {
    /// The sense of a sign: 1 or −1, else `None`.
    pub fn from_sign(sign: i64) -> Option<Self> {
        match sign {
            1 => Some(Self::Along),
            -1 => Some(Self::Against),
            _ => None,
        }
    }

    /// 1 or −1.
    pub fn sign(self) -> i8 {
        match self {
            Self::Along => 1,
            Self::Against => -1,
        }
    }
}
