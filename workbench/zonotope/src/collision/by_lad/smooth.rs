//! Where the optimum is, nearly: Newton steps on the objective with rounded-off kinks.
//!
//! Each |t| is replaced by t² / (2 e) + e / 2 where |t| < e (Huber's function), e in proportion to the length of the generator. The band of the
//! lines nearer than e shrinks as the steps get shorter, until it is a few lines thick. Nothing here is exact
//! and nothing rests on it but speed.

/// Lines a x + b y + c with the inverse length of their generators, as columns.
#[derive(Debug, Default)]
pub(super) struct Columns {
    pub(super) a: Vec<f64>,
    pub(super) b: Vec<f64>,
    pub(super) c: Vec<f64>,
    pub(super) weight: Vec<f64>,
}

/// A point near the optimum, the band in which the lines were rounded off, and the sides of a parallelogram around the point that
/// the optimum is likely to be in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guess {
    pub(super) point: [f64; 2],
    pub(super) band: f64,
    pub(super) sides: [[f64; 2]; 2],
}

/// What a guess is to allow for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aim {
    /// Lines in the thinnest band.
    pub(super) thickness: f64,
    /// How many lines the columns stand for.
    pub(super) population: usize,
    /// Standard deviations of the gradient that lines of the band and those that are missing may contribute.
    pub(super) deviations: f64,
}

/// The most Newton steps.
const STEPS: usize = 24;

/// Lines read side by side.
const LANES: usize = 4;

/// A symmetric matrix [[xx, xy], [xy, yy]].
type Symmetric = [f64; 3];

/// Sums over the lines at a point for one band.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    gradient: [f64; 2],
    hessian: Symmetric,
    /// Σ weight over the band.
    weight: f64,
    count: f64,
}

impl Columns {
    /// Lines as [a, b, c, weight].
    pub(super) fn collect(lines: impl ExactSizeIterator<Item = [f64; 4]>) -> Self {
        let column = || vec![0.0; lines.len()];
        let mut columns = Self { a: column(), b: column(), c: column(), weight: column() };
        let Self { a, b, c, weight } = &mut columns;
        let places = a.iter_mut().zip(b).zip(c.iter_mut().zip(weight));
        for (line, ((a, b), (c, weight))) in lines.zip(places) {
            [*a, *b, *c, *weight] = line;
        }
        columns
    }

    pub(super) fn len(&self) -> usize {
        self.a.len()
    }

    /// The minimum of Σ weight · (a x + b y + c)² and the root of the mean square.
    pub(super) fn least_squares(&self) -> Option<([f64; 2], f64)> {
        let (mut matrix, mut right, mut constant, mut lengths) = ([0.0; 3], [0.0; 2], 0.0, 0.0);
        for i in 0..self.len() {
            let (a, b, c, w) = (self.a[i], self.b[i], self.c[i], self.weight[i]);
            let (wa, wb, wc) = (w * a, w * b, w * c);
            matrix = [matrix[0] + wa * a, matrix[1] + wa * b, matrix[2] + wb * b];
            right = [right[0] + wa * c, right[1] + wb * c];
            constant += wc * c;
            lengths += 1.0 / w;
        }
        let point = solve(&matrix, right)?.map(|v| -v);
        let rest = constant + right[0] * point[0] + right[1] * point[1];
        Some((point, (rest.max(0.0) / lengths).sqrt()))
    }

    /// Σ normal · normalᵀ over the lines of a band, plus `share` of all of them.
    fn spread(&self, [x, y]: [f64; 2], band: f64, share: f64) -> Symmetric {
        let mut sum = [0.0; 3];
        for i in 0..self.len() {
            let (a, b) = (self.a[i], self.b[i]);
            let near = (a * x + b * y + self.c[i]).abs() * self.weight[i] < band;
            let part = if near { 1.0 } else { share };
            sum = [sum[0] + part * a * a, sum[1] + part * a * b, sum[2] + part * b * b];
        }
        sum
    }

    fn moments(&self, point: [f64; 2], band: f64) -> Moments {
        let mut lanes = Lanes::default();
        let scale = 1.0 / band;
        let ((a, a_rest), (b, b_rest)) = (self.a.as_chunks::<LANES>(), self.b.as_chunks::<LANES>());
        let ((c, c_rest), (w, w_rest)) = (self.c.as_chunks::<LANES>(), self.weight.as_chunks::<LANES>());
        for (((a, b), c), w) in a.iter().zip(b).zip(c).zip(w) {
            lanes.read(a, b, c, w, point, scale);
        }
        if !a_rest.is_empty() {
            // the missing lines have no normal and are far from every point
            let padded = |rest: &[f64], fill: f64| {
                let mut lanes = [fill; LANES];
                lanes[..rest.len()].copy_from_slice(rest);
                lanes
            };
            let (a, b) = (padded(a_rest, 0.0), padded(b_rest, 0.0));
            lanes.read(&a, &b, &padded(c_rest, 1.0), &padded(w_rest, f64::MAX), point, scale);
        }
        lanes.total()
    }

