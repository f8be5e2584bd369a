//! Text with a little mathematics, and how much room it takes.
//!
//! Between dollar signs letters are slanted, `_` lowers and `^` raises the next character or `{group}`, and `'` is a
//! prime: `$P'_{a'_s}$` is the paper's name of a reflected point. Outside, text stands as it is.

use super::page::{PageBox, PagePoint, decimals};
use crate::style::{Color, PAPER, text_size};

/// Which point of the text lies at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The left end of the base line.
    Start,
    /// The middle of the base line.
    Middle,
    /// The right end of the base line.
    End,
}

/// A run of characters of one size and slant.
#[derive(Clone, Debug, PartialEq)]
struct Run {
    text: String,
    slanted: bool,
    /// Size relative to the text's.
    size: f64,
    /// Height of the base line above the text's, in text sizes.
    rise: f64,
}

impl Run {
    /// Height of its letters in page units: raised and lowered letters are smaller, down to the least size.
    fn height(&self, style: &TextStyle) -> f64 {
        (self.size * style.size).max(text_size::LEAST.min(style.size))
    }
}

/// A parsed line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    runs: Vec<Run>,
}

/// The look of a line of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextStyle {
    /// Height of a line in page units.
    pub size: f64,
    /// Colour of the letters.
    pub color: Color,
    /// Heavy letters.
    pub bold: bool,
    /// Width of the rim of paper around the letters, 0 for none.
    pub halo: f64,
}

impl TextStyle {
    /// Ordinary letters without a rim.
    pub const fn new(size: f64, color: Color) -> Self {
        Self { size, color, bold: false, halo: 0.0 }
    }

    /// The same letters, heavy.
    pub const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same letters with a rim of paper that keeps them readable over lines.
    pub const fn haloed(self) -> Self {
        Self { halo: 3.5, ..self }
    }
}

const SUBSCRIPT_SIZE: f64 = 0.72;
const SUBSCRIPT_DROP: f64 = 0.26;
const SUPERSCRIPT_RISE: f64 = 0.38;
/// The distance that a slanted letter leans over what follows: a prime moves out of its way.
const LEAN: f64 = 0.1;

impl Line {
    /// Reads the notation of the module's head; unbalanced braces and dollars close at the end.
    pub fn parse(source: &str) -> Self {
        let mut line = Self { runs: Vec::new() };
        for (part, text) in source.split('$').enumerate() {
            if part % 2 == 0 {
                for character in text.chars() {
                    line.push(character, false, 1.0, 0.0);
                }
            } else {
                line.parse_mathematics(&mut text.chars().peekable(), 1.0, 0.0);
            }
        }
        line
    }

    fn parse_mathematics(&mut self, rest: &mut std::iter::Peekable<std::str::Chars<'_>>, size: f64, rise: f64) {
        while let Some(character) = rest.next() {
            let shift = match character {
                '}' => return,
                '_' => -SUBSCRIPT_DROP,
                '^' => SUPERSCRIPT_RISE,
                '\'' => {
                    self.push('′', false, size, rise);
                    continue;
                }
                _ => {
                    self.push(character, character.is_alphabetic(), size, rise);
                    continue;
                }
            };
            let (inner_size, inner_rise) = (size * SUBSCRIPT_SIZE, rise + shift * size);
            match rest.next() {
                Some('{') => self.parse_mathematics(rest, inner_size, inner_rise),
                Some(single) => self.push(single, single.is_alphabetic(), inner_size, inner_rise),
                None => return,
            }
        }
    }

    fn push(&mut self, character: char, slanted: bool, size: f64, rise: f64) {
        match self.runs.last_mut() {
            Some(run) if run.slanted == slanted && run.size == size && run.rise == rise => {
                run.text.push(character);
            }
            _ => self.runs.push(Run { text: character.into(), slanted, size, rise }),
        }
    }

    /// Its width in a wide sans-serif font of the given style: an upper estimate.
    pub fn width(&self, style: &TextStyle) -> f64 {
        let weight = if style.bold { 1.12 } else { 1.0 };
        self.runs.iter().map(|run| run.text.chars().map(advance).sum::<f64>() * run.height(style) * weight).sum()
    }

    /// The rectangle that its letters fill when it stands at `place`.
    pub fn extent(&self, place: PagePoint, anchor: Anchor, style: &TextStyle) -> PageBox {
        let width = self.width(style);
        let left = match anchor {
            Anchor::Start => place.x,
            Anchor::Middle => place.x - width / 2.0,
            Anchor::End => place.x - width,
        };
        let lowest = self.runs.iter().map(|run| run.rise - 0.22 * run.size).fold(0.0, f64::min);
        let highest = self.runs.iter().map(|run| run.rise + 0.76 * run.size).fold(0.0, f64::max);
        PageBox {
            min: PagePoint::new(left, place.y - highest * style.size),
            max: PagePoint::new(left + width, place.y - lowest * style.size),
        }
    }

    /// The SVG element; below it one more that is the rim of paper, if the style has one. They are two because not
    /// every program knows the attribute that paints the rim of a text first.
    pub fn element(&self, place: PagePoint, anchor: Anchor, style: &TextStyle) -> String {
        let rim = format!(
            " aria-hidden=\"true\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
            PAPER.hex(),
            decimals(style.halo)
        );
        let below = if style.halo > 0.0 { self.painted(place, anchor, style, PAPER, &rim) } else { String::new() };
        below + &self.painted(place, anchor, style, style.color, "")
    }

