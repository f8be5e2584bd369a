//! A few tight Gaussian clusters whose centres are spread over the unit disc.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Number of clusters, whatever the number of points.
const CLUSTERS: usize = 16;
/// Standard deviation of a cluster; the centres lie in the unit disc.
const SPREAD: f64 = 0.01;

/// Points in 16 tight Gaussian clusters.
pub const CLUSTERED: Family = Family {
    id: "clustered",
    title: "Clustered",
    description: "16 Gaussian clusters of standard deviation 0.01, centres uniform in the unit disc, each point in a \
        random cluster",
    hull_size: HullSize::Few,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    let centers: Vec<_> = (0..CLUSTERS).map(|_| source.disc_point()).collect();
    (0..n)
        .map(|_| {
            let center = centers[source.below(CLUSTERS)];
            let [x, y] = source.normal_pair();
            [center[0] + SPREAD * x, center[1] + SPREAD * y]
        })
        .collect()
}
