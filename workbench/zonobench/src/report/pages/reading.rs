//! The end of the report: how to read it, to repeat it and to cite it.

use crate::report::Evidence;
use crate::report::html::Escaped;

/// The citation of the workbench, as a file of its own beside the report.
pub const CITATION: &str = include_str!("../../../../../CITATION.cff");

/// The paper and the workbench, for a bibliography.
const BIBLIOGRAPHY: &str = include_str!("../citation.bib");

/// The section.
pub(super) fn section(evidence: &Evidence) -> String {
    format!(
        "<section id=\"reading\">\n<h2>How to read, repeat and cite this</h2>\n\
         <details><summary>How growth and claims are judged</summary>\n<p><b>Growth</b> is judged on operation counts, \
         which are the same on every machine. An exponent <i>a</i> is that of the best power law <i>n<sup>a</sup></i> \
         over the sizes shown, with its 95 % interval; every law is fitted over all sizes and over the last four \
         doublings, and where it is fitted on less than that, the table says so. “Beyond it” is the exponent that \
         remains after division by the bound. If its whole interval is at most 0.05, a slack that was fixed \
         beforehand, the count is <i>within the bound</i>, and if all of it is under −0.05, <i>below the bound</i>, \
         which a bound from above allows; if all of it is over 0.05, it is <i>above the bound</i>; and an interval \
         that also reaches beyond 0.05 leaves the bound <i>undecided</i>. A bound that has its constant with it is a \
         number, which every sample keeps or breaks; beside it stands the largest sample. Bounds that the paper states \
         are named after their place there, the others are our own. “Bend” is an F test: whether the means of the \
         sizes miss the law by more than the instances of a size differ. Where they do, the interval rests on the \
         means alone; where the instances of a size are equal, or there is one, nothing can be tested. “Closest” names \
         the law that fits best of those that were compared. Where counts that have to read the whole input seem to \
         grow slower than it, <i>lower-order terms show</i>, and they are not called below the bound.</p>\n\
         <p><b>Claims</b> are checked in exact arithmetic on instances from a fixed seed. “Holds” means that it held \
         on instances of several kinds, or of the one kind that it is about; a statement about any dimension that was \
         tried in one alone “holds where tried”; each correction shows a witness.</p>\n\
         </details>\n\
         <p><b>Everything here</b> comes from the profile {} with seed {}. <a \
         href=\"manifest.json\"><code>manifest.json</code></a> lists every file with its hash and says which ones \
         must not change from run to run; <a href=\"records/counts.jsonl\"><code>records/counts.jsonl</code></a> holds \
         the counts, and each experiment has them as CSV. What the clock said, and on which <a \
         href=\"times.html#machine\">machine</a>, stands in <a \
         href=\"times.html\"><code>times.html</code></a>.</p>\n\
         <pre tabindex=\"0\"><code>{}</code></pre>\n\
         <details><summary>To cite the paper and the workbench</summary>\n<p>The same as a file: <a \
         href=\"CITATION.cff\">CITATION.cff</a>.</p>\n\
         <pre tabindex=\"0\"><code>{}</code></pre>\n</details>\n</section>\n",
        evidence.profile,
        evidence.seed,
        Escaped(&evidence.command()),
        Escaped(BIBLIOGRAPHY)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a field, between quotation marks or braces or to the end of the line.
    fn value<'a>(text: &'a str, field: &str) -> &'a str {
        let line = text.lines().find(|line| line.trim_start().starts_with(field)).expect("the field is there");
        let (_, value) = line.split_once([':', '=']).expect("it has a value");
        value.trim().trim_end_matches(',').trim_matches(['{', '}', '"'])
    }

    #[test]
    fn the_bibliography_agrees_with_the_citation_file() {
        let (software, paper) = CITATION.split_once("references:").expect("the paper is referred to");
        let (of_paper, of_software) = BIBLIOGRAPHY.split_once("@software").expect("an entry for each");
        assert_eq!(value(of_paper, "title"), value(paper, "title"));
        assert_eq!(value(of_paper, "year"), value(paper, "year"));
        assert_eq!(value(of_paper, "booktitle"), value(paper, "collection-title"));
        assert_eq!(value(of_paper, "pages"), format!("{}--{}", value(paper, "start"), value(paper, "end")));
        for name in paper.lines().filter_map(|line| line.trim().strip_prefix("- family-names: ")) {
            assert!(of_paper.contains(&format!("{name}, ")), "{name}");
        }
        assert_eq!(value(of_paper, "url"), value(paper, "url"));
        assert_eq!(value(of_paper, "publisher"), value(paper, "name:"));
        assert!(value(software, "date-released").starts_with(value(of_software, "year")));
        assert_eq!(value(of_software, "title"), value(software, "title"));
        assert_eq!(value(of_software, "version"), value(software, "version"));
        assert_eq!(value(software, "version"), env!("CARGO_PKG_VERSION"));
    }
}
