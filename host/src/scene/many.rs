//! Many bodies that do not touch one another, stepped together on several cores.
//!
//! In: simulations that have begun. Out: the same after a number of steps. Each body is stepped by one core from
//! beginning to end and shares nothing with the others: results do not depend on the number of cores.

use std::sync::Mutex;
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
    /// The reason. The body is in its state before that step; all others have taken theirs.
    pub why: BodyError<S>,
}

/// Takes steps of length h with all bodies on several cores, all steps of one body before the next: its data stays in
/// the inner caches, which are too small for all bodies of a bed. A core that is free takes the next body, so that none
/// waits for one that has other work to do, or begins late.
///
/// # Errors
/// The first body of which a step is refused.
pub fn advance<S: Scalar + Send + Sync>(
    bodies: &mut [Simulation<S>],
    h: S,
    steps: usize,
    cores: usize,
) -> Result<(), Refused<S>> {
    let helpers = cores.min(bodies.len()).saturating_sub(1);
    let waiting = Mutex::new(bodies.iter_mut().enumerate());
    let refused = Mutex::new(None);
    let next = || waiting.lock().expect("nobody panics while a body is taken").next();
    let work = || {
        while let Some((body, simulation)) = next() {
            if let Err((step, why)) = simulation.advance(h, steps) {
                let mut first = refused.lock().expect("nobody panics while two are compared");
                let before = first.filter(|first: &Refused<S>| first.body < body);
                *first = before.or(Some(Refused { body, step, why }));
            }
        }
    };
    // The scope waits for their work, not for the threads to end, which would take another thirtieth of a short turn.
    thread::scope(|scope| {
        (0..helpers).for_each(|_| drop(scope.spawn(work)));
        work();
    });
    refused.into_inner().expect("nobody panics while two are compared").map_or(Ok(()), Err)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::parse;

    /// A sheet of springs of such a stiffness (N/m).
    fn body(stiffness: f64) -> Simulation<f64> {
        let text = format!(
            "format = 1\nshape = \"sheet\"\nrows = 13\ncolumns = 13\nmethod = \"verlet\"\nlaw = \"none\"\npressure = 2000\nallow_unstable = true\nK = {stiffness}\n"
        );
        let mut scene = parse("x", &text, &[]).expect("a scene");
        scene.lists.damping.fill(0.0);
        scene.around.air_drag = 0.0;
        let mut body = Simulation::new(&scene.lists, &scene.around, scene.method).expect("a body");
        body.begin(1e-3, &mut ()).expect("a start");
        body
    }

    /// Sheets that are stretched differently.
    fn bodies() -> Vec<Simulation<f64>> {
        (0..7).map(|i| body(f64::from(1000 + i))).collect()
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
    fn spans_of_steps_go_on_from_one_another_and_from_single_steps() {
        let (mut spans, mut singly) = (bodies(), bodies());
        let bits = |bodies: &[Simulation<f64>]| {
            let numbers = bodies.iter().flat_map(|body| body.pos().iter().chain(body.vel()).flatten());
            numbers.map(|x| x.to_bits()).collect::<Vec<_>>()
        };
        for count in [10, 10, 1, 7, 3, 20] {
            advance(&mut spans, 1e-3, count, 2).expect("steps");
            // The rows in which a body's numbers are kept go with its copy.
            spans = spans.clone();
            for body in &mut singly {
                (0..count).for_each(|_| body.step(1e-3, &mut ()).map(|_| ()).expect("a step"));
            }
            assert!(bits(&spans) == bits(&singly), "{count}");
        }
        for bodies in [&mut spans, &mut singly] {
            bodies.iter_mut().for_each(|body| body.begin(1e-3, &mut ()).expect("a start"));
        }
        advance(&mut spans, 1e-3, 10, 1).expect("steps");
        for body in &mut singly {
            (0..10).for_each(|_| body.step(1e-3, &mut ()).map(|_| ()).expect("a step"));
        }
        assert!(bits(&spans) == bits(&singly));
    }

    #[test]
    fn who_is_refused_stops_nobody_else_on_any_number_of_cores() {
        let after = |cores: usize| {
            // Steps of this length are too long for two of them, which begin to swing.
            let mut bodies: Vec<_> = bodies();
            for stiff in [2, 5] {
                bodies[stiff] = body(1e9);
            }
            let refused = advance(&mut bodies, 1e-3, 30, cores).expect_err("too stiff");
            (refused, bodies.iter().map(Simulation::t).collect::<Vec<_>>())
        };
        let (refused, times) = after(1);
        assert!(refused.body == 2 && refused.step < 30, "{refused:?}");
        for (number, t) in times.iter().enumerate() {
            assert_eq!((t - 0.03).abs() > 1e-9, [2, 5].contains(&number), "{number} {t}");
        }
        for cores in [2, 3, 7] {
            assert!(after(cores) == (refused, times.clone()), "{cores} cores");
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
