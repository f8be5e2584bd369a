//! The methods of other libraries beside ours: tables made from the committed record.

use experiments::peers::{PeersRecord, Table, median};

use crate::report::html::{Escaped, grouped, prose, table};

/// The placements of questions near contact.
const NEAR_CONTACT: [&str; 2] = ["inside_1e-9", "outside_1e-9"];

/// The section with every table of the record, the first one open; empty if nothing has been recorded.
pub(super) fn section() -> String {
    let record = experiments::peers::committed().expect("a test reads the committed record");
    let Some(environment) = &record.environment else { return String::new() };
    let mut text = format!(
        "<section id=\"peers\">\n<h2>Beside other libraries</h2>\n\
         <p class=\"statement\">The same questions to each method, turn by turn. A pass is one vectorised evaluation \
         of the support function over the same generators, timed in the same run: what reads its input once needs \
         one at least. The truth about a question comes from its construction.</p>\n{}\
         <p><small>Recorded once, on one machine ({}; {}), by <code>cargo run --release -p peers --features \
         others</code>; committed as <code>experiments/data/peers.json</code> with every raw sample.</small></p>\n",
        lesson(&record).map_or_else(String::new, |lesson| {
            format!("<p class=\"lesson\"><b>What we learned.</b> {}</p>\n", prose(&lesson))
        }),
        Escaped(&environment.cpu),
        Escaped(&environment.toolchain),
    );
    for (index, shown) in experiments::peers::tables(&record).iter().enumerate() {
        text.push_str(&match index {
            0 => format!("<p>{}</p>\n{}", prose(&shown.caption), markup(shown)),
            _ => format!("<details>\n<summary>{}</summary>\n{}</details>\n", prose(&shown.caption), markup(shown)),
        });
    }
    text.push_str("</section>\n");
    text
}

fn markup(shown: &Table) -> String {
    let head: Vec<String> = shown.head.iter().map(|cell| prose(cell)).collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let rows: Vec<Vec<String>> = shown.rows.iter().map(|row| row.iter().map(|cell| prose(cell)).collect()).collect();
    table("peers", &head, &rows)
}

/// Time and wrong answers near contact, ours beside the best known other library.
fn lesson(record: &PeersRecord) -> Option<String> {
    let cells = || record.cells.iter().filter(|cell| NEAR_CONTACT.contains(&cell.placement.as_str()));
    let random = || cells().filter(|cell| cell.family == "random_bodies");
    let largest = random().map(|cell| cell.n).max()?;
    let at_largest = || random().filter(|cell| cell.n == largest);
    let passes = |method| median(&at_largest().flat_map(|cell| cell.ratios(method, "pass")).collect::<Vec<_>>());
    let wrong = |method| {
        let entries = cells().filter_map(|cell| cell.entry(method));
        let [wrong, asked] =
            entries.fold([0_u64; 2], |[w, a], entry| [w + u64::from(entry.wrong), a + u64::from(entry.asked)]);
        format!("{} of {}", grouped(wrong), grouped(asked))
    };
    Some(format!(
        "Where bodies of {} generators almost touch, an intersection with its proof takes {:.1} passes of ours, \
         prepared, and {:.1} of parry's GJK in double precision; with gaps of 1e-9 ours answers {} questions wrong \
         and parry's {}.",
        grouped(largest as u64),
        passes("intersection")?,
        passes("parry_gjk")?,
        wrong("intersection"),
        wrong("parry_gjk")
    ))
}
