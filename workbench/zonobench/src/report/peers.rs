//! The methods of other libraries beside ours: tables made from the committed record.

use super::html::{Escaped, table};

/// The section with every table of the record; empty if nothing has been recorded.
pub(super) fn section() -> String {
    let record = experiments::peers::committed().expect("a test reads the committed record");
    let Some(environment) = &record.environment else { return String::new() };
    let mut text = format!(
        "<section id=\"peers\">\n<h2>Beside other libraries</h2>\n\
         <p>The same questions to each method, turn by turn. A pass is one vectorised evaluation of the support \
         function over the same generators, timed in the same run: what reads its input once cannot be faster. The \
         truth about a question comes from its construction. Recorded once, on one machine ({}; {}), by <code>cargo \
         run --release -p peers --features others</code>; committed as <code>experiments/data/peers.json</code> with \
         every raw sample.</p>\n",
        Escaped(&environment.cpu),
        Escaped(&environment.toolchain),
    );
    for shown in experiments::peers::tables(&record) {
        let head: Vec<&str> = shown.head.iter().map(String::as_str).collect();
        let rows: Vec<Vec<String>> =
            shown.rows.iter().map(|row| row.iter().map(|cell| Escaped(cell).to_string()).collect()).collect();
        text.push_str(&format!("<p>{}</p>\n{}", Escaped(&shown.caption), table("peers", &head, &rows)));
    }
    text.push_str("</section>\n");
    text
}
