//! The file formats that hold points.

use std::fmt;
use std::path::Path;

use clap::ValueEnum;

use super::error::{InputError, Place, Problem};

/// The file formats that hold points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A table of comma-, semicolon-, tab-, bar- or space-separated cells, with or without a header line.
    Csv,
    /// A cloud of points as scanners write it: a table whose columns are x, y, z and perhaps others.
    Xyz,
    /// Any GeoJSON object; every position in it is a point (longitude, latitude), altitudes are left out unless they
    /// are chosen as a column.
    Geojson,
    /// A JSON list of rows `[x, y, …]` or `{"x": …, "y": …}`, or an object that holds such a list under `points`, or
    /// whose fields are the columns.
    Json,
    /// An array of NumPy: floats or whole numbers in two dimensions, or records.
    Npy,
    /// A mesh, Wavefront OBJ: the vertices that faces, lines or points use, or all where there are none of these.
    Obj,
    /// A mesh or a cloud of points, PLY in text or binary.
    Ply,
    /// A mesh of triangles, STL in text or binary.
    Stl,
    /// A mesh, OFF in text.
    Off,
}

/// Extensions of tables, meshes, clouds of points and archives that are known, but not read.
const FOREIGN: &str = "\
    xlsx xls xlsm ods numbers parquet feather arrow mat h5 hdf5 nc npz pkl glb gltf dae vtk vtu vtp vtm msh mesh pcd \
    las laz e57 ptx rcp 3ds 3mf fbx blend step stp iges igs usd usda usdz x3d wrl shp gpkg kml kmz gpx tif tiff bag \
    pdf zip gz";

impl Format {
    /// The format that a file's extension names.
    pub fn of_extension(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" | "tsv" | "txt" => Some(Self::Csv),
            "xyz" | "pts" | "asc" => Some(Self::Xyz),
            "geojson" => Some(Self::Geojson),
            "json" => Some(Self::Json),
            "npy" => Some(Self::Npy),
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            "off" => Some(Self::Off),
            _ => None,
        }
    }

    /// Whether an extension is that of a known format that is not read, and that no other format's reader can read.
    pub(super) fn is_foreign(extension: &str) -> bool {
        let extension = extension.to_ascii_lowercase();
        FOREIGN.split_whitespace().any(|foreign| foreign == extension)
    }

    /// The format of a file: the one that was chosen, or that its extension names.
    pub(super) fn of_file(file: &Path, chosen: Option<Self>) -> Result<Self, InputError> {
        if let Some(format) = chosen.or_else(|| Self::of_extension(file)) {
            return Ok(format);
        }
        let is_standard_input = file.as_os_str() == "-";
        let problem = match (file.metadata(), file.extension().map(|extension| extension.to_string_lossy())) {
            (Err(error), _) if !is_standard_input => Problem::Unreadable(error),
            (Ok(metadata), _) if metadata.is_dir() => Problem::Folder,
            (_, Some(extension)) if Self::is_foreign(&extension) => Problem::ForeignFormat(extension.into_owned()),
            (_, Some(extension)) => Problem::UnreadFormat(extension.into_owned()),
            (_, None) => Problem::UnknownFormat,
        };
        Err(problem.at(file, Place::File))
    }

    /// Whether files of this format have columns of which some are chosen.
    pub fn has_columns(self) -> bool {
        !self.is_mesh()
    }

    /// Whether files of this format are tables in text, with lines that may be left out.
    pub fn is_table(self) -> bool {
        matches!(self, Self::Csv | Self::Xyz)
    }

    /// Whether files of this format hold meshes: points of space.
    pub fn is_mesh(self) -> bool {
        matches!(self, Self::Obj | Self::Ply | Self::Stl | Self::Off)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Csv => "csv",
            Self::Xyz => "xyz",
            Self::Geojson => "geojson",
            Self::Json => "json",
            Self::Npy => "npy",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Off => "off",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Text readers make nothing of these files, so that a message about them does not advise one.
    #[test]
    fn known_formats_that_are_not_read_are_to_be_exported() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let told = |name: &str, chosen: Option<Format>| {
            let file = folder.path().join(name);
            std::fs::write(&file, "1,2\n").expect("written");
            Format::of_file(&file, chosen).map_err(|error| error.to_string())
        };
        for extension in ["xlsx", "glb", "dae", "vtk", "vtu", "msh", "pcd", "GLTF"] {
            let name = format!("m.{extension}");
            let complaint = told(&name, None).expect_err(&name);
            assert!(complaint.contains("export the points as CSV, or the mesh as STL or PLY"), "{complaint}");
            assert!(!complaint.contains("--format"), "{complaint}");
            assert!(told(&name, Some(Format::Csv)).is_ok(), "{name}");
        }
        let complaint = told("p.dat", None).expect_err("unknown");
        assert!(complaint.contains("--format csv"), "{complaint}");
        for name in ["absent.dwg", "absent.xlsx", "iris.cvs", "absent"] {
            let complaint = Format::of_file(Path::new(name), None).expect_err(name).to_string();
            assert!(complaint.contains("cannot be read: No such file"), "{complaint}");
        }
    }
}
