//! The one look of all figures: colours, line weights, text sizes.
//!
//! The colours of the objects are those of Okabe and Ito, which stay apart for every kind of colour vision; every
//! distinction is also carried by a second sign (dash, marker, label), so that a grey print reads as well. Fonts are
//! the generic `sans-serif`: the reader's machine chooses, and the layout leaves room for wide ones.

/// An opaque sRGB colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color {
    /// The components red, green and blue.
    pub rgb: [u8; 3],
}

impl Color {
    /// The colour with the given components.
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self { rgb: [red, green, blue] }
    }

    /// The colour in the notation of SVG, `#rrggbb`.
    pub fn hex(self) -> String {
        let [red, green, blue] = self.rgb;
        format!("#{red:02x}{green:02x}{blue:02x}")
    }

    /// The colour `part` of the way (in 1/256) from this one to `other`.
    pub const fn mixed(self, other: Self, part: u16) -> Self {
        const fn mix(a: u8, b: u8, part: u16) -> u8 {
            ((a as u16 * (256 - part) + b as u16 * part) / 256) as u8
        }
        let (a, b) = (self.rgb, other.rgb);
        Self::new(mix(a[0], b[0], part), mix(a[1], b[1], part), mix(a[2], b[2], part))
    }
}

/// Text and outlines.
pub const INK: Color = Color::new(0x1f, 0x24, 0x2b);
/// Secondary text, construction lines.
pub const GREY: Color = Color::new(0x6b, 0x72, 0x7c);
/// Frames, grids and what has been ruled out.
pub const PALE: Color = Color::new(0xc9, 0xce, 0xd6);
/// The page.
pub const PAPER: Color = Color::new(0xff, 0xff, 0xff);
/// The input: points and their hull.
pub const INPUT: Color = Color::new(0x00, 0x72, 0xb2);
/// The input reflected through the centre.
pub const REFLECTED: Color = Color::new(0xd5, 0x5e, 0x00);
/// The enclosing zonogon.
pub const ENCLOSING: Color = Color::new(0x00, 0x9e, 0x73);
/// The optimum.
pub const OPTIMUM: Color = Color::new(0xa8, 0x32, 0x7d);
/// The object that a step of an algorithm looks at.
pub const FOCUS: Color = Color::new(0xe6, 0x9f, 0x00);

/// A light blue beside the others.
const SKY: Color = Color::new(0x56, 0xb4, 0xe9);
/// A dark yellow beside the others.
const OLIVE: Color = Color::new(0x8a, 0x6d, 0x00);
/// A dark brown beside the others.
const BROWN: Color = Color::new(0x6e, 0x3b, 0x1f);

/// The colours of the series of a plot, in order of use, where series are no methods.
pub const SERIES: [Color; 6] = [INPUT, REFLECTED, ENCLOSING, OPTIMUM, SKY, OLIVE];

/// The colours of methods: a method has the same one in every plot. Where methods are compared, blue is the one that is
/// used by default, orange the paper's own, green the next exact one; other colours are for the rest.
const METHODS: [(&str, Color); 50] = [
    ("by_pruning", INPUT),
    ("by_control_points", INPUT),
    ("by_lad", INPUT),
    ("by_row_generation", INPUT),
    ("by_column_generation", INPUT),
    ("by_sweep", INPUT),
    ("cluster", INPUT),
    ("fresh", INPUT),
    ("by_scan", INPUT),
    ("by_discarding", INPUT),
    ("by_slope_selection", REFLECTED),
    ("by_space_time_volumes", REFLECTED),
    ("papers_program", REFLECTED),
    ("papers_net", REFLECTED),
    ("lemma_5_5", REFLECTED),
    ("by_dynamic_hull", REFLECTED),
    ("walking", REFLECTED),
    ("randomized", REFLECTED),
    ("by_cutting", REFLECTED),
    ("extreme_point_scan", REFLECTED),
    ("by_line_search", ENCLOSING),
    ("by_chord", ENCLOSING),
    ("by_explicit_faces", ENCLOSING),
    ("support_form", ENCLOSING),
    ("net_of_cells", ENCLOSING),
    ("trees", ENCLOSING),
    ("girard", ENCLOSING),
    ("by_monotone_chain", ENCLOSING),
    ("by_lad_location", ENCLOSING),
    ("by_direction_tree", ENCLOSING),
    ("by_gjk", OPTIMUM),
    ("by_conservative_advancement", OPTIMUM),
    ("combastel", OPTIMUM),
    ("warm", OPTIMUM),
    ("brute_force", OPTIMUM),
    ("clarabel", SKY),
    ("pca", SKY),
    ("microlp", OLIVE),
    ("scott", OLIVE),
    ("adaptive", GREY),
    ("zonotope_by_cost", BROWN),
    ("zonotope_6", INPUT),
    ("zonotope_5", REFLECTED),
    ("zonotope_4", ENCLOSING),
    ("zonotope_3", OPTIMUM),
    ("aabb", SKY),
    ("dop_18", FOCUS),
    ("dop_26", OLIVE),
    ("obb", INK),
    ("sphere", GREY),
];

