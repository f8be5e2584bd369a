//! The tables of README are those of the committed record: `ZONOTOPE_BLESS=1` rewrites them.

use experiments::peers::{self, Table};
use tests::sources::root;

const BEGIN: &str = "<!-- peers: made from experiments/data/peers.json -->\n";
const END: &str = "<!-- peers: end -->\n";

#[test]
fn tables_of_the_readme_are_those_of_the_record() {
    let record = peers::committed().expect("the committed record reads as one");
    let made = peers::tables_of_readme(&record).iter().map(Table::markdown).collect::<Vec<_>>().join("\n");
    let file = root().join("README.md");
    let readme = std::fs::read_to_string(&file).expect("there is a README");
    let (before, rest) = readme.split_once(BEGIN).expect("README marks where the tables begin");
    let (shown, after) = rest.split_once(END).expect("README marks where the tables end");
    if std::env::var_os("ZONOTOPE_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&file, format!("{before}{BEGIN}{made}{END}{after}")).expect("README can be written");
        return;
    }
    assert_eq!(shown, made, "README's tables are not those of the record; ZONOTOPE_BLESS=1 rewrites them");
}

#[test]
fn the_record_names_what_exists() {
    let record = peers::committed().expect("the committed record reads as one");
    for cell in &record.cells {
        assert!(families::bodies::find(&cell.family).is_some(), "{}", cell.family);
        assert!(cell.entries.iter().all(|entry| entry.wrong + entry.failed <= entry.asked), "{cell:?}");
    }
}

/// README's sentence: near contact and on clear questions the kernel is the quicker one of random bodies at every size,
/// and where bodies touch it is the slower one at every size.
#[test]
fn the_kernel_leads_where_the_readme_says_so() {
    let record = peers::committed().expect("the committed record reads as one");
    let [_, lead, _] = peers::tables_of_readme(&record);
    let medians = |row: &[String]| -> Vec<f64> {
        let known = row[1..].iter().filter_map(|cell| cell.split(' ').next()?.parse().ok());
        known.collect()
    };
    for row in &lead.rows[..3] {
        assert!(medians(row).iter().all(|&ratio| ratio > 1.0), "{row:?}");
    }
    assert!(lead.rows[3][0].contains("touching"));
    assert!(medians(&lead.rows[3]).iter().all(|&ratio| ratio < 1.0), "{:?}", lead.rows[3]);
    for row in &lead.rows[8..] {
        assert!(row[0].contains("single precision"));
        assert!(medians(row).last().is_some_and(|&ratio| ratio < 1.0), "{row:?}");
    }
}
