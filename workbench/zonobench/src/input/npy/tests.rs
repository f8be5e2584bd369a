//! Arrays of every version, type and order, and files that are none.

use super::*;

/// A file of the given version, with the header that NumPy writes.
fn file_of(version: u8, kind: &str, is_fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}");
    file_with(version, &header, data)
}

fn file_with(version: u8, header: &str, data: &[u8]) -> Vec<u8> {
    let begins = if version == 1 { 10 } else { 12 };
    let padded = format!("{header:<width$}\n", width = (begins + header.len() + 1).next_multiple_of(64) - begins - 1);
    let length = u32::try_from(padded.len()).expect("a short header").to_le_bytes();
    let length = if version == 1 { &length[..2] } else { &length[..] };
    [MAGIC, &[version, 0], length, padded.as_bytes(), data].concat()
}

fn bytes<const N: usize, T: Copy>(numbers: &[T], write: fn(T) -> [u8; N]) -> Vec<u8> {
    numbers.iter().flat_map(|&number| write(number)).collect()
}

fn read(content: &[u8], columns: Option<&str>, wanted: Wanted) -> Result<Reading, String> {
    let columns = columns.map(|columns| columns.parse().expect("the test's columns are well formed"));
    points(Path::new("p.npy"), content, columns.as_ref(), wanted, &mut Skipping::default())
        .map_err(|error| error.to_string())
}

#[test]
fn rows_of_records_have_the_names_of_their_fields() {
    let header = "{'descr': [('c', '<f8'), ('g1', '<f8'), ('g2', '<f8')], 'fortran_order': False, 'shape': (1,), }";
    let content = file_with(1, header, &bytes(&[1.0, 2.0, 3.0], f64::to_le_bytes));
    let found = rows(Path::new("p.npy"), &content, Order::Coordinates).expect("records");
    assert_eq!(
        (found.names, found.numbers),
        (["c", "g1", "g2"].map(str::to_owned).to_vec(), vec![vec![1.0, 2.0, 3.0]])
    );
    let content = file_of(1, "<f8", false, "(1, 2)", &bytes(&[1.0, 2.0], f64::to_le_bytes));
    let found = rows(Path::new("p.npy"), &content, Order::Coordinates).expect("an array");
    assert!(found.names.is_empty());
}

/// The fields of records pass through the same questions as the columns of a table.
#[test]
fn fields_of_vectors_are_put_in_order_and_labels_left_out() {
    let records = |fields: &str, numbers: &[f64]| {
        let header = format!("{{'descr': [{fields}], 'fortran_order': False, 'shape': (1,), }}");
        let content = file_with(1, &header, &bytes(numbers, f64::to_le_bytes));
        let found = super::rows(Path::new("p.npy"), &content, Order::Coordinates).map_err(|error| error.to_string())?;
        Ok::<_, String>((found.numbers, found.notes))
    };
    let left_out = |name: &str| vec![format!("left out: the column {name}")];
    assert_eq!(
        records("('index', '<f8'), ('x', '<f8'), ('y', '<f8')", &[7.0, 1.0, 2.0]),
        Ok((vec![vec![1.0, 2.0]], left_out("index")))
    );
    assert_eq!(
        records("('a', '<f8'), ('b', '<f8'), ('w', '<f8')", &[1.0, 2.0, 9.0]),
        Ok((vec![vec![1.0, 2.0]], left_out("w")))
    );
    let told = vec!["the columns are read in the order x, y".to_owned()];
    assert_eq!(records("('y', '<f8'), ('x', '<f8')", &[2.0, 1.0]), Ok((vec![vec![1.0, 2.0]], told)));
    let several = records("('c', '<f8', (2,)), ('G', '<f8', (2, 2))", &[1.0; 6]);
    assert!(several.expect_err("arrays").contains("the field `c` of the records is an array"));
    assert!(records("('G', '<f8', (2, 2))", &[1.0; 4]).expect_err("a matrix").contains("the field `G`"));
    assert_eq!(records("('g', '<f8', (2,))", &[1.0, 2.0]), Ok((vec![vec![1.0, 2.0]], Vec::new())));
}

