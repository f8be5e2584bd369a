//! Zonotopes as bodies of their own: how far they reach, how many faces they have.

use super::Verdict;
use super::placed::Placed;
use super::reading::{boolean, exact_numbers, float, fractions, index, indices, member, point, text, vector, vectors};
use super::traced::Traced;
use crate::json::Tree;
use verifier::{
    CombinatoricsAnswer, FacetTriple, Fraction, SupportAnswer, check_combinatorics, check_separator,
    check_slope_selection, check_support, check_upper_hull, check_walk,
};

pub(super) fn support(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let direction = vector(member(input, "direction")?, "direction")?;
    let body = Placed::read(input, "center")?;
    // A coordinate beyond the range of doubles is an infinity.
    let point = point(member(result, "point")?, "point")?;
    let answer = SupportAnswer { value: float(result, "value")?, point };
    Ok(check_support(&direction, &body.body(), &answer).in_words())
}

pub(super) fn slope_selection(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let ranks: Vec<u64> = indices(input, "k")?.into_iter().map(|rank| rank as u64).collect();
    Ok(check_slope_selection(&generators, &ranks, &fractions(result, "x")?).in_words())
}

pub(super) fn combinatorics(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let body = Placed::around_origin(input)?;
    let sizes = member(result, "facet_sizes")?.fields().ok_or("`facet_sizes` is not an object")?;
    // A size has one spelling, so that none comes twice.
    let size = |name: &str| name.parse::<usize>().ok().filter(|size| size.to_string() == name);
    let sizes = sizes.map(|(name, count)| Some((size(name)?, count.tree.index()? as u64)));
    let count = |name| index(result, name).map(|count| count as u64);
    let answer = CombinatoricsAnswer {
        affine_dim: index(result, "affine_dim")?,
        vertices: count("vertices")?,
        edges: count("edges")?,
        facets: count("facets")?,
        facet_sizes: sizes.collect::<Option<_>>().ok_or("`facet_sizes` holds something else than counts")?,
        measure: Fraction::parse(text(result, "measure")?).ok_or("`measure` is not an exact number")?,
    };
    Ok(check_combinatorics(&body.body(), &answer).in_words())
}

pub(super) fn separator(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let chain = member(result, "chain")?.elements().ok_or("`chain` is not a list")?;
    let point = |point: Traced<'_>| <[_; 2]>::try_from(exact_numbers(point)?).ok();
    let chain: Vec<_> =
        chain.map(point).collect::<Option<_>>().ok_or("`chain` holds something else than exact points")?;
    let k = index(input, "k")? as u64;
    Ok(check_separator(&generators, k, &chain).in_words())
}

pub(super) fn walk(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let triple = |tree: &Tree| -> Option<FacetTriple> {
        let [first, second, sign] = tree.list()? else { return None };
        let sign = [-1, 1].into_iter().find(|candidate| Some(*candidate as f64) == sign.float())?;
        Some((first.index()?, second.index()?, sign))
    };
    let facet = triple(member(input, "facet")?.tree).ok_or("`facet` is no facet")?;
    let list = member(result, "neighbours")?.tree.list().ok_or("`neighbours` is not a list")?;
    let neighbours: Vec<FacetTriple> =
        list.iter().map(triple).collect::<Option<_>>().ok_or("a neighbour is no facet")?;
    Ok(check_walk(&generators, facet, &neighbours).in_words())
}

pub(super) fn upper_hull(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let p0 = <[f64; 2]>::try_from(vector(member(input, "p0")?, "p0")?).map_err(|_| "p0 is not a point of the plane")?;
    let z = match member(result, "z")?.tree {
        Tree::Null => None,
        value => Some(value.text().and_then(Fraction::parse).ok_or("`z` is neither an exact number nor null")?),
    };
    Ok(check_upper_hull(&generators, p0, boolean(result, "above_q")?, z.as_ref()).in_words())
}
