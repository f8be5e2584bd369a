//! Wavefront OBJ: the vertices that faces, lines, points, curves or surfaces use, in the order of the file, and the
//! faces. A file without any of these elements is a cloud of points. The control points of a curve or a surface stand
//! for it: those of Bézier curves and B-splines enclose it.

mod keyword;

use std::borrow::Cow;

pub(in crate::input) use self::keyword::Keyword;
use super::content::{Mesh, Misplaced, broken, on_line, vertex_on_line};
use super::words::{lines, words};
use crate::input::encoding;
use crate::input::error::{Place, Problem};
use crate::input::number::{self, Losses};
use crate::input::points::{MAX_POINTS, push_limited};
use crate::input::reading::{Skipping, counted};

pub(super) fn read(content: &[u8], skipping: &mut Skipping) -> Result<Mesh, Misplaced> {
    let text = encoding::text(content).map_err(|problem| (problem, Place::File))?;
    let mut file = Elements::default();
    let mut physical = lines(&text);
    while let Some((line, first)) = physical.next() {
        let (whole, is_glued) = continued(first, &mut physical);
        let mut rest = words(&whole);
        let at_line = |problem: Problem| (problem, Place::Line(line));
        let Some(word) = rest.next() else { continue };
        let keyword = Keyword::of(word);
        if is_glued && !matches!(keyword, None | Some(Keyword::Passed)) {
            let complaint = "a backslash between two characters may separate two numbers or join one";
            return Err(at_line(broken("OBJ", complaint)));
        }
        match keyword {
            Some(Keyword::Vertex) => file.vertex(line, &rest.collect::<Vec<_>>())?,
            Some(keyword @ (Keyword::Element | Keyword::Face)) => {
                file.element(line, rest, keyword == Keyword::Face).map_err(at_line)?;
            }
            Some(Keyword::FreeForm { parameters }) => file.free_form(line, rest, parameters).map_err(at_line)?,
            Some(Keyword::Passed) => {}
            None => {
                file.unknown.0 += 1;
                file.unknown.1.get_or_insert_with(|| (String::from_utf8_lossy(word).into_owned(), line));
            }
        }
    }
    file.mesh(skipping)
}

/// A line without its comment, and the lines with which a backslash at its end continues it; and whether some
/// backslash stands between two characters that are no space.
fn continued<'a>(first: &'a [u8], more: &mut impl Iterator<Item = (u64, &'a [u8])>) -> (Cow<'a, [u8]>, bool) {
    let without_comment = |line: &'a [u8]| line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii_end();
    let is_space = |byte: Option<&u8>| byte.is_none_or(u8::is_ascii_whitespace);
    let mut whole = Cow::Borrowed(without_comment(first));
    let mut is_glued = false;
    while let Some(begin) = whole.strip_suffix(b"\\") {
        let mut joined = begin.to_vec();
        let next = more.next().map(|(_, line)| without_comment(line)).unwrap_or_default();
        is_glued |= !is_space(joined.last()) && !is_space(next.first());
        joined.extend(next);
        whole = Cow::Owned(joined);
    }
    (whole, is_glued)
}

/// The elements of a file.
#[derive(Default)]
struct Elements {
    vertices: Vec<[f64; 3]>,
    /// The vertices with a coordinate that is missing or not finite, by number, with their lines: an error only if they
    /// are used.
    missing: Vec<(usize, u64, Problem)>,
    /// The number of vertices that were divided by a weight.
    weighted: usize,
    /// The vertices with other numbers than three, a weight or a colour: how many, the count of the first, its line.
    longer: (usize, Option<(usize, u64)>),
    faces: Vec<Box<[usize]>>,
    is_used: Vec<bool>,
    /// The largest vertex that is used, with the line that does so.
    farthest: Option<(usize, u64)>,
    /// Whether a vertex is a control point of a curve or a surface.
    is_control: Vec<bool>,
    /// The lines that begin with a word that OBJ does not have: their number, and the first one.
    unknown: (usize, Option<(String, u64)>),
    losses: Losses,
}

impl Elements {
    /// A vertex: three coordinates, with a weight as the fourth number or with colours behind.
    fn vertex(&mut self, line: u64, numbers: &[&[u8]]) -> Result<(), Misplaced> {
        let at = |problem, column: usize| (problem, Place::Cell { line, column: column as u64 });
        let &[x, y, z, ref rest @ ..] = numbers else {
            let has_commas = numbers.iter().any(|number| number.contains(&b','));
            let between = if has_commas { ", with spaces between them, not commas" } else { "" };
            return Err(at(broken("OBJ", &format!("a vertex has three coordinates{between}")), numbers.len() + 1));
        };
        if !matches!(rest.len(), 0 | 1 | 3) {
            self.longer.0 += 1;
            self.longer.1.get_or_insert((numbers.len(), line));
        }
        let mut weight = 1.0;
        if let &[word] = rest {
            weight = number::number(word).map_err(|problem| at(problem, 4))?;
            self.losses.note(word, weight, || Place::Cell { line, column: 4 });
        }
        if weight == 0.0 {
            return Err(at(broken("OBJ", "a vertex of weight 0 lies at infinity"), 4));
        }
        self.weighted += usize::from(weight != 1.0);
        let vertex = match on_line([x, y, z], [1, 2, 3], line, &mut self.losses)? {
            Ok(vertex) => vertex.map(|x| x / weight),
            Err(problem) => {
                self.missing.push((self.vertices.len(), line, problem));
                [f64::NAN; 3]
            }
        };
        if vertex.iter().any(|x| x.is_infinite()) {
            return Err(at(broken("OBJ", "a coordinate divided by its weight is outside the range of a double"), 4));
        }
        push_limited(&mut self.vertices, vertex).map_err(|problem| (problem, Place::Line(line)))
    }

