//! Tables with and without header, whole and broken.

mod atoms;
mod doubts;
mod foreign;
mod silent;

use super::*;

/// The points of a table in which nothing is skipped that is not finite.
fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    skip: Option<u64>,
    wanted: Wanted,
) -> Result<Reading, InputError> {
    let shape = Shape { columns, skip, wanted, has_options: true, is_cloud: false };
    super::points(file, content, &shape, &mut Skipping::default())
}

fn read(content: &str, columns: Option<&str>) -> Result<Vec<[f64; 2]>, String> {
    let columns = columns.map(|columns| columns.parse().expect("the test's columns are well formed"));
    let points = points(Path::new("points.csv"), content.as_bytes(), columns.as_ref(), None, Wanted::Planar);
    match points.map_err(|error| error.to_string())?.points {
        Points::Plane(points) => Ok(points),
        other => panic!("{other:?} are not points of the plane"),
    }
}

#[test]
fn headers_are_recognised_and_may_be_absent() {
    let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
    assert_eq!(read("1,2\n3,4\n", None), expected);
    assert_eq!(read("a,b\n1,2\n3,4", None), expected);
    assert_eq!(read("y,w,x\n2,0,1\n4,0,3\n", None), expected);
    assert_eq!(read("name,Lat,LON\np,2,1\nq,4,3\n", None), expected);
    assert_eq!(
        read("7,8\n2,1\n4,3\n", Some("8,7")),
        Err("points.csv: line 1: there is no column 8; the row has 2 cells".into())
    );
    let twice = "points.csv: line 1: two columns are named 'x'; choose with --columns by number";
    assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", None), Err(twice.into()));
    assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", Some("x,y")), Err(twice.into()));
    assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", Some("1,2")), expected);
    let broken = "points.csv: line 1: there is no column 'x'; the columns are a\\nb, c";
    assert_eq!(read("\"a\nb\",c\n1,2\n", Some("x,c")), Err(broken.into()));
}

#[test]
fn line_endings_blank_lines_quotes_and_separators() {
    let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
    assert_eq!(read("x,y\r\n1,2\r\n\r\n3,4\r\n", None), expected);
    assert_eq!(read("\n\n1,2\n   \n3,4\n\n\n", None), expected);
    assert_eq!(read("\"1\",\"2\"\n\"3\", 4 \n", None), expected);
    assert_eq!(read("1;2\n3;4\n", None), expected);
    assert_eq!(read("1\t2\n3\t4\n", None), expected);
}

#[test]
fn complaints_name_line_and_column() {
    let complaint = |content, columns| read(content, columns).expect_err("the table is wrong");
    assert_eq!(complaint("x,y\n1,2\n\n3,abc\n", None), "points.csv: line 4, column 2: 'abc' is not a number");
    assert_eq!(
        complaint("x,y\r\n1,2\r\n\r\n\r\nnan,2\r\n", None),
        "points.csv: line 5, column 1: 'nan' is not a finite number"
    );
    assert_eq!(
        complaint("1,2\n1e999,2\n", None),
        "points.csv: line 2, column 1: '1e999' is outside the range of a double"
    );
    assert_eq!(complaint("1,2\n3\n", None), "points.csv: line 2, column 2: the row has 1 cells, not 2");
    assert_eq!(complaint("1,2\n3,4,5\n", None), "points.csv: line 2, column 3: the row has 3 cells, not 2");
    assert_eq!(complaint("1,2\n3,\n", None), "points.csv: line 2, column 2: the cell is empty");
    assert_eq!(
        complaint("1,2,3\n3,4,5\n", None),
        "points.csv: has 3 column(s); choose two with --columns, such as --columns 1,2"
    );
    assert_eq!(
        complaint("a,b\n1,2\n", Some("a,c")),
        "points.csv: line 1: there is no column 'c'; the columns are a, b"
    );
    assert_eq!(complaint("x,y\n1,\"2\n3\"\n4,z\n", None), "points.csv: line 2, column 2: '2\\n3' is not a number");
    let advice = "points.csv: has 1 column, and points of the plane or of space need two or three; ";
    for (content, cure) in [
        ("1\n2\n", "commas, semicolons, tabs, bars and spaces separate the cells of a row"),
        ("ply\nformat ascii 1.0\n", "it begins with `ply`, so it may be of the format ply: --format ply"),
        (
            "title\nby\n1,2\n3,4\n",
            "line 1 has 1 cell, and line 3 has 2; if the table begins there, --skip 2 leaves out what stands above it",
        ),
    ] {
        assert_eq!(complaint(content, None), format!("{advice}{cure}"));
    }
}

