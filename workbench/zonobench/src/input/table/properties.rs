//! The line that names the columns of a list of atoms: `Properties=species:S:1:pos:R:3`, each with its kind and count.

use csv::ByteRecord;

use crate::input::error::Problem;

/// The columns of a list of atoms that are not its positions, by its second row; none where that names no columns.
pub(super) fn columns_beside_positions(title: &ByteRecord) -> Result<Option<Vec<usize>>, Problem> {
    let Some(properties) = title.iter().find_map(properties) else { return Ok(None) };
    let words: Vec<&str> = properties.split(':').collect();
    let refused = |what: &str| {
        Problem::Shape(format!("names the columns by Properties={properties}, {what}; a list of atoms has pos:R:3"))
    };
    let (columns, rest) = words.as_chunks::<3>();
    let counted =
        columns.iter().map(|[name, kind, count]| Some((*name, *kind, usize::from(count.parse::<u8>().ok()?))));
    let counted = counted.collect::<Option<Vec<_>>>().filter(|_| rest.is_empty());
    let counted = counted.ok_or_else(|| refused("which are not names, kinds and counts"))?;
    let mut begin = 0;
    let mut positions = None;
    for (name, kind, count) in counted {
        if name.eq_ignore_ascii_case("pos") {
            if !kind.eq_ignore_ascii_case("R") || count != 3 {
                return Err(refused("where the positions are no three reals"));
            }
            positions = Some(begin..begin + count);
        }
        begin += count;
    }
    let positions = positions.ok_or_else(|| refused("without positions"))?;
    Ok(Some((0..begin).filter(|column| !positions.contains(column)).collect()))
}

/// The text behind the word `Properties=` in a cell, without quotation marks.
fn properties(cell: &[u8]) -> Option<&str> {
    let cell = std::str::from_utf8(cell).ok()?.trim();
    let (word, properties) = cell.split_once('=')?;
    word.eq_ignore_ascii_case("properties").then(|| properties.trim_matches('"'))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(title: &str) -> Result<Option<Vec<usize>>, String> {
        columns_beside_positions(&title.split(' ').collect()).map_err(|problem| problem.to_string())
    }

    #[test]
    fn positions_stand_wherever_the_title_says() {
        assert_eq!(columns("Properties=species:S:1:vel:R:3:pos:R:3"), Ok(Some(vec![0, 1, 2, 3])));
        assert_eq!(columns("pbc=T properties=\"pos:R:3:Z:I:1\" energy=1"), Ok(Some(vec![3])));
        assert_eq!(columns("a molecule of water"), Ok(None));
        for title in [
            "Properties=species:S:1",
            "Properties=pos:R:2",
            "Properties=pos:I:3",
            "Properties=pos:R",
            "Properties=a:S:300:pos:R:3",
        ] {
            assert!(columns(title).is_err_and(|told| told.contains("a list of atoms has pos:R:3")), "{title}");
        }
    }
}
