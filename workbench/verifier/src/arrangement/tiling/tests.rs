//! Tilings by hand, and each of their parts spoilt.

use super::*;

fn whole<const N: usize>(numbers: [i64; N]) -> [Fraction; N] {
    numbers.map(|number| Fraction::new(number, 1).expect("one is not zero"))
}

/// Two sides of a square on its corner: the lines x + y = 0 and −x + y + 1 = 0 cross at (1/2, −1/2).
const SQUARE: [[f64; 3]; 2] = [[1.0, 1.0, 0.0], [-1.0, 1.0, 1.0]];

fn square() -> TilingAnswer {
    let edge = |generator, upper, lower, left, right| TilingEdge { generator, upper, lower, left, right };
    TilingAnswer {
        // top, left, bottom, right
        vertices: [[0, 2, 1], [-2, 0, 1], [0, -2, -1], [2, 0, -1]].map(whole).to_vec(),
        edges: vec![
            edge(0, 0, 1, None, Some(0)),
            edge(1, 1, 2, None, Some(0)),
            edge(0, 3, 2, Some(0), None),
            edge(1, 0, 3, Some(0), None),
        ],
        tiles: vec![Tile {
            generators: [0, 1],
            corners: [0, 1, 2, 3],
            edges: [0, 1, 2, 3],
            dual: [Fraction::new(1, 2), Fraction::new(-1, 2)].map(|x| x.expect("two is not zero")),
        }],
        left_side: vec![0, 1, 2],
    }
}

fn check(generators: &[[f64; 3]], answer: &TilingAnswer) -> Verdict<TilingProof> {
    let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
    check_tiling(&generators, answer)
}

#[test]
fn one_tile_by_hand() {
    assert_eq!(check(&SQUARE, &square()), Verdict::Right(TilingProof { tiles: 1 }));
    // An upright generator lifts the whole upper hull.
    let mut lifted = square();
    for vertex in &mut lifted.vertices {
        vertex[2] = Fraction::new(vertex[2].numerator() + IBig::from(5), 1).expect("one is not zero");
    }
    let [a, b] = SQUARE;
    assert!(check(&[a, b, [0.0, 0.0, -5.0]], &lifted).is_right());
    assert!(check(&[a, b, [0.0, 0.0, -5.0]], &square()).is_wrong());
}

#[test]
fn every_kind_of_fault_is_named() {
    let complaint = |change: &dyn Fn(&mut TilingAnswer)| {
        let mut answer = square();
        change(&mut answer);
        check(&SQUARE, &answer).proof().expect_err("the tiling was broken")
    };
    assert!(complaint(&|t| t.tiles[0].dual = whole([1, 0])).contains("no tile of its own"));
    assert!(complaint(&|t| t.tiles[0].generators = [1, 0]).contains("no tile of its own"));
    assert!(complaint(&|t| t.tiles.push(t.tiles[0].clone())).contains("from left to right"));
    assert!(complaint(&|t| t.tiles.clear()).contains("names what does not exist"));
    assert!(complaint(&|t| t.edges[0].right = None).contains("has no edge"));
    assert!(complaint(&|t| t.edges[0].upper = 1).contains("ends of its edge"));
    assert!(complaint(&|t| t.edges[0].lower = 9).contains("edge 0 names"));
    assert!(complaint(&|t| t.edges.push(t.edges[0])).contains("vertices for"));
    assert!(complaint(&|t| t.vertices[0][2] = whole([0])[0].clone()).contains("ends of its edge"));
    assert!(complaint(&|t| t.vertices[0][2] = Fraction::new(1, 3).expect("not zero")).contains("no sum"));
    assert!(complaint(&|t| t.vertices.push(t.vertices[0].clone())).contains("vertices for"));
    assert!(complaint(&|t| t.tiles[0].corners.swap(0, 1)).contains("parallelogram"));
    assert!(complaint(&|t| t.tiles[0].edges.swap(2, 3)).contains("parallelogram"));
    assert!(complaint(&|t| t.tiles[0].corners[2] = 4).contains("tile 0 names"));
    assert!(complaint(&|t| t.left_side[1] = 3).contains("left side"));
    assert!(complaint(&|t| t.left_side[1] = 8).contains("left side names"));
    assert!(complaint(&|t| t.left_side.truncate(2)).contains("left side"));
}

#[test]
fn bodies_without_tiles() {
    let nothing = TilingAnswer { vertices: vec![whole([0, 0, 2])], edges: vec![], tiles: vec![], left_side: vec![0] };
    assert!(check(&[[0.0, 0.0, 2.0]], &nothing).is_right());
    assert!(check(&[[0.0, 0.0, 1.0]], &nothing).is_wrong());
    assert!(check(&[], &TilingAnswer { vertices: vec![], ..nothing.clone() }).is_wrong());
    assert!(check(&[[1.0, 0.0, 2.0]], &nothing).is_wrong());
    assert!(check_tiling(&[vec![1.0]], &nothing).is_wrong());
    assert!(check(&[[f64::NAN, 0.0, 2.0]], &nothing).is_wrong());
    let many = vec![[1.0, 1.0, 0.0]; 1000];
    assert!(matches!(check(&many, &nothing), Verdict::Unchecked(_)));
}
