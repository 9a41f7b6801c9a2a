//! The surroundings of a scene's body: gravity, air, ground with its law, gas.

use smartbed_runtime::contact::{ContactLaw, ForceLaw, Ground};
use smartbed_runtime::flexible::pressure::enclosed_volume;
use smartbed_runtime::flexible::spring::STRETCH_LIMIT;
use smartbed_runtime::flexible::{Gas, Inflation, PressureForm};
use smartbed_runtime::vec3;

use super::super::fields::{Fields, finite, row};
use super::super::keys;
use super::super::lists::Lists;
use super::super::simulation::Surroundings;
use super::super::surface::open_edges;
use crate::suggest;

/// Points within this fraction of the shortest rest length touch together.
const CLUSTER: f64 = 1e-11;
/// Largest such fraction: a point this near to the ground is on it.
const WIDEST_CLUSTER: f64 = 1e-3;
/// A normal whose length differs from 1 by less than this, because it has few digits, is scaled to a unit vector.
const UNIT: f64 = 1e-3;
/// A rim is in a plane if its points are off by less than this fraction of its size.
const FLAT: f64 = 1e-9;
/// Pressure of the air outside unless it is given (Pa, absolute).
pub const AMBIENT: f64 = 101_325.0;

/// Reads the surroundings; the mass of massless points is distributed to their neighbours.
///
/// # Errors
/// What is wrong, and where.
pub(super) fn read(fields: &Fields, lists: &mut Lists) -> Result<Surroundings, String> {
    Ok(Surroundings {
        gravity: match fields.get("g") {
            Some(serde_json::Value::Array(_)) => fields.vector("g")?,
            _ => [0.0, 0.0, -fields.number("g", 9.81)?],
        },
        air_drag: fields.not_negative("air_drag", 0.0)?,
        ground: read_ground(fields, lists)?,
        inflation: read_inflation(fields, lists)?,
    })
}

/// The law's name; reference files write "EC-P, frictionless floor ...".
pub(super) fn law(fields: &Fields) -> Result<&'static str, String> {
    let word = fields.word("law", "compensation")?;
    let name = if word.starts_with("EC-P") { "compensation" } else { word };
    keys::laws().find(|law| *law == name).ok_or_else(|| {
        let help = suggest::help(word, keys::laws());
        fields.error("law", &format!("unknown law `{word}`{help}"))
    })
}

/// The gas's name.
pub(super) fn gas(fields: &Fields) -> Result<&'static str, String> {
    let word = fields.word("gas", "constant")?;
    keys::gases().find(|gas| *gas == word).ok_or_else(|| {
        let help = suggest::help(word, keys::gases());
        fields.error("gas", &format!("unknown gas `{word}`{help}"))
    })
}

fn read_ground(fields: &Fields, lists: &mut Lists) -> Result<Option<Ground<f64>>, String> {
    let share = |key: &str, default: f64| {
        let x = fields.not_negative(key, default)?;
        if x <= 1.0 { Ok(x) } else { Err(fields.error(key, &format!("expected 0 to 1, found {x}"))) }
    };
    let law = match law(fields)? {
        "none" => return Ok(None),
        "newton" => ContactLaw::Newton { restitution: share("e", 0.0)? },
        "moreau" => ContactLaw::Moreau { restitution: share("e", 0.0)? },
        "penalty" => ContactLaw::Force(ForceLaw::Penalty { stiffness: fields.positive("stiffness", 1e5)? }),
        "hunt_crossley" => ContactLaw::Force(ForceLaw::HuntCrossley {
            stiffness: fields.positive("stiffness", 1e5)?,
            dissipation: fields.not_negative("dissipation", 0.0)?,
        }),
        "massless_point" => {
            take_masses(fields, lists)?;
            ContactLaw::MasslessPoint
        }
        _ => ContactLaw::Compensation {
            eta: share("eta", 1.0)?,
            anchor: fields.flag("anchor")?,
            plastic_alone: fields.flag("plastic_alone")?,
            first_receiver: first_receiver(fields, lists)?,
        },
    };
    let (normal, offset) = read_floor(fields)?;
    let shortest = lists.rest_lengths.iter().copied().filter(|l| *l > 0.0).fold(1.0, f64::min);
    let tolerance = fields.not_negative("cluster_tolerance", CLUSTER * shortest)?;
    if tolerance > WIDEST_CLUSTER * shortest {
        let message = format!(
            "expected at most {WIDEST_CLUSTER} of the shortest rest length, {:.3e} m, found {tolerance} m: points \
             apart would touch at once",
            WIDEST_CLUSTER * shortest
        );
        return Err(fields.error("cluster_tolerance", &message));
    }
    Ok(Some(Ground { normal, offset, law, friction: fields.not_negative("mu", 0.0)?, tolerance }))
}

