//! Two vectors of space side by side: the operations of passes that take generators in pairs.

use wide::f64x2;

/// Two generators side by side.
pub(crate) type Columns = [f64x2; 3];

#[inline(always)]
pub(crate) fn columns([[a, b, c], [d, e, f]]: [[f64; 3]; 2]) -> Columns {
    [[a, d], [b, e], [c, f]].map(f64x2::new)
}

#[inline(always)]
pub(crate) fn for_pairs(generators: &[[f64; 3]], mut read: impl FnMut(Columns)) {
    let (pairs, last) = generators.as_chunks::<2>();
    for pair in pairs {
        read(columns(*pair));
    }
    if let [last] = last {
        read(columns([*last, [0.0; 3]]));
    }
}

#[inline(always)]
pub(crate) fn product(v: &Columns, u: &Columns) -> f64x2 {
    v[0] * u[0] + v[1] * u[1] + v[2] * u[2]
}

#[inline(always)]
pub(crate) fn size(v: &Columns) -> f64x2 {
    v[0].abs().fast_max(v[1].abs()).fast_max(v[2].abs()).fast_max(f64x2::splat(f64::MIN_POSITIVE))
}

#[inline(always)]
pub(crate) fn clipped(t: f64x2, limit: f64x2) -> f64x2 {
    t.fast_min(limit).fast_max(-limit)
}

#[inline(always)]
pub(crate) fn total(lanes: f64x2) -> f64 {
    let [first, second] = lanes.to_array();
    first + second
}

#[inline(always)]
pub(crate) fn totals([x, y, z]: &Columns) -> [f64; 3] {
    [total(*x), total(*y), total(*z)]
}
