//! Checks every claim of the paper and prints claim, place, evidence and finding, one line each.

use paper_checks::{CheckContext, run, text};

fn main() {
    let results = run(&CheckContext::default(), |_| ());
    print!("{}", text(&results));
}
