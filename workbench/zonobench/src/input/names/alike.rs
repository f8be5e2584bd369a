//! Names of coordinates that are alike but for the coordinate: `world_y` beside `world_x`, `cy` beside `cx`.
//!
//! Prefixes and suffixes have no list: they are whatever the names of one point have in common. The names of several
//! points in a row, as in `x1, y1, x2, y2`, decide nothing.

use std::collections::BTreeMap;

/// Coordinates in the order in which they are read, three before two.
const SETS: [&[&str]; 7] = [
    &["x", "y", "z"],
    &["x", "y"],
    &["lon", "lat"],
    &["lng", "lat"],
    &["long", "lat"],
    &["longitude", "latitude"],
    &["easting", "northing"],
];

/// Words that stand before or behind the letter of a coordinate without anything between, beside single letters.
const GLUED: [&str; 7] = ["pos", "coord", "point", "center", "centre", "ref", "world"];

/// The columns whose names are alike but for the coordinate, in the order of the coordinates; none where no names are,
/// or those of more than one point. It takes a search in a tree for each name, since tables have thousands of columns.
pub(super) fn of_alike_names(names: &[String]) -> Option<Vec<usize>> {
    SETS.iter().find_map(|set| {
        let columns: Vec<BTreeMap<String, usize>> = set.iter().map(|coordinate| by_stem(names, coordinate)).collect();
        let columns_of = |stem: &String| columns.iter().map(|by_stem| by_stem.get(stem).copied()).collect();
        let mut points = columns[0].keys().filter_map(columns_of);
        let first: Vec<usize> = points.next()?;
        points.all(|other| other == first).then_some(first)
    })
}

/// The first column of each stem that names have for a coordinate.
fn by_stem(names: &[String], coordinate: &str) -> BTreeMap<String, usize> {
    let mut columns = BTreeMap::new();
    for (column, name) in names.iter().enumerate() {
        for stem in stems(name, coordinate) {
            columns.entry(stem).or_insert(column);
        }
    }
    columns
}

/// The name with a mark in the place of a coordinate, for each place where the coordinate stands.
fn stems(name: &str, coordinate: &str) -> Vec<String> {
    let name = name.split(['[', '(']).next().unwrap_or_default().trim().to_lowercase();
    let mut stems = Vec::new();
    let mut begin = 0;
    for word in name.split(|c: char| !c.is_alphabetic()) {
        let end = begin + word.len();
        let mut mark = |from: usize, to: usize| stems.push(format!("{}*{}", &name[..from], &name[to..]));
        let is_glue = |rest: &str| rest.chars().count() == 1 || GLUED.contains(&rest);
        if word == coordinate {
            mark(begin, end);
        } else if coordinate.len() == 1 {
            if word.strip_prefix(coordinate).is_some_and(is_glue) {
                mark(begin, begin + 1);
            }
            if word.strip_suffix(coordinate).is_some_and(is_glue) {
                mark(end - 1, end);
            }
        }
        // the separator takes as many bytes as its character
        begin = end + name[end..].chars().next().map_or(0, char::len_utf8);
    }
    stems
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(names: &str) -> Option<Vec<usize>> {
        of_alike_names(&names.split(',').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn what_names_have_in_common_does_not_matter() {
        for names in [
            "y1,x1",
            "ypos,xpos",
            "y0,x0",
            "cy,cx",
            "center_y,center_x",
            "ty,tx",
            "world_y,world_x",
            "Y_ref,X_ref",
            "field.y,field.x",
            "/pose/y,/pose/x",
            "gps_lat,gps_lon",
            "ÿ y,ÿ x",
        ] {
            assert_eq!(columns(names), Some(vec![1, 0]), "{names}");
        }
        assert_eq!(columns("tz,id,tx,ty"), Some(vec![2, 3, 0]));
        assert_eq!(columns("pos_y [m],pos_x [m],pos_z [m]"), Some(vec![1, 0, 2]));
    }

    #[test]
    fn many_names_take_little_time() {
        let many: Vec<String> = (0..100_000).map(|k| format!("x{k}")).collect();
        assert_eq!(of_alike_names(&many), None);
    }

    #[test]
    fn several_points_and_other_words_decide_nothing() {
        for names in ["x1,y1,x2,y2", "tx,ty,tz,qx,qy,qz", "max,may", "y_left,x_right", "a,b", "", "x_,z_"] {
            assert_eq!(columns(names), None, "{names}");
        }
    }
}
