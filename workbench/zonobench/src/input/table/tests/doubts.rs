//! First rows and names that may be meant otherwise, and numbers that doubles do not hold: read with a line that says
//! so.

use super::*;

fn reading(content: &str, is_cloud: bool) -> Reading {
    let shape = Shape { columns: None, skip: None, wanted: Wanted::Any, has_options: true, is_cloud };
    super::super::points(Path::new("p.csv"), content.as_bytes(), &shape, &mut Skipping::default()).expect(content)
}

fn notes_of_vectors(content: &str) -> Vec<String> {
    rows(Path::new("z.csv"), content.as_bytes(), Order::Coordinates, None).expect(content).notes
}

#[test]
fn a_first_row_that_may_say_the_sizes_is_read_as_data_and_told() {
    let doubt = "the first row (2, 2) is read as data, though it may say the sizes of the table";
    for content in ["2,2\n1,0\n0,1\n", "2;2\n1;0\n0;1\n", "2\t2\n1\t0\n0\t1\n", "2 2\n1 0\n0 1\n"] {
        let reading = reading(content, false);
        assert_eq!(reading.points.len(), 3, "{content}");
        assert_eq!(reading.notes, [format!("{doubt}; --skip 1 leaves it out")], "{content}");
        assert_eq!(notes_of_vectors(content), [doubt], "{content}");
    }
    assert!(reading("3,2\n1,0\n0,1\n", false).notes.is_empty());
    assert!(reading("x,y\n2,2\n1,0\n", false).notes.is_empty());
}

#[test]
fn a_first_row_that_may_number_the_columns_is_told_by_every_reader() {
    for (content, is_cloud) in [("0,1\n2,3\n4,7\n", false), ("0 1\n2 3\n4 7\n", true), ("0 1 2\n2 3 5\n4 7 5\n", true)]
    {
        let notes = reading(content, is_cloud).notes;
        assert!(notes[0].contains("is read as data; --skip 1 leaves it out"), "{notes:?}");
    }
    assert_eq!(notes_of_vectors("0,1\n2,3\n4,7\n"), ["the first row (0, 1) is read as data"]);
}

#[test]
fn unknown_names_that_count_down_are_read_as_they_stand_and_told() {
    for names in ["b,a", "v,u", "col2,col1", "p_3,p_1,p_2"] {
        let row = if names.matches(',').count() == 1 { "1,2" } else { "1,2,3" };
        let content = format!("{names}\n{row}\n");
        let told = format!("the columns {} are read in the order in which they stand", names.replace(',', ", "));
        assert_eq!(reading(&content, false).notes, std::slice::from_ref(&told), "{names}");
        assert_eq!(notes_of_vectors(&content), [told], "{names}");
    }
    for names in ["a,b", "u,v", "col1,col2", "y,x", "width,height", "lat,lon", "col9,col10"] {
        let notes = reading(&format!("{names}\n1,2\n"), false).notes;
        assert!(notes.is_empty(), "{names}: {notes:?}");
    }
}

#[test]
fn no_advice_leaves_out_no_lines() {
    for content in
        [",v\n5,1.5\n6,2.5\n", "7\n8\n", "a,,\n1,2,3\n", "north,1\n2,3\n", "1,2,north\n2,3,4\n", "0 1 2\n3 4 5\n"]
    {
        for wanted in [Wanted::Planar, Wanted::PlaneOrSpace, Wanted::Any] {
            let shape = Shape { columns: None, skip: None, wanted, has_options: true, is_cloud: false };
            let read = super::super::points(Path::new("p.csv"), content.as_bytes(), &shape, &mut Skipping::default());
            let words = match read {
                Ok(reading) => reading.in_words().unwrap_or_default(),
                Err(complaint) => complaint.to_string(),
            };
            assert!(!words.contains("--skip 0"), "{words}");
        }
    }
}

#[test]
fn numbers_of_a_table_that_doubles_do_not_hold_are_counted_with_their_first_place() {
    let told = |content: &str| reading(content, false).losses;
    let rounded = "1 whole number has more digits than a double holds and is rounded";
    assert_eq!(told("x,y\n1,2\n9007199254740993,0\n"), Some(format!("{rounded} (9007199254740993, line 3, column 1)")));
    let vanished = told("1e-400;0,5\n2;-1,5E-999\n").expect("numbers vanish");
    assert!(vanished.starts_with("2 numbers are too small for a double and are read as 0"), "{vanished}");
    assert!(vanished.ends_with("(the first is 1e-400, line 1, column 1)"), "{vanished}");
    assert_eq!(told("id,x,y\n9007199254740993,1,2\n"), None, "a column that is not read loses nothing");
    let notes = notes_of_vectors("9007199254740993,1\n0,1e-400\n");
    assert!(notes[0].contains("is rounded") && notes[0].contains("is read as 0"), "{notes:?}");
}
