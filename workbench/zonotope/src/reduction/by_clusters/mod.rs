//! Stub.
use super::answer::{Problem, Reduced, ReductionError};
use super::keeping::by_girard::girard;

/// Stub.
///
/// # Errors
/// As Girard.
pub fn clusters<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    girard(problem)
}
