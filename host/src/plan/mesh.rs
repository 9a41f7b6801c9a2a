//! Reads a solid from a mesh's file: Wavefront OBJ, STL, Gmsh MSH.
//!
//! In: the path that a plan names, relative to the plan's own folder, and the length of the file's unit. Out: the solid
//! in its principal axes and their pose in the file's, or what is wrong with the file. Corners at equal positions are
//! merged.

use super::gmsh;
use crate::input;
use smartbed_bed::body::mesh::{Mesh, Solid};
use smartbed_bed::pose::Pose;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// Largest file (bytes): 200 000 triangles of text take 50 MB.
const LARGEST: u64 = 64 << 20;
/// Possible endings of a path.
const ENDINGS: &str = ".obj, .stl or .msh";

/// The path of the mesh's file that a plan names.
#[must_use]
pub fn path(plan: &str, file: &str) -> PathBuf {
    Path::new(plan).parent().unwrap_or(Path::new("")).join(file)
}

/// The bytes of a mesh's file.
///
/// # Errors
/// Why it cannot be read.
pub fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    input::bytes(path, LARGEST)
}

/// Reads a solid.
///
/// # Errors
/// A message if it is not a valid solid.
pub(super) fn read(path: &Path, unit: f64) -> Result<(Solid, Pose), String> {
    let bytes = bytes(path)?;
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let places = match ending.as_str() {
        "obj" => obj(&bytes)?,
        "stl" => stl(bytes)?,
        "msh" => {
            gmsh::triangles(std::str::from_utf8(&bytes).map_err(|_| "the mesh is not text".to_owned())?)?
        }
        _ => return Err(format!("expected a name that ends in {ENDINGS}")),
    };
    let mesh = Mesh::welded(places.into_iter().map(|place| place.map(|x| unit * x)));
    Solid::new(mesh).map_err(|fault| fault.to_string())
}

/// Three positions per triangle, of all objects together.
fn obj(bytes: &[u8]) -> Result<Vec<[f64; 3]>, String> {
    let bytes = joined(bytes);
    let options =
        tobj::LoadOptions { ignore_points: true, ignore_lines: true, ..tobj::LoadOptions::default() };
    // Materials are not used: no other file is read.
    let without = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut bytes.as_slice(), &options, without)
        .map_err(|error| format!("the mesh is no OBJ: {error}"))?;
    let mut places = Vec::new();
    for tobj::Model { mesh, .. } in models {
        if let Some(arity) = mesh.face_arities.iter().find(|arity| **arity != 3) {
            return Err(format!("the mesh has a face of {arity} corners, expected triangles"));
        }
        let corner = |n: &u32| {
            let at = 3 * *n as usize;
            [mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]]
        };
        places.extend(mesh.indices.iter().map(corner));
    }
    Ok(places)
}

/// Joins every line of an OBJ that ends in `\` with the next one; in a comment it is a letter as any other.
fn joined(bytes: &[u8]) -> Vec<u8> {
    let mut text = Vec::with_capacity(bytes.len());
    for line in bytes.split_inclusive(|byte| *byte == b'\n') {
        let is_comment = line.trim_ascii_start().starts_with(b"#");
        match line.trim_ascii_end().strip_suffix(b"\\") {
            Some(part) if !is_comment => text.extend(part.iter().chain(b" ")),
            _ => text.extend(line),
        }
    }
    text
}

/// Three positions per triangle.
fn stl(mut bytes: Vec<u8>) -> Result<Vec<[f64; 3]>, String> {
    // A binary file states the number of triangles, of 50 bytes each, after 80 bytes; some begin with the word of text
    // files nevertheless.
    let count = bytes.get(80..84).map(|c| u64::from(u32::from_le_bytes([c[0], c[1], c[2], c[3]])));
    if count.is_some_and(|count| bytes.len() as u64 == 84 + 50 * count) {
        bytes[..5].fill(0);
    }
    let wrong = |error: std::io::Error| format!("the mesh is no STL: {error}");
    let mut file = Cursor::new(bytes);
    let mut places = Vec::new();
    for triangle in stl_io::create_stl_reader(&mut file).map_err(wrong)? {
        places.extend(triangle.map_err(wrong)?.vertices.map(|corner| corner.0.map(f64::from)));
    }
    Ok(places)
}
