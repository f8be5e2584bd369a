//! The point of a simplex nearest to the origin, in doubles, as vertices are added to it.

use crate::numeric::linear::dot;

/// An edge shorter than this share of itself off the others is taken for their combination.
const DEPENDENT: f64 = 1e-14;

/// A simplex of at most eight vertices with its point nearest to the origin as a combination of these, each weight
/// positive. It works in doubles and proves nothing.
#[derive(Debug, Clone)]
pub struct NearestSimplex<const D: usize> {
    vertices: [[f64; D]; 8],
    weights: [f64; 8],
    count: usize,
}

impl<const D: usize> Default for NearestSimplex<D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const D: usize> NearestSimplex<D> {
    /// A simplex without vertices.
    pub fn new() -> Self {
        const { assert!(D <= 7, "a simplex has at most eight vertices") }
        Self { vertices: [[0.0; D]; 8], weights: [0.0; 8], count: 0 }
    }

    /// Whether the nearest point is the origin, inside the simplex.
    pub fn is_full(&self) -> bool {
        self.count == D + 1
    }

    /// Whether a point is one of the vertices.
    pub fn has_vertex(&self, point: &[f64; D]) -> bool {
        self.vertices[..self.count].contains(point)
    }

    /// The square of the longest vertex.
    pub fn largest_square(&self) -> f64 {
        self.vertices[..self.count].iter().map(|v| dot(v, v)).fold(0.0, f64::max)
    }

    /// Adds a vertex and keeps those that the nearest point needs; that point, or `None` if the simplex is flat to
    /// rounding.
    ///
    /// The nearest point of the affine hull is taken if its weights are positive; else the old point is moved towards
    /// it until a weight vanishes, and that vertex is dropped.
    pub fn add(&mut self, vertex: [f64; D]) -> Option<[f64; D]> {
        self.vertices[self.count] = vertex;
        self.weights[self.count] = if self.count == 0 { 1.0 } else { 0.0 };
        self.count += 1;
        loop {
            let (nearest, target) = self.nearest_of_hull()?;
            let mut step = 1.0;
            let mut leaving = None;
            for (i, (weight, target)) in self.weights.iter().zip(&target).enumerate().take(self.count) {
                if *target <= 0.0 {
                    let share = weight / (weight - target);
                    // A new vertex of weight 0 that wants a negative one does not come nearer.
                    if share < step || leaving.is_none() {
                        (step, leaving) = (share.min(step), Some(i));
                    }
                }
            }
            for (weight, target) in self.weights.iter_mut().zip(&target).take(self.count) {
                *weight += step * (target - *weight);
            }
            let Some(leaving) = leaving else { return Some(nearest) };
            self.count -= 1;
            self.vertices.swap(leaving, self.count);
            self.weights.swap(leaving, self.count);
        }
    }

    /// The point of the affine hull nearest to the origin and its weights, by orthogonalising the edges from the last
    /// vertex.
    fn nearest_of_hull(&self) -> Option<([f64; D], [f64; 8])> {
        let edges = self.count.checked_sub(1)?;
        let origin = self.vertices[edges];
        let mut axes = [[0.0; D]; 8];
        let mut triangle = [[0.0; 8]; 8];
        let mut along = [0.0; 8];
        let mut nearest = origin;
        for j in 0..edges {
            let edge: [f64; D] = std::array::from_fn(|k| self.vertices[j][k] - origin[k]);
            let mut left = edge;
            for i in 0..j {
                triangle[i][j] = dot(&axes[i], &left);
                subtract(&mut left, triangle[i][j], &axes[i]);
            }
            let length = dot(&left, &left).sqrt();
            if length.is_nan() || length <= DEPENDENT * dot(&edge, &edge).sqrt() {
                return None;
            }
            triangle[j][j] = length;
            axes[j] = left.map(|v| v / length);
            along[j] = -dot(&axes[j], &nearest);
            subtract(&mut nearest, -along[j], &axes[j]);
        }
        let mut weights = [0.0; 8];
        weights[edges] = 1.0;
        for j in (0..edges).rev() {
            let known: f64 = (j + 1..edges).map(|k| triangle[j][k] * weights[k]).sum();
            weights[j] = (along[j] - known) / triangle[j][j];
            weights[edges] -= weights[j];
        }
        Some((nearest, weights))
    }
}

fn subtract<const D: usize>(from: &mut [f64; D], factor: f64, vector: &[f64; D]) {
    from.iter_mut().zip(vector).for_each(|(a, b)| *a -= factor * b);
}
