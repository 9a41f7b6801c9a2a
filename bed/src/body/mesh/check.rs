//! Checks that a surface is closed, a manifold, and of a plausible size.
//!
//! In: a mesh. Out: the same with outward normals and without degenerate triangles, or what is wrong with it and where.
//! Each edge must belong to two triangles that run along it in opposite directions; the triangles around a corner must
//! form one ring. No two triangles may meet elsewhere (`crossing`), and all parts of the surface must face outwards,
//! cavities inwards (`parts`).

use super::crossing::crossing;
use super::mass::Moments;
use super::parts::is_inside_out;
use super::triangles::{Mesh, doubled_area};
use smartbed_runtime::vec3::{Vec3, norm};
use std::collections::BTreeMap;
use std::fmt;

/// Most triangles of a mesh.
pub const MOST_TRIANGLES: usize = 200_000;
/// Smallest and largest allowed value of the longest side of a mesh (m).
const SIDES: [f64; 2] = [0.01, 3.0];
/// A triangle whose area is below this share of the longest side squared has no reliable normal.
const THINNEST: f64 = 1e-13;

/// The reason why a mesh is not a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshFault {
    /// It has no triangles.
    Empty,
    /// It has this many triangles.
    TooMany(usize),
    /// This corner, counted from 1, has a coordinate that is not finite.
    NotFinite(usize),
    /// This triangle, counted from 1, names a corner that does not exist.
    NoCorner(usize),
    /// The length of its longest side (m) is implausible.
    Size(f64),
    /// A triangle at this place has no area.
    Flat(Vec3<f64>),
    /// Number of edges that belong to only one triangle, and the place of one of them.
    Open(usize, Vec3<f64>),
    /// An edge at this place belongs to this number of triangles.
    NotManifold(usize, Vec3<f64>),
    /// Neighbouring triangles at this place have opposite orientations.
    Turned(Vec3<f64>),
    /// Two parts of the surface share only this corner.
    Pinched(Vec3<f64>),
    /// The surface intersects or touches itself at this place.
    Crossed(Vec3<f64>),
    /// The part of the surface at this place faces the other way than the rest.
    InsideOut(Vec3<f64>),
    /// It encloses no volume; this is its volume (m^3).
    Hollow(f64),
}

impl fmt::Display for MeshFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = |[x, y, z]: &Vec3<f64>| format!("at ({x:.4}, {y:.4}, {z:.4}) m");
        match self {
            MeshFault::Empty => f.write_str("the mesh has no triangles"),
            MeshFault::TooMany(count) => {
                write!(f, "the mesh has {count} triangles, expected at most {MOST_TRIANGLES}")
            }
            MeshFault::NotFinite(corner) => {
                write!(f, "a coordinate of corner {corner} of the mesh is not a number")
            }
            MeshFault::NoCorner(triangle) => {
                write!(f, "triangle {triangle} of the mesh refers to a corner that does not exist")
            }
            MeshFault::Size(longest) => write!(
                f,
                "the longest side of the mesh is {longest:.3e} m, expected {} to {} m",
                SIDES[0], SIDES[1]
            ),
            MeshFault::Flat(place) => write!(f, "a triangle {} has no area", at(place)),
            MeshFault::Open(count, place) => write!(
                f,
                "the mesh is open: {count} of its edges belong to one triangle only, one of them {}",
                at(place)
            ),
            MeshFault::NotManifold(count, place) => {
                write!(
                    f,
                    "the mesh is not a manifold: an edge {} belongs to {count} triangles, expected 2",
                    at(place)
                )
            }
            MeshFault::Turned(place) => {
                write!(
                    f,
                    "neighbouring triangles {} have opposite orientations; expected corners in the same sense",
                    at(place)
                )
            }
            MeshFault::Pinched(place) => {
                write!(f, "the mesh is not a manifold: parts of it meet {} in one corner only", at(place))
            }
            MeshFault::Crossed(place) => write!(f, "the mesh intersects itself {}", at(place)),
            MeshFault::InsideOut(place) => write!(
                f,
                "the part of the mesh {} is oriented opposite to the rest: expected normals outwards, of cavities \
                 inwards",
                at(place)
            ),
            MeshFault::Hollow(volume) => {
                write!(f, "the mesh encloses {volume:.1e} m^3, expected more than 0")
            }
        }
    }
}

