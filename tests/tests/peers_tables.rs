//! The tables of README are those of the committed record: `ZONOTOPE_BLESS=1` rewrites them.

use experiments::peers::{self, Table};
use tests::sources::root;

const BEGIN: &str = "<!-- peers: made from experiments/data/peers.json -->\n";
const END: &str = "<!-- peers: end -->\n";

#[test]
fn tables_of_the_readme_are_those_of_the_record() {
    let record = peers::committed().expect("the committed record reads as one");
    // Near contact and wrong answers; the report has the others as well.
    let chosen: Vec<Table> =
        peers::tables(&record).into_iter().enumerate().filter(|(i, _)| [0, 2].contains(i)).map(|(_, t)| t).collect();
    let made = chosen.iter().map(Table::markdown).collect::<Vec<_>>().join("\n");
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
