//! The header of an array: a dictionary in the notation of Python.

/// The entries of the header.
pub(super) struct Header<'a> {
    pub(super) descr: Descr<'a>,
    pub(super) is_fortran: bool,
    pub(super) shape: Vec<usize>,
}

/// The type of an item of the array.
pub(super) enum Descr<'a> {
    /// A number of this type.
    Plain(&'a str),
    /// A record of these fields.
    Records(Vec<Field<'a>>),
}

/// A field of a record.
pub(super) struct Field<'a> {
    pub(super) name: &'a str,
    pub(super) kind: &'a str,
    /// The number of values of this type in the field.
    pub(super) count: usize,
    /// Whether it is an array of values.
    pub(super) is_list: bool,
    /// The number of dimensions of that array.
    pub(super) dimensions: usize,
}

impl<'a> Header<'a> {
    pub(super) fn parse(text: &'a str) -> Option<Self> {
        let mut words = Words(text);
        let (mut descr, mut is_fortran, mut shape) = (None, None, None);
        words.take("{").then_some(())?;
        while !words.take("}") {
            let name = words.quoted()?;
            words.take(":").then_some(())?;
            match name {
                "descr" if words.take("[") => descr = Some(Descr::Records(words.fields()?)),
                "descr" => descr = Some(Descr::Plain(words.quoted()?)),
                "fortran_order" if words.take("True") => is_fortran = Some(true),
                "fortran_order" if words.take("False") => is_fortran = Some(false),
                "shape" => shape = Some(words.shape()?),
                _ => return None,
            }
            if !words.take(",") {
                words.take("}").then_some(())?;
                break;
            }
        }
        let is_over = words.0.trim().is_empty();
        is_over.then_some(Self { descr: descr?, is_fortran: is_fortran?, shape: shape? })
    }
}

/// The text that is still to be read.
struct Words<'a>(&'a str);

impl<'a> Words<'a> {
    fn take(&mut self, word: &str) -> bool {
        let rest = self.0.trim_start().strip_prefix(word);
        rest.inspect(|rest| self.0 = rest).is_some()
    }

    fn quoted(&mut self) -> Option<&'a str> {
        let quote = if self.take("'") { '\'' } else { self.take("\"").then_some('"')? };
        let (text, rest) = self.0.split_once(quote)?;
        self.0 = rest;
        Some(text)
    }

    /// The fields behind a bracket: `('x', '<f4'), ('normal', '<f4', (3,))`. Records within records are not read.
    fn fields(&mut self) -> Option<Vec<Field<'a>>> {
        let mut fields = Vec::new();
        while !self.take("]") {
            self.take("(").then_some(())?;
            let name = self.quoted()?;
            self.take(",").then_some(())?;
            let kind = self.quoted()?;
            let shape = if self.take(",") { Some(self.shape()?) } else { None };
            self.take(")").then_some(())?;
            let count = shape.iter().flatten().try_fold(1_usize, |count, length| count.checked_mul(*length))?;
            let dimensions = shape.as_ref().map_or(0, Vec::len);
            fields.push(Field { name, kind, count, is_list: shape.is_some(), dimensions });
            if !self.take(",") {
                self.take("]").then_some(())?;
                break;
            }
        }
        Some(fields)
    }

    fn shape(&mut self) -> Option<Vec<usize>> {
        self.take("(").then_some(())?;
        let (lengths, rest) = self.0.split_once(')')?;
        self.0 = rest;
        let lengths = lengths.trim().trim_end_matches(',');
        if lengths.is_empty() {
            return Some(Vec::new());
        }
        lengths.split(',').map(|length| length.trim().trim_end_matches('L').parse().ok()).collect()
    }
}
