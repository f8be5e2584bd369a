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

/// README's sentences: prepared random bodies at rest are answered sooner than by parry's GJK at every size where they
/// nearly touch, overlap or are apart; the first rows of the table are those of races that ours lose somewhere, and
/// touching bodies are decided later at every size.
#[test]
fn public_calls_lead_where_the_readme_says_so() {
    let record = peers::committed().expect("the committed record reads as one");
    let [_, lead, _] = peers::tables_of_readme(&record);
    let medians = |title: &str| -> Vec<f64> {
        let row = lead.rows.iter().find(|row| row[0] == title).expect("README names the race");
        row[1..].iter().filter_map(|cell| cell.split(' ').next()?.parse().ok()).collect()
    };
    for title in [
        "random bodies near contact (1e-9)",
        "random bodies overlapping",
        "random bodies separated",
        "near contact, every coefficient written",
    ] {
        assert!(medians(title).iter().all(|&ratio| ratio > 1.0), "{title}");
    }
    assert!(medians("random bodies touching").iter().all(|&ratio| ratio < 1.0));
    let least = |title: &str| medians(title).into_iter().fold(f64::INFINITY, f64::min);
    for title in [
        "distance, separated",
        "penetration depth, near contact (1e-9)",
        "parry's in single precision, overlapping",
        "parry's in single precision, separated",
        "random bodies, gap 1e-3",
        "not prepared, overlapping",
        "not prepared, separated",
        "under poses, overlapping",
        "under poses, separated",
    ] {
        assert!(least(title) < 1.0, "{title}");
    }
    let in_order: Vec<f64> = lead.rows.iter().map(|row| least(&row[0])).collect();
    assert!(in_order.is_sorted_by(|a, b| *a <= b + 0.05), "{in_order:?}");
}

/// README's last sentence: next to contact GJK is wrong about many questions, in single precision about half of them.
#[test]
fn wrong_answers_are_where_the_readme_says_so() {
    let record = peers::committed().expect("the committed record reads as one");
    let near =
        || record.cells.iter().filter(|cell| cell.placement.ends_with("1e-9") || cell.placement.ends_with("1e-12"));
    let share = |method: &str| {
        let entries = near().filter_map(|cell| cell.entry(method));
        let [wrong, asked] = entries.fold([0, 0], |[w, a], entry| [w + entry.wrong, a + entry.asked]);
        f64::from(wrong) / f64::from(asked)
    };
    assert!(share("parry_gjk") > 0.1 && (0.4..0.6).contains(&share("parry_f32_gjk")));
    for cell in &record.cells {
        let ours = ["intersection", "intersection_written", "intersection_posed", "intersection_of_rows", "gauge"];
        let ours = ours.iter().chain(&["by_lad", "by_lad_gauge", "distance", "proximity", "penetration"]);
        assert!(ours.filter_map(|id| cell.entry(id)).all(|entry| entry.wrong + entry.failed == 0), "{cell:?}");
    }
}
