//! The expected costs of experiments, by which shards are made even. They shape shards and no record.

/// Nanoseconds of a processor for each element of an input that is counted or timed, to two digits: the processor time
/// of `reproduce --only ID --threads 1` in the quick profile over the sizes of all cases and repetitions.
const RATES: [(&str, u64); 23] = [
    ("min-area-scaling", 2_000),
    ("min-area-stages", 500),
    ("lad-scaling", 950),
    ("lad-race", 4_800),
    ("pruning-passes", 570),
    ("slope-selection-scaling", 5_000),
    ("hull-scaling", 300),
    ("methods-agree", 13_000),
    ("area-ratio", 2_600),
    ("directions-scaling", 990_000),
    ("points-scaling", 1_600),
    ("scan-race", 2_400),
    ("length-ratio", 50_000),
    ("net-scaling", 1_700_000),
    ("net-scaling-in-space", 340_000_000),
    ("net-points", 8_500),
    ("gap-curve", 330_000),
    ("few-generators", 110_000),
    ("enclosing-quality", 170_000),
    ("collision-scaling", 3_200),
    ("gauge-passes", 710),
    ("fallback-rate", 25_000),
    ("rung-shares", 34_000),
];

/// The rate of an experiment that has no row: the middle one of those that have.
const MIDDLE: u64 = 5_000;

/// The expected nanoseconds of an experiment for each element of an input.
pub fn nanoseconds_an_element(experiment: &str) -> u64 {
    RATES.iter().find(|(id, _)| *id == experiment).map_or(MIDDLE, |&(_, rate)| rate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_those_of_experiments_and_the_middle_one_is_in_the_middle() {
        let mut rates: Vec<u64> = RATES.iter().map(|&(_, rate)| rate).collect();
        rates.sort_unstable();
        assert_eq!(MIDDLE, rates[rates.len() / 2]);
        for (id, rate) in RATES {
            assert!(crate::catalog::find(id).is_some(), "{id} is no experiment");
            assert_eq!(nanoseconds_an_element(id), rate);
        }
    }
}