    /// A point near the minimum of linear · x + Σ |a x + b y + c|; searched from another guess, if there is one.
    pub(super) fn guess(&self, linear: [f64; 2], start: Option<&Guess>, aim: Aim) -> Option<Guess> {
        let Aim { thickness, population, deviations } = aim;
        let (mut point, mut band) = match start {
            Some(guess) => (guess.point, guess.band),
            None => self.least_squares()?,
        };
        let mut last: Option<(Moments, f64)> = None;
        for _ in 0..STEPS {
            let moments = self.moments(point, band);
            let gradient = [moments.gradient[0] + linear[0], moments.gradient[1] + linear[1]];
            let step = if moments.count < thickness { None } else { solve(&moments.hessian, gradient) };
            let Some(step) = step else {
                if last.is_some() {
                    break;
                }
                band *= 4.0;
                continue;
            };
            point = [point[0] - step[0], point[1] - step[1]];
            last = Some((moments, band));
            // the mean square of the change of t / e in the band, each length taken for the harmonic mean
            let [xx, xy, yy] = moments.hessian;
            let curvature = (xx * step[0] + 2.0 * xy * step[1]) * step[0] + yy * step[1] * step[1];
            let change = curvature * moments.weight / (band * moments.count * moments.count);
            if change < 0.25 {
                if moments.count < 2.0 * thickness {
                    break;
                }
                band *= (1.5 * thickness / moments.count).max(0.125);
            } else if change < 4.0 {
                band *= 0.5;
            }
        }
        let (moments, band) = last?;
        let missing = 1.0 - self.len() as f64 / population as f64;
        let [first, second] = factor(&self.spread(point, band, missing))?;
        let side = |v: [f64; 2]| solve(&moments.hessian, v.map(|c| c * deviations));
        let guess = Guess { point, band, sides: [side(first)?, side(second)?] };
        let finite = |v: [f64; 2]| v[0].is_finite() && v[1].is_finite();
        (finite(guess.point) && finite(guess.sides[0]) && finite(guess.sides[1])).then_some(guess)
    }
}

/// Sums side by side: the gradient, the Hessian, weight and count of the band.
#[derive(Default)]
struct Lanes([[f64; LANES]; 7]);

impl Lanes {
    #[inline(always)]
    fn read(
        &mut self,
        a: &[f64; LANES],
        b: &[f64; LANES],
        c: &[f64; LANES],
        w: &[f64; LANES],
        [x, y]: [f64; 2],
        scale: f64,
    ) {
        for lane in 0..LANES {
            let weight = w[lane] * scale;
            let t = (a[lane] * x + b[lane] * y + c[lane]) * weight;
            // the arguments in this order make a NaN a bound, and the compiler's minimum and maximum single instructions
            let slope = if t < 1.0 { t } else { 1.0 };
            let slope = if slope > -1.0 { slope } else { -1.0 };
            let inside = t.abs() < 1.0;
            let stiff = if inside { weight } else { 0.0 };
            let (sa, sb) = (stiff * a[lane], stiff * b[lane]);
            self.0[0][lane] += slope * a[lane];
            self.0[1][lane] += slope * b[lane];
            self.0[2][lane] += sa * a[lane];
            self.0[3][lane] += sa * b[lane];
            self.0[4][lane] += sb * b[lane];
            self.0[5][lane] += stiff;
            self.0[6][lane] += if inside { 1.0 } else { 0.0 };
        }
    }

    fn total(&self) -> Moments {
        let [gx, gy, xx, xy, yy, weight, count] = self.0.map(|lanes| lanes.iter().sum());
        Moments { gradient: [gx, gy], hessian: [xx, xy, yy], weight, count }
    }
}

fn solve([xx, xy, yy]: &Symmetric, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = xx * yy - xy * xy;
    (determinant > 1e-14 * (xx * yy)).then(|| [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant])
}

/// The columns of the lower triangular L with L Lᵀ = the matrix.
fn factor([xx, xy, yy]: &Symmetric) -> Option<[[f64; 2]; 2]> {
    let first = xx.sqrt();
    let rest = yy - xy * xy / xx;
    (*xx > 0.0 && rest > 0.0).then(|| [[first, xy / first], [0.0, rest.sqrt()]])
}
