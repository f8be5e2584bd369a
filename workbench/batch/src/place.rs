//! Places in an input, in words.

use std::fmt;

/// One step on the way from the input down to a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// Into a field of an object.
    Field(String),
    /// Into an element of a list, counted from 0.
    Element(usize),
}

/// A place in an input: `a`, `generators`, 3, 1 reads "a, generator 4, coordinate 2".
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Place(pub(super) Vec<Step>);

impl Place {
    /// The place one step further down.
    pub(super) fn then(&self, step: Step) -> Self {
        Self(self.0.iter().cloned().chain([step]).collect())
    }

    /// The place of a field below this one.
    pub(super) fn field(&self, name: &str) -> Self {
        self.then(Step::Field(name.to_owned()))
    }

    /// The place of an element below this one.
    pub(super) fn element(&self, index: usize) -> Self {
        self.then(Step::Element(index))
    }

    /// Whether this is the place of a field with one of the names, in the object that the fields `within` lead to.
    pub(super) fn is_field_of(&self, within: &[&str], names: &[&str]) -> bool {
        let is_named =
            |step: &Step, names: &[&str]| matches!(step, Step::Field(name) if names.contains(&name.as_str()));
        let Some((last, above)) = self.0.split_last() else { return false };
        let leads_there =
            above.len() == within.len() && above.iter().zip(within).all(|(step, &name)| is_named(step, &[name]));
        leads_there && is_named(last, names)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut words: Vec<String> = Vec::new();
        let mut plural = false;
        let mut element = "coordinate";
        for step in &self.0 {
            match step {
                Step::Field(name) => {
                    plural = name.len() > 1 && name.ends_with('s');
                    element = match name.as_str() {
                        "k" => "entry",
                        "matrix" => "row",
                        "triangles" => "corner",
                        _ => "coordinate",
                    };
                    words.push(name.clone());
                }
                Step::Element(index) if plural => {
                    let name = words.pop().unwrap_or_default();
                    let one = if name == "vertices" { "vertex" } else { name.trim_end_matches('s') };
                    words.push(format!("{one} {}", index + 1));
                    plural = false;
                }
                Step::Element(index) => {
                    words.push(format!("{element} {}", index + 1));
                    element = if element == "row" { "entry" } else { element };
                }
            }
        }
        f.write_str(&words.join(", "))
    }
}
