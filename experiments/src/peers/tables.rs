//! The record as tables.

use super::{Cell, PeersRecord, median};
use crate::families::bodies::{self, question::PLACEMENTS};
use std::collections::BTreeSet;

/// The name for people of a contender.
const TITLES: &[(&str, &str)] = &[
    ("by_lad", "ours: location, with its proof"),
    ("by_lad_gauge", "ours: exact gauge, with its proof"),
    ("by_slope_selection", "Theorem 5.2 (slope selection)"),
    ("by_explicit_faces", "explicit faces"),
    ("by_gjk", "our GJK (rounded, shows its failures)"),
    ("parry_gjk", "parry3d-f64: GJK on a support map"),
    ("parry_polyhedron", "parry3d-f64: GJK on explicit polyhedra, made before"),
    ("clarabel", "clarabel: feasibility"),
    ("microlp", "microlp: feasibility"),
];

/// The sizes of the tables for people; the record has more.
const SIZES: [usize; 5] = [6, 1 << 10, 1 << 12, 1 << 16, 1 << 20];

/// A table of text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// What it shows, in a sentence.
    pub caption: String,
    /// The heads of the columns.
    pub head: Vec<String>,
    /// The rows; the first entry names the row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// The table as Markdown, its caption above.
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = format!("|{}\n", " --- |".repeat(self.head.len()));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        format!("{}\n\n{}{rule}{rows}", self.caption, line(&self.head))
    }
}

/// Every table of the record: time near contact and when clear, wrong answers, the gauge family by family, the line fit.
pub fn tables(record: &PeersRecord) -> Vec<Table> {
    vec![
        times(
            record,
            "Near contact (certified relative gap 1e-9, both sides), in passes",
            &["inside_1e-9", "outside_1e-9"],
        ),
        times(record, "Clearly overlapping or separated, in passes", &["overlapping", "separated"]),
        wrong_answers(record),
        gauge_by_family(record),
        line_fits(record),
    ]
}

fn size_name(n: usize) -> String {
    if n > 4096 && n.is_power_of_two() { format!("2^{}", n.ilog2()) } else { n.to_string() }
}

fn passes(value: f64) -> String {
    if value < 99.5 { format!("{value:.1}") } else { format!("{value:.0}") }
}

/// The median over the cells' questions of a contender's time in passes, as text.
fn median_passes<'a>(cells: impl Iterator<Item = &'a Cell>, method: &str) -> String {
    let ratios: Vec<f64> = cells.flat_map(|cell| cell.ratios(method, "pass")).collect();
    median(&ratios).map_or_else(|| "–".to_owned(), passes)
}

fn times(record: &PeersRecord, what: &str, placements: &[&str]) -> Table {
    // Six generators are two boxes; from there on random bodies are the reference.
    let family = |n: usize| if n == SIZES[0] { "box_sums" } else { "random_bodies" };
    let chosen = |n: usize| {
        record.cells.iter().filter(move |cell| {
            cell.n == n && cell.family == family(n) && placements.contains(&cell.placement.as_str())
        })
    };
    let row = |&(method, title): &(&str, &str)| {
        let cells = SIZES.iter().map(|&n| median_passes(chosen(n), method));
        [title.to_owned()].into_iter().chain(cells).collect::<Vec<_>>()
    };
    let is_known = |row: &Vec<String>| row[1..].iter().any(|cell| cell != "–");
    let head = SIZES.iter().map(|&n| if n == SIZES[0] { "n = 6 (two boxes)".to_owned() } else { size_name(n) });
    Table {
        caption: format!("{what}: median over random bodies. A dash: not run at this size."),
        head: ["method".to_owned()].into_iter().chain(head).collect(),
        rows: TITLES.iter().map(row).filter(is_known).collect(),
    }
}

fn wrong_answers(record: &PeersRecord) -> Table {
    let groups: [(&str, &[usize]); 6] = [
        ("clear", &[0, 1]),
        ("gap 1e-3", &[2, 3]),
        ("gap 1e-6", &[4, 5]),
        ("gap 1e-9", &[6, 7]),
        ("gap 1e-12", &[8, 9]),
        ("touching", &[10]),
    ];
    let row = |&(method, title): &(&str, &str)| {
        let mut row = vec![title.to_owned()];
        for (_, members) in groups {
            let placements: Vec<&str> = members.iter().map(|&i| PLACEMENTS[i].id).collect();
            let cells = record.cells.iter().filter(|cell| placements.contains(&cell.placement.as_str()));
            let [asked, wrong, failed] = cells
                .filter_map(|cell| cell.entry(method))
                .fold([0; 3], |sum, entry| [sum[0] + entry.asked, sum[1] + entry.wrong, sum[2] + entry.failed]);
            row.push(match (asked, failed) {
                (0, _) => "–".to_owned(),
                (_, 0) => format!("{wrong} / {asked}"),
                _ => format!("{wrong} + {failed} failed / {asked}"),
            });
        }
        row
    };
    Table {
        caption:
            "Wrong answers among the questions asked, all families and sizes together; the truth is known from each \
                  question's construction."
                .to_owned(),
        head: ["method"].into_iter().chain(groups.map(|(name, _)| name)).map(str::to_owned).collect(),
        rows: TITLES.iter().map(row).filter(|row| row[1..].iter().any(|cell| cell != "–")).collect(),
    }
}

fn gauge_by_family(record: &PeersRecord) -> Table {
    let sizes: BTreeSet<usize> = record.cells.iter().map(|cell| cell.n).filter(|n| SIZES.contains(n)).collect();
    let row = |family: &bodies::BodyFamily<3>| {
        let cells = sizes.iter().map(|&n| {
            let chosen = record.cells.iter().filter(|cell| cell.n == n && cell.family == family.id);
            median_passes(chosen, "by_lad_gauge")
        });
        [family.title.to_owned()].into_iter().chain(cells).collect::<Vec<_>>()
    };
    Table {
        caption: "The exact gauge with its proof, in passes: median over all placements.".to_owned(),
        head: ["family".to_owned()].into_iter().chain(sizes.iter().map(|&n| size_name(n))).collect(),
        rows: bodies::BODY_FAMILIES.iter().map(row).filter(|row| row[1..].iter().any(|cell| cell != "–")).collect(),
    }
}

fn line_fits(record: &PeersRecord) -> Table {
    let row = |fit: &super::LineFit| {
        let times = [&fit.palb_ns, &fit.ours_ns, &fit.pass_ns].map(|samples| median(samples).unwrap_or(f64::NAN));
        let [palb, ours, pass] = times;
        let relative = (fit.palb_residual - fit.ours_residual) / fit.ours_residual;
        vec![
            size_name(fit.n),
            passes(palb / pass),
            passes(ours / pass),
            format!("{:.0}×", palb / ours),
            format!("{relative:.1e}"),
        ]
    };
    Table {
        caption:
            "The L1 line fit against the crate palb, in passes; last, by how much its sum of residuals exceeds ours."
                .to_owned(),
        head: ["points", "palb", "ours", "ratio", "excess of palb"].map(str::to_owned).to_vec(),
        rows: record.line_fits.iter().map(row).collect(),
    }
}
