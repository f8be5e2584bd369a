//! A first column that counts the rows.

/// Whether a first column without a name, which nobody chose, counts the rows.
pub(in crate::input) struct Counting {
    begin: Option<f64>,
    rows: usize,
    is_possible: bool,
}

/// Rows from which on a column is said to count them.
const COUNTED_ROWS: usize = 3;

impl Counting {
    pub(in crate::input) fn new(is_chosen: bool, is_named: bool, columns: &[usize]) -> Self {
        let is_possible = !is_chosen && !is_named && columns.len() >= 2 && columns[0] == 0;
        Self { begin: None, rows: 0, is_possible }
    }

    pub(in crate::input) fn note(&mut self, number: f64) {
        let begin = *self.begin.get_or_insert(number);
        self.is_possible &= (begin == 0.0 || begin == 1.0) && number == begin + self.rows as f64;
        self.rows += 1;
    }

    pub(in crate::input) fn in_words(&self, columns: &[usize], may_choose: bool) -> Option<String> {
        let others: Vec<String> = columns.iter().skip(1).map(|column| (column + 1).to_string()).collect();
        let advice = if may_choose && others.len() >= 2 {
            format!("; --columns {} leaves it out", others.join(","))
        } else {
            String::new()
        };
        let is_told = self.is_possible && self.rows >= COUNTED_ROWS;
        is_told.then(|| format!("column 1 counts the rows and is read as a coordinate{advice}"))
    }
}
