//! Tables as other programs write them: decimal commas, numbers for names, clouds of scanners, encodings.

use super::*;

#[test]
fn decimal_commas_are_read_where_they_are_plain_and_refused_by_name_elsewhere() {
    let expected = Ok(vec![[0.5, 0.5], [1.5, -2500.0]]);
    for content in [
        "0,5;0,5\n1,5;-2,5e3\n",
        "x;y\n0,5;0,5\n1,5;-2500\n",
        "x;y\r\n\"0,5\";\"0,5\"\r\n\"1,5\";\"-2500\"\r\n",
        "0,5\t0,5\n1,5\t-2500,000\n",
        "\"0,5\",\"0,5\"\n\"1,5\",\"-2500\"\n",
        "sep=;\n0,5;0,5\n1,5;-2500\n",
    ] {
        assert_eq!(read(content, None), expected, "{content}");
    }
    let columns: Columns = "1,2".parse().expect("well formed");
    let told = points(Path::new("p.csv"), b"0,5;0,5\n", Some(&columns), None, Wanted::Planar).expect("a point");
    assert_eq!(told.in_words().as_deref(), Some("1, 2; commas are read as decimal points"));
    let complaint = |content: &str, columns: Option<&str>| read(content, columns).expect_err("commas are in doubt");
    assert_eq!(
        complaint("0,5;0,5\n1,5;0,5\n", Some("1,3")),
        "points.csv: line 1: there is no column 3; the row has 2 cells"
    );
    assert!(complaint("0,5 1,5\n2,5 3,5\n", None).contains("'0,5' may be one number with a decimal comma or two"));
    assert!(complaint("1;2\n1,234;5,678\n", None).contains("line 2, column 1: the comma of '1,234' may be"));
    assert!(complaint("0,5;1\n1.5;2\n", None).contains("'0,5' has a decimal comma, but another number"));
    assert!(complaint("1.234,5;2\n3;4\n", None).contains("'1.234,5' has separators of thousands"));
    assert!(complaint("1 234,5;2\n3;4\n", None).contains("'1 234,5' has separators of thousands"));
    assert!(complaint("\"1,234.5\",2\n3,4\n", None).contains("separators of thousands"));
    assert!(complaint("0,5:0,5\n1,5:0,5\n", None).contains("column 2: '5:0' is not a number; if commas are decimal"));
    assert_eq!(complaint("0,5|0,5\n1,5|0,5\n", Some("1,3")), complaint("0,5;0,5\n1,5;0,5\n", Some("1,3")));
    for halves in ["0,5,0,5\n1,5,0,5\n", "-0,5,1,25\n1,5,0,5\n", "0,5,1,5,2,5\n1,5,0,5,2,0\n"] {
        assert!(
            complaint(halves, None).contains("if their commas are decimal ones, separate the cells by"),
            "{halves}"
        );
    }
    for columns in ["0,5,0,-5\n", "0,5,0.5,1\n", "0\t5\t0\t5\n", "1,2,3,4,5\n"] {
        assert!(complaint(columns, None).contains("column(s); choose two with --columns"), "{columns}");
    }
    assert!(complaint("x,y\n0,5,1,5\n", None).contains("if its commas are decimal ones, separate the cells by"));
}

