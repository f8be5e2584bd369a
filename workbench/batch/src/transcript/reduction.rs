//! Bodies around bodies, and how far apart they are at most.

use super::Verdict;
use super::placed::Placed;
use super::reading::{boolean, float, index, indices, member, vector, vectors};
use super::traced::Traced;
use crate::json::Tree;
use verifier::{HausdorffAnswer, Reduction, ReductionAnswer, Shares, check_hausdorff, check_reduction};

pub(super) fn reduce(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let (center, generators) = Placed::read(input, "center")?.image()?;
    let question = Reduction { center, generators, count: Some(index(input, "count")?), epsilon: None };
    checked(&question, result)
}

pub(super) fn approx(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let center = vec![0.0; generators.first().map_or(3, Vec::len)];
    checked(&Reduction { center, generators, count: None, epsilon: Some(float(input, "epsilon")?) }, result)
}

fn checked(question: &Reduction, result: Traced<'_>) -> Result<Verdict, String> {
    let (certificate, distance) = (member(result, "certificate")?, member(result, "hausdorff")?);
    let answer = ReductionAnswer {
        center: vector(member(result, "center")?, "center")?,
        generators: vectors(member(result, "generators")?, "generators")?,
        bounds: [float(distance, "lower")?, float(distance, "upper")?],
        direction: vector(member(distance, "direction")?, "direction")?,
        shares: proof(certificate)?,
    };
    Ok(check_reduction(question, &answer))
}

/// The shares, or nothing where every facet normal is to be tried: the certificate says which of them.
fn proof(certificate: Traced<'_>) -> Result<Option<Shares>, String> {
    if let Some(list) = certificate.field("shares") {
        return shares(list, certificate).map(Some);
    }
    match certificate.field("facet_normals").map(|_| boolean(certificate, "facet_normals")).transpose()? {
        Some(true) => Ok(None),
        Some(false) | None => Err("certificate: there are neither `shares` nor `facet_normals`".to_owned()),
    }
}

fn shares(list: Traced<'_>, certificate: Traced<'_>) -> Result<Shares, String> {
    let share = |tree: &Tree| match (tree, tree.list()) {
        (Tree::Null, _) => Ok(None),
        (_, Some([generator, coefficient])) => match (generator.index(), coefficient.float()) {
            (Some(generator), Some(coefficient)) => Ok(Some((generator, coefficient))),
            _ => Err("a share is no index with a coefficient".to_owned()),
        },
        _ => Err("a share is neither a pair nor null".to_owned()),
    };
    let list = list.tree.list().ok_or("`shares` is not a list")?;
    Ok(Shares { shares: list.iter().map(share).collect::<Result<_, _>>()?, frame: indices(certificate, "frame")? })
}

pub(super) fn hausdorff(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let body = |name| Placed::read(member(input, name)?, "center")?.image();
    let (a, b) = (body("a")?, body("b")?);
    let answer = HausdorffAnswer {
        value: float(result, "value")?,
        bounds: [float(result, "lower")?, float(result, "upper")?],
        direction: vector(member(result, "direction")?, "direction")?,
        is_subset: boolean(result, "a_subset_b")?,
    };
    Ok(check_hausdorff((&a.0, &a.1), (&b.0, &b.1), &answer))
}
