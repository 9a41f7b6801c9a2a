//! Patches of a mesh's skin, for maps, and a coarser mesh, for pictures.

use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, add, axpy, norm, scale};
use std::collections::BTreeMap;

/// A patch of the skin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Its centre (m).
    pub place: Vec3<f64>,
    /// Unit outward normal.
    pub normal: Vec3<f64>,
    /// Area (m^2).
    pub area: f64,
}

/// Patches of the skin about as wide as `width` (m): triangles in one cell of a grid that face about the same way are
/// merged; large triangles are bisected first.
pub(super) fn patches(mesh: &Mesh, width: f64) -> Vec<Patch> {
    let mut found: BTreeMap<([i64; 3], usize), Patch> = BTreeMap::new();
    let mut waiting: Vec<[Vec3<f64>; 3]> = (0..mesh.triangles.len()).map(|t| mesh.places(t)).collect();
    while let Some(places) = waiting.pop() {
        let length = |k: usize| norm(axpy(places[(k + 1) % 3], -1.0, places[k]));
        let longest = (1..3).fold(0, |best, k| if length(k) > length(best) { k } else { best });
        if length(longest) > width {
            let [a, b, c] = [0, 1, 2].map(|n| places[(longest + n) % 3]);
            let middle = scale(add(a, b), 0.5);
            waiting.extend([[a, middle, c], [middle, b, c]]);
            continue;
        }
        let doubled = doubled_area(places);
        let (area, middle) =
            (0.5 * norm(doubled), scale(add(add(places[0], places[1]), places[2]), 1.0 / 3.0));
        let axis = (1..3).fold(0, |best, k| if doubled[k].abs() > doubled[best].abs() { k } else { best });
        let side = 2 * axis + usize::from(doubled[axis] < 0.0);
        let cell = middle.map(|x| (x / width).floor() as i64);
        let own = found.entry((cell, side)).or_insert(Patch { place: [0.0; 3], normal: [0.0; 3], area: 0.0 });
        own.place = axpy(own.place, area, middle);
        own.normal = add(own.normal, doubled);
        own.area += area;
    }
    let whole = |p: Patch| Patch {
        place: scale(p.place, 1.0 / p.area),
        normal: scale(p.normal, 1.0 / norm(p.normal)),
        area: p.area,
    };
    found.into_values().map(whole).collect()
}

/// Merges the corners in each cell of a grid, which is made as coarse as needed to keep at most `most` triangles.
pub(super) fn coarse(mesh: &Mesh, most: usize) -> Mesh {
    let (mut found, mut width) = (mesh.clone(), 0.002);
    while found.triangles.len() > most.max(1) {
        let mut cells: BTreeMap<[i64; 3], usize> = BTreeMap::new();
        let (mut corners, mut shares) = (Vec::<Vec3<f64>>::new(), Vec::<f64>::new());
        let mut number = |place: &Vec3<f64>| {
            let key = place.map(|x| (x / width).floor() as i64);
            let own = *cells.entry(key).or_insert(corners.len());
            if own == corners.len() {
                corners.push([0.0; 3]);
                shares.push(0.0);
            }
            corners[own] = add(corners[own], *place);
            shares[own] += 1.0;
            own
        };
        let numbers: Vec<usize> = mesh.corners.iter().map(&mut number).collect();
        corners.iter_mut().zip(&shares).for_each(|(corner, count)| *corner = scale(*corner, 1.0 / count));
        let triangles = mesh.triangles.iter().map(|t| t.map(|corner| numbers[corner]));
        let triangles = triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        found = Mesh { corners, triangles };
        width *= 1.3;
    }
    found
}
