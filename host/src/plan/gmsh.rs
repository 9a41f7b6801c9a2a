//! Reads triangles from a mesh of Gmsh: MSH 2.2 and 4.1 as text.
//!
//! In: a file's text. Out: positions of corners, three per triangle, in the file's unit. Elements of points, lines and
//! volumes are skipped; surface elements other than flat triangles are refused (Gmsh reference manual, 10: file
//! formats).

use std::collections::HashMap;
use std::str::SplitAsciiWhitespace;

/// Gmsh's element type of flat triangles.
const TRIANGLE: usize = 2;
/// Element types of points, lines and volumes, which are not part of a surface.
const OTHERS: [usize; 16] = [1, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 17, 18, 19, 26, 27];

/// Positions of the triangles' corners.
///
/// # Errors
/// A message about what is invalid.
pub(super) fn triangles(text: &str) -> Result<Vec<[f64; 3]>, String> {
    let mut format = section(text, "MeshFormat")?;
    let (version, kind) = (format.word("a version")?, format.count("a kind of file")?);
    if kind != 0 {
        return Err("the mesh is binary; write it as text: gmsh -format msh41 -save".to_owned());
    }
    let [nodes, elements] = ["Nodes", "Elements"].map(|name| section(text, name));
    let (nodes, triangles) = match version {
        "2.2" => old(nodes?, elements?)?,
        "4.1" => new(nodes?, elements?)?,
        other => return Err(format!("the mesh is of format {other}, expected 2.2 or 4.1")),
    };
    let place = |tag: usize| nodes.get(&tag).copied().ok_or_else(|| format!("there is no node {tag}"));
    triangles.into_iter().flatten().map(place).collect()
}

/// Positions by tag, and triangles by tags.
type Parts = (HashMap<usize, [f64; 3]>, Vec<[usize; 3]>);

/// MSH 2.2: one node per line; one element per line, with its type and number of tags.
fn old(mut nodes: Words, mut elements: Words) -> Result<Parts, String> {
    let (mut places, mut triangles) = (HashMap::new(), Vec::new());
    for _ in 0..nodes.count("how many nodes")? {
        places.insert(nodes.count("a node's number")?, nodes.place()?);
    }
    for _ in 0..elements.count("how many elements")? {
        elements.line()?;
        let (_, kind) = (elements.count("an element's number")?, elements.count("its kind")?);
        for _ in 0..elements.count("how many tags")? {
            elements.word("a tag")?;
        }
        if is_triangle(kind)? {
            triangles.push(elements.corners()?);
        }
    }
    Ok((places, triangles))
}

/// MSH 4.1: blocks of nodes, tags first; blocks of elements of one kind.
fn new(mut nodes: Words, mut elements: Words) -> Result<Parts, String> {
    let (mut places, mut triangles) = (HashMap::new(), Vec::new());
    let blocks = nodes.count("how many blocks of nodes")?;
    for _ in 0..blocks {
        nodes.line()?;
        nodes.skip(3)?;
        let mut tags = Vec::new();
        for _ in 0..nodes.count("how many nodes of a block")? {
            nodes.line()?;
            tags.push(nodes.count("a node's tag")?);
        }
        for tag in tags {
            nodes.line()?;
            places.insert(tag, nodes.place()?);
        }
    }
    let blocks = elements.count("how many blocks of elements")?;
    for _ in 0..blocks {
        elements.line()?;
        elements.skip(2)?;
        let (kind, count) = (elements.count("a kind of elements")?, elements.count("how many elements")?);
        let is_wanted = is_triangle(kind)?;
        for _ in 0..count {
            elements.line()?;
            elements.skip(1)?;
            if is_wanted {
                triangles.push(elements.corners()?);
            }
        }
    }
    Ok((places, triangles))
}

fn is_triangle(kind: usize) -> Result<bool, String> {
    match kind {
        TRIANGLE => Ok(true),
        _ if OTHERS.contains(&kind) => Ok(false),
        3 | 10 | 16 => Err("the mesh has four-sided faces, expected triangles".to_owned()),
        _ => Err(format!("the mesh has faces of Gmsh's kind {kind}, expected flat triangles (kind 2)")),
    }
}

/// Words of a section, line by line.
struct Words<'a> {
    name: &'static str,
    lines: std::str::Lines<'a>,
    words: SplitAsciiWhitespace<'a>,
}

/// The text between $NAME and $EndNAME.
fn section<'a>(text: &'a str, name: &'static str) -> Result<Words<'a>, String> {
    let (start, end) = (format!("${name}"), format!("$End{name}"));
    let missing = || format!("the mesh has no section {start}");
    let (_, rest) = text.split_once(&start).ok_or_else(missing)?;
    let (inner, _) = rest.split_once(&end).ok_or_else(|| format!("the section {start} has no {end}"))?;
    Ok(Words { name, lines: inner.lines(), words: "".split_ascii_whitespace() })
}

impl<'a> Words<'a> {
    /// Goes to the next line that is not empty, skipping the rest of this one.
    fn line(&mut self) -> Result<(), String> {
        let next = self.lines.by_ref().find(|line| !line.trim().is_empty());
        self.words = next
            .ok_or_else(|| format!("the section ${} ends too early", self.name))?
            .split_ascii_whitespace();
        Ok(())
    }

    fn word(&mut self, what: &str) -> Result<&'a str, String> {
        if let Some(word) = self.words.next() {
            return Ok(word);
        }
        self.line()?;
        self.words.next().ok_or_else(|| format!("the section ${} lacks {what}", self.name))
    }

    fn skip(&mut self, count: usize) -> Result<(), String> {
        (0..count).try_for_each(|_| self.word("a number").map(|_| ()))
    }

    fn count(&mut self, what: &str) -> Result<usize, String> {
        let word = self.word(what)?;
        word.parse().map_err(|_| format!("the section ${} has {word:?}, expected {what}", self.name))
    }

    fn place(&mut self) -> Result<[f64; 3], String> {
        let mut place = [0.0; 3];
        for x in &mut place {
            let word = self.word("a coordinate")?;
            *x = word
                .parse()
                .map_err(|_| format!("the section ${} has {word:?}, expected a coordinate", self.name))?;
        }
        Ok(place)
    }

    fn corners(&mut self) -> Result<[usize; 3], String> {
        Ok([self.count("a corner")?, self.count("a corner")?, self.count("a corner")?])
    }
}