#[test]
fn versions_types_and_orders() {
    let whole = [1, -2, 3, 4, -5, 6];
    let rows = vec![vec![1.0, -2.0, 3.0], vec![4.0, -5.0, 6.0]];
    let floats = whole.map(f64::from);
    let by_columns = [0, 3, 1, 4, 2, 5].map(|index| floats[index]);
    let files = [
        ("<f8", false, bytes(&floats, f64::to_le_bytes)),
        (">f8", false, bytes(&floats, f64::to_be_bytes)),
        ("<f8", true, bytes(&by_columns, f64::to_le_bytes)),
        (">f8", true, bytes(&by_columns, f64::to_be_bytes)),
        ("<f4", false, bytes(&floats.map(|x| x as f32), f32::to_le_bytes)),
        (">f4", false, bytes(&floats.map(|x| x as f32), f32::to_be_bytes)),
        ("<i8", false, bytes(&whole.map(i64::from), i64::to_le_bytes)),
        (">i8", false, bytes(&whole.map(i64::from), i64::to_be_bytes)),
        ("<i4", false, bytes(&whole, i32::to_le_bytes)),
        (">i4", false, bytes(&whole, i32::to_be_bytes)),
        ("<i2", false, bytes(&whole.map(|x| x as i16), i16::to_le_bytes)),
        (">i2", false, bytes(&whole.map(|x| x as i16), i16::to_be_bytes)),
        ("|i1", false, bytes(&whole.map(|x| x as i8), i8::to_le_bytes)),
    ];
    let space = Points::Space(vec![[1.0, -2.0, 3.0], [4.0, -5.0, 6.0]]);
    for (kind, is_fortran, data) in files {
        for version in 1..=3 {
            let content = file_of(version, kind, is_fortran, "(2, 3)", &data);
            assert_eq!(
                super::rows(Path::new("p.npy"), &content, Order::Coordinates).expect("an array").numbers,
                rows,
                "{version} {kind}"
            );
            let reading = read(&content, None, Wanted::PlaneOrSpace).expect("points of space");
            assert_eq!(reading.points, space, "{version} {kind}");
        }
    }
    let unsigned = file_of(1, "<u2", false, "(2, 1)", &bytes(&[1, 65_535], u16::to_le_bytes));
    assert_eq!(
        super::rows(Path::new("p.npy"), &unsigned, Order::Coordinates).expect("an array").numbers,
        [[1.0], [65_535.0]]
    );
    let old = file_with(1, "{\"shape\": (1L, 2L), 'fortran_order':False,'descr':\"|u1\"}", &[7, 255]);
    assert_eq!(super::rows(Path::new("p.npy"), &old, Order::Coordinates).expect("an array").numbers, [[7.0, 255.0]]);
    let wide = file_of(1, "|u1", false, "(1, 6)", &[1, 2, 3, 4, 5, 6]);
    assert_eq!(
        super::rows(Path::new("p.npy"), &wide, Order::Coordinates).expect("an array").numbers,
        [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]]
    );
}

#[test]
fn columns_are_chosen_by_number() {
    let content = file_of(1, "|u1", false, "(2, 3)", &[1, 2, 3, 4, 5, 6]);
    let reading = read(&content, Some("3,1"), Wanted::Planar).expect("points of the plane");
    assert_eq!(reading.points, Points::Plane(vec![[3.0, 1.0], [6.0, 4.0]]));
    assert_eq!(reading.in_words().as_deref(), Some("3, 1; left out: column 2"));
    let complaint = |columns: Option<&str>| read(&content, columns, Wanted::Planar).expect_err("a wrong choice");
    assert_eq!(complaint(None), "p.npy: has 3 column(s); choose two with --columns, such as --columns 1,2");
    assert_eq!(complaint(Some("1,4")), "p.npy: there is no column 4; the row has 3 cells");
    assert_eq!(complaint(Some("x,y")), "p.npy: there is no column 'x'; the columns are numbered 1 to 3");
}