impl std::error::Error for MeshFault {}

/// Applies all checks to a mesh.
pub(super) fn checked(mut mesh: Mesh) -> Result<Mesh, MeshFault> {
    if mesh.triangles.len() > MOST_TRIANGLES {
        return Err(MeshFault::TooMany(mesh.triangles.len()));
    }
    if let Some(corner) = mesh.corners.iter().position(|c| !c.iter().all(|x| x.is_finite())) {
        return Err(MeshFault::NotFinite(corner + 1));
    }
    if let Some(triangle) = mesh.triangles.iter().position(|t| t.iter().any(|c| *c >= mesh.corners.len())) {
        return Err(MeshFault::NoCorner(triangle + 1));
    }
    // A triangle with a repeated corner is a line; its neighbours close the surface without it.
    mesh.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    if mesh.triangles.is_empty() {
        return Err(MeshFault::Empty);
    }
    mesh = used(mesh);
    let [low, high] = mesh.bounds();
    let longest = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    if !(SIDES[0]..=SIDES[1]).contains(&longest) {
        return Err(MeshFault::Size(longest));
    }
    for triangle in 0..mesh.triangles.len() {
        let places = mesh.places(triangle);
        if norm(doubled_area(places)) < THINNEST * longest * longest {
            return Err(MeshFault::Flat(places[0]));
        }
    }
    edges(&mesh)?;
    rings(&mesh)?;
    let Moments { volume, .. } = Moments::of(&mesh);
    if volume.abs() < 1e-9 * longest.powi(3) {
        return Err(MeshFault::Hollow(volume));
    }
    if let Some(place) = crossing(&mesh, longest) {
        return Err(MeshFault::Crossed(place));
    }
    if is_inside_out(&mesh).map_err(MeshFault::InsideOut)? {
        mesh.triangles.iter_mut().for_each(|[_, b, c]| std::mem::swap(b, c));
    }
    Ok(mesh)
}

/// Removes corners that no triangle uses.
fn used(mesh: Mesh) -> Mesh {
    let mut numbers = vec![None; mesh.corners.len()];
    let mut corners = Vec::new();
    let mut number = |old: usize| {
        *numbers[old].get_or_insert_with(|| {
            corners.push(mesh.corners[old]);
            corners.len() - 1
        })
    };
    let triangles = mesh.triangles.iter().map(|t| t.map(&mut number)).collect();
    Mesh { corners, triangles }
}

/// Checks that each edge belongs to two triangles, which run along it in opposite directions.
fn edges(mesh: &Mesh) -> Result<(), MeshFault> {
    let mut known: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new();
    for [a, b, c] in &mesh.triangles {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            let own = known.entry([from.min(to), from.max(to)]).or_default();
            own[usize::from(from > to)] += 1;
        }
    }
    let mut open = known.iter().filter(|(_, [up, down])| up + down == 1);
    if let Some((edge, _)) = open.next() {
        return Err(MeshFault::Open(open.count() + 1, mesh.corners[edge[0]]));
    }
    for (edge, [up, down]) in &known {
        let place = mesh.corners[edge[0]];
        match (up, down) {
            (1, 1) => {}
            (2, 0) | (0, 2) => return Err(MeshFault::Turned(place)),
            _ => return Err(MeshFault::NotManifold(up + down, place)),
        }
    }
    Ok(())
}

/// Checks that the triangles around each corner form one ring.
fn rings(mesh: &Mesh) -> Result<(), MeshFault> {
    // Around a corner each triangle leads from its next corner to the one after that.
    let mut follows: Vec<BTreeMap<usize, usize>> = vec![BTreeMap::new(); mesh.corners.len()];
    for [a, b, c] in &mesh.triangles {
        for [own, from, to] in [[*a, *b, *c], [*b, *c, *a], [*c, *a, *b]] {
            follows[own].insert(from, to);
        }
    }
    for (corner, ring) in follows.iter().enumerate() {
        let Some((start, first)) = ring.iter().next() else { continue };
        let (mut at, mut length) = (*first, 1);
        while at != *start && length <= ring.len() {
            at = ring.get(&at).copied().unwrap_or(*start);
            length += 1;
        }
        if length != ring.len() {
            return Err(MeshFault::Pinched(mesh.corners[corner]));
        }
    }
    Ok(())
}
