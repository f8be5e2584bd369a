//! Names of centres and generators, as columns and rows of tables have them: one list of spellings for both.

/// Spellings of a centre, in small letters and digits.
const CENTERS: &str = "center centre centers centres centerpoint centrepoint c centroid midpoint middle mid mean mu \
                       cen ctr cent";

/// The spellings that mean a centre within a sentence, too.
const PLAIN_CENTERS: [&str; 6] = ["center", "centre", "centers", "centres", "centroid", "midpoint"];

/// The form of a generator by the names of columns before their numbers.
const GENERATORS: [&str; 4] = ["g", "gen", "generator", "generators"];

/// Whether a name is one of a centre; capitals and marks do not matter.
pub(in crate::input) fn is_center(name: &str) -> bool {
    let plain: String = name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect();
    CENTERS.split_whitespace().any(|center| center == plain)
}

/// Whether a name is the letter c, which stands for a centre unless other letters of the alphabet stand beside it.
pub(in crate::input) fn is_letter_c(name: &str) -> bool {
    name.trim().eq_ignore_ascii_case("c")
}

/// Whether a name beside `c` shows that it is the third letter of the alphabet.
pub(in crate::input) fn is_letter_beside_c(name: &str) -> bool {
    ["b", "d"].iter().any(|letter| name.trim().eq_ignore_ascii_case(letter))
}

/// The places of the names that are those of a centre.
pub(in crate::input) fn centers(names: &[String]) -> Vec<usize> {
    let is_lettered = names.iter().any(|name| is_letter_beside_c(name));
    let is_meant = |name: &String| is_center(name) && !(is_lettered && is_letter_c(name));
    (0..names.len()).filter(|&place| is_meant(&names[place])).collect()
}

/// Whether a name is that of a generator, with a number or without.
pub(in crate::input) fn is_generator(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let word = name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches(['_', ' ', '-']);
    GENERATORS.contains(&word)
}

/// Whether a name such as g1 or v1 is that of a vector; a column g alone may be a colour.
pub(in crate::input) fn is_numbered_vector(name: &str) -> bool {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    letters.len() < name.len() && (is_generator(name) || letters.eq_ignore_ascii_case("v"))
}

/// Whether the names are those of a centre and of generators, or may be meant so.
pub(in crate::input) fn are_of_bodies(names: &[String]) -> bool {
    names.len() > 1 && (!centers(names).is_empty() || names.iter().all(|name| is_generator(name)))
}

/// Whether a line of comment, without its mark, says something of a centre: it has the word, or it begins with one of
/// its short spellings. A centre at the origin is that of a body whose file names none.
pub(in crate::input) fn speaks_of_center(comment: &str) -> bool {
    let words: Vec<String> =
        comment.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty()).map(str::to_lowercase).collect();
    let is_plain = |word: &String| PLAIN_CENTERS.contains(&word.as_str());
    let name = comment.split([':', '=', ',', ';']).next().unwrap_or_default();
    (words.iter().any(is_plain) || is_center(name)) && !words.iter().any(|word| word == "origin")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn centers_of(names: &str) -> Vec<usize> {
        centers(&names.split(',').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_centre_has_many_spellings_and_c_may_be_a_letter() {
        for names in ["c,x1", "C,A1", "mean,pc1", "Centroid,g", "midpoint,g1", "center_point,a", "ctr.,a"] {
            assert_eq!(centers_of(names), [0], "{names}");
        }
        assert_eq!(centers_of("g1,c,center"), [1, 2]);
        for names in ["a,b,c", "c,d,e", "x,y", "cx,cy", "x_mean,y_mean"] {
            assert_eq!(centers_of(names), [0; 0], "{names}");
        }
        assert_eq!(centers_of("center,b,c"), [0]);
    }

    #[test]
    fn comments_speak_of_a_centre_by_the_word_or_as_a_heading() {
        for comment in [" center", "c", " c: 10, 0", "mean = (1, 2)", "generators, then the centre", "Center (10,0)"] {
            assert!(speaks_of_center(comment), "{comment}");
        }
        for comment in ["", " generators", "c code wrote this", "the mean of all", "center at the origin", "centred"] {
            assert!(!speaks_of_center(comment), "{comment}");
        }
    }
}