/// The first point that may receive the energy of an impact: all neighbours of a touching point do, or only masses in
/// the middle of cells (thesis 5.9).
fn first_receiver(fields: &Fields, lists: &Lists) -> Result<usize, String> {
    match (fields.word("receivers", "all")?, lists.first_centre) {
        ("all", _) => Ok(0),
        ("centres", Some(first)) => Ok(first),
        ("centres", None) => Err(fields
            .error("receivers", "this body has no masses in its middle; expected shape `cubes` or `ball`")),
        (word, _) => {
            Err(fields.error("receivers", &format!("expected \"all\" or \"centres\", found \"{word}\"")))
        }
    }
}

/// Removes the mass of the points that touch: those named, else the lowest.
fn take_masses(fields: &Fields, lists: &mut Lists) -> Result<(), String> {
    let massless = match fields.points("massless", lists.points.len())? {
        Some(points) if points.is_empty() => {
            return Err(
                fields.error("massless", "expected at least one point: no other one touches the ground")
            );
        }
        Some(points) => points,
        None => {
            let lowest = lists.points.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
            (0..lists.points.len()).filter(|p| lists.points[*p][2] <= lowest + 1e-9).collect()
        }
    };
    lists.redistribute(&massless).map_err(|e| fields.error("massless", &e))
}

/// The ground is the plane n.x = offset; scaling n alone would move it.
fn read_floor(fields: &Fields) -> Result<([f64; 3], f64), String> {
    let Some([normal, offset]) = fields.table("floor", ["normal", "offset"])? else {
        return Ok(([0.0, 0.0, 1.0], 0.0));
    };
    let expected = |entry: &str, found| {
        fields.error(
            "floor",
            &format!("expected {{ normal = [x, y, z], offset = metres }}; `{entry}` is {found}"),
        )
    };
    let offset = match offset {
        None => 0.0,
        Some(value) => finite(value).ok_or_else(|| expected("offset", value))?,
    };
    let Some(value) = normal else { return Ok(([0.0, 0.0, 1.0], offset)) };
    let normal: [f64; 3] = row(value).ok_or_else(|| expected("normal", value))?;
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    if (length - 1.0).abs() > UNIT {
        let help = match length > 0.0 && length.is_finite() {
            true => format!(
                "; write {:?}, and offset as the distance from the origin",
                normal.map(|c| c / length)
            ),
            false => String::new(),
        };
        let message = format!("expected a `normal` of length 1, found {value} of length {length:.4}{help}");
        return Err(fields.error("floor", &message));
    }
    Ok((normal.map(|c| c / length), offset))
}