#[test]
fn any_number_of_coordinates() {
    let read = |content: &str, columns: Option<&str>| {
        let columns = columns.map(|columns| columns.parse().expect("well formed"));
        points(Path::new("p.csv"), content.as_bytes(), columns.as_ref(), None, Wanted::Any)
            .map(|reading| reading.points)
            .map_err(|error| error.to_string())
    };
    assert_eq!(read("z,x,y,w\n3,1,2,9\n", None), Ok(Points::Space(vec![[1.0, 2.0, 3.0]])));
    assert_eq!(read("7\n8\n", None), Ok(Points::Line(vec![[7.0], [8.0]])));
    assert_eq!(read("1,2,3,4\n", None), Ok(Points::Four(vec![[1.0, 2.0, 3.0, 4.0]])));
    assert_eq!(read("id,lon,lat\na,1,2\n", None), Ok(Points::Plane(vec![[1.0, 2.0]])));
    let iris = "150,4,setosa,versicolor,virginica\n5.1,3.5,1.4,0.2,0\n";
    let refused = "p.csv: line 1, column 3: 'setosa' is not a number, but below it is one; if this line is a header, \
                   --skip 1 leaves it out";
    for columns in [None, Some("1,2,3,4")] {
        assert_eq!(read(iris, columns), Err(refused.to_owned()));
    }
    let columns: Columns = "1,2,3,4".parse().expect("well formed");
    let skipped = points(Path::new("p.csv"), iris.as_bytes(), Some(&columns), Some(1), Wanted::Any);
    assert_eq!(skipped.expect("numbers").points, Points::Four(vec![[5.1, 3.5, 1.4, 0.2]]));
    let cities = "# no header\n1,2,north\n3,4,south\n";
    let planar = points(Path::new("p.csv"), cities.as_bytes(), None, None, Wanted::PlaneOrSpace);
    let refused = "p.csv: line 2, column 3: 'north' is text; choose two to four of the 3 columns with --columns";
    assert_eq!(planar.map_err(|error| error.to_string()), Err(refused.to_owned()));
}

/// Three columns x, y, z are a point of space each: none of them is dropped unless the others are chosen.
#[test]
fn a_third_coordinate_is_not_dropped_in_silence() {
    let read = |columns: Option<&str>, wanted: Wanted| {
        let columns = columns.map(|columns| columns.parse().expect("well formed"));
        let content = b"Name,X,y,Z\na,1,2,3\n";
        points(Path::new("p.csv"), content, columns.as_ref(), None, wanted).map_err(|error| error.to_string())
    };
    for wanted in [Wanted::PlaneOrSpace, Wanted::Any] {
        let reading = read(None, wanted).expect("points of space");
        assert_eq!(reading.points, Points::Space(vec![[1.0, 2.0, 3.0]]));
        assert_eq!(reading.in_words().as_deref(), Some("X, y, Z; left out: Name"));
    }
    let refused = "p.csv: line 1: has the columns x, y and z, so its points are in space; choose two columns with \
                   --columns";
    assert_eq!(read(None, Wanted::Planar), Err(refused.to_owned()));
    let chosen = read(Some("x,y"), Wanted::Planar).expect("points of the plane");
    assert_eq!(chosen.points, Points::Plane(vec![[1.0, 2.0]]));
    assert_eq!(chosen.in_words().as_deref(), Some("X, y; left out: Name, Z"));
}

#[test]
fn the_columns_told_are_columns_to_choose() {
    for content in ["a,b,c\n1,2,x\n", "7;8;x\n9;9;y\n", "q,q,r\n1,2,3\n", "2,1,z\n5,6,y\n"] {
        let columns: Columns = "2,1".parse().expect("well formed");
        let read = |columns| points(Path::new("p.csv"), content.as_bytes(), Some(columns), None, Wanted::Planar);
        let reading = read(&columns).expect("two columns of numbers");
        let again = read(&Columns(reading.columns.clone())).expect("the same columns");
        assert_eq!(reading, again, "{content}");
    }
}

#[test]
fn bytes_that_are_not_text_are_named() {
    let error = points(Path::new("p.csv"), b"1,2\n3,\xff\n", None, None, Wanted::Planar).expect_err("not text");
    assert_eq!(error.to_string(), "p.csv: line 2, column 2: is not UTF-8 text");
}

#[test]
fn nothing_and_a_header_alone_have_no_points() {
    assert_eq!(read("", None), Ok(vec![]));
    assert_eq!(read("\n\r\n", None), Ok(vec![]));
    assert_eq!(read("x,y\n", None), Ok(vec![]));
}