    /// One element with further attributes. Written in one piece: between the runs white space would show.
    fn painted(&self, place: PagePoint, anchor: Anchor, style: &TextStyle, color: Color, further: &str) -> String {
        let mut element = format!(
            "<text xml:space=\"preserve\" x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\" fill=\"{}\"",
            decimals(place.x),
            decimals(place.y),
            decimals(style.size),
            color.hex()
        );
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => element.push_str(" text-anchor=\"middle\""),
            Anchor::End => element.push_str(" text-anchor=\"end\""),
        }
        if style.bold {
            element.push_str(" font-weight=\"bold\"");
        }
        element.push_str(further);
        element.push('>');
        let mut rise = 0.0;
        let mut after_slanted = false;
        for run in &self.runs {
            let lean = std::mem::replace(&mut after_slanted, run.slanted) && run.text.starts_with('′');
            let text = escaped(&run.text);
            if run.size == 1.0 && run.rise == rise && !run.slanted && !lean {
                element.push_str(&text);
                continue;
            }
            element.push_str("<tspan");
            if run.rise != rise {
                element.push_str(&format!(" dy=\"{}\"", decimals((rise - run.rise) * style.size)));
                rise = run.rise;
            }
            if lean {
                element.push_str(&format!(" dx=\"{}\"", decimals(LEAN * run.size * style.size)));
            }
            if run.size != 1.0 {
                element.push_str(&format!(" font-size=\"{}\"", decimals(run.height(style))));
            }
            if run.slanted {
                element.push_str(" font-style=\"italic\"");
            }
            element.push('>');
            element.push_str(&text);
            element.push_str("</tspan>");
        }
        element.push_str("</text>");
        element
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The advance width of a character in ems, as in DejaVu Sans, one of the widest fonts behind `sans-serif`.
fn advance(character: char) -> f64 {
    match character {
        'i' | 'j' | 'l' | '\'' | '|' | '′' => 0.29,
        ' ' | '.' | ',' | ':' | ';' | 'I' | '·' => 0.33,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' | '/' => 0.41,
        's' | 'c' | 'z' | 'v' | 'x' | 'y' | 'k' | 'J' => 0.57,
        'm' | 'w' | 'M' | 'W' | '…' | '—' => 1.0,
        '×' | '+' | '=' | '−' | '<' | '>' | '≤' | '≥' | '≈' | '±' | '→' => 0.84,
        'A'..='Z' => 0.72,
        _ => 0.635,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::INK;

    fn levels(source: &str) -> Vec<(String, bool, i32)> {
        Line::parse(source)
            .runs
            .into_iter()
            .map(|run| (run.text, run.slanted, libm::round(run.rise * 1000.0) as i32))
            .collect()
    }

    #[test]
    fn nested_subscripts_and_primes() {
        assert_eq!(
            levels("at $P'_{a'_s}$"),
            [
                ("at ".into(), false, 0),
                ("P".into(), true, 0),
                ("′".into(), false, 0),
                ("a".into(), true, -260),
                ("′".into(), false, -260),
                ("s".into(), true, -447),
            ]
        );
    }

    #[test]
    fn base_line_returns_after_a_subscript() {
        let element =
            Line::parse("$x_1$ ok").element(PagePoint::new(0.0, 0.0), Anchor::Start, &TextStyle::new(10.0, INK));
        assert!(
            element.ends_with("dy=\"2.6\" font-size=\"9\">1</tspan><tspan dy=\"-2.6\"> ok</tspan></text>"),
            "{element}"
        );
    }

    #[test]
    fn the_rim_of_a_text_is_an_element_below_it() {
        let style = TextStyle::new(10.0, INK).haloed();
        let elements = Line::parse("$x$").element(PagePoint::new(1.0, 2.0), Anchor::Start, &style);
        let (rim, letters) = elements.split_once("</text><text").expect("two elements");
        assert!(rim.contains("fill=\"#ffffff\" aria-hidden=\"true\" stroke=\"#ffffff\" stroke-width=\"3.5\""), "{rim}");
        assert!(letters.contains("fill=\"#1f242b\"") && !letters.contains("stroke"), "{letters}");
    }

    #[test]
    fn markup_in_data_is_escaped() {
        let element =
            Line::parse("a<b & c").element(PagePoint::new(0.0, 0.0), Anchor::Start, &TextStyle::new(10.0, INK));
        assert!(element.ends_with(">a&lt;b &amp; c</text>"), "{element}");
    }

    #[test]
    fn extent_follows_the_anchor() {
        let (line, style) = (Line::parse("abc"), TextStyle::new(10.0, INK));
        let width = line.width(&style);
        let place = PagePoint::new(50.0, 50.0);
        assert_eq!(line.extent(place, Anchor::Start, &style).min.x, 50.0);
        assert_eq!(line.extent(place, Anchor::End, &style).max.x, 50.0);
        assert_eq!(line.extent(place, Anchor::Middle, &style).min.x, 50.0 - width / 2.0);
    }
}
