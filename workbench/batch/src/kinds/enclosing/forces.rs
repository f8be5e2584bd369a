//! The forces of a certificate, read for the check.

use crate::claimed::{Traced, index, member};

/// Points and their multipliers, vectors that the batch interface calls forces.
pub(super) fn forces<T>(
    certificate: Traced<'_>,
    read: impl Fn(Traced<'_>) -> Option<T>,
) -> Result<Vec<(usize, T)>, String> {
    let list = member(certificate, "forces")?.elements().ok_or("`forces` is not a list")?;
    let force = |tree: Traced<'_>| {
        let vector = read(member(tree, "vector")?).ok_or("`vector` of a force holds something else than numbers")?;
        Ok((index(tree, "point")?, vector))
    };
    list.map(force).collect()
}
