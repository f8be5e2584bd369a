//! The structure that was chosen, asked as any of them.

use thiserror::Error;

use super::costs::{Kind, Plan, plans, rows};
use crate::collision::prepared::by_cutting::{PreparationError, PreparedByCutting};
use crate::collision::prepared::by_direction_tree::DirectionTree;
use crate::collision::prepared::by_facets::PreparedByFacets;
use crate::collision::{Location, Query, Status, by_lad};
use crate::numeric::non_finite::NonFinite;
use crate::seed::DEFAULT_SEED;
use crate::zonotope::{PreparedBody, Zonotope};

/// A body of space in the structure that suits the memory and the number of queries.
#[derive(Debug)]
pub struct QueryStructure {
    kind: Kind,
    held: Held,
}

/// The structures by kind; those that are large in themselves behind a pointer.
#[derive(Debug)]
enum Held {
    Rows(Zonotope<3>),
    Blocks(PreparedBody),
    DirectionTree(Box<DirectionTree>),
    Cutting(Box<PreparedByCutting>),
    Facets(PreparedByFacets),
}

/// Why there is no structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ChoiceError {
    /// The memory does not hold the body itself.
    #[error("{budget} bytes are less than the {needed} of the body alone")]
    TooLittleMemory {
        /// The bytes that were allowed.
        budget: u64,
        /// The bytes that the body takes.
        needed: u64,
    },
    /// The space of a cutting is not one that the body can be prepared with.
    #[error(transparent)]
    Cutting(#[from] PreparationError),
}

impl QueryStructure {
    /// The structure of the least cost, by [`plans`], that holds at most `budget` bytes, for about so many queries.
    ///
    /// Where a structure turns out to hold more than its plan says, the next one is taken; the bytes that are needed
    /// while it is built are not counted.
    ///
    /// # Errors
    /// [`ChoiceError::TooLittleMemory`] if the body alone takes more.
    pub fn new(body: Zonotope<3>, budget: u64, queries: u64) -> Result<Self, ChoiceError> {
        let n = body.generators().len() as u64;
        for Plan { kind, .. } in plans(n, budget, queries) {
            let structure = Self::of_kind(body.clone(), kind)?;
            if structure.bytes() <= budget {
                return Ok(structure);
            }
        }
        Err(ChoiceError::TooLittleMemory { budget, needed: rows(n).bytes })
    }

    /// The structure of a kind.
    ///
    /// # Errors
    /// [`ChoiceError::Cutting`] if a cutting's space is not between n and n².
    pub fn of_kind(body: Zonotope<3>, kind: Kind) -> Result<Self, ChoiceError> {
        let held = match kind {
            Kind::Rows => Held::Rows(body),
            Kind::Blocks => Held::Blocks(PreparedBody::new(body)),
            Kind::DirectionTree => Held::DirectionTree(Box::new(DirectionTree::new(&body))),
            Kind::Cutting { space } => {
                Held::Cutting(Box::new(PreparedByCutting::new(body, space, DEFAULT_SEED, &mut ())?))
            }
            Kind::Facets => Held::Facets(PreparedByFacets::new(body)),
        };
        Ok(Self { kind, held })
    }

    /// Which structure it is.
    pub fn which(&self) -> Kind {
        self.kind
    }

    /// The body in blocks, if that is the structure.
    pub(in crate::collision) fn blocks(&self) -> Option<&PreparedBody> {
        if let Held::Blocks(body) = &self.held { Some(body) } else { None }
    }

    /// The tree, if that is the structure.
    pub(in crate::collision) fn tree(&self) -> Option<&DirectionTree> {
        if let Held::DirectionTree(tree) = &self.held { Some(tree) } else { None }
    }

    /// The bytes that it holds, the generators included.
    pub fn bytes(&self) -> u64 {
        match &self.held {
            Held::Rows(body) => rows(body.generators().len() as u64).bytes,
            Held::Blocks(body) => body.bytes() as u64,
            Held::DirectionTree(tree) => (size_of::<DirectionTree>() + tree.bytes()) as u64,
            Held::Cutting(cutting) => {
                let own = size_of::<PreparedByCutting>() + size_of_val(cutting.body().generators());
                own as u64 + cutting.bytes()
            }
            Held::Facets(facets) => facets.bytes() as u64,
        }
    }

    /// Whether a point lies in the closed body, exactly.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(self.status(point)?.is_member())
    }

    /// Where a point lies, exactly and without a proof.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn status(&self, point: [f64; 3]) -> Result<Status, NonFinite> {
        match &self.held {
            Held::DirectionTree(tree) => Ok(tree.locate(point, &mut ())?.status()),
            Held::Cutting(cutting) => Ok(cutting.facet(point, &mut ())?.status()),
            Held::Facets(facets) => facets.status(point),
            Held::Rows(_) | Held::Blocks(_) => Ok(self.locate(point)?.status()),
        }
    }

    /// How many times the body must be taken, from its centre, to hold a point, and a bound on the error of that.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<(f64, f64), NonFinite> {
        match &self.held {
            Held::Rows(body) => Ok(by_lad::facet(&Query::of_point(point, body)?, &mut ()).value()),
            Held::Blocks(body) => Ok(by_lad::facet(&Query::of_point_in(point, body.placed())?, &mut ()).value()),
            Held::DirectionTree(tree) => tree.gauge(point, &mut ()).map(|measured| (measured.value, measured.error)),
            Held::Cutting(cutting) => Ok(cutting.facet(point, &mut ())?.value()),
            Held::Facets(facets) => facets.gauge(point),
        }
    }

    /// Where a point lies, with a proof in coefficients of the body's generators, or a separating direction. Whatever
    /// the structure, O(n) for a member.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Location<3>, NonFinite> {
        match &self.held {
            Held::Rows(body) => Ok(by_lad::locate(&Query::of_point(point, body)?, &mut ())),
            Held::Blocks(body) => Ok(by_lad::locate(&Query::of_point_in(point, body.placed())?, &mut ())),
            Held::DirectionTree(tree) => Ok(tree.locate(point, &mut ())?.expand()),
            Held::Cutting(cutting) => Ok(cutting.facet(point, &mut ())?.location()),
            Held::Facets(facets) => Ok(by_lad::locate(&Query::of_point(point, facets.body())?, &mut ())),
        }
    }
}
