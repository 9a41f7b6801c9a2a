//! Reads the load of a bed: a patient, or a ball, a cylinder, a plate or a mesh.

use super::mesh;
use crate::world::read::value::{Bound, count, list, needed, number, one_of};
use smartbed_bed::body::anthropometry::Table as Anthropometry;
use smartbed_bed::body::figure::{Angles, Figure, Posture};
use smartbed_bed::body::{Body, Segment, Shape, Surface};
use smartbed_bed::metrics::braden::{Braden, SUBSCALES};
use smartbed_bed::plan::Load;
use smartbed_bed::pose::Pose;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Value, wrong_kind};
use smartbed_runtime::vec3::norm;
use std::sync::Arc;

/// Anthropometric tables by name.
const TABLES: [(&str, Anthropometry); 3] = [
    ("de_leva_male", Anthropometry::DeLevaMale),
    ("de_leva_female", Anthropometry::DeLevaFemale),
    ("winter", Anthropometry::Winter),
];
/// Postures by name.
const POSTURES: [(&str, Posture); 3] =
    [("supine", Posture::Supine), ("side_lying", Posture::SideLying), ("sitting", Posture::Sitting)];
/// Shapes by name.
const SHAPES: [&str; 4] = ["ball", "cylinder", "plate", "mesh"];

/// Reads `[patient]` or `[load]` of the plan at a path; without either the bed is empty. Returns also the nurse's
/// scores of a patient.
pub(super) fn read(plan: &Fields<'_>, path: &str, found: &mut Diagnostics) -> Option<(Load, Option<Braden>)> {
    match (plan.table("patient", found), plan.table("load", found)) {
        (Some(table), None) => patient(table, found),
        (None, Some(table)) => Some((solid(table, path, found)?, None)),
        (None, None) => Some((Load { body: Body::default(), poses: Vec::new(), figure: None }, None)),
        (Some(_), Some(table)) => {
            let error = Diagnostic::error("[patient] and [load] are both given; expected one of them");
            found.push(error.label(table.span, "the second").help("leave one of them out"));
            None
        }
    }
}

fn place(fields: &Fields<'_>, found: &mut Diagnostics) -> Option<[f64; 2]> {
    fields.get("place").map_or(Some([0.0; 2]), |value| list::<2>(value, "place", "m", found))
}

