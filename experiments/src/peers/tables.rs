//! The record as tables.

use super::record::{PeersRecord, median};
use crate::question::PLACEMENTS;
use families::bodies;
use std::collections::BTreeSet;

/// The names for people of the contenders that say whether two bodies meet.
const TITLES: &[(&str, &str)] = &[
    ("intersection", "ours: intersection of prepared bodies, with a proof of constant size"),
    ("intersection_written", "ours: the same, a coefficient of each generator written"),
    ("intersection_posed", "ours: of prepared bodies under poses"),
    ("intersection_of_rows", "ours: of bodies that were not prepared"),
    ("by_lad", "ours: the kernel on rows of generators"),
    ("gauge", "ours: exact gauge of a prepared body, with its proof"),
    ("by_lad_gauge", "ours: exact gauge, the kernel on rows of generators"),
    ("by_slope_selection", "Theorem 5.2 (slope selection)"),
    ("by_explicit_faces", "explicit faces"),
    ("by_gjk", "our GJK (rounded, shows its failures)"),
    ("parry_gjk", "parry3d-f64: GJK on a support map"),
    ("parry_gjk_posed", "parry3d-f64: GJK on bodies under poses"),
    ("parry_f32_gjk", "parry3d (single precision): GJK on a support map"),
    ("parry_polyhedron", "parry3d-f64: GJK on explicit polyhedra, made before"),
    ("clarabel", "clarabel: feasibility"),
    ("microlp", "microlp: feasibility"),
];

/// The names for people of the contenders that measure how far apart two bodies are, or how deep they overlap.
const MEASURES: &[(&str, &str)] = &[
    ("distance", "ours: distance within two units in the last place"),
    ("proximity", "ours: distance with points, faces and coefficients"),
    ("parry_distance", "parry3d-f64: distance by GJK"),
    ("penetration", "ours: penetration depth, proved within a hundredth"),
    ("parry_epa", "parry3d-f64: penetration depth by EPA"),
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

/// Every table of the record: time near contact, by gap, and when clear, distance and depth, wrong answers, how far
/// ours is ahead, the gauge family by family, the line fit.
pub fn tables(record: &PeersRecord) -> Vec<Table> {
    let yes_or_no = |what, placements| times(record, what, placements, TITLES);
    let measures = |what, placements| times(record, what, placements, MEASURES);
    vec![
        near_contact(record),
        yes_or_no("Near contact (relative gap 1e-6, both sides)", GAPS_OF_1E_6),
        yes_or_no("Near contact (relative gap 1e-3, both sides)", GAPS_OF_1E_3),
        yes_or_no("Touching", TOUCHING),
        yes_or_no("Clearly overlapping or separated", &["overlapping", "separated"]),
        measures("Distance and penetration depth, clearly overlapping or separated", &["overlapping", "separated"]),
        measures("Distance and penetration depth near contact (relative gap 1e-9)", GAPS_OF_1E_9),
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
    times(record, "Near contact (relative gap 1e-9, both sides)", GAPS_OF_1E_9, TITLES)
}

fn times(record: &PeersRecord, what: &str, placements: &[&str], contenders: &[(&str, &str)]) -> Table {
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
        caption: format!("{what}, in passes (and in time): medians over random bodies; a dash: not run."),
        head: ["method".to_owned()].into_iter().chain(head).collect(),
        rows: [&pass].into_iter().chain(contenders).map(row).filter(|row| is_known(row)).collect(),
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
        rows: TITLES.iter().chain(MEASURES).map(row).filter(|row| is_known(row)).collect(),
    }
}

/// A method of others beside ours on some questions.
struct Race {
    title: &'static str,
    /// The contender of ours, and that of others.
    between: [&'static str; 2],
    placements: &'static [&'static str],
    /// Of this family; of all families if there is none.
    family: Option<&'static str>,
}

const GAPS_OF_1E_9: &[&str] = &["inside_1e-9", "outside_1e-9"];
const GAPS_OF_1E_6: &[&str] = &["inside_1e-6", "outside_1e-6"];
const GAPS_OF_1E_3: &[&str] = &["inside_1e-3", "outside_1e-3"];
const TOUCHING: &[&str] = &["touching"];
const OVERLAPPING: &[&str] = &["overlapping"];
const SEPARATED: &[&str] = &["separated"];

/// A race on random bodies.
const fn random(title: &'static str, between: [&'static str; 2], placements: &'static [&'static str]) -> Race {
    Race { title, between, placements, family: Some("random_bodies") }
}

/// A race on the bodies of every family.
const fn every(title: &'static str, between: [&'static str; 2], placements: &'static [&'static str]) -> Race {
    Race { title, between, placements, family: None }
}

