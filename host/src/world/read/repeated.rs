//! Sensors and controllers of a part that `grid` repeats: one for each copy, like what is attached to it.
//!
//! In: sensors and controllers as written. Out: the same, where `[sensors.air] of = "bladder.gauge"` has become
//! `air[0,0]` of `bladder[0,0].gauge`, `air[0,1]`, ...; a controller reads what belongs to the copy that it drives.

use super::join::copy_of;
use crate::world::assembly::{Controlling, Part, Sensing};
use smartbed_codegen::source::fnv1a;

/// The indices, `[0,0]` and so on, of the copies of a repeated part; none where there is a part of this name.
fn copies<'p>(name: &'p str, parts: &'p [Part]) -> impl Iterator<Item = &'p str> {
    parts.iter().filter_map(move |part| copy_of(name, part))
}

/// `bladder.gauge` of the copy with these indices, if that part is repeated.
fn of_copy(column: &str, indices: &str, parts: &[Part]) -> Option<String> {
    let (part, own) = column.split_once('.')?;
    copies(part, parts).any(|copy| copy == indices).then(|| format!("{part}{indices}.{own}"))
}

/// The indices of the copies of the part whose column, or input, this is.
fn indices<'p>(column: &'p str, parts: &'p [Part]) -> Vec<&'p str> {
    column.split_once('.').map_or_else(Vec::new, |(part, _)| copies(part, parts).collect())
}

/// Sensors, one for each copy of what they read, with noise of its own.
pub(super) fn sensors(written: Vec<Sensing>, parts: &[Part]) -> Vec<Sensing> {
    let each = |own: Sensing| {
        let copies = indices(&own.of, parts);
        if copies.is_empty() {
            return vec![own];
        }
        let copy = |indices: &&str| {
            let of = of_copy(&own.of, indices, parts).unwrap_or_else(|| own.of.clone());
            let (name, seed) = (format!("{}{indices}", own.name), own.seed ^ fnv1a(indices.bytes()));
            Sensing { name, of, seed, ..own.clone() }
        };
        copies.iter().map(copy).collect()
    };
    written.into_iter().flat_map(each).collect()
}

/// Controllers, one for each copy of what they drive.
pub(super) fn controllers(
    written: Vec<Controlling>,
    sensors: &[Sensing],
    parts: &[Part],
) -> Vec<Controlling> {
    let each = |own: Controlling| {
        let copies = indices(&own.drives, parts);
        if copies.is_empty() {
            return vec![own];
        }
        let copy = |indices: &&str| {
            let beside = match own.reads.strip_prefix("sensors.") {
                Some(sensor) => {
                    let name = format!("{sensor}{indices}");
                    sensors.iter().any(|own| own.name == name).then(|| format!("sensors.{name}"))
                }
                None => of_copy(&own.reads, indices, parts),
            };
            Controlling {
                name: format!("{}{indices}", own.name),
                reads: beside.unwrap_or_else(|| own.reads.clone()),
                drives: of_copy(&own.drives, indices, parts).unwrap_or_else(|| own.drives.clone()),
                ..own.clone()
            }
        };
        copies.iter().map(copy).collect()
    };
    written.into_iter().flat_map(each).collect()
}
