//! The lines and the tiles of generators, numbered alike.

use crate::solid::Face;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::slope_selection::{ArrangementVertex, Method};

/// The arrangement of the lines of some generators and the tiling of the upper hull that is dual to it. The generators
/// are in general position, those of a figure small integers, so that everything here is what is drawn.
#[derive(Clone, Debug)]
pub(crate) struct DualPair {
    /// (a, b, c), with b > 0: the projection (a, b) points up, the line is a x + b y + c = 0.
    pub(crate) generators: Vec<[f64; 3]>,
    /// The crossings from left to right.
    pub(crate) crossings: Vec<Crossing>,
    /// The distance at which the separators at the ends stand beside all crossings.
    margin: f64,
}

/// The distance at which the separators at the ends stand beside the crossings of a figure.
const FIGURE_MARGIN: f64 = 0.4;

/// The coefficients of the two generators at the corners of a tile, in order: first the first one changes.
const AROUND: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];

/// The crossing of two lines, and the tile dual to it.
#[derive(Clone, Debug)]
pub(crate) struct Crossing {
    pub(crate) place: [f64; 2],
    pub(crate) pair: [usize; 2],
    /// The middle of the tile.
    pub(crate) middle: [f64; 2],
    /// The height of the facet's middle above the plane.
    pub(crate) height: f64,
}

impl DualPair {
    /// That of generators with two lines at least that cross.
    pub(crate) fn new(generators: &[[f64; 3]]) -> Self {
        let arrangement =
            LineArrangement::from_rows(generators).expect("generators that are drawn are finite and not many");
        let crossing = |vertex: &ArrangementVertex| {
            let pair = vertex.lines.map(|line| line.position());
            let [x, y, w] = arrangement.exact_line(vertex.lines[0]).meet(&arrangement.exact_line(vertex.lines[1]));
            let place = [x.ratio(&w), y.ratio(&w)];
            let mut middle = [0.0; 3];
            for (index, generator) in generators.iter().enumerate().filter(|(index, _)| !pair.contains(index)) {
                let sign = if value(generator, place) < 0.0 { -1.0 } else { 1.0 };
                middle = std::array::from_fn(|i| middle[i] + sign * generators[index][i]);
            }
            Crossing { place, pair, middle: [middle[0], middle[1]], height: middle[2] }
        };
        Self {
            generators: generators.to_vec(),
            crossings: Method::BruteForce.all_vertices(&arrangement, 0).iter().map(crossing).collect(),
            margin: FIGURE_MARGIN,
        }
    }

    /// The same pair with the separators at the ends beside all crossings by a part of the distance between the
    /// outermost ones.
    pub(crate) fn with_margin(self, part: f64) -> Self {
        let x = |crossing: Option<&Crossing>| crossing.map_or(0.0, |crossing| crossing.place[0]);
        let spread = x(self.crossings.last()) - x(self.crossings.first());
        Self { margin: if spread > 0.0 { part * spread } else { FIGURE_MARGIN }, ..self }
    }

    /// The x of the vertical line L_k: between the k-th crossing and the next.
    pub(crate) fn separator_x(&self, k: usize) -> f64 {
        let x = |index: usize| self.crossings[index].place[0];
        match k {
            0 => x(0) - self.margin,
            _ if k == self.crossings.len() => x(k - 1) + self.margin,
            _ => (x(k - 1) + x(k)) / 2.0,
        }
    }

    /// The lines that L_k meets, from top to bottom.
    pub(crate) fn order_on(&self, x: f64) -> Vec<usize> {
        let height = |&index: &usize| {
            let [a, b, c] = self.generators[index];
            -(a * x + c) / b
        };
        let mut order: Vec<usize> = (0..self.generators.len()).collect();
        order.sort_by(|one, other| height(other).total_cmp(&height(one)));
        order
    }

    /// The chain L'_k from the top vertex of Q down.
    pub(crate) fn chain(&self, k: usize) -> Vec<[f64; 2]> {
        let mut place = self.top();
        let mut chain = vec![place];
        for index in self.order_on(self.separator_x(k)) {
            let [a, b, _] = self.generators[index];
            place = [place[0] - 2.0 * a, place[1] - 2.0 * b];
            chain.push(place);
        }
        chain
    }

    fn top(&self) -> [f64; 2] {
        self.generators.iter().fold([0.0; 2], |[x, y], [a, b, _]| [x + a, y + b])
    }

    /// The corners of Q, counter-clockwise from the top.
    pub(crate) fn outline(&self) -> Vec<[f64; 2]> {
        let mut left = self.chain(0);
        left.pop();
        let right = left.iter().map(|[x, y]| [-x, -y]).collect::<Vec<_>>();
        [left, right].concat()
    }

    /// The faces of the zonohedron: those over the tiles and their reflections through the centre.
    pub(crate) fn faces(&self) -> Vec<Face> {
        let upper = self.crossings.iter().map(|crossing| self.upper_face(crossing));
        let reflected = |v: [f64; 3]| v.map(|c| -c);
        upper
            .flat_map(|face| {
                let lower = Face {
                    corners: face.corners.iter().copied().map(reflected).collect(),
                    normal: reflected(face.normal),
                    sides: face.sides.clone(),
                };
                [face, lower]
            })
            .collect()
    }

    /// The face over a tile.
    pub(crate) fn upper_face(&self, crossing: &Crossing) -> Face {
        let [v, w] = crossing.pair.map(|index| self.generators[index]);
        let [x, y] = crossing.middle;
        let middle = [x, y, crossing.height];
        let corner = |[s, t]: [f64; 2]| std::array::from_fn(|i| middle[i] + s * v[i] + t * w[i]);
        let [i, j] = crossing.pair;
        let [nx, ny] = crossing.place;
        Face { corners: AROUND.map(corner).to_vec(), normal: [nx, ny, 1.0], sides: vec![i, j, i, j] }
    }

    /// The corners of a tile, in order around it.
    pub(crate) fn tile(&self, crossing: &Crossing) -> Vec<[f64; 2]> {
        self.upper_face(crossing).corners.iter().map(|&[x, y, _]| [x, y]).collect()
    }
}

fn value(generator: &[f64; 3], [x, y]: [f64; 2]) -> f64 {
    generator[0] * x + generator[1] * y + generator[2]
}
