//! `--error` and `--budget`: picks method and step by calibration; the run then goes on as if they had been given.

use super::arguments::Arguments;
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::output;
use crate::progress::Progress;
use crate::report::body::Body;
use crate::report::mechanism::Mechanism;
use crate::report::pick::{Aim, pick};
use crate::report::point::Control;
use crate::report::subject::{Kind, Subject};
use crate::report::world::World;
use std::path::Path;

/// Relative difference up to which a quotient of times counts as whole.
const ROUNDING: f64 = 1e-6;

/// The arguments with method and step instead of the error or budget, and what was not examined; says on standard error
/// what was picked and why.
///
/// # Errors
/// [`Failure::Wrong`] for a wrong error or budget, or one that no method meets.
pub(super) fn resolve(
    arguments: &Arguments,
    (path, kind): (&Path, FileKind),
) -> Result<(Arguments, Option<String>), Failure> {
    let aim = match (arguments.error, &arguments.budget) {
        (None, None) => return Ok((arguments.clone(), None)),
        _ if arguments.resume.is_some() => {
            return Err(Failure::Wrong(
                "--resume: a run goes on with the step it began with; leave --error and --budget out"
                    .to_owned(),
            ));
        }
        (Some(error), _) if error > 0.0 && error.is_finite() => Aim::Error(error),
        (Some(error), _) => {
            return Err(Failure::Wrong(format!(
                "--error {error}: expected a number above 0, for example 1e-4"
            )));
        }
        (None, Some(budget)) => Aim::Budget(nanoseconds(budget)?),
    };
    let clock = Progress::new("calibrating");
    let mut plain = Arguments { error: None, budget: None, method: None, ..arguments.clone() };
    let mut takes_method = true;
    let (subject, interval): (Box<dyn Subject>, f64) = if kind == FileKind::World {
        if arguments.scalar == ScalarKind::F32 {
            return Err(Failure::Wrong(
                "--scalar f32: --error and --budget choose the step of a world in f64; give --step instead"
                    .to_owned(),
            ));
        }
        let world = World::of(&arguments.model, super::world::open(&plain, path)?)?;
        let run = &world.assembly().run;
        let interval = run.step * run.every as f64;
        takes_method = world.takes_method();
        (Box::new(world), interval)
    } else if kind == FileKind::Body {
        let path = path.display().to_string();
        let body = Body::open(&arguments.model, &path, &super::body::settings(&plain))?.in_steps_of_rows();
        let interval = body.scene().step * body.scene().every as f64;
        (Box::new(body), interval)
    } else {
        let mechanism = Mechanism::with(&plain)?;
        let interval = mechanism.row_interval();
        (Box::new(mechanism), interval)
    };
    if subject.seconds() <= 0.0 {
        return Err(Failure::Wrong(
            "--error and --budget measure a run, but this one takes 0 s; leave them out, or give more --seconds".to_owned(),
        ));
    }
    // A scene has only one engine.
    let engine = match subject.kind() {
        Kind::Mechanism => arguments.engine,
        Kind::Body | Kind::World => EngineKind::Interpreter,
    };
    let method = arguments.method.as_deref();
    if let Some(name) = method {
        crate::report::check_name(subject.as_ref(), name)?;
    }
    let picked = pick(subject.as_ref(), aim, interval, (method, arguments.scalar, engine))?;
    output::say(&format!("{} [{:.1} s]", picked.text, clock.seconds()));
    plain.method = takes_method.then_some(picked.method);
    match picked.control {
        Control::Step(step) => {
            plain.step = Some(step);
            // The interval between rows stays as asked for, or less where no step divides it.
            plain.every = Some((interval / step + ROUNDING).floor().max(1.0) as usize);
        }
        Control::Tolerance(tolerance) => plain.tolerance = Some(tolerance),
    }
    Ok((plain, picked.warning))
}

/// A time with its unit: 300ns, 200us, 1.5ms, 0.1s.
fn nanoseconds(text: &str) -> Result<f64, Failure> {
    let units = [("ns", 1.0), ("us", 1e3), ("ms", 1e6), ("s", 1e9)];
    let read = |(unit, size): (&str, f64)| Some(size * text.strip_suffix(unit)?.trim().parse::<f64>().ok()?);
    let found = units.into_iter().find_map(read).filter(|t| *t > 0.0 && t.is_finite());
    found.ok_or_else(|| {
        let expected = "expected a time with its unit: ns, us, ms or s, for example 200us";
        Failure::Wrong(format!("--budget {text}: {expected}"))
    })
}

#[cfg(test)]
mod tests {
    use super::nanoseconds;

    #[test]
    fn budgets_have_units() {
        let cases = [("200us", 2e5), ("1.5ms", 1.5e6), ("0.1s", 1e8), ("7 ns", 7.0)];
        cases.iter().for_each(|(text, ns)| assert_eq!(nanoseconds(text), Ok(*ns), "{text}"));
        ["", "200", "us", "-1us", "nanus", "infs", "1h"].iter().for_each(|text| {
            let failure = nanoseconds(text).expect_err(text);
            assert!(failure.to_string().contains("for example 200us"), "{text}");
        });
    }
}
