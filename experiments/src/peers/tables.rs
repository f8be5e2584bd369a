//! The record as tables.

use super::record::{PeersRecord, median};
use crate::question::PLACEMENTS;
use families::bodies;
use std::collections::BTreeSet;

/// The name for people of a contender.
const TITLES: &[(&str, &str)] = &[
    ("by_lad", "ours: location, with its proof"),
    ("by_lad_gauge", "ours: exact gauge, with its proof"),
    ("by_lad_prepared", "ours: location, of prepared bodies"),
    ("intersection", "ours: intersection of prepared bodies, its proof of constant size"),
    ("intersection_written", "ours: the same, a coefficient of each generator written"),
    ("by_lad_gauge_prepared", "ours: exact gauge, of prepared bodies"),
    ("by_slope_selection", "Theorem 5.2 (slope selection)"),
    ("by_explicit_faces", "explicit faces"),
    ("by_gjk", "our GJK (rounded, shows its failures)"),
    ("parry_gjk", "parry3d-f64: GJK on a support map"),
    ("parry_f32_gjk", "parry3d (single precision): GJK on a support map"),
    ("parry_polyhedron", "parry3d-f64: GJK on explicit polyhedra, made before"),
    ("clarabel", "clarabel: feasibility"),
    ("microlp", "microlp: feasibility"),
];

/// The sizes of the tables for people; the record has more.
const SIZES: [usize; 5] = [6, 1 << 10, 1 << 12, 1 << 16, 1 << 20];

/// A table of text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// The content, in a sentence.
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

/// Every table of the record: time near contact and when clear, wrong answers, how far ours is ahead, the gauge family
/// by family, the line fit.
pub fn tables(record: &PeersRecord) -> Vec<Table> {
    vec![
        near_contact(record),
        times(record, "Clearly overlapping or separated, in passes", &["overlapping", "separated"]),
        wrong_answers(record),
        lead(record, &RACES),
        gauge_by_family(record),
        line_fits(record),
    ]
}

fn size_name(n: usize) -> String {
    if n > 4096 && n.is_power_of_two() { format!("2^{}", n.ilog2()) } else { n.to_string() }
}

fn passes(value: f64) -> String {
    match value {
        value if value < 0.095 => format!("{value:.3}"),
        value if value < 0.995 => format!("{value:.2}"),
        value if value < 99.5 => format!("{value:.1}"),
        value => format!("{value:.0}"),
    }
}

/// A time in nanoseconds, as text.
fn duration(ns: f64) -> String {
    match ns {
        ns if ns < 999.5 => format!("{ns:.0} ns"),
        ns if ns < 9.95e3 => format!("{:.1} µs", ns / 1e3),
        ns if ns < 999.5e3 => format!("{:.0} µs", ns / 1e3),
        ns => format!("{:.1} ms", ns / 1e6),
    }
}

/// The middle of some ratios, as text.
fn middle(ratios: &[f64]) -> String {
    median(ratios).map_or_else(|| "–".to_owned(), passes)
}

/// The middle of some ratios and another of them, as text.
fn middle_and(ratios: &[f64], other: fn(f64, f64) -> f64) -> String {
    let Some(other) = ratios.iter().copied().reduce(other) else { return "–".to_owned() };
    format!("{} ({})", middle(ratios), passes(other))
}

/// Whether any of a row's cells says something.
fn is_known(row: &[String]) -> bool {
    row[1..].iter().any(|cell| cell != "–")
}

fn near_contact(record: &PeersRecord) -> Table {
    times(record, "Near contact (relative gap 1e-9, both sides), in passes", GAPS_OF_1E_9)
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
        let cell = |&n: &usize| {
            let ratios: Vec<f64> = chosen(n).flat_map(|cell| cell.ratios(method, "pass")).collect();
            let times: Vec<f64> = chosen(n).flat_map(|cell| cell.times(method)).collect();
            median(&times).map_or_else(|| "–".to_owned(), |time| format!("{} ({})", middle(&ratios), duration(time)))
        };
        [title.to_owned()].into_iter().chain(SIZES.iter().map(cell)).collect::<Vec<_>>()
    };
    let pass = ("pass", "one pass");
    let head = SIZES.iter().map(|&n| if n == SIZES[0] { "n = 6 (two boxes)".to_owned() } else { size_name(n) });
    Table {
        caption: format!("{what} (and in time): medians over random bodies; a dash: not run."),
        head: ["method".to_owned()].into_iter().chain(head).collect(),
        rows: [&pass].into_iter().chain(TITLES).map(row).filter(|row| is_known(row)).collect(),
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
        caption: "Wrong answers among all questions asked; the truth is known from each question's construction."
            .to_owned(),
        head: ["method"].into_iter().chain(groups.map(|(name, _)| name)).map(str::to_owned).collect(),
        rows: TITLES.iter().map(row).filter(|row| is_known(row)).collect(),
    }
}

/// A method of others beside our location on some questions.
struct Race {
    title: &'static str,
    method: &'static str,
    placements: &'static [&'static str],
    /// Of this family; of all families if there is none.
    family: Option<&'static str>,
    /// The contender that it runs against.
    ours: &'static str,
}

