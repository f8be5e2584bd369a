//! Lists of atoms, with a count and a title before them, and clouds whose first column may hold atomic numbers.

use super::*;

fn told(content: &str, is_cloud: bool) -> Result<(Points, String), String> {
    let shape = Shape { columns: None, skip: None, wanted: Wanted::Any, has_options: true, is_cloud };
    let reading = super::super::points(Path::new("m.xyz"), content.as_bytes(), &shape, &mut Skipping::default());
    reading.map(|reading| (reading.points.clone(), reading.in_words().unwrap_or_default())).map_err(|e| e.to_string())
}

#[test]
fn atoms_have_three_coordinates_whether_a_symbol_or_a_number_stands_before_them() {
    let expected = Points::Space(vec![[0.0, 0.0, 0.5], [1.0, 2.0, 3.0]]);
    for title in ["water", "a molecule of water", "", "# water", "3 4"] {
        for (first, second) in [("O", "H"), ("8", "1"), ("118", "6")] {
            let content = format!("2\n{title}\n{first} 0.0 0.0 0.5\n{second} 1 2 3\n");
            for is_cloud in [true, false] {
                match told(&content, is_cloud) {
                    Ok((points, told)) => {
                        assert_eq!(points, expected, "{content}");
                        assert!(told.contains("left out: column 1"), "{told}");
                        assert!(first == "O" || told.contains("column 1, the atomic numbers"), "{told}");
                    }
                    Err(complaint) => assert!(!is_cloud && complaint.contains("is text; choose"), "{complaint}"),
                }
            }
        }
    }
    let forces = "2\nProperties=species:I:1:pos:R:3\n8 0 0 0.5 9 9 9\n1 1 2 3 9 9 9\n";
    assert_eq!(told(forces, true).expect("atoms").0, expected);
    let two_frames = "1\na\n8 0 0 0.5\n1\nb\n8 1 2 3\n";
    assert!(told(two_frames, true).is_err(), "a second frame is not read as more atoms");
}

#[test]
fn a_cloud_whose_first_column_may_hold_atomic_numbers_says_how_it_is_read() {
    let advice = "if column 1 holds atomic numbers, --columns 2,3,4 leaves it out";
    let (points, words) = told("6 0.5 0 0\n8 1 1.5 1\n", true).expect("points");
    assert_eq!(points.dimension(), 3);
    assert!(words.contains(advice), "{words}");
    for plain in ["6.5 0 0 1\n8 1 1.5 1\n", "600 0.5 0 0\n8 1 1.5 1\n", "6 0 0 9\n8 1 1 9\n", "6 0.5 0\n8 1 1.5\n"] {
        let (_, words) = told(plain, true).expect("points");
        assert!(!words.contains("atomic"), "{words}");
    }
    let counted = "2\n600 0.5 0 0\n8 1 1.5 1\n";
    let cloud = Points::Space(vec![[600.0, 0.5, 0.0], [8.0, 1.0, 1.5]]);
    assert_eq!(told(counted, true).expect("a cloud with intensities").0, cloud);
}
