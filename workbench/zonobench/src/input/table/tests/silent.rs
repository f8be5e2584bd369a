//! Tables of which a reader might take something else than is meant: refused, or read with a line that says so.

use super::*;

/// The points, or the complaint, with what is told.
fn told(content: &str, is_cloud: bool, skip: Option<u64>) -> Result<(Vec<Vec<f64>>, String), String> {
    let shape = Shape { columns: None, skip, wanted: Wanted::Any, has_options: true, is_cloud };
    let mut skipping = Skipping::default();
    let reading = super::super::points(Path::new("p.csv"), content.as_bytes(), &shape, &mut skipping);
    let reading = reading.map_err(|error| error.to_string())?;
    Ok((reading.points.rows().map(<[f64]>::to_vec).collect(), reading.in_words().unwrap_or_default()))
}

/// The rows of vectors, or the complaint, with what is told.
fn vectors(content: &str) -> Result<(Vec<Vec<f64>>, Vec<String>), String> {
    let rows =
        rows(Path::new("z.csv"), content.as_bytes(), Order::Coordinates, None).map_err(|error| error.to_string())?;
    Ok((rows.numbers, rows.notes))
}

#[test]
fn a_first_row_of_broken_numbers_is_refused_by_every_reader() {
    for first in [
        "\u{2212}1,\u{2212}1",
        "1/2,1/3",
        "1D0,2D0",
        "1m,2m",
        "0x10,0x20",
        "$10,$20",
        "5\u{b1}0.1,6\u{b1}0.1",
        "(1,2)",
        "1+2j,1+0j",
        "\u{ff11},\u{ff12}",
        "\u{661},\u{662}",
        "l.5,O.5",
        "--,--",
        "-,-",
        "?,?",
        "****,****",
    ] {
        let content = format!("{first}\n3,4\n5,6\n");
        let refused = |complaint: String| assert!(complaint.contains("line 1, column 1"), "{complaint}");
        refused(told(&content, false, None).expect_err(first));
        refused(told(&content, true, None).expect_err(first));
        refused(vectors(&content).expect_err(first));
    }
}

#[test]
fn a_column_without_a_name_is_no_coordinate() {
    for (content, expected) in [
        (",a,b\n0,2,1\n2,3,4\n", vec![vec![2.0, 1.0], vec![3.0, 4.0]]),
        (",0,1\n0,2.041,-2.556\n2,-0.453,-0.216\n", vec![vec![2.041, -2.556], vec![-0.453, -0.216]]),
        (",v\n5,1.5\n", vec![vec![1.5]]),
        ("Unnamed: 0,a,b\n7,2,1\n", vec![vec![2.0, 1.0]]),
        ("a,,b\n2,9,1\n", vec![vec![2.0, 1.0]]),
    ] {
        let (points, words) = told(content, false, None).expect(content);
        let (rows, notes) = vectors(content).expect(content);
        assert_eq!((&points, &rows), (&expected, &expected), "{content}");
        assert!(words.contains("which has no name") || words.contains("Unnamed: 0"), "{words}");
        assert!(notes.concat().contains("which has no name"), "{notes:?}");
    }
}

#[test]
fn labels_of_rows_are_no_coordinates_of_vectors() {
    for (content, name) in [("id,dx,dy\n10,1,0\n", "id"), ("dx,dy,w\n1,0,9\n", "w"), ("Index,a,b\n7,1,0\n", "Index")] {
        let told = vec![format!("left out: the column {name}")];
        assert_eq!(vectors(content), Ok((vec![vec![1.0, 0.0]], told)), "{content}");
    }
    assert_eq!(vectors("u,v,w\n1,2,3\n"), Ok((vec![vec![1.0, 2.0, 3.0]], Vec::new())));
    let (_, notes) = vectors("0,5,6\n1,7,8\n2,9,9\n").expect("numbers");
    assert_eq!(notes, ["column 1 counts the rows and is read as a coordinate"]);
}

