//! Formats by the first bytes of a content, whatever its name: a table that is none is refused by the name of the
//! format that it has.

use super::encoding;
use super::error::Problem;
use super::format::Format;
use super::mesh::{Keyword, binary_stl_length};
use super::number::is_number;
use batch::json::{self, MAX_VALUES};

/// First bytes of formats that are not read, with their names.
const FOREIGN: [(&[u8], &str); 33] = [
    (b"PK\x03\x04", "a ZIP archive, as files of spreadsheets (xlsx, ods) and of several arrays (npz) are"),
    (b"PK\x05\x06", "an empty ZIP archive"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "an old file of Excel or another of Microsoft's compound files"),
    (b"\x89HDF\r\n\x1a\n", "HDF5"),
    (b"CDF\x01", "NetCDF"),
    (b"CDF\x02", "NetCDF"),
    (b"%PDF-", "PDF"),
    (b"\x1f\x8b", "compressed by gzip"),
    (b"BZh", "compressed by bzip2"),
    (b"\xfd7zXZ\0", "compressed by xz"),
    (b"\x28\xb5\x2f\xfd", "compressed by Zstandard"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive"),
    (b"PAR1", "Parquet"),
    (b"ARROW1", "Arrow"),
    (b"FEA1", "Feather"),
    (b"SQLite format 3\0", "a database of SQLite, as GeoPackage is"),
    (b"MATLAB 5.0 MAT-file", "a MAT-file of MATLAB"),
    (b"LASF", "LAS"),
    (b"glTF", "glTF"),
    (b"Kaydara FBX", "FBX"),
    (b"\x89PNG\r\n\x1a\n", "a picture (PNG)"),
    (b"\xff\xd8\xff", "a picture (JPEG)"),
    (b"{\\rtf", "RTF"),
    (b"# vtk DataFile", "VTK"),
    (b"# .PCD", "PCD"),
    (b"ISO-10303-21", "STEP"),
    (b"$MeshFormat", "a mesh of Gmsh"),
    (b"#VRML", "VRML"),
    (b"<?xml", "XML"),
    (b"<!DOCTYPE", "HTML or XML"),
    (b"<html", "HTML"),
    (b"<svg", "SVG"),
    (b"<kml", "KML"),
];

/// Refuses a content that is of another format than the one in which it is to be read, by the name of that format and
/// with the option that names it.
pub(super) fn check(format: Format, content: &[u8], option: &'static str) -> Result<(), Problem> {
    match other(format, content)? {
        None => Ok(()),
        Some(found) => Err(Problem::OtherFormat { found: found.to_string(), named: format.to_string(), option }),
    }
}

/// The other format that is read and that a content has beyond doubt; an error if it is of none that is read.
pub(super) fn other(format: Format, content: &[u8]) -> Result<Option<Format>, Problem> {
    // The header of a binary STL may be any words.
    if format == Format::Stl && binary_stl_length(content) == Some(content.len() as u64) {
        return Ok(None);
    }
    let text = content.strip_prefix(b"\xef\xbb\xbf").unwrap_or(content);
    if let Some((_, name)) = FOREIGN.iter().find(|(bytes, _)| text.starts_with(bytes)) {
        return Err(Problem::ForeignContent((*name).to_owned()));
    }
    match own(format, content) {
        None if format.is_table() && is_binary(content) => {
            Err(Problem::ForeignContent("of a binary format, which none of its first bytes tells".to_owned()))
        }
        found => Ok(found.filter(|&found| found != format)),
    }
}

/// The format that is read and that a content has beyond doubt.
fn own(format: Format, content: &[u8]) -> Option<Format> {
    if content.starts_with(b"\x93NUMPY") {
        return Some(Format::Npy);
    }
    if format.is_table() && binary_stl_length(content) == Some(content.len() as u64) && is_binary(content) {
        return Some(Format::Stl);
    }
    let text = encoding::text(content).ok()?;
    let text = text.trim_ascii_start();
    let first = text.split(|&byte| byte == b'\n').next().unwrap_or_default().trim_ascii();
    let word = first.split(u8::is_ascii_whitespace).next().unwrap_or_default();
    if first == b"ply" {
        return Some(Format::Ply);
    }
    // Other formats than tables have complaints of their own about what stands first.
    if !format.is_table() {
        return None;
    }
    let has_word = |word: &[u8]| text.split(u8::is_ascii_whitespace).any(|other| other.eq_ignore_ascii_case(word));
    if word.eq_ignore_ascii_case(b"solid") && (has_word(b"facet") || has_word(b"endsolid")) {
        return Some(Format::Stl);
    }
    if word.to_ascii_uppercase().ends_with(b"OFF") && !first.contains(&b',') && is_off(text) {
        return Some(Format::Off);
    }
    let is_json = |text: &[u8]| json::read(text, MAX_VALUES).is_ok();
    if matches!(text.first(), Some(b'[' | b'{')) && (is_json(text) || is_json(first)) {
        return Some(Format::Json);
    }
    is_obj(text).then_some(Format::Obj)
}

/// Whether the word `OFF` is followed by two numbers of things, perhaps behind lines of comment.
fn is_off(text: &[u8]) -> bool {
    let lines = text.split(|&byte| byte == b'\n').map(|line| line.split(|&byte| byte == b'#').next().unwrap_or(line));
    let mut words = lines.flat_map(|line| line.split(u8::is_ascii_whitespace)).filter(|word| !word.is_empty()).skip(1);
    let mut is_count = || words.next().is_some_and(|word| word.iter().all(u8::is_ascii_digit));
    is_count() && is_count()
}

/// Whether each line begins with a word of OBJ, one at least with the `v` of a vertex before three numbers.
fn is_obj(text: &[u8]) -> bool {
    let without_comment = |line| <[u8]>::split(line, |&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
    let lines = text.split(|&byte| byte == b'\n').map(without_comment).filter(|line| !line.is_empty());
    let mut has_vertex = false;
    for line in lines {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match Keyword::of(words.next().unwrap_or_default()) {
            None => return false,
            Some(Keyword::Vertex) => has_vertex |= words.filter(|word| is_number(word)).count() >= 3,
            Some(_) => {}
        }
    }
    has_vertex
}

/// Whether a content has a byte that no text has.
fn is_binary(content: &[u8]) -> bool {
    encoding::text(content).is_ok_and(|text| text.contains(&0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaint(format: Format, content: &[u8]) -> Option<String> {
        check(format, content, "--format").err().map(|problem| problem.to_string())
    }

    #[test]
    fn foreign_contents_are_refused_by_their_name_in_every_text() {
        for (bytes, name) in FOREIGN {
            let content = [bytes, b"\x00\x01 and more\n1,2\n"].concat();
            for format in [Format::Csv, Format::Xyz, Format::Json, Format::Geojson, Format::Obj, Format::Off] {
                let complaint = complaint(format, &content).expect(name);
                assert!(complaint.contains(name) && complaint.contains("export the points as CSV"), "{complaint}");
            }
        }
        assert!(complaint(Format::Csv, b"\x00\x01\x02").expect("binary").contains("of a binary format"));
    }

    #[test]
    fn contents_of_other_formats_that_are_read_name_the_option() {
        let mut stl = vec![0; 84 + 50];
        stl[80] = 1;
        for (content, found) in [
            (&b"\x93NUMPY\x01\0v\0"[..], "npy"),
            (&stl, "stl"),
            (b"solid a\nfacet normal 0 0 1\n", "stl"),
            (b"ply\nformat ascii 1.0\n", "ply"),
            (b"OFF\n3 1 3\n0 0 0\n", "off"),
            (b"# made by hand\nOFF # counts\n3 1 3\n", "csv"),
            (b"COFF 3 1 3\n0 0 0 1 1 1 1\n", "off"),
            (b"[[0,0],[1,0],\n[0,1]]\n", "json"),
            (b"{\"type\":\"MultiPoint\",\"coordinates\":[[0,0]]}", "json"),
            (b"# c\nv 0 0 0\nv 1 0 0\nf 1 2 1\n", "obj"),
            (b"v 0 0 0\nv 1 0 0\n", "obj"),
        ] {
            for format in [Format::Csv, Format::Xyz] {
                let text = String::from_utf8_lossy(content);
                match complaint(format, content) {
                    Some(complaint) => assert!(complaint.contains(&format!("--format {found}")), "{complaint}"),
                    None => assert_eq!(found, "csv", "{text}"),
                }
            }
        }
        assert!(complaint(Format::Obj, b"ply\nformat ascii 1.0\n").expect("PLY").contains("--format ply"));
        assert!(complaint(Format::Json, b"\x93NUMPY\x01\0").expect("an array").contains("--format npy"));
    }

    #[test]
    fn tables_whose_first_bytes_look_like_those_of_a_format_stay_tables() {
        for content in [
            &b"1,2\n3,4\n"[..],
            b"solid,liquid\n1,2\n",
            b"solid liquid\n1 2\n",
            b"OFF,ON\n1,2\n",
            b"off on\n1 2\n",
            b"[m],[s]\n1,2\n",
            b"v w\n1 2\n",
            b"v,0,0\nv,1,1\n",
            b"V 0 0 0\nV 1 0 0\n",
            b"v 0 0 0\nw 1 0 0\n",
            b"#x y\n1 2\n",
            b"\xff\xfe1\0,\x002\0\n\0",
            b"",
        ] {
            assert_eq!(complaint(Format::Csv, content), None, "{}", String::from_utf8_lossy(content));
        }
    }
}