    /// A point, line or face, by references to vertices and perhaps to textures and normals.
    fn element<'a>(
        &mut self,
        line: u64,
        references: impl Iterator<Item = &'a [u8]>,
        is_face: bool,
    ) -> Result<(), Problem> {
        let corners = self.corners(line, references)?;
        if is_face && corners.len() >= 3 {
            self.faces.push(corners);
        }
        Ok(())
    }

    /// A curve or a surface, by the ends of its parameters and references to its control points.
    fn free_form<'a>(
        &mut self,
        line: u64,
        words: impl Iterator<Item = &'a [u8]>,
        parameters: usize,
    ) -> Result<(), Problem> {
        let corners = self.corners(line, words.skip(parameters))?;
        for &corner in corners.iter().filter(|&&corner| corner < MAX_POINTS) {
            if corner >= self.is_control.len() {
                self.is_control.resize(corner + 1, false);
            }
            self.is_control[corner] = true;
        }
        Ok(())
    }

    /// The vertices that an element refers to, which are used from then on.
    fn corners<'a>(&mut self, line: u64, references: impl Iterator<Item = &'a [u8]>) -> Result<Box<[usize]>, Problem> {
        let count = self.vertices.len();
        let corner = |reference: &[u8]| {
            let index = reference.split(|&byte| byte == b'/').next().unwrap_or_default();
            let index: i64 = std::str::from_utf8(index).ok()?.parse().ok()?;
            // Numbers count from 1; negative ones count back from the last vertex before the line.
            let index = if index < 0 { index.checked_add_unsigned(count as u64)? } else { index - 1 };
            usize::try_from(index).ok()
        };
        let corners = references.map(|reference| {
            corner(reference).ok_or_else(|| {
                broken("OBJ", &format!("'{}' is no vertex", String::from_utf8_lossy(reference).escape_debug()))
            })
        });
        let corners: Box<[usize]> = corners.collect::<Result<_, _>>()?;
        for &corner in &corners {
            if self.farthest.is_none_or(|(farthest, _)| corner > farthest) {
                self.farthest = Some((corner, line));
            }
            if let Some(is_used) = self.is_used.get_mut(corner) {
                *is_used = true;
            } else if corner < MAX_POINTS {
                self.is_used.resize(corner + 1, false);
                self.is_used[corner] = true;
            }
        }
        Ok(corners)
    }

    /// The mesh of the vertices that are used.
    fn mesh(mut self, skipping: &mut Skipping) -> Result<Mesh, Misplaced> {
        let count = self.vertices.len();
        if let Some((farthest, line)) = self.farthest.filter(|&(farthest, _)| farthest >= count) {
            let complaint = format!("the vertex {} is used, of {count}", farthest + 1);
            return Err((broken("OBJ", &complaint), Place::Line(line)));
        }
        if let (0, (_, Some((word, line)))) = (count, &self.unknown) {
            let complaint = format!("'{}' is no word with which its lines begin", word.escape_debug());
            return Err((broken("OBJ", &complaint), Place::Line(*line)));
        }
        self.is_used.resize(count, self.farthest.is_none());
        let mut mesh = Mesh::default();
        let mut places = vec![0; count];
        let mut missing = self.missing.into_iter().peekable();
        for (index, vertex) in self.vertices.into_iter().enumerate() {
            let gap = missing.next_if(|&(number, ..)| number == index);
            if !self.is_used[index] {
                continue;
            }
            places[index] = mesh.vertices.len();
            let (line, vertex) = match gap {
                Some((_, line, problem)) => (line, Err(problem)),
                None => (0, Ok(vertex)),
            };
            mesh.push(vertex, skipping, |_| vertex_on_line(index + 1, line))?;
        }
        mesh.faces = self.faces;
        mesh.faces.iter_mut().flat_map(|face| face.iter_mut()).for_each(|corner| *corner = places[*corner]);
        let unused = count - mesh.vertices.len();
        mesh.left_out.extend(counted(unused, "vertex that nothing uses", "vertices that nothing uses"));
        if let (vertices, Some((numbers, line))) = self.longer {
            let begin = counted(vertices, "vertex", "vertices").unwrap_or_default();
            mesh.left_out.push(format!(
                "the numbers behind three coordinates of {begin} (the first has {numbers}, line {line}), which may be \
                 a weight and a colour"
            ));
        }
        if let (lines, Some((word, line))) = self.unknown {
            let begin = counted(lines, "line that begins with a word", "lines that begin with words");
            let word = word.escape_debug();
            mesh.left_out.extend(begin.map(|begin| format!("{begin} that OBJ does not have ('{word}', line {line})")));
        }
        let controls = self.is_control.iter().filter(|&&is_control| is_control).count();
        mesh.notes.extend(counted(
            controls,
            "vertex is a control point of curves or surfaces, which are not read themselves",
            "vertices are control points of curves or surfaces, which are not read themselves",
        ));
        mesh.losses = self.losses;
        mesh.notes.extend(counted(self.weighted, "vertex divided by its weight", "vertices divided by their weights"));
        Ok(mesh)
    }
}