#[test]
fn numbers_in_place_of_names_are_left_out_or_told() {
    let read = |content: &str, wanted: Wanted| {
        let reading = points(Path::new("p.csv"), content.as_bytes(), None, None, wanted).expect("points");
        let again =
            points(Path::new("p.csv"), content.as_bytes(), Some(&Columns(reading.columns.clone())), None, wanted);
        assert_eq!(again.expect("the same columns").points, reading.points, "{content}");
        let told = reading.in_words().unwrap_or_default();
        (reading.points, told)
    };
    let plane = |points: &[[f64; 2]]| Points::Plane(points.to_vec());
    let (found, told) = read("0,1\n0.5,0.5\n1.5,2.0\n", Wanted::Planar);
    assert_eq!(found, plane(&[[0.5, 0.5], [1.5, 2.0]]));
    assert_eq!(told, "1, 2; left out: the first row (0, 1), which numbers the columns");
    let (found, _) = read("0,1,2\n0.5,0.5,1.5\n1.5,2.5,3.5\n", Wanted::Any);
    assert_eq!(found, Points::Space(vec![[0.5, 0.5, 1.5], [1.5, 2.5, 3.5]]));
    let (found, told) = read("0,1\n0.866,-0.5\n-0.866,-0.5\n", Wanted::Planar);
    assert_eq!((found.len(), told.as_str()), (3, "1, 2; the first row (0, 1) is read as data; --skip 1 leaves it out"));
    let (found, told) = read("0,1\n5,6\n", Wanted::Planar);
    assert_eq!(found, plane(&[[0.0, 1.0], [5.0, 6.0]]));
    assert_eq!(told, "1, 2; the first row (0, 1) is read as data; --skip 1 leaves it out");
    let (found, told) = read(",0,1\n0,0.5,0.5\n1,1.5,3\n", Wanted::Planar);
    assert_eq!(found, plane(&[[0.5, 0.5], [1.5, 3.0]]));
    let index = "left out: column 1, which counts the rows";
    assert_eq!(told, format!("2, 3; {index}, the first row (0, 1), which numbers the columns"));
    for content in [",a,b\n0,5,6\n1,7,8\n", "\"\",\"a\",\"b\"\n\"1\",5,6\n\"2\",7,8\n", "a b\n1 5 6\n2 7 8\n"] {
        let (found, told) = read(content, Wanted::Planar);
        assert_eq!((found, told), (plane(&[[5.0, 6.0], [7.0, 8.0]]), format!("a, b; {index}")), "{content}");
    }
    let (found, told) = read("0,5,6\n1,7,8\n2,9,9\n", Wanted::Any);
    assert_eq!(found.dimension(), 3);
    assert_eq!(told, "1, 2, 3; column 1 counts the rows and is read as a coordinate; --columns 2,3 leaves it out");
    let rows = rows(Path::new("z.csv"), b",g1,g2\n0,1,0\n1,0,2\n", Order::Coordinates, None).expect("numbers");
    assert_eq!((rows.names.join(" "), rows.numbers), ("g1 g2".to_owned(), vec![vec![1.0, 0.0], vec![0.0, 2.0]]));
    assert_eq!(rows.notes, [index]);
    let refused = points(Path::new("p.csv"), b"x,y\n5,2,7\n", None, None, Wanted::Planar).expect_err("ragged");
    assert_eq!(refused.to_string(), "p.csv: line 2, column 3: the row has 3 cells, not 2");
}

#[test]
fn clouds_of_scanners_are_tables_of_x_y_z() {
    let read = |content: &str, wanted: Wanted| {
        let shape = Shape { columns: None, skip: None, wanted, has_options: true, is_cloud: true };
        let reading = super::super::points(Path::new("p.xyz"), content.as_bytes(), &shape, &mut Skipping::default());
        reading.map(|reading| (reading.points.clone(), reading.in_words())).map_err(|error| error.to_string())
    };
    let space = || Points::Space(vec![[0.0, 0.0, 0.5], [1.0, 0.0, 0.0]]);
    for (content, told) in [
        ("0 0 .5\n1 0 0\n", "1, 2, 3"),
        ("0\t0 0.5\n1 0\t0\n", "1, 2, 3"),
        ("0,0,0.5\n1,0,0\n", "1, 2, 3"),
        ("0 0 0.5 7 255 0 0\n1 0 0 7 0 255 0\n", "1, 2, 3; left out: column 4, column 5, column 6, column 7"),
        ("2\n0 0 0.5\n1 0 0\n", "1, 2, 3; left out: the first row, which counts 2 points"),
        ("//X,Y,Z,R\n0,0,0.5,1\n1,0,0,1\n", "X, Y, Z; left out: R"),
        ("//X Y Z\n2\n0 0 0.5\n1 0 0\n", "X, Y, Z; left out: the second row, which counts 2 points"),
        ("# from a scanner\n0 0 0.5 # first\n1 0 0\n", "1, 2, 3; left out: 1 line that begins with #"),
        ("% x y z\n// more\n0 0 0.5\n1 0 0\n", "x, y, z; left out: 1 line that begins with //"),
        (
            "% corners\n// more\n0 0 0.5\n1 0 0\n",
            "1, 2, 3; left out: 1 line that begins with %, 1 line that begins with //",
        ),
        (
            "2\nwater, nearly\nO 0 0 0.5\nH 1 0 0\n",
            "2, 3, 4; left out: column 1, the first row, which counts 2 points, the second row, a title",
        ),
        ("z;x;y\n0.5;0;0\n0;1;0\n", "x, y, z"),
    ] {
        assert_eq!(read(content, Wanted::PlaneOrSpace), Ok((space(), Some(told.to_owned()))), "{content}");
    }
    assert!(read("0 0 0\n1 0 0\n", Wanted::Planar).expect_err("in space").contains("points are in space"));
    let wrong = "p.xyz: a line counts 3 points, but 2 follow";
    assert_eq!(read("3\n0 0 0\n1 0 0\n", Wanted::PlaneOrSpace), Err(wrong.to_owned()));
    let grid = "p.xyz: is a grid of heights, which holds no points";
    assert_eq!(read("ncols 2\nnrows 1\nxllcorner 0\n1 2\n", Wanted::PlaneOrSpace), Err(grid.to_owned()));
}

