//! The readers of zonotopes: any bytes in any format and layout are read or refused, and neither panics.
#![no_main]

use std::fs;
use std::path::PathBuf;

use libfuzzer_sys::fuzz_target;
use zonobench::input::{BodySource, Format, Layout, OptionNames};

fuzz_target!(|bytes: &[u8]| {
    let [chosen, content @ ..] = bytes else { return };
    let file: PathBuf = std::env::temp_dir().join(format!("bodies-{}", std::process::id()));
    fs::write(&file, content).expect("there is a place for files");
    let layout = Layout {
        columns_are_generators: chosen / 4 % 2 == 1,
        center_first: chosen / 8 % 2 == 1,
        skip: (chosen / 16 % 2 == 1).then_some(1),
    };
    let format = [Format::Csv, Format::Json, Format::Json, Format::Npy][usize::from(chosen % 4)];
    let source = BodySource { file: file.clone(), format: Some(format), layout, options: OptionNames::OF_FIRST };
    match source.read(|told| assert!(!told.contains('\n'), "a remark is one line")) {
        Ok((placed, _)) => {
            let _ = (placed.question(), placed.exact(), placed.rounded(&file).is_ok(), placed.center());
            assert!(placed.reach() >= 0.0 || placed.reach().is_nan(), "a reach is no negative number");
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "a complaint is one line"),
    }
});
