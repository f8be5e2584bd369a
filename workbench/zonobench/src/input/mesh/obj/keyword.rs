//! The words with which the lines of Wavefront OBJ begin.

/// The use of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::input) enum Keyword {
    /// A vertex.
    Vertex,
    /// Points or a polyline.
    Element,
    /// A face.
    Face,
    /// A curve or a surface, whose control points follow so many parameters.
    FreeForm { parameters: usize },
    /// Names, normals, textures, materials, and what belongs to curves and surfaces beside their control points:
    /// nothing in these lines moves a vertex.
    Passed,
}

/// Words of lines that hold no vertices and refer to none.
const PASSED: &str = "\
    vt vn vp o g s mg usemtl mtllib usemap maplib lod bevel c_interp d_interp shadow_obj trace_obj ctech stech \
    cstype deg bmat step curv2 parm trim hole scrv sp end con";

impl Keyword {
    /// The use of a line by its first word, if OBJ has such lines.
    pub(in crate::input) fn of(word: &[u8]) -> Option<Self> {
        Some(match word {
            b"v" => Self::Vertex,
            b"p" | b"l" => Self::Element,
            b"f" | b"fo" => Self::Face,
            b"curv" => Self::FreeForm { parameters: 2 },
            b"surf" => Self::FreeForm { parameters: 4 },
            _ if PASSED.split_whitespace().any(|passed| passed.as_bytes() == word) => Self::Passed,
            _ => return None,
        })
    }
}
