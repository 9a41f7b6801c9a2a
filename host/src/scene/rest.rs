//! Approximates the equilibrium shape of a scene's sheet as a function of pressure, for the firmware's program `rest`.
//!
//! In: a scene's lists. Out: coefficients of Chebyshev polynomials, as many as needed, and their distance from the
//! moving sheet while its pressure rises from half of the scene's to all of it and falls again, over the scene's
//! length. The equilibrium is found by dynamic relaxation: motion that is stopped whenever its kinetic energy falls.

use super::Scene;
use super::walk;
use smartbed_runtime::flexible::pressure::enclosed_volume;
use smartbed_runtime::flexible::rest::Rest;
use smartbed_runtime::flexible::walk::{Node, Sheet};
use smartbed_runtime::vec3::{norm, sub};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Largest error of the polynomials, relative to the motion.
const EXACT: f64 = 1e-4;
/// Most terms.
const MOST: usize = 16;
/// Force on a node that counts as zero, relative to that of the pressure on a cell.
const LEFT: f64 = 1e-9;
/// Most steps of a relaxation.
const PATIENCE: usize = 400_000;
/// Number of times at which the motion is compared.
const TIMES: usize = 20;

/// The approximation.
#[derive(Clone, PartialEq, Debug)]
pub struct Found {
    /// Least and largest pressure (Pa).
    pub range: [f64; 2],
    /// Coefficients of the positions (m): for each term those of all nodes.
    pub places: Vec<[f64; 3]>,
    /// Coefficients of the volume (m^3).
    pub volume: Vec<f64>,
    /// Largest distance of a node from its equilibrium, and from its position in the scene's motion, relative to how
    /// far nodes move.
    pub errors: [f64; 2],
}

/// A sheet and the step of its relaxation.
struct Bladder {
    sheet: Sheet<f64>,
    flat: Vec<Node<f64>>,
    facets: Vec<[usize; 4]>,
    /// Step (s).
    h: f64,
}

impl Found {
    /// Finds the approximation.
    ///
    /// # Errors
    /// If the scene is no such sheet, or does not come to rest.
    pub fn new(scene: &Scene) -> Result<Self, String> {
        let (sheet, flat) = walk::read::<f64>(&scene.lists, &scene.around, scene.method)?;
        let pressure = sheet.pressure.filter(|p| *p > 0.0).ok_or("it has no pressure")?;
        let facets = (0..flat.len() - sheet.columns).filter(|a| (a + 1) % sheet.columns > 0);
        let facets = facets.map(|a| [a, a + 1, a + sheet.columns + 1, a + sheet.columns]).collect();
        let bladder = Bladder { sheet, flat, facets, h: scene.step };
        let [low, high] = [0.5 * pressure, pressure];
        let shapes: Vec<_> = [low, 0.8 * low + 0.2 * high, 0.3 * low + 0.7 * high, high]
            .into_iter()
            .map(|p| Ok((p, bladder.rest(p)?)))
            .collect::<Result<_, String>>()?;
        let way = distance(&shapes[0].1, &shapes[3].1);
        for terms in 2..=MOST {
            let mut found = bladder.fit([low, high], terms)?;
            let off = shapes.iter().map(|(p, shape)| distance(&found.at(*p), shape)).fold(0.0, f64::max);
            if off <= EXACT * way {
                let moving = bladder.follow(&found, shapes[0].1.clone(), scene.seconds)?;
                found.errors = [off / way, moving / way];
                return Ok(found);
            }
        }
        Err(format!(
            "polynomials of {MOST} terms do not approximate the shapes to {EXACT} of the displacement"
        ))
    }

    /// Equilibrium positions by the polynomials (m).
    fn at(&self, pressure: f64) -> Vec<[f64; 3]> {
        let mut pos = vec![[0.0; 3]; self.places.len() / self.volume.len()];
        Rest { range: self.range, places: &self.places, volume: &self.volume }.place(pressure, &mut pos);
        pos
    }

    /// The program's constants; a tick takes `step` (s), the rise and fall of pressure together `seconds`.
    #[must_use]
    pub fn rust(&self, step: f64, seconds: f64) -> String {
        let (n, terms) = (self.places.len() / self.volume.len(), self.volume.len());
        let rounded: Vec<[f32; 3]> = self.places.iter().map(|x| x.map(|x| x as f32)).collect();
        let volume: Vec<f32> = self.volume.iter().map(|v| *v as f32).collect();
        let mut text = String::new();
        let _ = writeln!(text, "pub const NODES: usize = {n};");
        let _ = writeln!(text, "pub const TURN: f32 = {:?};", (2.0 * PI * step / seconds) as f32);
        let _ = writeln!(text, "pub const RANGE: [f32; 2] = {:?};", self.range.map(|p| p as f32));
        let _ = writeln!(text, "pub static PLACES: [[f32; 3]; {}] = {rounded:?};", rounded.len());
        let _ = writeln!(text, "pub static VOLUME: [f32; {terms}] = {volume:?};");
        text
    }
}

