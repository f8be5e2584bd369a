//! The word that OFF begins with, and what it says of the numbers of a vertex.

/// Prefixes of the word `OFF`, with the numbers of a vertex behind its coordinates where every file has the same:
/// texture coordinates, colours (of three or four numbers) and normals, as long as a vertex.
const PREFIXES: [(&str, Behind); 8] = [
    ("", Behind { numbers: Some(0), normals: 0 }),
    ("ST", Behind { numbers: Some(2), normals: 0 }),
    ("C", Behind { numbers: None, normals: 0 }),
    ("N", Behind { numbers: Some(0), normals: 1 }),
    ("CN", Behind { numbers: None, normals: 1 }),
    ("STC", Behind { numbers: None, normals: 0 }),
    ("STN", Behind { numbers: Some(2), normals: 1 }),
    ("STCN", Behind { numbers: None, normals: 1 }),
];

/// The numbers behind the coordinates of a vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Behind {
    /// Those beside normals, where they are as many in every file.
    numbers: Option<usize>,
    /// The vectors as long as the vertex.
    normals: usize,
}

/// The keyword of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Keyword {
    behind: Behind,
    /// Whether the number of coordinates stands before the counts.
    pub(super) has_dimension: bool,
}

impl Default for Keyword {
    /// That of vertices with three coordinates and nothing else.
    fn default() -> Self {
        Self { behind: PREFIXES[0].1, has_dimension: false }
    }
}

impl Keyword {
    /// Reads a word, and gives the digits behind it as well. Capitals matter in the last letter before `OFF` alone: `n`
    /// is the mark of a dimension, `N` that of normals, and so is the `n` of a word without capitals.
    pub(super) fn read(word: &[u8]) -> Result<(Self, &[u8]), String> {
        let digits = word.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
        let (letters, digits) = word.split_at(word.len() - digits);
        let is_off = letters.len() >= 3 && letters[letters.len() - 3..].eq_ignore_ascii_case(b"OFF");
        let prefix = if is_off { &letters[..letters.len() - 3] } else { letters };
        let has_capitals = letters.iter().any(u8::is_ascii_uppercase);
        let (prefix, has_dimension) = match prefix.strip_suffix(b"n").filter(|_| is_off && has_capitals) {
            Some(shorter) => (shorter, true),
            None => (prefix, false),
        };
        let spelled = String::from_utf8_lossy(word);
        if is_off && prefix.last() == Some(&b'4') && Self::named(&prefix[..prefix.len() - 1]).is_some() {
            return Err(format!(
                "begins with '{}', whose last number is a weight to some programs and a coordinate to others; write \
                 OFF, or nOFF and 4",
                spelled.escape_debug()
            ));
        }
        match Self::named(prefix).filter(|_| is_off) {
            Some(behind) => Ok((Self { behind, has_dimension }, digits)),
            None => Err(format!("begins with '{}', not with OFF for three coordinates", spelled.escape_debug())),
        }
    }

    fn named(prefix: &[u8]) -> Option<Behind> {
        let found = PREFIXES.iter().find(|(name, _)| prefix.eq_ignore_ascii_case(name.as_bytes()));
        found.map(|&(_, behind)| behind)
    }

    /// The numbers of a vertex of so many coordinates, where every file has the same.
    pub(super) fn width(self, dimension: usize) -> Option<usize> {
        self.behind.numbers.map(|numbers| dimension * (1 + self.behind.normals) + numbers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_keyword_tells_the_numbers_of_a_vertex() {
        for (word, in_space, digits) in [
            ("OFF", Some(3), ""),
            ("off", Some(3), ""),
            ("OFF12", Some(3), "12"),
            ("STOFF", Some(5), ""),
            ("NOFF", Some(6), ""),
            ("noff", Some(6), ""),
            ("STNOFF", Some(8), ""),
            ("COFF", None, ""),
            ("StcnOFF", None, ""),
        ] {
            let (keyword, behind) = Keyword::read(word.as_bytes()).expect(word);
            assert_eq!((keyword.width(3), behind), (in_space, digits.as_bytes()), "{word}");
            assert_eq!(keyword.has_dimension, word == "StcnOFF", "{word}");
        }
        for (word, in_the_plane) in [("nOFF", Some(2)), ("STnOFF", Some(4)), ("NnOFF", Some(4)), ("CnOFF", None)] {
            let (keyword, _) = Keyword::read(word.as_bytes()).expect(word);
            assert_eq!((keyword.width(2), keyword.has_dimension), (in_the_plane, true), "{word}");
        }
        for (word, complaint) in [
            ("4OFF", "to some programs"),
            ("C4nOFF", "to some programs"),
            ("5OFF", "not with OFF"),
            ("nof", "not with OFF"),
            ("xOFF", "not with OFF"),
        ] {
            let told = Keyword::read(word.as_bytes()).expect_err(word);
            assert!(told.contains(word) && told.contains(complaint), "{told}");
        }
    }
}
