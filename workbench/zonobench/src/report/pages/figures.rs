//! Figures within a page.

use crate::report::DrawnFigure;
use figures::figure::{Figure, FigureInput};

use crate::report::html::{Escaped, prose};
use crate::report::repeat::{Repeat, shown};

impl DrawnFigure {
    /// Draws a figure.
    pub fn draw(figure: &'static Figure, input: &FigureInput) -> Self {
        Self { figure, drawing: figure.draw(input).map_err(|error| error.to_string()) }
    }

    /// Its file in the report's folder.
    pub fn path(&self) -> String {
        format!("figures/{}.svg", self.figure.id)
    }
}

/// The figures with their captions, the drawings within the page; `number` has each one's place in the page, from 0.
pub(super) fn plates(
    figures: &[&DrawnFigure],
    repeat: Repeat,
    number: impl Fn(&DrawnFigure) -> Option<usize>,
) -> String {
    figures.iter().map(|figure| plate(figure, repeat, number(figure))).collect()
}

fn plate(drawn: &DrawnFigure, repeat: Repeat, number: Option<usize>) -> String {
    let figure = drawn.figure;
    let drawing = match &drawn.drawing {
        Ok(svg) => inlined(svg, figure.id),
        Err(reason) => format!("<p class=\"missing\">Not drawn: {}</p>", Escaped(reason)),
    };
    format!(
        "<figure id=\"figure-{}\">\n<div class=\"plate\" tabindex=\"0\">{drawing}</div>\n\
         <figcaption><b>{}{}.</b> {}<br><small>{}</small></figcaption>\n</figure>\n",
        figure.id,
        number.map_or_else(String::new, |number| format!("Figure {}. ", number + 1)),
        prose(figure.title),
        prose(figure.caption),
        sources(drawn, repeat).join(" · ")
    )
}

/// Links to the drawing as a file, and to the numbers that it shows; the command that draws it again.
fn sources(drawn: &DrawnFigure, repeat: Repeat) -> Vec<String> {
    let mut links = Vec::new();
    if drawn.drawing.is_ok() {
        links.push(format!("<a href=\"{}\">SVG</a>", drawn.path()));
    }
    let sort = if drawn.figure.deterministic { "counts" } else { "times" };
    for id in drawn.figure.experiments {
        links.push(format!("<a href=\"records/{id}.{sort}.csv\">numbers as CSV</a>"));
        links.push(format!("<a href=\"records/{sort}.jsonl\">record</a> of <a href=\"#experiment-{id}\">{id}</a>"));
    }
    links.extend(repeat.figure(drawn.figure).map(|command| shown(&command)));
    links
}

/// The document's root element, its ids made unique within the page by a prefix.
fn inlined(svg: &str, prefix: &str) -> String {
    let root = svg.find("<svg").map_or(svg, |start| &svg[start..]);
    root.replace(" id=\"", &format!(" id=\"{prefix}-"))
        .replace("url(#", &format!("url(#{prefix}-"))
        .replace("href=\"#", &format!("href=\"#{prefix}-"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inlined_drawings_do_not_share_ids() {
        let svg =
            "<?xml version=\"1.0\"?>\n<svg><clipPath id=\"c\"/><g clip-path=\"url(#c)\"><use href=\"#c\"/></g></svg>";
        let expected = "<svg><clipPath id=\"f-c\"/><g clip-path=\"url(#f-c)\"><use href=\"#f-c\"/></g></svg>";
        assert_eq!(inlined(svg, "f"), expected);
    }
}
