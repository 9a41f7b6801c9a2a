//! A scene's sheet for the kernel that steps it row by row (`flexible::walk`): Rust constants for the firmware's
//! program `sheet`.
//!
//! In: the lists of a scene. Out: the text of a Rust file, or an error about what that kernel does not support.

use super::lists::{Lists, Table};
use super::simulation::Surroundings;
use smartbed_runtime::flexible::walk::{Node, Sheet, Tie};
use smartbed_runtime::flexible::{Gas, PressureForm};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;
use std::fmt::Write as _;

/// Rest lengths, masses and the like count as equal up to this relative difference.
const ALIKE: f64 = 1e-9;

/// The constants; `step` is the scene's step (s).
///
/// # Errors
/// A property of the scene that the kernel does not support.
pub fn rust(lists: &Lists, around: &Surroundings, method: Method<f64>, step: f64) -> Result<String, String> {
    let (sheet, nodes) = read::<f32>(lists, around, method)?;
    let n = nodes.len();
    let list = |of: fn(&Node<f32>) -> [f32; 3]| nodes.iter().map(of).collect::<Vec<_>>();
    let inverse_mass: Vec<f32> = nodes.iter().map(|node| node.inverse_mass).collect();
    let mut text = String::new();
    let _ = writeln!(text, "pub const NODES: usize = {n};\npub const STEP: f32 = {:?};", step as f32);
    let _ = writeln!(text, "pub const SHEET: Sheet<f32> = {sheet:?};");
    let _ = writeln!(text, "pub static POS: [[f32; 3]; {n}] = {:?};", list(|node| node.pos));
    let _ = writeln!(text, "pub static VEL: [[f32; 3]; {n}] = {:?};", list(|node| node.vel));
    let _ = writeln!(text, "pub static INVERSE_MASS: [f32; {n}] = {inverse_mass:?};");
    Ok(text)
}

/// The sheet and its nodes in their initial state.
///
/// # Errors
/// A property of the scene that the kernel does not support.
pub fn read<S: Scalar>(
    lists: &Lists,
    around: &Surroundings,
    method: Method<f64>,
) -> Result<(Sheet<S>, Vec<Node<S>>), String> {
    let table = lists.table.as_ref().ok_or("its shape is no `sheet`")?;
    if method != Method::Verlet {
        return Err("its method is not `verlet`".to_owned());
    }
    if around.ground.is_some() {
        return Err("there is a ground; write law = \"none\"".to_owned());
    }
    let sheet = sheet(lists, around, table)?;
    let vector = |x: [f64; 3]| x.map(S::from_f64);
    let mut nodes = Vec::new();
    for (place, node) in table.nodes.iter().enumerate() {
        nodes.push(match *node {
            Some(node) if !lists.fixed[node] => {
                let vel = lists.velocities.get(node).copied().unwrap_or_default();
                Node::new(vector(lists.points[node]), vector(vel), S::from_f64(1.0 / lists.masses[node]))
            }
            held => {
                let pos = held.map_or_else(|| corner(lists, table, place), |node| Ok(lists.points[node]))?;
                Node::new(vector(pos), [S::ZERO; 3], S::ZERO)
            }
        });
    }
    Ok((sheet, nodes))
}