impl Bladder {
    /// Equilibrium positions by relaxation (m).
    fn rest(&self, pressure: f64) -> Result<Vec<[f64; 3]>, String> {
        let sheet = Sheet { pressure: Some(pressure), ..self.sheet };
        let mut nodes = self.flat.clone();
        let lost = |_| "a step of the scene's length is too long".to_owned();
        sheet.begin(&mut nodes).map_err(lost)?;
        let cell = sheet.springs.map_or(1.0, |[right, up]| right.rest_length * up.rest_length);
        let mut energy = 0.0;
        for _ in 0..PATIENCE {
            sheet.step(&mut nodes, self.h).map_err(lost)?;
            let now = nodes.iter().flat_map(|node| node.vel).map(|v| v * v).sum::<f64>();
            if now < energy {
                nodes.iter_mut().for_each(|node| node.vel = [0.0; 3]);
                sheet.begin(&mut nodes).map_err(lost)?;
                let force = |node: &Node<f64>| norm(node.acc) / node.inverse_mass.max(f64::MIN_POSITIVE);
                let left = nodes.iter().filter(|node| node.inverse_mass > 0.0).map(force).fold(0.0, f64::max);
                if left <= LEFT * pressure * cell {
                    return Ok(nodes.iter().map(|node| node.pos).collect());
                }
                energy = 0.0;
            } else {
                energy = now;
            }
        }
        Err(format!("the sheet is not at rest at {pressure} Pa within {PATIENCE} steps"))
    }

    /// Coefficients from the values at the Chebyshev points.
    //   c_k = (2 - [k = 0])/n sum f(cos a_j) cos k a_j, a_j = (j + 1/2) pi/n
    fn fit(&self, range: [f64; 2], terms: usize) -> Result<Found, String> {
        let [low, high] = range;
        let angle = |j: usize| (j as f64 + 0.5) * PI / terms as f64;
        let pressure = |j: usize| 0.5 * (low + high) + 0.5 * (high - low) * angle(j).cos();
        let shapes = (0..terms).map(|j| self.rest(pressure(j))).collect::<Result<Vec<_>, String>>()?;
        let n = self.flat.len();
        let (mut places, mut volume) = (vec![[0.0; 3]; n * terms], vec![0.0; terms]);
        for k in 0..terms {
            for (j, shape) in shapes.iter().enumerate() {
                let share = if k == 0 { 1.0 } else { 2.0 } / terms as f64 * (k as f64 * angle(j)).cos();
                volume[k] += share * enclosed_volume(&self.facets, shape);
                for (place, x) in places[k * n..(k + 1) * n].iter_mut().zip(shape) {
                    (0..3).for_each(|c| place[c] += share * x[c]);
                }
            }
        }
        Ok(Found { range, places, volume, errors: [0.0; 2] })
    }

    /// Largest distance (m) of the moving sheet from its equilibrium.
    fn follow(&self, found: &Found, shape: Vec<[f64; 3]>, seconds: f64) -> Result<f64, String> {
        let [low, high] = found.range;
        let pressure = |t: f64| low + (high - low) * 0.5 * (1.0 - (2.0 * PI * t / seconds).cos());
        let mut nodes = self.flat.clone();
        nodes.iter_mut().zip(shape).for_each(|(node, x)| node.pos = x);
        let steps = (seconds / self.h).round().max(1.0) as usize;
        let mut farthest = 0.0_f64;
        for step in 0..=steps {
            let t = step as f64 * self.h;
            let sheet = Sheet { pressure: Some(pressure(t)), ..self.sheet };
            let taken = if step == 0 { sheet.begin(&mut nodes) } else { sheet.step(&mut nodes, self.h) };
            taken.map_err(|_| "a step of the scene's length is too long".to_owned())?;
            if step % steps.div_ceil(TIMES) == 0 {
                let pos: Vec<_> = nodes.iter().map(|node| node.pos).collect();
                farthest = farthest.max(distance(&pos, &found.at(pressure(t))));
            }
        }
        Ok(farthest)
    }
}

/// Largest distance between the nodes of two shapes (m).
fn distance(one: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    one.iter().zip(other).map(|(a, b)| norm(sub(*a, *b))).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{EXACT, Found};
    use crate::scene::parse;

    fn found(changes: &str) -> Result<Found, String> {
        let text = format!(
            "format = 1\nshape = \"sheet\"\nrows = 5\ncolumns = 5\nwidth = 0.2\ndepth = 0.2\nlaw = \"none\"\nmethod = \"verlet\"\n\
             mass = 1.1e-3\nK = 5000\nC = 0.1\nstep = 1e-4\n{changes}"
        );
        Found::new(&parse("x", &text, &[]).expect("a scene"))
    }

    /// Slower pressures leave it behind by the square of their speed; the volume's slope is that of a spring that
    /// stiffens.
    #[test]
    fn a_slow_bladder_is_where_it_would_rest() {
        let [slow, fast] = ["T = 0.8\n", "T = 0.4\n"].map(|time| {
            let changes = format!("pressure = 4000\n{time}");
            found(&changes).expect("rest")
        });
        assert!(slow.errors[0] <= EXACT, "{:?}", slow.errors);
        assert!(
            slow.errors[1] < 1e-3 && fast.errors[1] > 1.5 * slow.errors[1],
            "{:?}",
            [slow.errors, fast.errors]
        );
        let [low, high] = slow.range;
        let bulge = |p: f64| slow.at(p).iter().map(|x| x[2]).fold(0.0, f64::max);
        // A stretched membrane: w ~ p^(1/3), a little more for its springs.
        let power = (bulge(high) / bulge(low)).log2();
        assert!((0.3..0.45).contains(&power), "{power}");
    }

    #[test]
    fn what_has_no_pressure_is_named() {
        assert_eq!(found("T = 0.1\n").expect_err("no pressure"), "it has no pressure");
    }
}