#[test]
fn coordinates_are_put_in_their_order_in_vectors_as_in_points() {
    for (content, expected) in [
        ("y,x\n2,1\n", vec![1.0, 2.0]),
        ("lat,lon\n2,1\n", vec![1.0, 2.0]),
        ("z,y,x\n3,2,1\n", vec![1.0, 2.0, 3.0]),
        ("y [m],x [m]\n2,1\n", vec![1.0, 2.0]),
        ("y_m,x_m\n2,1\n", vec![1.0, 2.0]),
        ("Latitude (deg),Longitude (deg)\n2,1\n", vec![1.0, 2.0]),
        ("pos_y,pos_x\n2,1\n", vec![1.0, 2.0]),
        ("y_coord,x_coord\n2,1\n", vec![1.0, 2.0]),
        ("py,px\n2,1\n", vec![1.0, 2.0]),
        ("N,E\n2,1\n", vec![1.0, 2.0]),
        ("Hochwert;Rechtswert\n2;1\n", vec![1.0, 2.0]),
        ("# y x\n2 1\n", vec![1.0, 2.0]),
        ("% y x\n2 1\n", vec![1.0, 2.0]),
        ("%y,x\n2,1\n", vec![1.0, 2.0]),
        ("//Z Y X\n3 2 1\n", vec![1.0, 2.0, 3.0]),
        ("//Time X Y Z\n9 1 2 3\n", vec![1.0, 2.0, 3.0]),
    ] {
        let (points, words) = told(content, false, None).expect(content);
        let (rows, notes) = vectors(content).expect(content);
        assert_eq!((&points[0], &rows[0]), (&expected, &expected), "{content}");
        assert!(!words.is_empty() && notes.len() == 1, "{words} {notes:?}");
    }
    let pose = rows(Path::new("p.csv"), b"y,x\n0,1\n1,0\n", Order::Matrix, None).expect_err("another order");
    assert!(pose.to_string().contains("in another order than the coordinates"), "{pose}");
}

#[test]
fn a_row_that_begins_with_a_mark_of_comments_is_no_comment_where_it_holds_numbers() {
    for error in ["#REF!", "#DIV/0!", "#N/A", "#VALUE!"] {
        let complaint = format!("line 2, column 1: '{error}' is not a finite number");
        let content = format!("1,2\n{error},5\n3,4\n");
        assert!(told(&content, false, None).expect_err(error).contains(&complaint));
        assert!(vectors(&content).expect_err(error).contains(&complaint));
    }
    let mut skipping = Skipping::new(true);
    let shape = Shape { columns: None, skip: None, wanted: Wanted::Planar, has_options: true, is_cloud: false };
    let reading = super::super::points(Path::new("p.csv"), b"1,2\n#REF!,5\n", &shape, &mut skipping).expect("a point");
    assert_eq!((reading.points.len(), skipping.count()), (1, 1));
    for content in ["#1,1,2\n#2,3,4\n", "#ff0000,1,2\n#00ff00,3,4\n", "name,x,y\n#1,1,2\n"] {
        match told(content, false, None) {
            Ok((points, _)) => assert_eq!(points, [[1.0, 2.0]], "{content}"),
            Err(complaint) => assert!(complaint.contains("is text; choose"), "{complaint}"),
        }
        assert!(vectors(content).is_err() || vectors(content).expect("rows").0 == [[1.0, 2.0]], "{content}");
    }
    let told = vec!["left out: 1 line that begins with #".to_owned()];
    for content in ["# 5,6\n1,2\n", "1,2\n#3,4\n", "1,2,3\n#3,4,5\n"] {
        assert_eq!(
            vectors(content).map(|(_, notes)| notes.iter().any(|note| note.contains("begins with #"))),
            Ok(true)
        );
    }
    assert_eq!(vectors("# by hand\n1,2\n"), Ok((vec![vec![1.0, 2.0]], told)));
}

