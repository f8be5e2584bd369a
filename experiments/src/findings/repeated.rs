//! Sentences about section 5.2.

use super::finding::Findings;
use super::words::{course, per_size, plain, ratio, span};
use crate::definition::Quantity;

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "query-trade-off",
        counted: &[
            |found| {
                course(
                    found,
                    "The number of operations in a trapezoid",
                    CUTTING,
                    Quantity::Value("in_trapezoid"),
                    plain,
                )
            },
            |found| {
                course(
                    found,
                    "The number of steps, comparisons and lines looked at to find a trapezoid and the optimum in it",
                    CUTTING,
                    Quantity::Value("to_find_it"),
                    plain,
                )
            },
            |found| {
                span(
                    found,
                    "The part that a query takes of its bound",
                    CUTTING,
                    Quantity::Value("share_of_bound"),
                    plain,
                )
            },
            |found| {
                course(found, "The number of bytes a unit of space", CUTTING, Quantity::Value("bytes_a_unit"), plain)
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "direction-tree-queries",
        counted: &[
            |found| {
                let tree = ["direction-tree-queries", "by_direction_tree"];
                course(found, "The number of reads of a query over √n", tree, READS, |n, reads| reads / n.sqrt())
            },
            |found| ratio(found, "Reads", "direction-tree-queries", ["by_direction_tree", "by_lad"], READS),
        ],
        timed: &[],
    },
    Findings {
        experiment: "reduction-error",
        counted: &[
            |found| course(found, "The error of Lemma 5.5's patches", ["reduction-error", "lemma_5_5"], ERROR, plain),
            |found| course(found, "The error of fitted cluster sums", ["reduction-error", "cluster"], ERROR, plain),
            |found| course(found, "The error of Girard's rule", ["reduction-error", "girard"], ERROR, plain),
        ],
        timed: &[],
    },
    Findings {
        experiment: "hierarchy-levels",
        counted: &[
            |found| {
                course(
                    found,
                    "The number of pairs of levels visited of bodies apart",
                    ["hierarchy-levels", "apart"],
                    VISITED,
                    plain,
                )
            },
            |found| {
                course(
                    found,
                    "The share of the generators read of bodies apart",
                    ["hierarchy-levels", "apart"],
                    SHARE_READ,
                    plain,
                )
            },
            |found| {
                let overlapping = ["hierarchy-levels", "overlapping"];
                course(found, "The share of the generators read of bodies that overlap", overlapping, SHARE_READ, plain)
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "walk-steps",
        counted: &[|found| {
            span(
                found,
                "The number of bytes over n",
                ["walk-steps", "by_dynamic_hull"],
                Quantity::Value("bytes"),
                per_size,
            )
        }],
        timed: &[|found| ratio(found, "Times", "walk-steps", ["by_dynamic_hull", "by_scan"], Quantity::Time("walk"))],
    },
    Findings {
        experiment: "coherence",
        counted: &[
            |found| course(found, "The number of reads of fresh queries", ["coherence", "fresh"], READS, plain),
            |found| course(found, "The number of reads of queries to trees", ["coherence", "trees"], READS, plain),
            |found| {
                course(found, "The number of reads from the last frame's optimum", ["coherence", "warm"], READS, plain)
            },
            |found| {
                course(
                    found,
                    "The number of steps of walking",
                    ["coherence", "walking"],
                    Quantity::Value("steps"),
                    plain,
                )
            },
        ],
        timed: &[],
    },
];

const CUTTING: [&str; 2] = ["query-trade-off", "by_cutting"];
const READS: Quantity = Quantity::Value("reads");
const ERROR: Quantity = Quantity::Value("error");
const VISITED: Quantity = Quantity::Value("visited");
const SHARE_READ: Quantity = Quantity::Value("share_read");