#[test]
fn comments_blank_lines_and_trailing_separators_hold_nothing() {
    let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
    for content in [
        "# made by hand, \"roughly\nx,y\n1,2\n  # the last\n3,4\n#",
        "x,y,\n1,2,\n\n3,4,\n",
        "1;2;\n3;4\n",
        "x;y\n1;2;\n3;4;\n",
        "x\ty\t\n1\t2\n3\t4\t \n",
        "# x y\n  1.0   2.0 \n\n 3e0 4\n",
        "x y\n1 2\n3 4",
        "x,y,\n1,2,7\n3,4,8\n",
    ] {
        assert_eq!(read(content, None), expected, "{content}");
    }
    let complaint = |content| read(content, None).expect_err("the table is wrong");
    assert_eq!(complaint("# a\n1,2\n  #b\n\n3,z\n"), "points.csv: line 5, column 2: 'z' is not a number");
    assert_eq!(complaint("1,\n3,4\n"), "points.csv: line 1, column 2: the cell is empty");
    assert_eq!(complaint("1,2,\n3,,\n"), "points.csv: line 2, column 2: the cell is empty");
    assert_eq!(complaint("1,2,\n3,4,,\n"), "points.csv: line 2, column 3: the row has 4 cells, not 2");
    assert_eq!(complaint("1 2\n3 4\n5\n"), "points.csv: line 3, column 2: the row has 1 cells, not 2");
}

#[test]
fn a_broken_number_is_no_header() {
    let complaint = |content, columns| read(content, columns).expect_err("the table is wrong");
    assert_eq!(complaint("1.2.3,4\n5,6\n", None), "points.csv: line 1, column 1: '1.2.3' is not a number");
    assert_eq!(complaint("1,5e\n5,6\n", None), "points.csv: line 1, column 2: '5e' is not a number");
    assert_eq!(complaint("1,5e;2\n5;6\n", None), "points.csv: line 1, column 1: '1,5e' is not a number");
    assert_eq!(complaint("#\n1,5km\n5,6\n", None), "points.csv: line 2, column 2: '5km' is not a number");
    assert_eq!(read("1st,2nd\n5,6\n", None), Ok(vec![[5.0, 6.0]]));
}

#[test]
fn first_lines_are_skipped_when_they_are_told() {
    let read = |content: &str, skip: Option<u64>| {
        let columns: Columns = "1,2".parse().expect("well formed");
        let reading = points(Path::new("p.csv"), content.as_bytes(), Some(&columns), skip, Wanted::Planar);
        reading.map(|reading| (reading.points.clone(), reading.in_words())).map_err(|error| error.to_string())
    };
    let flowers = "150,4,setosa\n1,2,0\n3,4,0\n";
    let unclear = "p.csv: line 1, column 3: 'setosa' stands beside numbers and above one; if this line is a header, \
                   --skip 1 leaves it out, and --no-header reads it as data";
    assert_eq!(read(flowers, None), Err(unclear.to_owned()));
    let plane = |points: &[[f64; 2]]| Points::Plane(points.to_vec());
    let told = Some("1, 2; left out: column 3, the first line".to_owned());
    assert_eq!(read(flowers, Some(1)), Ok((plane(&[[1.0, 2.0], [3.0, 4.0]]), told)));
    let (all, told) = read(flowers, Some(0)).expect("three points");
    assert_eq!((all.len(), told.as_deref()), (3, Some("1, 2; left out: column 3")));
    let (some, told) = read("a table,\n\nx,y\n# none\n1,2\n#\n", Some(2)).expect("one point");
    assert_eq!(some, plane(&[[1.0, 2.0]]));
    assert_eq!(told.as_deref(), Some("x, y; left out: the first 2 lines, 2 lines that begin with #"));
    assert_eq!(read("7\n1,2\n3,z\n", Some(1)), Err("p.csv: line 3, column 2: 'z' is not a number".to_owned()));
    assert_eq!(read(flowers, Some(9)), Ok((plane(&[]), Some("left out: the first 3 lines".to_owned()))));
}