/// The colour of the method with this id; ink for one that is compared with no other.
pub fn method_color(id: &str) -> Color {
    find_method_color(id).unwrap_or(INK)
}

/// The colour of the method with this id, if it is one of those that are compared.
pub(crate) fn find_method_color(id: &str) -> Option<Color> {
    METHODS.iter().find(|(method, _)| *method == id).map(|(_, color)| *color)
}

/// Line weights, in page units.
pub mod weight {
    /// Construction lines.
    pub const FINE: f64 = 0.8;
    /// Ordinary outlines.
    pub const MEDIUM: f64 = 1.4;
    /// The outline that the picture is about.
    pub const STRONG: f64 = 2.4;
}

/// Text sizes, in page units.
pub mod text_size {
    /// Names of points and lines.
    pub const LABEL: f64 = 14.0;
    /// Legends, notes, ticks.
    pub const NOTE: f64 = 12.5;
    /// Headings of panels.
    pub const HEADING: f64 = 14.5;
    /// The least size of any text, raised and lowered letters included; pages show drawings at their natural size.
    pub const LEAST: f64 = 9.0;
}

/// The dash pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// The line is unbroken.
    Solid,
    /// The line is broken into long strokes.
    Dashed,
    /// The line is broken into dots.
    Dotted,
}

impl Dash {
    /// The pattern of SVG, none for a solid line.
    pub const fn pattern(self) -> Option<&'static str> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some("6 4"),
            Self::Dotted => Some("1.5 3.5"),
        }
    }
}

/// The look of a line: colour, weight and dash pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// The colour of the line.
    pub color: Color,
    /// The weight of the line in page units.
    pub width: f64,
    /// The dash pattern of the line.
    pub dash: Dash,
    /// From 0 (invisible) to 1.
    pub opacity: f64,
}

impl Stroke {
    /// A solid line.
    pub const fn new(color: Color, width: f64) -> Self {
        Self { color, width, dash: Dash::Solid, opacity: 1.0 }
    }

    /// The same line, broken.
    pub const fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same line, let through.
    pub const fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }
}

/// An area's look: a fill of some opacity, an outline, or both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Paint {
    /// Colour and opacity of the inside.
    pub fill: Option<(Color, f64)>,
    /// The outline.
    pub stroke: Option<Stroke>,
}

impl Paint {
    /// Only the inside.
    pub const fn fill(color: Color, opacity: f64) -> Self {
        Self { fill: Some((color, opacity)), stroke: None }
    }

    /// Only the outline.
    pub const fn outline(stroke: Stroke) -> Self {
        Self { fill: None, stroke: Some(stroke) }
    }

    /// The same inside with an outline.
    pub const fn with_outline(self, stroke: Stroke) -> Self {
        Self { stroke: Some(stroke), ..self }
    }
}

/// The sign that marks a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A filled disc.
    Disc,
    /// A circle filled with the page's colour.
    Ring,
    /// A filled diamond.
    Diamond,
    /// A star of five rays.
    Star,
    /// A diagonal cross.
    Cross,
}

/// A point's look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Its sign.
    pub shape: Shape,
    /// Half of its width in page units.
    pub radius: f64,
    /// The colour of the line.
    pub color: Color,
}

impl Marker {
    /// The marker with these properties.
    pub const fn new(shape: Shape, radius: f64, color: Color) -> Self {
        Self { shape, radius, color }
    }
}

/// An input point.
pub const INPUT_POINT: Marker = Marker::new(Shape::Disc, 3.2, INPUT);
/// A reflected input point.
pub const REFLECTED_POINT: Marker = Marker::new(Shape::Ring, 3.2, REFLECTED);
/// A chosen centre.
pub const CENTER: Marker = Marker::new(Shape::Diamond, 5.0, INK);
/// The optimal centre.
pub const OPTIMAL_CENTER: Marker = Marker::new(Shape::Star, 7.5, OPTIMUM);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::FIGURES;
    use std::collections::BTreeSet;

    #[test]
    fn methods_that_are_compared_have_colours_of_their_own() {
        assert_eq!(METHODS.iter().map(|(id, _)| id).collect::<BTreeSet<_>>().len(), METHODS.len());
        let is_colored = |id: &str| METHODS.iter().any(|(method, _)| *method == id);
        let mut compared = 0;
        for experiment in FIGURES.iter().flat_map(|figure| figure.experiments) {
            let experiment = experiments::catalog::find(experiment).expect("another test finds them all");
            let ids: Vec<&str> = experiment.variants.iter().map(|variant| variant.id).collect();
            if !ids.iter().any(|id| is_colored(id)) {
                continue;
            }
            let colors: BTreeSet<[u8; 3]> = ids.iter().map(|id| method_color(id).rgb).collect();
            assert!(ids.iter().all(|id| is_colored(id)) && colors.len() == ids.len(), "{}: {ids:?}", experiment.id);
            compared += 1;
        }
        assert!(compared > 5, "{compared} experiments compare methods");
    }
}
