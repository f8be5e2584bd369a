//! Questions of the batch and the check of their answers.

use pyo3::prelude::*;

use crate::border::outside;

/// The answer to a line of the batch, as a line.
#[pyfunction]
pub(crate) fn solve(py: Python<'_>, question: String) -> PyResult<String> {
    outside(py, || batch::answer(&question))
}

/// The verdict of the crate `verifier` on an answer: its word and the reason.
#[pyfunction]
pub(crate) fn verify(py: Python<'_>, question: String, answer: String) -> PyResult<(&'static str, String)> {
    outside(py, || match batch::verify(&question, &answer) {
        batch::Verdict::Right(reason) => ("right", reason),
        batch::Verdict::Wrong(reason) => ("wrong", reason),
        batch::Verdict::Unchecked(reason) => ("unchecked", reason),
    })
}
