//! The values of a question and an answer, which note the fields that a check reads: a claim of the answer that no
//! check has read is not proved, whatever the others are, and neither is what a question asks beyond them.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ptr;

use crate::json::Tree;
use crate::place::{Place, Step};

/// The values of fields that were read, each by its address.
#[derive(Debug, Default)]
pub(crate) struct Reads(RefCell<BTreeSet<*const Tree>>);

/// A value whose fields are noted as they are read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Traced<'a> {
    pub(crate) tree: &'a Tree,
    reads: &'a Reads,
}

impl<'a> Traced<'a> {
    pub(crate) fn new(tree: &'a Tree, reads: &'a Reads) -> Self {
        Self { tree, reads }
    }

    /// The field of an object, which is noted.
    pub(crate) fn field(self, name: &str) -> Option<Self> {
        let value = self.tree.field(name)?;
        self.reads.0.borrow_mut().insert(ptr::from_ref(value));
        Some(Self::new(value, self.reads))
    }

    /// The elements of a list.
    pub(crate) fn elements(self) -> Option<impl Iterator<Item = Self>> {
        Some(self.tree.list()?.iter().map(move |element| Self::new(element, self.reads)))
    }

    /// All fields of an object whose names are part of what it says; they are noted.
    pub(crate) fn fields(self) -> Option<impl Iterator<Item = (&'a str, Self)>> {
        let Tree::Object(fields) = self.tree else { return None };
        let noted = move |(name, _): &'a (String, Tree)| Some((name.as_str(), self.field(name)?));
        Some(fields.iter().filter_map(noted))
    }

    pub(crate) fn text(self) -> Option<&'a str> {
        self.tree.text()
    }

    /// The places of the fields below this object that were not read.
    pub(crate) fn unread(self) -> Vec<Place> {
        let mut unread = Vec::new();
        self.search(&Place::default(), &mut unread);
        unread
    }

    fn search(self, place: &Place, unread: &mut Vec<Place>) {
        let deeper = |value: &'a Tree| Self::new(value, self.reads);
        match self.tree {
            Tree::Object(fields) => {
                for (name, value) in fields {
                    let place = place.field(name);
                    if self.reads.0.borrow().contains(&ptr::from_ref(value)) {
                        deeper(value).search(&place, unread);
                    } else {
                        unread.push(place);
                    }
                }
            }
            Tree::List(elements) => {
                let nested = (0..).zip(elements).filter(|(_, value)| holds_fields(value));
                nested.for_each(|(at, value)| deeper(value).search(&place.then(Step::Element(at)), unread));
            }
            Tree::Null | Tree::Bool(_) | Tree::Number(_) | Tree::Text(_) => {}
        }
    }
}

/// Whether there is an object in a value; rows of numbers, of which there may be millions, hold none.
fn holds_fields(value: &Tree) -> bool {
    matches!(value, Tree::Object(_)) || value.list().is_some_and(|elements| elements.iter().any(holds_fields))
}
