//! Many bodies that do not touch one another, stepped together on several cores.
//!
//! In: simulations that have begun. Out: the same after a number of steps. Each body is stepped by one core from
//! beginning to end and shares nothing with the others: results do not depend on the number of cores.

use std::thread;

use smartbed_runtime::flexible::BodyError;
use smartbed_runtime::real::Scalar;

use super::Simulation;

/// The error if a body could not be stepped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refused<S> {
    /// The first such body, by its index.
    pub body: usize,
    /// The step that was refused, from 0.
    pub step: usize,
    /// The reason. The body is in its state before that step, those after it on the same core in their initial state.
    pub why: BodyError<S>,
}

/// Takes steps of length h with all bodies on several cores, all steps of one body before the next: its data stays in
/// the inner caches, which are too small for all bodies of a bed.
///
/// # Errors
/// The first body whose step is refused.
pub fn advance<S: Scalar + Send + Sync>(
    bodies: &mut [Simulation<S>],
    h: S,
    steps: usize,
    cores: usize,
) -> Result<(), Refused<S>> {
    let share = bodies.len().div_ceil(cores.max(1)).max(1);
    let one_core = |(number, bodies): (usize, &mut [Simulation<S>])| {
        for (i, body) in bodies.iter_mut().enumerate() {
            body.advance(h, steps).map_err(|(step, why)| Refused { body: number * share + i, step, why })?;
        }
        Ok(())
    };
    if bodies.len() <= share {
        return one_core((0, bodies));
    }
    thread::scope(|scope| {
        let shares = bodies.chunks_mut(share).enumerate();
        let running: Vec<_> = shares.map(|share| scope.spawn(move || one_core(share))).collect();
        let done: Vec<_> =
            running.into_iter().map(|core| core.join().expect("a step does not panic")).collect();
        done.into_iter().collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::parse;

    /// Sheets that are stretched differently.
    fn bodies() -> Vec<Simulation<f64>> {
        let text = |i: usize| {
            format!(
                "format = 1\nshape = \"sheet\"\nrows = 13\ncolumns = 13\nmethod = \"verlet\"\nlaw = \"none\"\npressure = 2000\nK = {}\n",
                1000 + i
            )
        };
        let scenes = (0..7).map(|i| parse("x", &text(i), &[]).expect("a scene"));
        scenes
            .map(|mut scene| {
                scene.lists.damping.fill(0.0);
                scene.around.air_drag = 0.0;
                let mut body = Simulation::new(&scene.lists, &scene.around, scene.method).expect("a body");
                body.begin(1e-3, &mut ()).expect("a start");
                body
            })
            .collect()
    }

    #[test]
    fn steps_at_once_have_the_bits_of_steps_one_by_one() {
        let (mut at_once, mut singly) = (bodies(), bodies());
        // More than are taken at once.
        let steps = 300;
        advance(&mut at_once, 1e-3, steps, 1).expect("steps");
        for (at_once, singly) in at_once.iter_mut().zip(&mut singly) {
            assert!(at_once.can_march());
            (0..steps).for_each(|_| singly.step(1e-3, &mut ()).map(|_| ()).expect("a step"));
            // One more shows what rounding dropped, and the forces.
            at_once.step(1e-3, &mut ()).expect("a step");
            singly.step(1e-3, &mut ()).expect("a step");
            let bits = |body: &Simulation<f64>| {
                let numbers = body.pos().iter().chain(body.vel()).flatten().copied().chain([body.t()]);
                numbers.map(f64::to_bits).collect::<Vec<_>>()
            };
            assert!(bits(at_once) == bits(singly));
        }
    }

    #[test]
    fn the_number_of_cores_changes_no_bit() {
        let after = |cores: usize| {
            let mut bodies = bodies();
            advance(&mut bodies, 1e-3, 20, cores).expect("steps");
            bodies
                .iter()
                .flat_map(|body| body.pos().as_flattened().iter().map(|x| x.to_bits()))
                .collect::<Vec<_>>()
        };
        let one = after(1);
        let start: Vec<u64> =
            bodies().iter().flat_map(|body| body.pos().as_flattened().iter().map(|x| x.to_bits())).collect();
        assert!(one != start, "they move");
        for cores in [0, 2, 3, 7, 50] {
            assert!(after(cores) == one, "{cores} cores");
        }
        advance(&mut Vec::<Simulation<f64>>::new(), 1e-3, 1, 2).expect("nothing to do");
    }
}
