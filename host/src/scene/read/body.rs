//! The body of a scene: a shape with its numbers, or lists of points and springs.
//!
//! In: the fields of a scene. Out: [`Lists`] in the initial position, every number in them finite.

use super::super::fields::Fields;
use super::super::keys;
use super::super::lists::Lists;
use super::super::shape as shapes;
use crate::suggest;

/// Most points of a body; each takes about two kilobytes of memory.
const MOST_POINTS: f64 = 1e5;

/// Reads the body.
///
/// # Errors
/// What is wrong, and where.
pub fn read(fields: &Fields) -> Result<Lists, String> {
    let mut lists = match fields.get("shape") {
        Some(_) => read_shape(fields)?,
        None => read_lists(fields)?,
    };
    let n = lists.points.len();
    if lists.stiffness.is_empty() {
        lists.stiffness = fields.numbers("K", 5000.0, lists.springs.len())?;
        lists.masses = fields.numbers("mass", 1.0, n)?;
    }
    lists.damping = fields.numbers("C", 0.0, lists.springs.len())?;
    place(fields, &mut lists)?;
    for point in fields.points("fixed", n)?.unwrap_or_default() {
        lists.fixed[point] = true;
    }
    let velocity = fields.vector("initial_velocity")?;
    lists.velocities = lists.fixed.iter().map(|fixed| if *fixed { [0.0; 3] } else { velocity }).collect();
    let stretch = fields.positive("stretch", 1.0)?;
    lists.rest_lengths.iter_mut().for_each(|l| *l /= stretch);
    if let Some(point) = (0..n).find(|p| lists.masses[*p] <= 0.0 && !lists.fixed[*p]) {
        return Err(
            fields.error("mass", &format!("point {point} has mass 0; expected > 0, or the point in `fixed`"))
        );
    }
    refuse_overflow(fields, &lists)?;
    Ok(lists)
}

/// Rotates the body about the y axis and lifts it; `points` of a list are already in their initial position.
fn place(fields: &Fields, lists: &mut Lists) -> Result<(), String> {
    let height = fields.number("drop_height", 0.0)?;
    let tilt = fields.number("tilt", 0.0)?;
    for point in &mut lists.points {
        let [x, z] = [point[0], point[2]];
        point[0] = x * tilt.cos() - z * tilt.sin();
        point[2] = x * tilt.sin() + z * tilt.cos() + height;
    }
    Ok(())
}

/// Refuses numbers whose sums or products overflow although each is finite.
fn refuse_overflow(fields: &Fields, lists: &Lists) -> Result<(), String> {
    let numbers = lists.points.as_flattened().iter().chain(&lists.masses).chain(&lists.rest_lengths);
    match numbers.chain(&lists.stiffness).all(|x| x.is_finite()) {
        true => Ok(()),
        false => {
            let key = if fields.get("shape").is_some() { "shape" } else { "points" };
            Err(fields
                .error(key, "places, masses or springs of this size are beyond 1e308; take smaller numbers"))
        }
    }
}

fn read_lists(fields: &Fields) -> Result<Lists, String> {
    let Some(points) = fields.rows::<3>("points")? else {
        return Err(
            fields.error("shape", "a scene needs a `shape` or `points`, `springs` and `rest_lengths`")
        );
    };
    if points.is_empty() {
        return Err(fields.error("points", "expected at least one point"));
    }
    bounded(fields, "points", points.len() as f64)?;
    let mut lists = Lists::default();
    points.into_iter().for_each(|p| {
        lists.point(p);
    });
    let n = lists.points.len();
    for (row, [tail, head]) in fields.whole_rows::<2>("springs")?.unwrap_or_default().into_iter().enumerate()
    {
        if tail >= n || head >= n || tail == head {
            let message = format!(
                "spring {row} joins {tail} and {head}; expected two different points, of 0 to {}",
                n - 1
            );
            return Err(fields.error("springs", &message));
        }
        lists.spring(tail, head);
    }
    if fields.get("rest_lengths").is_some() {
        lists.rest_lengths = fields.numbers("rest_lengths", 0.0, lists.springs.len())?;
    }
    lists.facets = fields.whole_rows::<4>("facets")?.unwrap_or_default();
    if let Some(row) = lists.facets.iter().position(|corners| corners.iter().any(|c| *c >= n)) {
        let message = format!("facet {row} is {:?}, but the points are 0 to {}", lists.facets[row], n - 1);
        return Err(fields.error("facets", &message));
    }
    for (row, corners) in lists.facets.iter_mut().enumerate() {
        match triangle_last(*corners) {
            Some(turned) => *corners = turned,
            None => {
                let message =
                    format!("facet {row} is {corners:?}, which has no area; expected three or four points");
                return Err(fields.error("facets", &message));
            }
        }
    }
    Ok(lists)
}

