//! The nearest of some names to one that is none of them: a suggestion for whoever misspelt it.

use strsim::osa_distance;

/// The nearest of the names, if it is so near that it may be meant: at most a third of its letters are changed, left
/// out, added or exchanged with their neighbour, upper and lower case, `-` and `_` being the same; or the given text is
/// the beginning of this one name alone.
pub fn nearest<'a>(given: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let plain = |name: &str| name.to_lowercase().replace('_', "-");
    let given = plain(given);
    let names: Vec<(&str, String)> = names.into_iter().map(|name| (name, plain(name))).collect();
    let mut beginnings = names.iter().filter(|(_, name)| !given.is_empty() && name.starts_with(&given));
    if let (Some((only, _)), None) = (beginnings.next(), beginnings.next()) {
        return Some(only);
    }
    let distances = names.iter().map(|(name, plain)| (osa_distance(&given, plain), plain.chars().count(), *name));
    let near = distances.filter(|&(distance, length, _)| 3 * distance <= length);
    near.min_by_key(|&(distance, ..)| distance).map(|(.., name)| name)
}

/// The suggestion as the end of a clause; empty where no name is near.
pub fn did_you_mean<'a>(given: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    nearest(given, names).map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}