#[test]
fn a_row_of_sizes_is_left_out_where_the_rows_agree_with_it() {
    for (content, expected) in [
        ("3 2\n1.0 2.0\n3.0 4.0\n5.0 6.0\n", vec![vec![1.0, 2.0], vec![3.0, 4.0], vec![5.0, 6.0]]),
        ("2 3\n1 2 3\n3 4 5\n", vec![vec![1.0, 2.0, 3.0], vec![3.0, 4.0, 5.0]]),
        ("2 2 0\n1 2\n3 4\n", vec![vec![1.0, 2.0], vec![3.0, 4.0]]),
        ("2 3 0 0\n1 1 2 3\n2 3 4 5\n", vec![vec![1.0, 2.0, 3.0], vec![3.0, 4.0, 5.0]]),
    ] {
        let (points, words) = told(content, false, None).expect(content);
        let (rows, notes) = vectors(content).expect(content);
        assert_eq!((&points, &rows), (&expected, &expected), "{content}");
        assert!(words.contains("says the sizes") && notes.concat().contains("says the sizes"), "{words} {notes:?}");
    }
    // a row that is as long as a point may be one, which standard error says
    let notes = |content: &str| {
        let shape = Shape { columns: None, skip: None, wanted: Wanted::Any, has_options: true, is_cloud: false };
        let reading = super::super::points(Path::new("p.csv"), content.as_bytes(), &shape, &mut Skipping::default());
        reading.expect("points").notes
    };
    let expected = "the first row (3, 2) is left out as the sizes of the table; --no-header reads it as a point";
    assert_eq!(notes("3 2\n1.0 2.0\n3.0 4.0\n5.0 6.0\n"), [expected]);
    assert_eq!(notes(&format!("9 2\n{}", "1 2\n".repeat(9))), [expected.replace("3, 2", "9, 2")]);
    // of few rows of whole numbers it is the first point
    for (content, row) in [("1 2\n3 4\n", "1, 2"), ("3 2\n1 2\n3 4\n5 6\n", "3, 2"), ("1 3 0\n4 5 6\n", "1, 3, 0")] {
        let read = format!("the first row ({row}) is read as data, though it may say the sizes of the table");
        assert_eq!(notes(content), [format!("{read}; --skip 1 leaves it out")], "{content}");
        let (rows, notes) = vectors(content).expect(content);
        assert_eq!((rows.len(), notes), (content.lines().count(), vec![read]), "{content}");
    }
    assert_eq!(notes("2 3\n1 2 3\n3 4 5\n"), [""; 0]);
    assert_eq!(vectors("2,2\n1,0\n0,1\n").expect("generators").0.len(), 3);
    assert_eq!(told("3 2\n1.0 2.0\n3.0 4.0\n5.0 6.0\n", false, Some(0)).expect("points").0.len(), 4);
    assert_eq!(told("4 2\n1 2\n3 4\n5 6\n", false, None).expect("points").0.len(), 4);
    // a point of large whole numbers takes no longer than another one, and none of its sums leaves their range
    for content in [
        "1 99999999999999999\n",
        "188800;0008415599203\n",
        "0 18446744073709551615 0 1\n",
        "1 2 18446744073709551615 1\n",
    ] {
        let whole = |cell: &str| cell.parse::<f64>().expect("a number");
        let row: Vec<f64> = content.trim().split([' ', ';']).map(whole).collect();
        assert_eq!(vectors(content).expect(content).0, [row], "{content}");
    }
}

#[test]
fn a_first_row_that_may_number_the_columns_is_asked_about() {
    let content = "0 1 2\n3 4 5\n6 7 9\n";
    let complaint = told(content, false, None).expect_err("a header or a point");
    assert!(complaint.contains("--skip 1 leaves it out, and --no-header reads it as data"), "{complaint}");
    assert_eq!(told(content, false, Some(0)).expect("points").0.len(), 3);
    assert_eq!(told(content, false, Some(1)).expect("points").0.len(), 2);
    assert_eq!(told(content, true, None).expect("points").0.len(), 3);
    assert_eq!(told("0.5 1 2\n3 4 5\n", false, None).expect("points").0.len(), 2);
}
