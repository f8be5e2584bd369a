//! PLY in text or binary of either byte order. Texts keep all digits of a double, whatever type a property has.

mod header;

use self::header::{Element, Encoding, Header, Property};
use super::content::{Mesh, Misplaced, broken, finite, on_line, vertex_on_line};
use super::words::{lines, words};
use crate::input::error::{Place, Problem};
use crate::input::points::MAX_POINTS;
use crate::input::reading::{Skipping, counted};
use crate::input::{encoding, number};

const AXES: [&str; 3] = ["x", "y", "z"];

/// The names that programs give to the list of a face's corners.
const CORNERS: [&str; 2] = ["vertex_index", "vertex_indices"];

pub(super) fn read(content: &[u8], skipping: &mut Skipping) -> Result<Mesh, Misplaced> {
    // A mark of the encoding stands before a text alone.
    let text = if content.starts_with(b"ply") { content.into() } else { encoding::text(content).map_err(whole)? };
    let header = Header::read(&text)?;
    let mut vertices = header.elements.iter().filter(|element| element.name == "vertex");
    let axes = match vertices.next() {
        None => return Err((broken("PLY", "has no element `vertex`"), Place::File)),
        Some(element) => axes(element)?,
    };
    if vertices.next().is_some() {
        return Err((broken("PLY", "has two elements `vertex`"), Place::File));
    }
    let body = &text[header.end..];
    let mut file = File { axes, mesh: Mesh::default(), faces: Vec::new(), skipping };
    match header.encoding {
        Encoding::Text => file.text(&encoding::text(body).map_err(whole)?, &header)?,
        _ => file.binary(body, &header)?,
    }
    let File { mut mesh, faces, .. } = file;
    for (number, face) in (1..).zip(faces) {
        mesh.add_face(&face, "PLY").map_err(|problem| (problem, Place::Path(format!("face {number}"))))?;
    }
    Ok(mesh)
}

fn whole(problem: Problem) -> Misplaced {
    (problem, Place::File)
}

/// The properties that are the coordinates of a vertex.
fn axes(element: &Element) -> Result<[usize; 3], Misplaced> {
    if element.count > MAX_POINTS {
        return Err(whole(Problem::TooMany { what: "points", limit: MAX_POINTS }));
    }
    let mut axes = [0; 3];
    for (slot, axis) in axes.iter_mut().zip(AXES) {
        let place = element.properties.iter().position(|property| property.name == axis && property.count.is_none());
        let missing = || whole(broken("PLY", &format!("vertices have no property `{axis}`")));
        *slot = place.ok_or_else(missing)?;
    }
    Ok(axes)
}

/// The elements that were read.
struct File<'a> {
    axes: [usize; 3],
    mesh: Mesh,
    faces: Vec<Vec<usize>>,
    skipping: &'a mut Skipping,
}

impl File<'_> {
    /// Reads a text: an element is a line.
    fn text(&mut self, body: &[u8], header: &Header) -> Result<(), Misplaced> {
        let filled = lines(body).filter(|(_, line)| !line.trim_ascii().is_empty());
        let mut filled = filled.map(|(number, line)| (header.lines + number, line));
        for element in &header.elements {
            for index in 0..element.count {
                let Some((line, text)) = filled.next() else { return Err(ended(element, index)) };
                let words: Vec<&[u8]> = words(text).collect();
                let wrong = |complaint: String| {
                    (broken("PLY", &format!("{} {}: {complaint}", element.name, index + 1)), Place::Line(line))
                };
                let is_read = ["vertex", "face"].contains(&element.name.as_str());
                let places = match places(&words, &element.properties) {
                    // Lines that are not read may be of any form.
                    Err(_) if !is_read => continue,
                    places => places.map_err(wrong)?,
                };
                check_types(&words, &places, &element.properties).map_err(wrong)?;
                if element.name == "vertex" {
                    let columns = self.axes.map(|axis| places[axis]);
                    let numbers = columns.map(|column| column as u64 + 1);
                    let read = on_line(columns.map(|column| words[column]), numbers, line, &mut self.mesh.losses)?;
                    self.mesh.push(read, self.skipping, |number| vertex_on_line(number, line))?;
                }
                if element.name == "face" {
                    let corners = corner_list(element).map(|list| {
                        let end = places.get(list + 1).copied().unwrap_or(words.len());
                        &words[places[list] + 1..end]
                    });
                    let corner = |word: &&[u8]| {
                        let corner = number::number(word).ok().and_then(corner);
                        corner.ok_or_else(|| wrong(format!("the corner '{}' is no vertex", shown(word))))
                    };
                    let face: Vec<usize> = corners.unwrap_or_default().iter().map(corner).collect::<Result<_, _>>()?;
                    self.faces.push(face);
                }
            }
        }
        let surplus = counted(filled.count(), "line behind the last element", "lines behind the last element");
        self.mesh.left_out.extend(surplus);
        Ok(())
    }

    fn binary(&mut self, body: &[u8], header: &Header) -> Result<(), Misplaced> {
        let mut rest = body;
        for element in &header.elements {
            if element.properties.is_empty() {
                continue;
            }
            let corner_list = corner_list(element).filter(|_| element.name == "face");
            for index in 0..element.count {
                let mut vertex = [0.0; 3];
                for (number, property) in element.properties.iter().enumerate() {
                    let values = take(&mut rest, property, header.encoding).ok_or_else(|| ended(element, index))?;
                    let value = |bytes: &[u8]| property.kind.read(bytes, header.encoding);
                    if element.name == "vertex"
                        && let Some(axis) = self.axes.iter().position(|&axis| axis == number)
                    {
                        vertex[axis] = value(values);
                    }
                    if corner_list == Some(number) {
                        let corner = |bytes: &[u8]| {
                            let number = value(bytes);
                            corner(number).ok_or_else(|| {
                                let complaint = format!("the corner {number} is no vertex");
                                (broken("PLY", &complaint), Place::Path(format!("face {}", index + 1)))
                            })
                        };
                        let corners = values.chunks_exact(property.kind.bytes()).map(corner);
                        self.faces.push(corners.collect::<Result<_, _>>()?);
                    }
                }
                if element.name == "vertex" {
                    let place = |number| Place::Path(format!("vertex {number}"));
                    self.mesh.push(finite(vertex), self.skipping, place)?;
                }
            }
        }
        let surplus = counted(rest.len(), "byte behind the last element", "bytes behind the last element");
        self.mesh.left_out.extend(surplus);
        Ok(())
    }
}