const GAPS_OF_1E_9: &[&str] = &["inside_1e-9", "outside_1e-9"];
const RANDOM: Option<&str> = Some("random_bodies");

/// Our location of prepared bodies against a method of others.
const fn prepared(
    title: &'static str,
    method: &'static str,
    placements: &'static [&'static str],
    family: Option<&'static str>,
) -> Race {
    Race { title, method, placements, family, ours: "by_lad_prepared" }
}

/// The races of the report.
const RACES: [Race; 7] = [
    Race {
        ours: "by_lad",
        ..prepared(
            "parry's GJK, random bodies near contact, ours on rows as they come",
            "parry_gjk",
            GAPS_OF_1E_9,
            RANDOM,
        )
    },
    prepared("parry's GJK, random bodies near contact", "parry_gjk", GAPS_OF_1E_9, RANDOM),
    prepared("parry's GJK, random bodies overlapping", "parry_gjk", &["overlapping"], RANDOM),
    prepared("parry's GJK, random bodies separated", "parry_gjk", &["separated"], RANDOM),
    prepared("parry's GJK, all families overlapping", "parry_gjk", &["overlapping"], None),
    prepared("parry's GJK, all families separated", "parry_gjk", &["separated"], None),
    Race {
        title: "Theorem 5.2, random bodies near contact",
        method: "by_slope_selection",
        placements: GAPS_OF_1E_9,
        family: RANDOM,
        ours: "by_lad",
    },
];

/// The races of README: those that ours win and those that they lose.
const RACES_OF_README: [Race; 10] = [
    prepared("random bodies near contact", "parry_gjk", GAPS_OF_1E_9, RANDOM),
    prepared("random bodies overlapping", "parry_gjk", &["overlapping"], RANDOM),
    prepared("random bodies separated", "parry_gjk", &["separated"], RANDOM),
    prepared("random bodies touching", "parry_gjk", &["touching"], RANDOM),
    prepared("all families near contact", "parry_gjk", GAPS_OF_1E_9, None),
    prepared("all families overlapping", "parry_gjk", &["overlapping"], None),
    prepared("all families separated", "parry_gjk", &["separated"], None),
    prepared("random bodies near contact, parry's in single precision", "parry_f32_gjk", GAPS_OF_1E_9, RANDOM),
    prepared("random bodies overlapping, parry's in single precision", "parry_f32_gjk", &["overlapping"], RANDOM),
    prepared("random bodies separated, parry's in single precision", "parry_f32_gjk", &["separated"], RANDOM),
];

/// The tables of README: near contact, the lead over parry's GJK, wrong answers.
pub fn tables_of_readme(record: &PeersRecord) -> [Table; 3] {
    let lead = Table {
        caption:
            "The time of parry's GJK over that of our location with its proof, of prepared bodies: median (least)."
                .to_owned(),
        ..lead(record, &RACES_OF_README)
    };
    [near_contact(record), lead, wrong_answers(record)]
}

/// The number of times that our location's time goes into that of others.
fn lead(record: &PeersRecord, races: &[Race]) -> Table {
    let sizes: BTreeSet<usize> = record.cells.iter().map(|cell| cell.n).collect();
    let row = |race: &Race| {
        let cells = sizes.iter().map(|&n| {
            let of_size = record.cells.iter().filter(|cell| cell.n == n);
            let chosen = of_size.filter(|cell| {
                race.placements.contains(&cell.placement.as_str())
                    && race.family.is_none_or(|family| cell.family == family)
            });
            middle_and(&chosen.flat_map(|cell| cell.ratios(race.method, race.ours)).collect::<Vec<_>>(), f64::min)
        });
        [race.title.to_owned()].into_iter().chain(cells).collect::<Vec<_>>()
    };
    Table {
        caption: "How often the time of our location with its proof goes into that of others, of bodies that were \
                  prepared for both: median (least) over questions; below 1 the other is faster."
            .to_owned(),
        head: ["method"].into_iter().map(str::to_owned).chain(sizes.iter().map(|&n| size_name(n))).collect(),
        rows: races.iter().map(row).filter(|row| is_known(row)).collect(),
    }
}

fn gauge_by_family(record: &PeersRecord) -> Table {
    let sizes: BTreeSet<usize> = record.cells.iter().map(|cell| cell.n).filter(|n| SIZES.contains(n)).collect();
    let row = |family: &bodies::BodyFamily<3>| {
        let cells = sizes.iter().map(|&n| {
            let chosen = record.cells.iter().filter(|cell| cell.n == n && cell.family == family.id);
            middle_and(
                &chosen.flat_map(|cell| cell.ratios("by_lad_gauge_prepared", "pass")).collect::<Vec<_>>(),
                f64::max,
            )
        });
        [family.title.to_owned()].into_iter().chain(cells).collect::<Vec<_>>()
    };
    Table {
        caption: "The exact gauge of prepared bodies with its proof, in passes: median (largest) over all placements."
            .to_owned(),
        head: ["family".to_owned()].into_iter().chain(sizes.iter().map(|&n| size_name(n))).collect(),
        rows: bodies::BODY_FAMILIES.iter().map(row).filter(|row| is_known(row)).collect(),
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