const PREPARED: [&str; 2] = ["intersection", "parry_gjk"];
const ROWS: [&str; 2] = ["intersection_of_rows", "parry_gjk"];
const POSED: [&str; 2] = ["intersection_posed", "parry_gjk_posed"];
const SINGLE: [&str; 2] = ["intersection", "parry_f32_gjk"];
const DISTANCE: [&str; 2] = ["distance", "parry_distance"];
const DEPTH: [&str; 2] = ["penetration", "parry_epa"];

/// The races: all of them in the report, those before [`OF_THE_REPORT_ALONE`] in README.
const RACES: [Race; 24] = [
    random("random bodies near contact (1e-9)", PREPARED, GAPS_OF_1E_9),
    random("random bodies, gap 1e-6", PREPARED, GAPS_OF_1E_6),
    random("random bodies, gap 1e-3", PREPARED, GAPS_OF_1E_3),
    random("random bodies touching", PREPARED, TOUCHING),
    random("random bodies overlapping", PREPARED, OVERLAPPING),
    random("random bodies separated", PREPARED, SEPARATED),
    every("all families near contact (1e-9)", PREPARED, GAPS_OF_1E_9),
    every("all families overlapping", PREPARED, OVERLAPPING),
    every("all families separated", PREPARED, SEPARATED),
    random("near contact, every coefficient written", ["intersection_written", "parry_gjk"], GAPS_OF_1E_9),
    random("under poses, near contact (1e-9)", POSED, GAPS_OF_1E_9),
    random("under poses, overlapping", POSED, OVERLAPPING),
    random("under poses, separated", POSED, SEPARATED),
    random("not prepared, near contact (1e-9)", ROWS, GAPS_OF_1E_9),
    random("not prepared, overlapping", ROWS, OVERLAPPING),
    random("not prepared, separated", ROWS, SEPARATED),
    random("parry's in single precision, near contact (1e-9)", SINGLE, GAPS_OF_1E_9),
    random("parry's in single precision, overlapping", SINGLE, OVERLAPPING),
    random("parry's in single precision, separated", SINGLE, SEPARATED),
    random("distance, separated", DISTANCE, SEPARATED),
    random("distance, near contact (1e-9)", DISTANCE, &["outside_1e-9"]),
    random("penetration depth, overlapping", DEPTH, OVERLAPPING),
    random("penetration depth, near contact (1e-9)", DEPTH, &["inside_1e-9"]),
    random("Theorem 5.2 in the place of parry's, near contact", ["by_lad", "by_slope_selection"], GAPS_OF_1E_9),
];

/// The number of the first race that README does not have.
const OF_THE_REPORT_ALONE: usize = 23;

/// The tables of README: near contact, the lead over parry, wrong answers.
pub fn tables_of_readme(record: &PeersRecord) -> [Table; 3] {
    [near_contact(record), lead(record, &RACES[..OF_THE_REPORT_ALONE]), wrong_answers(record)]
}

/// The number of times that our time goes into that of others, the race with the least median first.
fn lead(record: &PeersRecord, races: &[Race]) -> Table {
    let sizes: BTreeSet<usize> = record.cells.iter().map(|cell| cell.n).collect();
    let ratios = |race: &Race, n: usize| {
        let [ours, other] = race.between;
        let of_size = record.cells.iter().filter(|cell| cell.n == n);
        let chosen = of_size.filter(|cell| {
            race.placements.contains(&cell.placement.as_str()) && race.family.is_none_or(|family| cell.family == family)
        });
        chosen.flat_map(|cell| cell.ratios(other, ours)).collect::<Vec<_>>()
    };
    let least = |race: &Race| {
        let medians = sizes.iter().filter_map(|&n| median(&ratios(race, n)));
        medians.fold(f64::INFINITY, f64::min)
    };
    let mut races: Vec<(f64, &Race)> = races.iter().map(|race| (least(race), race)).collect();
    races.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let row = |race: &Race| {
        let cells = sizes.iter().map(|&n| middle_and(&ratios(race, n), f64::min));
        [race.title.to_owned()].into_iter().chain(cells).collect::<Vec<_>>()
    };
    Table {
        caption: "The time of parry's call over that of ours: median (least) over questions; the race with the least \
                  median first."
            .to_owned(),
        head: ["method"].into_iter().map(str::to_owned).chain(sizes.iter().map(|&n| size_name(n))).collect(),
        rows: races.iter().map(|(_, race)| row(race)).filter(|row| is_known(row)).collect(),
    }
}

fn gauge_by_family(record: &PeersRecord) -> Table {
    let sizes: BTreeSet<usize> = record.cells.iter().map(|cell| cell.n).filter(|n| SIZES.contains(n)).collect();
    let row = |family: &bodies::BodyFamily<3>| {
        let cells = sizes.iter().map(|&n| {
            let chosen = record.cells.iter().filter(|cell| cell.n == n && cell.family == family.id);
            middle_and(&chosen.flat_map(|cell| cell.ratios("gauge", "pass")).collect::<Vec<_>>(), f64::max)
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
