//! Real inputs, compiled into the program: country outlines and airports. Sources and licences: `data/SOURCES.md`.

use std::sync::LazyLock;

/// A country's largest ring, as plane points (longitude, latitude) in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Stable name: the file `data/outline_<name>.csv`.
    pub name: &'static str,
    /// The ring's corners in order, the first not repeated at the end unless the file does.
    pub points: Vec<[f64; 2]>,
}

macro_rules! outline_files {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../data/outline_", $name, ".csv")))),*]
    };
}

static OUTLINE_FILES: [(&str, &str); 10] = outline_files![
    "australia",
    "canada",
    "chile",
    "croatia",
    "france",
    "iceland",
    "italy",
    "new_zealand",
    "norway",
    "vietnam",
];

static AIRPORTS_FILE: &str = include_str!("../data/airports.csv");

static OUTLINES: LazyLock<Vec<Outline>> = LazyLock::new(|| {
    OUTLINE_FILES.iter().map(|&(name, text)| Outline { name, points: columns(text, ["lon", "lat"]) }).collect()
});

static AIRPORTS: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| columns(AIRPORTS_FILE, ["longitude", "latitude"]));

/// The ten country outlines, in alphabetical order.
pub fn outlines() -> &'static [Outline] {
    &OUTLINES
}

/// The outline called `name`, if there is one.
pub fn outline(name: &str) -> Option<&'static Outline> {
    outlines().iter().find(|outline| outline.name == name)
}

/// 3,376 airports of the United States, as plane points (longitude, latitude) in degrees.
pub fn airports() -> &'static [[f64; 2]] {
    &AIRPORTS
}

/// The points of the real input called `name`: `airports`, or an outline.
pub fn points(name: &str) -> Option<&'static [[f64; 2]]> {
    match name {
        "airports" => Some(airports()),
        _ => outline(name).map(|outline| outline.points.as_slice()),
    }
}

/// Two named columns of a CSV text. The files are part of the program, so a broken one is a broken build.
fn columns(text: &str, names: [&str; 2]) -> Vec<[f64; 2]> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().expect("an embedded file has a header line").clone();
    let positions =
        names.map(|name| headers.iter().position(|header| header == name).expect("an embedded file has its columns"));
    reader
        .records()
        .map(|record| {
            let record = record.expect("an embedded file is rectangular");
            positions.map(|column| record[column].parse().expect("an embedded column is numeric"))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_read_whole() {
        let sizes: Vec<_> = outlines().iter().map(|o| (o.name, o.points.len())).collect();
        let expected = [
            ("australia", 1153),
            ("canada", 3316),
            ("chile", 1144),
            ("croatia", 230),
            ("france", 533),
            ("iceland", 452),
            ("italy", 382),
            ("new_zealand", 323),
            ("norway", 993),
            ("vietnam", 554),
        ];
        assert_eq!(sizes, expected);
        assert_eq!(airports().len(), 3376);
    }

    #[test]
    fn points_are_longitude_then_latitude() {
        assert_eq!(airports()[0], [-89.23450472, 31.95376472]);
        assert_eq!(outline("iceland").expect("listed").points[0], [-15.543155431554311, 66.22915881643195]);
        for point in outlines().iter().flat_map(|o| &o.points).chain(airports()) {
            assert!(point[0].abs() <= 180.0 && point[1].abs() <= 90.0, "{point:?}");
        }
    }
}
