//! The paths that the code of a file names: those of its `use` statements, and those that its expressions begin with.

use tests::sources::Source;

/// A path as it is written, and the name by which the file knows its end.
#[derive(Debug, PartialEq, Eq)]
pub struct Import {
    /// The segments of the path.
    pub path: Vec<String>,
    /// The last segment, or what follows `as`.
    pub name: String,
}

/// The code of a file as one text: no comments, no unit tests, no statement that is for tests alone.
pub fn code(source: &Source) -> String {
    let mut text = String::new();
    let mut for_tests = false;
    for (_, line) in source.code_lines() {
        let line = line.split("//").next().unwrap_or(line);
        // the path of a visibility is no import
        let line = match line.split_once("pub(in ") {
            Some((before, after)) => format!("{before}pub{}", after.split_once(')').map_or("", |(_, rest)| rest)),
            None => line.to_owned(),
        };
        for_tests |= line.trim() == "#[cfg(test)]";
        if !for_tests {
            text.push_str(&line);
            text.push('\n');
        }
        // an attribute for tests goes before a statement, or before a function that ends at its own margin
        for_tests &= !line.ends_with(';') && !line.trim_end().ends_with(['}', ',']);
    }
    text
}

/// A statement that imports.
pub struct Statement<'a> {
    /// The text after `use`.
    pub tree: &'a str,
    /// Whether the statement hands on what it imports.
    pub is_public: bool,
}

/// The statements of a code that import, and the code without them.
pub fn taken_apart(code: &str) -> (Vec<Statement<'_>>, String) {
    let (mut imports, mut others) = (Vec::new(), String::new());
    for statement in code.split(';') {
        let word = statement.rfind("use ").filter(|at| {
            let before = statement[..*at].trim_end();
            before.is_empty() || before.ends_with(['}', '{', ']', ')']) || before.ends_with("pub")
        });
        if let Some(at) = word {
            let before = statement[..at].trim_end();
            let visibility = before.rsplit(['}', '{', ']', ';', '\n']).next().unwrap_or(before).trim_start();
            imports.push(Statement { tree: &statement[at + 4..], is_public: visibility.starts_with("pub") });
        }
        others.push_str(&statement[..word.unwrap_or(statement.len())]);
        others.push(';');
    }
    (imports, others)
}

/// `a::{b, c::{d as e}}` as `a::b` and `a::c::d`, the latter by the name `e`.
pub fn expanded(tree: &str) -> Vec<Import> {
    let tree = tree.trim();
    let Some((head, body)) = tree.strip_suffix('}').and_then(|tree| tree.split_once('{')) else {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
        let mut path = segments(path);
        if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
            path.pop();
        }
        let name = if name.is_empty() { path.last().cloned().unwrap_or_default() } else { name.trim().to_owned() };
        return vec![Import { path, name }];
    };
    let (mut found, mut depth, mut start) = (Vec::new(), 0, 0);
    for (at, letter) in body.char_indices().chain([(body.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !body[start..at].trim().is_empty() {
                    found.extend(expanded(&format!("{head}{}", body[start..at].trim())));
                }
                start = at + 1;
            }
            _ => {}
        }
    }
    found
}

fn segments(path: &str) -> Vec<String> {
    path.split("::").map(str::trim).filter(|part| !part.is_empty()).map(str::to_owned).collect()
}

/// The paths of at least two segments in a code.
pub fn named(code: &str) -> Vec<Vec<String>> {
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == ':';
    let words = code.split(|letter: char| !is_part(letter));
    words.filter(|word| word.contains("::") && !word.starts_with(':')).map(segments).collect()
}

/// Whether a word is in a code, outside of the texts in quotation marks.
pub fn has_word(code: &str, word: &str) -> bool {
    let unquoted = code.replace("'\"'", "").replace("\\\"", "");
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
    unquoted.split('"').step_by(2).any(|part| part.split(|letter| !is_part(letter)).any(|own| own == word))
}

/// Whether a code has functions.
pub fn has_functions(code: &str) -> bool {
    code.lines().any(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words.iter().position(|word| *word == "fn").is_some_and(|at| {
            words[..at].iter().all(|word| word.starts_with("pub") || *word == "const" || word.ends_with(')'))
        })
    })
}
