//! Does a `sign` of a speed change again and again within a few steps?
//!
//! In: the state after each step. Out: the loads and laws that chatter: dry friction at rest reverses within a few
//! steps again and again, and the mean of its reversals lets creep what it should hold.

use crate::jumps::SMOOTH;
use crate::observers::Observers;
use smartbed_codegen::{Interpreted, words};
use smartbed_runtime::mechanism::{Fault, Mechanism as _};
use smartbed_runtime::real::Scalar;

/// Reversals that follow one another within this number of steps are chatter.
const NEAR: u64 = 8;
/// So many of them are told.
const MANY: u64 = 16;
/// So many loads and laws are named.
const NAMED: usize = 4;

/// Counts reversals of the arguments.
#[derive(Clone, Debug)]
pub struct Chatter {
    owners: Vec<String>,
    arguments: Interpreted<f64>,
    courses: Vec<Course>,
    step: u64,
}

/// How an argument has changed.
#[derive(Clone, Copy, Default, Debug)]
struct Course {
    last: f64,
    /// Its last change.
    change: f64,
    /// The step in which it turned back last; 0 if it did not.
    turned: u64,
    /// How often it turned back soon after another time.
    soon: u64,
}

impl Chatter {
    /// Of a model with these observers.
    pub fn new(observers: &Observers) -> Self {
        let owners = observers.jumps.clone();
        let courses = vec![Course::default(); owners.len()];
        Self { owners, arguments: Interpreted::new(&observers.jumps()), courses, step: 0 }
    }

    /// Is there anything to watch?
    pub fn any(&self) -> bool {
        !self.owners.is_empty()
    }

    /// Observes the state after a step.
    ///
    /// # Errors
    /// The engine's.
    pub fn observe<S: Scalar>(&mut self, t: f64, x: &[S], inputs: &[S]) -> Result<(), Fault> {
        if !self.any() {
            return Ok(());
        }
        self.step += 1;
        let [x, inputs] = [x, inputs].map(|values| values.iter().map(|x| x.to_f64()).collect::<Vec<f64>>());
        let (q, u) = x.split_at(self.arguments.n_q());
        let arguments = self.arguments.outputs(t, q, u, &inputs)?;
        for (course, argument) in self.courses.iter_mut().zip(arguments) {
            course.follow(self.step, argument);
        }
        Ok(())
    }

    /// A warning that names what chatters, if something does; `whose` are the loads and laws, if not of the only model.
    pub fn warning(&self, whose: Option<&str>) -> Option<String> {
        let many = self.owners.iter().zip(&self.courses).filter(|(_, course)| course.soon >= MANY);
        let mut found: Vec<&str> = many.map(|(owner, _)| owner.as_str()).collect();
        found.dedup();
        let named: Vec<String> = found.iter().map(|name| format!("`{name}`")).collect();
        let whose = whose.map_or(String::new(), |part| format!(" of `{part}`"));
        (!named.is_empty()).then(|| {
            format!(
                "a `sign` of a speed in {}{whose} changed again and again within a few steps: it chatters about rest, and what \
                 it should hold creeps; {SMOOTH}",
                words::first_of(&named, NAMED)
            )
        })
    }
}

impl Course {
    /// Counts it where the argument turns back about 0: within a step of a method of several stages it changes sign,
    /// though from one step to the next it may keep it. An oscillation in many steps turns back far from 0.
    fn follow(&mut self, step: u64, argument: f64) {
        let change = argument - self.last;
        let is_about_zero = argument.abs().min(self.last.abs()) <= change.abs().max(self.change.abs());
        if step > 1 && change * self.change < 0.0 && is_about_zero {
            if self.turned > 0 && step - self.turned <= NEAR {
                self.soon += 1;
            }
            self.turned = step;
        }
        (self.last, self.change) = (argument, change);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn soon(argument: impl Fn(f64) -> f64) -> u64 {
        let mut course = Course::default();
        (1..1000_u32).for_each(|step| course.follow(u64::from(step), argument(f64::from(step))));
        course.soon
    }

    #[test]
    fn an_oscillation_is_no_chatter() {
        assert_eq!(
            [16.0, 40.0, 300.0].map(|steps| soon(|n| (std::f64::consts::TAU * n / steps).cos())),
            [0; 3]
        );
        assert_eq!(soon(|n| (-0.1 * n).exp()), 0);
        // From one side to the other, and on one side.
        assert!(soon(|n| if n % 2.0 == 0.0 { 1.0 } else { -1.0 }) > MANY);
        assert!(soon(|n| if n % 2.0 == 0.0 { 1.8 } else { 0.3 }) > MANY);
    }
}
