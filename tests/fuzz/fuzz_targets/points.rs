//! The readers of points and meshes: any bytes in any format are read or refused, and neither panics.
#![no_main]

use std::fs;
use std::path::PathBuf;

use libfuzzer_sys::fuzz_target;
use zonobench::input::{Format, PointSource, Wanted};

const FORMATS: [Format; 9] = [
    Format::Csv,
    Format::Xyz,
    Format::Geojson,
    Format::Json,
    Format::Npy,
    Format::Obj,
    Format::Ply,
    Format::Stl,
    Format::Off,
];

fuzz_target!(|bytes: &[u8]| {
    let [chosen, content @ ..] = bytes else { return };
    let file: PathBuf = std::env::temp_dir().join(format!("points-{}", std::process::id()));
    fs::write(&file, content).expect("there is a place for files");
    let wanted = [Wanted::Planar, Wanted::PlaneOrSpace, Wanted::Any][usize::from(chosen / 9 % 3)];
    let source = PointSource {
        format: Some(FORMATS[usize::from(chosen % 9)]),
        skip_nan: (chosen / 27 % 2 == 1).then_some(true),
        skip: (chosen / 54 % 2 == 1).then_some(1),
        ..PointSource::of_file(file)
    };
    match source.read(wanted) {
        Ok(reading) => {
            let _ = (reading.in_words(), reading.remarks());
            assert!(!reading.points.is_empty(), "a file without points is refused");
            assert!(
                reading.points.rows().flatten().all(|c| c.is_finite()),
                "what is not finite is refused or left out"
            );
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "a complaint is one line"),
    }
});