#[test]
fn rows_that_are_not_finite_are_left_out_where_that_is_asked() {
    let read = |content: &str| {
        let mut skipping = Skipping::new(true);
        let shape = Shape { columns: None, skip: None, wanted: Wanted::Planar, has_options: true, is_cloud: false };
        let reading = super::super::points(Path::new("p.csv"), content.as_bytes(), &shape, &mut skipping);
        reading.map(|reading| (reading.points.len(), skipping.count())).map_err(|error| error.to_string())
    };
    assert_eq!(read("x,y\n1,2\nnan,3\n,4\nNA,5\n6,-inf\n7,1.#QNAN\n"), Ok((1, 5)));
    assert_eq!(read("3\n1,2\n5,nan\n3,4\n"), Ok((2, 1)), "the line counts what is left out");
    assert_eq!(read("1,2\n1e999,3\n"), Ok((1, 1)), "no double is so large");
    assert!(read("1,2\nnan,north\n").expect_err("no number").contains("'north' is not a number"));
}

#[test]
fn encodings_are_read_or_named() {
    let wide: Vec<u8> = "\u{feff}x,y\r\n1,2\r\n3,4\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let read = |content: &[u8]| {
        let reading = points(Path::new("p.csv"), content, None, None, Wanted::Planar);
        reading.map(|reading| reading.points).map_err(|error| error.to_string())
    };
    assert_eq!(read(&wide), Ok(Points::Plane(vec![[1.0, 2.0], [3.0, 4.0]])));
    assert!(read(&wide[2..]).expect_err("no mark").contains("is in UTF-16 without a byte order mark"));
    assert_eq!(read(b"# made by hand\rx,y\r1,2\r3,4"), Ok(Points::Plane(vec![[1.0, 2.0], [3.0, 4.0]])));
}

#[test]
fn a_comment_that_has_the_names_asked_for_is_the_header() {
    let trajectory = "# a ground truth\n# timestamp tx ty tz qx qy qz qw\n9 1 2 3 0 0 0 1\n8 4 5 6 0 0 0 1\n";
    let read = |columns: &str| {
        let columns: Columns = columns.parse().expect("columns");
        let shape =
            Shape { columns: Some(&columns), skip: None, wanted: Wanted::Any, has_options: true, is_cloud: false };
        let reading = super::super::points(Path::new("t.txt"), trajectory.as_bytes(), &shape, &mut Skipping::default());
        let rows = |reading: Reading| reading.points.rows().map(<[f64]>::to_vec).collect::<Vec<_>>();
        reading.map(rows).map_err(|error| error.to_string())
    };
    assert_eq!(read("tx,ty,tz"), Ok(vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]]));
    assert_eq!(read("TZ,timestamp"), Ok(vec![vec![3.0, 9.0], vec![6.0, 8.0]]));
    let missing = read("tx,tw").expect_err("no such column");
    assert!(missing.contains("there is no column 'tx'") && missing.contains("a comment"), "{missing}");
}