#[test]
fn a_column_of_text_makes_no_header_of_the_first_row() {
    let complaint = |content: &str, wanted: Wanted| {
        let reading = points(Path::new("p.csv"), content.as_bytes(), None, None, wanted);
        reading.map(|reading| reading.points).map_err(|error| error.to_string())
    };
    let cities = "1,2,north\n3,4,south\n5,6,north\n";
    for (content, wanted) in [(cities, Wanted::Any), (cities, Wanted::PlaneOrSpace), ("1,2,north\n", Wanted::Any)] {
        let refused = "p.csv: line 1, column 3: 'north' is text; choose two to four of the 3 columns with --columns";
        assert_eq!(complaint(content, wanted), Err(refused.to_owned()), "{content} {wanted:?}");
    }
    for wanted in [Wanted::Any, Wanted::Planar] {
        for content in ["5,north\n6,south\n", "5,north\n"] {
            let refused = "p.csv: line 1, column 2: 'north' is not a number";
            assert_eq!(complaint(content, wanted), Err(refused.to_owned()), "{content} {wanted:?}");
        }
    }
    let broken = "p.csv: line 1, column 3: '3km' is not a number";
    assert_eq!(complaint("1,2,3km\n4,5,6km\n", Wanted::Any), Err(broken.to_owned()));
    let refused = "p.csv: line 1, column 3: 'north' is not a number";
    let generators = rows(Path::new("p.csv"), cities.as_bytes(), Order::Coordinates, None).map(|rows| rows.numbers);
    assert_eq!(generators.map_err(|error| error.to_string()), Err(refused.to_owned()));
    let columns = "1,2,3".parse().expect("well formed");
    let chosen = points(Path::new("p.csv"), cities.as_bytes(), Some(&columns), None, Wanted::Any);
    assert_eq!(chosen.map_err(|error| error.to_string()), Err(refused.to_owned()));
    let columns = "1,2".parse().expect("well formed");
    let chosen = points(Path::new("p.csv"), cities.as_bytes(), Some(&columns), None, Wanted::Any).expect("numbers");
    assert_eq!(chosen.points, Points::Plane(vec![[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]));
}

/// A row with a number is no header; where its text stands above a number, the error says what a header takes.
#[test]
fn a_number_in_the_first_row_makes_it_data() {
    let complaint = |content: &str, columns: Option<&str>, skip: Option<u64>, wanted: Wanted| {
        let columns = columns.map(|columns| columns.parse().expect("well formed"));
        let reading = points(Path::new("p.csv"), content.as_bytes(), columns.as_ref(), skip, wanted);
        reading.expect_err("the table is wrong").to_string()
    };
    let text = |place: &str, text: &str, skip: u64| {
        format!(
            "p.csv: {place}: '{text}' is not a number, but below it is one; if this line is a header, --skip {skip} \
             leaves it out"
        )
    };
    let mixed = "1,2,north\n3,4,5\n";
    for wanted in [Wanted::Any, Wanted::PlaneOrSpace, Wanted::Planar] {
        assert_eq!(complaint(mixed, None, None, wanted), text("line 1, column 3", "north", 1));
    }
    assert_eq!(complaint(mixed, Some("1,3"), None, Wanted::Planar), text("line 1, column 3", "north", 1));
    assert_eq!(complaint(mixed, Some("1,3"), Some(0), Wanted::Planar), text("line 1, column 3", "north", 1));
    let below = "# a comment\n\nx,2024\n3,4\n";
    assert_eq!(complaint(below, None, None, Wanted::Planar), text("line 3, column 1", "x", 3));
    assert_eq!(complaint("x,y,2024\n3,4,5\n", None, None, Wanted::Planar), text("line 1, column 1", "x", 1));
    // The error says what helps.
    let reading = points(Path::new("p.csv"), below.as_bytes(), None, Some(3), Wanted::Planar).expect("a point");
    assert_eq!(reading.points, Points::Plane(vec![[3.0, 4.0]]));
    let columns = "x,2024".parse().expect("well formed");
    let named = points(Path::new("p.csv"), b"x,2024\n3,4\n", Some(&columns), None, Wanted::Planar);
    assert!(named.is_err(), "2024 is the number of a column");
    let columns = "x,y".parse().expect("well formed");
    let named = points(Path::new("p.csv"), b"x,y,2024\n3,4,5\n", Some(&columns), None, Wanted::Planar);
    assert_eq!(named.expect("a header with both names").points, Points::Plane(vec![[3.0, 4.0]]));
    let generators = rows(Path::new("p.csv"), mixed.as_bytes(), Order::Coordinates, None).map(|rows| rows.numbers);
    assert_eq!(generators.map_err(|error| error.to_string()), Err(text("line 1, column 3", "north", 1)));
}

/// A choice by a name that no row has tells which columns there are, and never lists data as names.
#[test]
fn missing_names_are_told_from_data() {
    let complaint = |content: &str| read(content, Some("x,w")).expect_err(content);
    let of_data = complaint("# x v z\n1 2 3\n4 5 6\n");
    assert!(of_data.ends_with("numbered 1 to 3, as no row names them; a line that begins with # is a comment"));
    let unnamed = complaint(",x,y\n0,1,2\n1,3,4\n");
    assert!(unnamed.contains("the columns are column 1 (unnamed), x, y"), "{unnamed}");
}

#[test]
fn a_grid_of_heights_is_refused_whatever_is_skipped() {
    let grid = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n1 2\n3 4\n";
    for skip in [None, Some(1), Some(6)] {
        let file = Path::new("p.asc");
        let complaint = points(file, grid.as_bytes(), None, skip, Wanted::Any).expect_err("a grid").to_string();
        assert!(complaint.ends_with("is a grid of heights, which holds no points"), "{complaint}");
    }
}