fn ended(element: &Element, index: usize) -> Misplaced {
    let Element { name, count, .. } = element;
    (broken("PLY", &format!("ends after {index} of {count} elements `{name}`")), Place::File)
}

/// The property that lists the corners of a face.
fn corner_list(element: &Element) -> Option<usize> {
    let is_list = |property: &Property| property.count.is_some() && CORNERS.contains(&property.name.as_str());
    element.properties.iter().position(is_list)
}

/// The vertex that a number refers to, if it is a whole one that is not negative.
fn corner(number: f64) -> Option<usize> {
    (number >= 0.0 && number.fract() == 0.0).then_some(number as usize)
}

/// Refuses a word of an integer property that its type does not have, by the name of the property.
fn check_types(words: &[&[u8]], places: &[usize], properties: &[Property]) -> Result<(), String> {
    let ends = places.iter().skip(1).copied().chain([words.len()]);
    for ((property, &begin), end) in properties.iter().zip(places).zip(ends) {
        let values = begin + usize::from(property.count.is_some())..end;
        let lengths = property.count.map(|kind| (begin, kind));
        let all = lengths.into_iter().chain(values.map(|place| (place, property.kind)));
        for (place, kind) in all {
            if !kind.has(number::number(words[place]).ok()) {
                let (name, word) = (&property.name, shown(words[place]));
                return Err(format!("`{name}` is of the type {kind}, which '{word}' is not"));
            }
        }
    }
    Ok(())
}

/// A word as a message shows it.
fn shown(word: &[u8]) -> String {
    String::from_utf8_lossy(word).escape_debug().to_string()
}

/// The first word of every property on a line, which has no others.
fn places(words: &[&[u8]], properties: &[Property]) -> Result<Vec<usize>, String> {
    let mut places = Vec::with_capacity(properties.len());
    let mut next = 0_usize;
    let found = words.len();
    for property in properties {
        places.push(next);
        let count = match property.count {
            None => 0,
            Some(_) => {
                let count = words.get(next).and_then(|word| std::str::from_utf8(word).ok()?.parse::<usize>().ok());
                count.ok_or_else(|| format!("the list `{}` has no length", property.name))?
            }
        };
        next = next.saturating_add(1).saturating_add(count);
    }
    if next == found { Ok(places) } else { Err(format!("the line has {found} numbers, not {next}")) }
}

/// The bytes of the next property: of a list, those behind its length.
fn take<'a>(rest: &mut &'a [u8], property: &Property, encoding: Encoding) -> Option<&'a [u8]> {
    let count = match property.count {
        None => 1,
        Some(kind) => {
            let (bytes, behind) = rest.split_at_checked(kind.bytes())?;
            *rest = behind;
            let count = kind.read(bytes, encoding);
            (count >= 0.0).then_some(count as usize)?
        }
    };
    let (values, behind) = rest.split_at_checked(count.checked_mul(property.kind.bytes())?)?;
    *rest = behind;
    Some(values)
}
