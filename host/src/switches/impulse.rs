//! The impulse of a drive that changes its speed at once, at a kink of a command.
//!
//! In: the times just before and behind the kink, the speeds before it; kinetic energy as a function of time and speeds.
//! Out: the speeds behind it and the impulse's work. The impulse leaves the momenta along every direction N in which the
//! speeds are free to move; all are, where the state has independent speeds alone:
//! ```text
//! N' dT/du (q, u+, t+) = N' dT/du (q, u, t-)     T quadratic in u: differences of T over 2 are exact
//! ```

use smartbed_codegen::kinematics::linear;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;

/// A mechanism at a place.
pub trait Placed<S: Scalar> {
    /// Kinetic energy (J) at a time with some speeds of the state.
    ///
    /// # Errors
    /// The engine's.
    fn kinetic(&mut self, t: S, u: &[S]) -> Result<S, Fault>;
    /// All speeds that it has with these of the state.
    ///
    /// # Errors
    /// The engine's.
    fn speeds(&mut self, t: S, u: &[S]) -> Result<Vec<S>, Fault>;
    /// What the constraints leave of speeds of the state: all, unless dependent ones are state too.
    ///
    /// # Errors
    /// The engine's.
    fn tied(&mut self, _t: S, u: &[S]) -> Result<Vec<S>, Fault> {
        Ok(u.to_vec())
    }
}

/// Whether speeds of the mechanism depend on those of its state, `u`, in another way behind a time than before it.
///
/// # Errors
/// The engine's.
pub fn ties_change<S: Scalar>(own: &mut impl Placed<S>, times: [S; 2], u: &[S]) -> Result<bool, Fault> {
    let mut speeds = |t: S, u: &[S]| {
        let u = own.tied(t, u)?;
        own.speeds(t, &u)
    };
    let mut slopes = |t: S, k: usize| -> Result<Vec<S>, Fault> {
        let mut moved = vec![S::ZERO; u.len()];
        let still = speeds(t, &moved)?;
        moved[k] = S::ONE;
        Ok(speeds(t, &moved)?.iter().zip(&still).map(|(with, without)| *with - *without).collect())
    };
    // Relative to the largest slope: small ones are rounded as it is.
    for k in 0..u.len() {
        let (before, after) = (slopes(times[0], k)?, slopes(times[1], k)?);
        let largest = before.iter().chain(&after).fold(S::ONE, |largest, slope| largest.max(slope.abs()));
        let changes = |(a, b): (&S, &S)| (*b - *a).abs() > S::EPSILON.sqrt() * largest;
        if before.iter().zip(&after).any(changes) {
            return Ok(true);
        }
    }
    Ok(false)
}

fn momenta<S: Scalar>(own: &mut impl Placed<S>, t: S, u: &[S]) -> Result<Vec<f64>, Fault> {
    let mut with = |k: usize, by: S| {
        let mut moved = u.to_vec();
        moved[k] = moved[k] + by;
        own.kinetic(t, &moved).map(S::to_f64)
    };
    (0..u.len()).map(|k| Ok(0.5 * (with(k, S::ONE)? - with(k, -S::ONE)?))).collect()
}

/// Orthogonal directions of unit length in which the constraints at a time let speeds of the state change.
fn directions<S: Scalar>(own: &mut impl Placed<S>, t: S, u: &[S]) -> Result<Vec<Vec<f64>>, Fault> {
    let mut ways = Vec::with_capacity(u.len());
    for k in 0..u.len() {
        let mut moved = u.to_vec();
        moved[k] = moved[k] + S::ONE;
        let moved = own.tied(t, &moved)?;
        ways.push(
            moved.iter().zip(u).map(|(with, without)| (*with - *without).to_f64()).collect::<Vec<f64>>(),
        );
    }
    // What leaves such directions as they are and nothing else is a projection, whose trace is their number.
    let number = (0..u.len()).map(|k| ways[k][k]).sum::<f64>().round() as usize;
    let mut found: Vec<Vec<f64>> = Vec::with_capacity(number);
    for _ in 0..number {
        let size = |way: &[f64]| way.iter().map(|x| x * x).sum::<f64>();
        let longest = ways.iter().max_by(|a, b| size(a).total_cmp(&size(b)));
        let Some((way, length)) = longest.map(|way| (way, size(way).sqrt())) else { break };
        let unit: Vec<f64> = way.iter().map(|x| x / length).collect();
        for way in &mut ways {
            let part: f64 = way.iter().zip(&unit).map(|(a, b)| a * b).sum();
            way.iter_mut().zip(&unit).for_each(|(x, unit)| *x -= part * unit);
        }
        found.push(unit);
    }
    Ok(found)
}

/// The speeds after a kink, and the work (J) of the drive's impulse: along what is free to move the momenta are those of
/// the speeds `u` before it.
///
/// # Errors
/// The engine's.
pub fn pass<S: Scalar>(
    own: &mut impl Placed<S>,
    [early, late]: [S; 2],
    u: &[S],
) -> Result<(Vec<S>, f64), Fault> {
    let start = own.tied(late, u)?;
    let moved =
        |by: &[f64]| -> Vec<S> { start.iter().zip(by).map(|(u, by)| *u + S::from_f64(*by)).collect() };
    let free = directions(own, late, &start)?;
    let along = |felt: &[f64], less: &[f64]| -> Vec<f64> {
        let change = || felt.iter().zip(less).map(|(felt, less)| felt - less);
        free.iter().map(|way| way.iter().zip(change()).map(|(way, change)| way * change).sum()).collect()
    };
    let (before, after) = (momenta(own, early, u)?, momenta(own, late, &start)?);
    let mut missing = along(&before, &after);
    let mut mass = Vec::with_capacity(free.len() * free.len());
    for way in &free {
        mass.extend(along(&momenta(own, late, &moved(way))?, &after));
    }
    let (shares, _) = linear::solve_to(&mass, &mut missing, free.len(), 0.0);
    let share = |i: usize| free.iter().zip(&shares).map(|(way, share)| way[i] * share).sum();
    let new = moved(&(0..u.len()).map(share).collect::<Vec<f64>>());
    let work = own.kinetic(late, &new)? - own.kinetic(early, u)?;
    Ok((new, work.to_f64()))
}

/// The message for a command, in words with its name, whose value jumps.
pub fn jumped(command: &str, t: f64) -> String {
    format!(
        "{command} jumps at t = {t:.6} s, which no motion can follow; let its value pass over some steps, for example by \
         smooth_step"
    )
}

/// The message for a command, in words with its name, which ties other speeds from a time on.
pub fn tied(command: &str, t: f64) -> String {
    format!(
        "{command} ties other speeds to one another from t = {t:.6} s on, which no impulse of a drive does; let its factors \
         pass over some steps, for example by smooth_step"
    )
}
