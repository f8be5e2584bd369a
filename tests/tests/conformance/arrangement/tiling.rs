//! The swept tiling: the isomorphism of Figure 1 on random and structured bodies, the separators, what is refused. It
//! is the tiling by the facets of the upper hull, too.

use proptest::prelude::*;
use rivals::tiling::{TileIndex, TilingError, check_tiling, tiling};
use zonotope::Zonotope;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::separator;
use zonotope::arrangement::tiling::by_face_lattice::{FacetTile, facet_tiling};
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

/// The bodies of a long run, for each property.
const CASES: u32 = 300;

type Vector = [f64; 3];

fn check(generators: &[Vector]) -> Result<(), TestCaseError> {
    let tiling = match tiling(generators) {
        Ok(tiling) => tiling,
        Err(TilingError::Coplanar { generators: found }) => {
            let [a, b, c] = found.map(|i| generators[i].map(|c| Dyadic::from_f64(c).to_rational()));
            let cross = [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]];
            let determinant = &cross[0] * &c[0] + &cross[1] * &c[1] + &cross[2] * &c[2];
            prop_assert_eq!(determinant, Rational::ZERO);
            return Ok(());
        }
        Err(TilingError::Parallel { first, second }) => {
            let [a, b] = [generators[first], generators[second]].map(|v| v.map(Dyadic::from_f64));
            let cross = [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]];
            prop_assert!(cross.iter().all(Dyadic::is_zero));
            return Ok(());
        }
        Err(other) => return Err(TestCaseError::fail(other.to_string())),
    };
    prop_assert_eq!(check_tiling(generators, &tiling).proof().map(drop), Ok(()));
    let dual = DualArrangement::new(generators).expect("finite");
    prop_assert_eq!(dual.lines().vertex_count(), tiling.tiles().len() as u64);
    for k in 0..=tiling.tiles().len() {
        let chain = tiling.separator(k).expect("there are k tiles");
        let points: Vec<[Dyadic; 2]> = chain
            .iter()
            .map(|&corner| {
                let [x, y, _] = tiling.vertices()[corner.0 as usize].exact_point.clone();
                [x, y]
            })
            .collect();
        let selected = separator(&dual, k as u64, 0, &mut ()).expect("the generators are in general position");
        prop_assert_eq!(&selected.exact_points, &points, "k = {}", k);
        prop_assert_eq!(Some(selected.generators), tiling.separator_generators(k), "k = {}", k);
    }
    prop_assert_eq!(tiling.separator(tiling.tiles().len() + 1), None);
    Ok(())
}

fn generators(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<Vector>> {
    proptest::collection::vec([coordinate.clone(), coordinate.clone(), coordinate], 0..9)
}

tests::properties! {
    CASES;

    #[test]
    fn random_bodies(generators in generators(-1.0..1.0f64)) {
        check(&generators)?;
    }

    #[test]
    fn lattice_bodies(generators in generators((-4i32..5).prop_map(f64::from))) {
        check(&generators)?;
    }

    #[test]
    fn level_vertical_and_parallel_projections(
        generators in generators(-1.0..1.0f64),
        level in proptest::collection::vec((1..4i32, -90..90i32), 0..3),
        vertical in -2i32..3,
        heights in proptest::collection::vec(-1.0..1.0f64, 0..3),
    ) {
        let level = level.into_iter().map(|(x, z)| [f64::from(x), 0.0, f64::from(z)]);
        let parallel = heights.into_iter().map(|z| [1.0, 2.0, z]);
        let all: Vec<Vector> =
            generators.into_iter().chain(level).chain(parallel).chain([[0.0, 0.0, f64::from(vertical)]]).collect();
        check(&all)?;
    }

    #[test]
    fn in_general_position_the_tiles_are_those_of_the_sweep(
        generators in proptest::collection::vec([-999i32..1000, -999i32..1000, -999i32..1000], 2..8),
    ) {
        let generators: Vec<[f64; 3]> = generators.into_iter().map(|g| g.map(f64::from)).collect();
        let Ok(swept) = tiling(&generators) else { return Ok(()) };
        let body = Zonotope::new([0.0; 3], generators).expect("the generators are finite");
        let by_faces = facet_tiling(&body).expect("there are few generators");
        let generators_of = |tile: &FacetTile| {
            let mut all: Vec<usize> =
                tile.classes.iter().flat_map(|&class| by_faces.classes[class].generators.clone()).collect();
            all.sort_unstable();
            all
        };
        let expected: Vec<Vec<usize>> = swept.tiles().iter().map(|tile| tile.generators.to_vec()).collect();
        prop_assert_eq!(by_faces.tiles.iter().map(generators_of).collect::<Vec<_>>(), expected);
        for k in 0..=swept.tiles().len() {
            let flat = |[x, y, _]: [f64; 3]| [x, y];
            let points: Vec<[f64; 2]> =
                by_faces.separator(k).expect("as many tiles").iter().map(|&v| flat(by_faces.vertices[v])).collect();
            let chain = swept.separator(k).expect("so many tiles");
            let expected: Vec<[f64; 2]> =
                chain.iter().map(|corner| swept.vertices()[corner.0 as usize].point()).collect();
            prop_assert_eq!(points, expected);
        }
    }
}

#[test]
fn what_is_not_in_general_position_is_named() {
    let parallel = [[1.0, 0.0, 0.0], [0.0, 1.0, 1.0], [0.0, -2.0, -2.0]];
    assert_eq!(tiling(&parallel), Err(TilingError::Parallel { first: 1, second: 2 }));
    let coplanar = [[1.0, 0.0, 0.0], [0.0, 1.0, 1.0], [5.0, 3.0, 9.0], [1.0, 1.0, 1.0]];
    assert_eq!(tiling(&coplanar), Err(TilingError::Coplanar { generators: [0, 1, 3] }));
    let error = tiling(&[[0.0, 0.0, f64::INFINITY]]).expect_err("not finite");
    assert_eq!(error.to_string(), "generator 0, coordinate 2 is inf, not a finite number");
}

#[test]
fn an_index_of_another_tiling_has_no_center() {
    let tiling = tiling(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("general position");
    assert_eq!(tiling.center(TileIndex(0)), Some([0.0, 0.0]));
    assert_eq!((tiling.center(TileIndex(1)), tiling.separator(2)), (None, None));
}