/// Records are read by the names of their fields: those of coordinates, or those that are chosen.
#[test]
fn fields_of_records_are_columns() {
    let number = |x: f32| x.to_le_bytes();
    let record = |x: f32, y: f32, z: f32| {
        [&b"ab"[..], &number(z), &number(x), &[7, 0], &number(y), &number(0.5), &number(f32::NAN)].concat()
    };
    let header = "{'descr': [('id', '|S2'), ('Z', '<f4'), ('X', '<f4'), ('', '|V2'), ('Y', '<f4'), \
        ('normal', '<f4', (2,))], 'fortran_order': False, 'shape': (2,), }";
    let content = file_with(1, header, &[record(1.0, 2.0, 3.0), record(4.0, 5.0, 6.0)].concat());
    let reading = read(&content, None, Wanted::PlaneOrSpace).expect("points of space");
    assert_eq!(reading.points, Points::Space(vec![[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
    assert_eq!(reading.in_words().as_deref(), Some("X, Y, Z; left out: id, normal[0], normal[1]"));
    let reading = read(&content, Some("y,2"), Wanted::Planar).expect("points of the plane");
    assert_eq!(reading.points, Points::Plane(vec![[2.0, 3.0], [5.0, 6.0]]));
    let complaint = |columns: Option<&str>| read(&content, columns, Wanted::Planar).expect_err("a wrong choice");
    assert!(complaint(None).contains("has the columns x, y and z"));
    assert_eq!(
        complaint(Some("x,id")),
        "p.npy: id: numbers of the type '|S2' are not read; real numbers of at most 64 bits are"
    );
    assert!(
        complaint(Some("x,w")).ends_with("there is no column 'w'; the columns are id, Z, X, Y, normal[0], normal[1]")
    );
    assert_eq!(complaint(Some("x,normal[1]")), "p.npy: [0][5]: 'NaN' is not a finite number");
}

/// The field of a position holds the points, whatever else the records have.
#[test]
fn the_position_of_records_holds_the_points() {
    let of = |name: &str, shape: &str| {
        let header = format!(
            "{{'descr': [('id', '|u1'), ('{name}', '|u1', {shape}), ('normal', '|u1', (3,))], \
             'fortran_order': False, 'shape': (1,)}}"
        );
        let count = if shape == "(3,)" { 7 } else { 6 };
        file_with(1, &header, &[7, 1, 2, 3, 4, 5, 6][..count])
    };
    for wanted in [Wanted::PlaneOrSpace, Wanted::Any] {
        let reading = read(&of("Pos", "(3,)"), None, wanted).expect("points of space");
        assert_eq!(reading.points, Points::Space(vec![[1.0, 2.0, 3.0]]));
        let left_out = "Pos[0], Pos[1], Pos[2]; left out: id, normal[0], normal[1], normal[2]";
        assert_eq!(reading.in_words().as_deref(), Some(left_out));
        assert_eq!(read(&of("xy", "(2,)"), None, wanted).expect("points").points, Points::Plane(vec![[1.0, 2.0]]));
        let unnamed = read(&of("velocity", "(3,)"), None, wanted).expect_err("no field is a position");
        assert!(unnamed.contains("has 7 column(s); choose two to four with --columns"), "{unnamed}");
    }
}

#[test]
fn halves_are_read_and_what_is_not_finite_is_skipped() {
    let halves = [0x3800_u16, 0xc000, 0x7e00, 0x3c00, 0x0001, 0x7bff];
    for (kind, data) in [("<f2", bytes(&halves, u16::to_le_bytes)), (">f2", bytes(&halves, u16::to_be_bytes))] {
        let content = file_of(1, kind, false, "(3, 2)", &data);
        let mut skipping = Skipping::new(true);
        let reading = points(Path::new("p.npy"), &content, None, Wanted::Planar, &mut skipping).expect("two points");
        assert_eq!(reading.points, Points::Plane(vec![[0.5, -2.0], [2.0_f64.powi(-24), 65504.0]]));
        assert_eq!(skipping.count(), 1);
    }
}

#[test]
fn what_is_no_array_of_points_is_refused() {
    let complaint = |content: &[u8]| {
        let error = super::rows(Path::new("p.npy"), content, Order::Coordinates).expect_err("no array").to_string();
        error.strip_prefix("p.npy: ").expect("the file is named").to_owned()
    };
    let is_not = |reason: &str| format!("is not npy: {reason}");
    assert_eq!(complaint(b"1,2\n"), is_not("it does not begin as arrays of NumPy do"));
    assert_eq!(complaint(b"\x93NUMPY\x04\x00"), is_not("its version is not 1.0, 2.0 or 3.0"));
    assert_eq!(complaint(b"\x93NUMPY\x02\x00\xff\xff\xff\xff{"), is_not("it ends within the header"));
    let of_shape = |shape: &str| file_of(1, "|u1", false, shape, &[1, 2]);
    assert_eq!(complaint(&of_shape("(2,)")), "the array has 1 dimension(s), not 2: a row for each point");
    assert_eq!(complaint(&of_shape("()")), "the array has 0 dimension(s), not 2: a row for each point");
    assert_eq!(complaint(&of_shape("(1, 3)")), is_not("2 bytes follow the header, not 1 × 3 numbers of 1 bytes"));
    assert_eq!(complaint(&of_shape("(99999999, 1)")), "is too large: more than 10000000 points");
    assert!(complaint(&of_shape("(2, 18446744073709551615)")).contains("2 bytes follow the header"));
    let nested = format!("{{'descr': {}", "[".repeat(60_000));
    let within = "{'descr': [('p', [('x', '<f8')])], 'fortran_order': False, 'shape': (1,)}";
    for header in ["", "{}", "{'descr': '|u1'}", "{'descr': [('x', '<f8')], 'shape': (1, 2)}", within, nested.as_str()]
    {
        assert_eq!(
            complaint(&file_with(1, header, &[1])),
            is_not("its header is not that of an array of plain numbers or of records")
        );
    }
    assert_eq!(complaint(b"PK\x03\x04"), is_not("it is an archive of arrays, .npz; save one array as .npy"));
    let of_records = |fields: &str, shape: &str| {
        complaint(&file_with(1, &format!("{{'descr': [{fields}], 'fortran_order': False, 'shape': {shape}}}"), &[1, 2]))
    };
    let by_two = "the records have 2 dimension(s), not 1: a record for each point";
    assert_eq!(of_records("('x', '|u1')", "(1, 2)"), by_two);
    assert_eq!(of_records("('x', '|u1')", "(3,)"), is_not("2 bytes follow the header, not 3 records of 1 bytes"));
    assert_eq!(of_records("('x', '|O')", "(2,)"), "fields of the type '|O' are not read");
    assert_eq!(of_records("('x', '<f\n\x00')", "(2,)"), r"fields of the type '<f\n\0' are not read");
    assert!(of_records("('x', '|u1', (99999999,))", "(2,)").contains("more than 65536 numbers in a record"));
    assert_eq!(
        of_records("('x', '|S1')", "(2,)"),
        "x: numbers of the type '|S1' are not read; real numbers of at most 64 bits are"
    );
    for kind in ["<f16", "<c16", "|b1", "|O", "f8", "|f8", "<U3", ""] {
        let expected = format!("numbers of the type '{kind}' are not read; real numbers of at most 64 bits are");
        assert_eq!(complaint(&file_of(1, kind, false, "(1, 1)", &[1])), expected);
    }
    let infinite = file_of(1, "<f8", true, "(2, 1)", &bytes(&[1.0, f64::INFINITY], f64::to_le_bytes));
    assert_eq!(complaint(&infinite), "[1][0]: 'inf' is not a finite number");
    let long = file_of(1, "<u8", false, "(1, 2)", &bytes(&[1 << 53, (1 << 53) + 1], u64::to_le_bytes));
    assert_eq!(complaint(&long), "[0][1]: 9007199254740993 is not a double: reading it would round it");
}