/// The constant part.
fn sheet<S: Scalar>(lists: &Lists, around: &Surroundings, table: &Table) -> Result<Sheet<S>, String> {
    let place = |node: usize| table.nodes.iter().position(|other| *other == Some(node));
    let is_frame = |node: usize| {
        let (columns, place) = (table.columns, place(node).unwrap_or_default());
        let (row, column, rows) = (place / columns, place % columns, table.nodes.len() / columns);
        row == 0 || column == 0 || column + 1 == columns || row + 1 == rows
    };
    if (0..lists.points.len()).any(|node| lists.fixed[node] != is_frame(node)) {
        return Err("the frame is not what is fixed".to_owned());
    }
    let free = (0..lists.points.len()).filter(|node| !lists.fixed[*node]);
    let mass = alike("masses", free.map(|node| lists.masses[node]))?;
    let is_right = |[tail, head]: [usize; 2]| place(tail).map(|tail| tail + 1) == place(head);
    let tie = |of_rows: bool| {
        let numbers = || (0..lists.springs.len()).filter(|i| is_right(lists.springs[*i]) == of_rows);
        let damping = alike("C", numbers().map(|i| lists.damping[i]))?;
        Ok::<_, String>(Tie {
            stiffness: S::from_f64(alike("K", numbers().map(|i| lists.stiffness[i]))?),
            rest_length: S::from_f64(alike("rest lengths", numbers().map(|i| lists.rest_lengths[i]))?),
            damping: (damping > 0.0).then_some(S::from_f64(damping)),
        })
    };
    let is_slack = lists.stiffness.iter().chain(&lists.damping).all(|k| *k == 0.0);
    let springs = if is_slack { None } else { Some([tie(true)?, tie(false)?]) };
    let pressure = match around.inflation.map(|inflation| (inflation.gas, inflation.form)) {
        None => None,
        Some((Gas::Constant(pressure), PressureForm::Exact)) => Some(S::from_f64(pressure)),
        Some((Gas::Constant(_), _)) => return Err("pressure_form is not `exact`".to_owned()),
        Some((Gas::Polytropic { .. }, _)) => return Err("gas is not `constant`".to_owned()),
    };
    let weight = around.gravity.map(|g| S::from_f64(mass * g));
    Ok(Sheet { columns: table.columns, springs, weight, air_drag: S::from_f64(around.air_drag), pressure })
}

/// The common value of all numbers.
fn alike(what: &str, mut numbers: impl Iterator<Item = f64>) -> Result<f64, String> {
    let first = numbers.next().ok_or_else(|| format!("there are no {what}"))?;
    match numbers.find(|x| (x - first).abs() > ALIKE * first.abs()) {
        Some(other) => Err(format!("{what} differ: {first} and {other}")),
        None => Ok(first),
    }
}

/// Position of a corner of the frame, which has no node: midway between its neighbours (m).
fn corner(lists: &Lists, table: &Table, place: usize) -> Result<[f64; 3], String> {
    let (columns, rows) = (table.columns, table.nodes.len() / table.columns);
    let (row, column) = (place / columns, place % columns);
    let inwards = |at: usize, count: usize| if at == 0 { Some(1) } else { (at + 1 == count).then(|| at - 1) };
    let beside = inwards(column, columns).and_then(|column| table.nodes[row * columns + column]);
    let above = inwards(row, rows).and_then(|row| table.nodes[row * columns + column]);
    match (beside, above) {
        (Some(a), Some(b)) => {
            let [a, b] = [a, b].map(|node| lists.points[node]);
            Ok([0, 1, 2].map(|c| 0.5 * (a[c] + b[c])))
        }
        _ => Err("the sheet has a hole".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::rust;
    use crate::scene::parse;

    fn tables(changes: &str) -> Result<String, String> {
        let text = format!(
            "format = 1\nshape = \"sheet\"\nrows = 3\ncolumns = 4\nwidth = 1.0\ndepth = 0.8\nlaw = \"none\"\nmethod = \"verlet\"\n{changes}"
        );
        let scene = parse("x", &text, &[]).expect("a scene");
        rust(&scene.lists, &scene.around, scene.method, scene.step)
    }

    #[test]
    fn a_sheet_is_printed_with_its_frame() {
        let text = tables("pressure = 50\nC = 0.5\n").expect("tables");
        assert!(text.contains("NODES: usize = 30;"), "{text}");
        assert!(text.contains(
            "columns: 6, springs: Some([Tie { stiffness: 5000.0, rest_length: 0.2, damping: Some(0.5) }"
        ));
        assert!(text.contains("POS: [[f32; 3]; 30] = [[0.1, 0.1, 0.0], [0.2, 0.0, 0.0]"), "{text}");
        assert!(tables("K = 0.0\n").expect("tables").contains("springs: None"));
    }

    #[test]
    fn what_the_walk_does_not_know_is_named() {
        for (changes, why) in [
            ("pressure = 50\npressure_form = \"facet\"\n", "pressure_form is not `exact`"),
            ("pressure = 50\ngas = \"polytropic\"\ndead_volume = 1\n", "gas is not `constant`"),
            ("fixed = [0]\n", "the frame is not what is fixed"),
        ] {
            assert_eq!(tables(changes).expect_err(changes), why);
        }
    }
}