fn read_inflation(fields: &Fields, lists: &Lists) -> Result<Option<Inflation<f64>>, String> {
    if fields.get("pressure").is_none() {
        return Ok(None);
    }
    let pressure = fields.number("pressure", 0.0)?;
    if lists.facets.is_empty() {
        return Err(fields.error("pressure", "the body has no `facets` for a pressure to act on"));
    }
    if let Some((spring, times)) = drawn_too_far(lists) {
        let message = format!(
            "spring {spring} starts {times:.3} times as long as at rest; with a pressure {STRETCH_LIMIT} times is the most, since \
             beyond it a balloon grows without end: take longer `rest_lengths`, or less `stretch`"
        );
        return Err(fields.error("pressure", &message));
    }
    let form = match fields.word("pressure_form", "exact")? {
        "exact" => PressureForm::Exact,
        "facet" => PressureForm::Facet,
        "fan" => PressureForm::Fan,
        other => {
            let message = format!("unknown form `{other}`; known: exact, facet, fan (Eq. 3.10 as printed)");
            return Err(fields.error("pressure_form", &message));
        }
    };
    let gas = match gas(fields)? {
        "polytropic" => polytropic(fields, lists, pressure)?,
        _ => Gas::Constant(pressure),
    };
    let ambient = if let Gas::Polytropic { ambient, .. } = gas { ambient } else { AMBIENT };
    if pressure + ambient <= 0.0 {
        let message = format!(
            "{pressure} Pa below the {ambient} Pa outside is less than a vacuum; expected a gauge pressure above {} Pa",
            -ambient
        );
        return Err(fields.error("pressure", &message));
    }
    Ok(Some(Inflation { gas, form }))
}

/// The first spring that starts beyond [`STRETCH_LIMIT`], and how many times as long as at rest it is.
fn drawn_too_far(lists: &Lists) -> Option<(usize, f64)> {
    let drawn = |(spring, [a, b]): (usize, [usize; 2])| {
        let square: f64 = (0..3).map(|i| (lists.points[a][i] - lists.points[b][i]).powi(2)).sum();
        (spring, square.sqrt() / lists.rest_lengths[spring])
    };
    let springs = lists.springs.iter().copied().enumerate().map(drawn);
    springs.into_iter().find(|(_, times)| times.is_finite() && *times > STRETCH_LIMIT)
}

/// Gas whose pressure follows its volume, which an open surface has only where its rim stays in a plane through the
/// origin, which is its base. Unless the text gives it, the volume at which the pressure holds is that at the start.
fn polytropic(fields: &Fields, lists: &Lists, pressure: f64) -> Result<Gas<f64>, String> {
    let open = open_edges(&lists.facets);
    if let Some((a, b)) = open.iter().next().filter(|_| !has_base(lists, open.keys())) {
        let message = format!(
            "gas needs a closed surface, or a fixed rim in a plane through the origin, which closes it: the edge from point {a} \
             to point {b} belongs to one facet only; take gas = \"constant\", or more `facets`, counter-clockwise seen from outside"
        );
        return Err(fields.error("gas", &message));
    }
    let dead_volume = fields.not_negative("dead_volume", 0.0)?;
    let filled = enclosed_volume(&lists.facets, &lists.points) + dead_volume;
    if filled <= 0.0 {
        let message = format!(
            "the gas has {filled:.3e} m^3 at the start; expected facets that go counter-clockwise seen from outside, or a \
             `dead_volume`"
        );
        return Err(fields.error("gas", &message));
    }
    Ok(Gas::Polytropic {
        pressure,
        ambient: fields.not_negative("ambient", AMBIENT)?,
        volume: fields.positive("volume", filled)?,
        exponent: fields.positive("exponent", 1.4)?,
        dead_volume,
    })
}

/// Is the rim fixed, in a plane through the origin? Facets and this plane then enclose a volume, to which the plane
/// itself adds nothing.
fn has_base<'a>(lists: &Lists, rim: impl Iterator<Item = &'a usize> + Clone) -> bool {
    let places = rim.clone().map(|point| lists.points[*point]);
    let size = places.clone().map(|x| vec3::dot(x, x)).fold(0.0, f64::max).sqrt();
    let first = places.clone().find(|x| vec3::dot(*x, *x) > 0.0).unwrap_or_default();
    let normals = places.clone().map(|x| vec3::cross(first, x));
    let normal = normals.fold([0.0; 3], |a, b| if vec3::dot(b, b) > vec3::dot(a, a) { b } else { a });
    let length = vec3::dot(normal, normal).sqrt();
    let is_flat = |x: [f64; 3]| vec3::dot(x, normal).abs() <= FLAT * length * size;
    rim.clone().all(|point| lists.fixed[*point]) && places.clone().all(is_flat)
}