/// The same facet begun at the corner from which a triangle repeats its third; `None` if it has fewer than three corners.
fn triangle_last(corners: [usize; 4]) -> Option<[usize; 4]> {
    let same = |i: usize| corners[i] == corners[(i + 1) % 4];
    let repeated: Vec<usize> = (0..4).filter(|i| same(*i)).collect();
    match repeated[..] {
        [] if corners[0] != corners[2] && corners[1] != corners[3] => Some(corners),
        [i] => Some([2, 3, 4, 5].map(|k| corners[(i + k) % 4])),
        _ => None,
    }
}

/// The shape's name.
pub(super) fn shape(fields: &Fields) -> Result<&'static str, String> {
    let word = fields.word("shape", "")?;
    keys::shapes().find(|shape| *shape == word).ok_or_else(|| {
        let help = suggest::help(word, keys::shapes());
        fields.error("shape", &format!("unknown shape `{word}`{help}"))
    })
}

/// Checks the number of points before memory is allocated.
fn bounded(fields: &Fields, key: &str, points: f64) -> Result<(), String> {
    match points <= MOST_POINTS {
        true => Ok(()),
        false => {
            let message = format!("{points:.0} points; a body has {MOST_POINTS} at most: take a coarser one");
            Err(fields.error(key, &message))
        }
    }
}

fn read_shape(fields: &Fields) -> Result<Lists, String> {
    let length = |key: &str, default: f64| fields.positive(key, default);
    let count = |key: &str, default: usize, least: usize| fields.count(key, default, least);
    let bounded = |points: f64| bounded(fields, "shape", points);
    let side = length("side", 1.0)?;
    match shape(fields)? {
        "chain" => {
            let links = count("links", 1, 1)?;
            bounded(links as f64 + 1.0)?;
            Ok(shapes::chain(links, length("length", 1.0)?))
        }
        "polygon" => {
            let corners = count("corners", 3, 3)?;
            bounded(corners as f64)?;
            Ok(shapes::polygon(corners, side))
        }
        "truss" => {
            let bays = count("bays", 2, 1)?;
            bounded(2.0 * bays as f64 + 1.0)?;
            Ok(shapes::truss(bays, side))
        }
        "prism" => Ok(shapes::prism(side, length("height", 1.0)?)),
        "cube" => Ok(shapes::cube(side)),
        "cylinder" => {
            let (corners, rings) = (count("corners", 8, 3)?, count("rings", 2, 1)?);
            bounded(corners as f64 * (rings as f64 + 1.0))?;
            Ok(shapes::cylinder(corners, rings, length("radius", 0.5)?, length("height", 1.0)?))
        }
        "ball" => {
            let (corners, bands) = (count("corners", 8, 3)?, count("bands", 6, 2)?);
            bounded(corners as f64 * (bands as f64 - 1.0) + 3.0)?;
            Ok(shapes::ball(corners, bands, length("radius", 0.5)?))
        }
        "cubes" => {
            let [n, m, k] = read_cells(fields)?;
            let cells = [n, m, k].map(|c| c as f64);
            bounded(cells.iter().product::<f64>() + cells.iter().map(|c| c + 1.0).product::<f64>())?;
            Ok(shapes::cubes(n, m, k, side))
        }
        "sheet" => {
            let (rows, columns) = (count("rows", 27, 1)?, count("columns", 27, 1)?);
            bounded((rows as f64 + 2.0) * (columns as f64 + 2.0) - 4.0)?;
            Ok(shapes::sheet(rows, columns, length("width", 1.4)?, length("depth", 1.4)?))
        }
        // A bar: the table of keys has no other shape left.
        _ => {
            let elements = count("elements", 50, 1)?;
            bounded(elements as f64 + 1.0)?;
            let [length, modulus, density, area] =
                [length("length", 10.0)?, length("E", 900.0)?, length("rho", 1.0)?, length("A", 1.0)?];
            Ok(shapes::bar(elements, length, modulus, density, area))
        }
    }
}

/// `cells = [[n, m, k]]`: cubes along x, y, z.
fn read_cells(fields: &Fields) -> Result<[usize; 3], String> {
    match fields.whole_rows::<3>("cells")?.as_deref() {
        None => Ok([2, 1, 1]),
        Some([cells]) if cells.iter().all(|c| *c >= 1) => Ok(*cells),
        Some(_) => {
            let message = "expected one row of three whole numbers >= 1, for example [[2, 2, 1]]";
            Err(fields.error("cells", message))
        }
    }
}