/// One of several words, each with its meaning; the first if the key is missing.
pub(super) fn named<T: Copy>(
    fields: &Fields<'_>,
    key: &'static str,
    known: &[(&'static str, T)],
    found: &mut Diagnostics,
) -> Option<T> {
    let Some(text) = fields.text(key, found) else { return known.first().map(|(_, value)| *value) };
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let hit = one_of(&text.text, text.span, (key, &names), found)?;
    known.iter().find(|(name, _)| *name == hit).map(|(_, value)| *value)
}

fn patient(table: &Table, found: &mut Diagnostics) -> Option<(Load, Option<Braden>)> {
    let fields = Fields::of("patient", table.span, table);
    let posture = named(&fields, "posture", &POSTURES, found);
    let by = named(&fields, "table", &TABLES, found);
    let mass = number(&fields, "mass", "kg", Bound::Positive, found).unwrap_or(75.0);
    let stature = number(&fields, "stature", "m", Bound::Positive, found).unwrap_or(1.75);
    let stops = fields.boolean("stops", found).unwrap_or(false);
    let place = place(&fields, found);
    let joints = match fields.table("joints", found) {
        Some(table) => joints(table, found)?,
        None => Vec::new(),
    };
    let braden = match fields.table("braden", found) {
        Some(table) => Some(braden(table, found)?),
        None => None,
    };
    fields.finish(found);
    let figure = match Figure::new(by?, mass, stature, posture?, &joints) {
        Ok(figure) if stops => figure.with_stops(),
        Ok(figure) => figure,
        Err(error) => {
            let error = Diagnostic::error(error.to_string()).label(table.span, "of this patient");
            found.push(error.help("docs/bed.md lists the joints and their ranges"));
            return None;
        }
    };
    let (body, poses) = (figure.body.clone(), figure.poses.clone());
    Some((Load { body, poses, figure: Some(figure) }.placed(place?), braden))
}

/// Scores on the Braden scale, all six of them.
fn braden(table: &Table, found: &mut Diagnostics) -> Option<Braden> {
    let fields = Fields::of("braden", table.span, table);
    let marks = SUBSCALES.map(|(key, _)| {
        fields.need(key, "3", found)?;
        count(&fields, key, 1, found).map(|mark| u8::try_from(mark).unwrap_or(u8::MAX))
    });
    fields.finish(found);
    let marks: Vec<u8> = marks.into_iter().collect::<Option<_>>()?;
    match Braden::new(marks.try_into().ok()?) {
        Ok(braden) => Some(braden),
        Err(wrong) => {
            let error = Diagnostic::error(wrong.to_string()).label(table.span, "of these marks");
            found.push(error.help("1 is the worst; 4 the best, 3 of friction_and_shear"));
            None
        }
    }
}

/// Angles of joints: flexion, spread, twist.
fn joints(table: &Table, found: &mut Diagnostics) -> Option<Vec<(String, Angles)>> {
    let one = |(key, value): &(smartbed_codegen::model::document::Key, Value)| {
        if !matches!(value, Value::Array(..)) {
            let help = "\"left knee\" = [\"-30_deg\", 0, 0]: flexion, spread, twist";
            found.push(wrong_kind(&key.name, "three angles", value).help(help));
            return None;
        }
        let angles: [f64; 3] = list(value, &key.name, "", found)?;
        // Rounded to the author's digits, so that a limit is met exactly.
        Some((key.name.clone(), angles.map(|a| (a.to_degrees() * 1e9).round() / 1e9)))
    };
    table.entries.iter().map(one).collect()
}

fn solid(table: &Table, plan: &str, found: &mut Diagnostics) -> Option<Load> {
    let fields = Fields::of("load", table.span, table);
    let word = fields.need("shape", "\"ball\"", found)?;
    let Value::Text(text) = word else {
        found.push(wrong_kind("shape", "ball, cylinder, plate or mesh", word));
        return None;
    };
    let kind = one_of(&text.text, text.span, ("shape", &SHAPES), found)?;
    let surface = if kind == "mesh" { of_mesh(&fields, plan, found) } else { round(&fields, kind, found) };
    let mass = needed(&fields, "mass", ("kg", "\"10_kg\""), found);
    let foundation = number(&fields, "foundation", "Pa/m", Bound::Positive, found).unwrap_or(1e7);
    let turn = fields.get("turn").map_or(Some([0.0; 3]), |value| list::<3>(value, "turn", "", found));
    let place = place(&fields, found);
    fields.finish(found);
    let ((shape, own), turn) = (surface?, turn?);
    let angle = norm(turn);
    let axis = if angle > 0.0 { turn.map(|x| x / angle) } else { [1.0, 0.0, 0.0] };
    let pose = Pose::turned([0.0; 3], axis, angle).of(&own);
    let name = kind.to_owned();
    let segment = Segment { name, shape, mass: mass?, centre: [0.0; 3], foundation, free: [true; 6] };
    let load = Load { body: Body::single(segment), poses: vec![pose], figure: None };
    Some(load.placed(place?))
}

/// A box with rounded edges, along the axes of the load.
fn round(fields: &Fields<'_>, kind: &str, found: &mut Diagnostics) -> Option<(Surface, Pose)> {
    let radius = needed(fields, "radius", ("m", "\"0.1_m\""), found);
    let half = match kind {
        "ball" => Some([0.0; 3]),
        "cylinder" => needed(fields, "length", ("m", "\"0.4_m\""), found).map(|l| [0.5 * l, 0.0, 0.0]),
        _ => {
            let value = fields.need("size", "[\"0.3_m\", \"0.4_m\", \"0.02_m\"]", found)?;
            let size = list::<3>(value, "size", "m", found)?;
            if let Some(side) = size.iter().find(|side| **side < 0.0) {
                let error = Diagnostic::error(format!("a side of the plate is {side} m, expected >= 0"));
                found.push(
                    error
                        .label(value.span(), "without the round edge")
                        .help("size = [\"0.3_m\", \"0.4_m\", 0]"),
                );
                return None;
            }
            Some(size.map(|side| 0.5 * side))
        }
    };
    Some((Shape { half: half?, radius: radius? }.into(), Pose::at([0.0; 3])))
}

/// The solid in a mesh's file, and the pose of its principal axes.
fn of_mesh(fields: &Fields<'_>, plan: &str, found: &mut Diagnostics) -> Option<(Surface, Pose)> {
    let value = fields.need("file", "\"body.stl\"", found)?;
    let unit = number(fields, "unit", "m", Bound::Positive, found).unwrap_or(1.0);
    let Value::Text(file) = value else {
        found.push(wrong_kind("file", "the name of a mesh's file", value).help("file = \"body.stl\""));
        return None;
    };
    match mesh::read(&mesh::path(plan, &file.text), unit) {
        Ok((solid, pose)) => Some((Surface::Mesh(Arc::new(solid)), pose)),
        Err(what) => {
            let error = Diagnostic::error(format!("{}: {what}", file.text)).label(file.span, "this mesh");
            found.push(error.help(
                "a closed surface of triangles as .obj, .stl or .msh beside the plan; unit = \"1_mm\" says how long its unit is",
            ));
            None
        }
    }
}
