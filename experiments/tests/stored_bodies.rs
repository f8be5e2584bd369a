//! The bodies that are stored for comparisons are those of the families: `ZONOTOPE_BLESS=1` writes them anew.

use families::bodies::{BODY_FAMILIES, BodyFamily, NEAR_BALLS};
use std::fs;
use std::path::{Path, PathBuf};

const GENERATORS: usize = 1000;
const SEED: u64 = 1;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/bodies")
}

/// The table of a body: digits that give each double back.
fn table(family: &BodyFamily<3>) -> String {
    let rows = family.generate(GENERATORS, SEED).into_iter().map(|[x, y, z]| format!("{x:?},{y:?},{z:?}\n"));
    std::iter::once(String::from("x,y,z\n")).chain(rows).collect()
}

#[test]
fn stored_bodies_are_those_of_the_families() {
    let bless = std::env::var_os("ZONOTOPE_BLESS").is_some_and(|value| value == "1");
    for family in [NEAR_BALLS].into_iter().chain(BODY_FAMILIES) {
        let (path, table) = (folder().join(format!("{}.csv", family.id)), table(family));
        if bless {
            fs::write(&path, &table).expect("the folder of the bodies can be written");
        }
        let stored = fs::read_to_string(&path).unwrap_or_default();
        assert!(stored == table, "{} is not the family's body; ZONOTOPE_BLESS=1 writes it anew", path.display());
    }

    let stored = fs::read_dir(folder()).expect("the folder is there").filter_map(Result::ok);
    let tables = stored.filter(|entry| entry.path().extension().is_some_and(|ending| ending == "csv")).count();
    assert_eq!(tables, BODY_FAMILIES.len() + 1, "nothing else is stored beside them");
}
