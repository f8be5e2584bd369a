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

/// The complaint about the square's tiling after a change.
fn complaint(change: &dyn Fn(&mut TilingAnswer)) -> String {
    let mut answer = square();
    change(&mut answer);
    check(&SQUARE, &answer).proof().expect_err("the tiling was broken")
}

#[test]
fn every_kind_of_fault_is_named() {
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
fn indices_just_beyond_their_lists_are_named() {
    assert!(complaint(&|t| t.edges[0].generator = 2).contains("edge 0 names"));
    assert!(complaint(&|t| t.edges[0].upper = 4).contains("edge 0 names"));
    assert!(complaint(&|t| t.edges[0].right = Some(1)).contains("edge 0 names"));
    assert!(complaint(&|t| t.tiles[0].generators = [0, 2]).contains("tile 0 names"));
    assert!(complaint(&|t| t.tiles[0].edges[3] = 4).contains("tile 0 names"));
    assert!(complaint(&|t| t.left_side[1] = 4).contains("left side names vertex 4"));
}

/// Tiles are looked at before edges: the one tile's place is taken by others, which have no edges.
#[test]
fn tiles_are_numbered_from_left_to_right_and_each_is_there_once() {
    let told = |generators: &[[f64; 3]], tiles: &[([usize; 2], [i64; 2])]| {
        let changed = |&(generators, [x, y]): &([usize; 2], [i64; 2])| Tile {
            generators,
            dual: [x, y].map(|twice| Fraction::new(twice, 2).expect("two is not zero")),
            ..square().tiles[0].clone()
        };
        let answer = TilingAnswer { tiles: tiles.iter().map(changed).collect(), ..square() };
        check(generators, &answer).proof().expect_err("the edges are those of another tiling")
    };
    // A second tile of the same two generators, further left.
    assert!(told(&SQUARE, &[([0, 1], [0, -1]), ([0, 1], [1, -1])]).contains("from left to right"));
    // The lines x + y = 0, y + 1 = 0 and −x + y = 0.
    let hexagon = [[1.0, 1.0, 0.0], [0.0, 1.0, 1.0], [-1.0, 1.0, 0.0]];
    let [left, top, right] = [([1, 2], [-2, -2]), ([0, 2], [0, 0]), ([0, 1], [2, -2])];
    assert!(told(&hexagon, &[left, top, right]).contains("has no edge of its own"));
    for tiles in [[left, right, top], [top, left, right], [right, top, left]] {
        assert!(told(&hexagon, &tiles).contains("from left to right"), "{tiles:?}");
    }
    // Three lines through the origin cross only once, and their generators lie in one plane.
    let flat = [[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    assert!(told(&flat, &[([0, 1], [0, 0]), ([0, 2], [0, 0]), ([1, 2], [0, 0])]).contains("from left to right"));
}

/// A tiling of two parallel generators has two edges and no tile; Q is a segment.
fn parallel(vertices: [[i64; 3]; 3], edges: [[usize; 2]; 2]) -> TilingAnswer {
    let edge = |generator: usize| {
        let [upper, lower] = edges[generator];
        TilingEdge { generator, upper, lower, left: None, right: None }
    };
    TilingAnswer {
        vertices: vertices.map(whole).to_vec(),
        edges: vec![edge(0), edge(1)],
        tiles: vec![],
        left_side: vec![0, 1, 2],
    }
}

#[test]
fn parallel_lines_are_stepped_along_from_the_top() {
    // The line 6 x + 8 y + 201 = 0 lies just below 3 x + 4 y + 100 = 0, and just above 3 x + 4 y + 101 = 0.
    let [line, lower, upper] = [[6.0, 8.0, 201.0], [3.0, 4.0, 101.0], [3.0, 4.0, 100.0]];
    let first = parallel([[9, 12, 301], [3, 4, 101], [-9, -12, -301]], [[0, 1], [1, 2]]);
    assert!(check(&[upper, line], &first).is_right());
    let second = parallel([[9, 12, 302], [-3, -4, -100], [-9, -12, -302]], [[1, 2], [0, 1]]);
    assert!(check(&[lower, line], &second).is_right());
    assert!(check(&[lower, line], &first).is_wrong() && check(&[upper, line], &second).is_wrong());
}

/// Each of two generators along one line takes the other to lie on its lower side, and so no chain has both as steps.
#[test]
fn generators_along_one_line_have_no_tiling() {
    let along = [[1.0, 1.0, 0.0], [2.0, 2.0, 0.0]];
    let told = |answer: &TilingAnswer| check(&along, answer).proof().expect_err("there is no tiling");
    let apart = parallel([[1, 1, 0], [-1, -1, 0], [-3, -3, 0]], [[1, 2], [0, 2]]);
    assert!(told(&apart).contains("left side"));
    let chain = parallel([[3, 3, 0], [1, 1, 0], [-3, -3, 0]], [[0, 1], [1, 2]]);
    assert!(told(&chain).contains("are not the ends of its edge"));
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
