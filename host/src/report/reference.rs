//! The reference solution of a subject, and the time over which it is valid.
//!
//! It is the closed form if there is one, else the most accurate run, DOP853 at 1e-13 if equations are smooth; a second
//! method must agree with it. If motion is chaotic, or touches depend on rounding, two accurate methods diverge after a
//! while: the simulated time is then cut to the samples over which they still agree, and the report says so.

use super::clock::{self, Stop};
use super::point::Reference;
use super::subject::{SAMPLES, Subject, Time, Trace};
use std::time::Duration;

/// How often the simulated time may be cut.
const CUTS: usize = 6;
/// A reference over less than this fraction of the time is not representative, and is refused.
const LEAST: f64 = 1e-4;

/// A subject's reference: how it was made, how long it is valid, the motion at the samples.
#[derive(Clone, PartialEq, Debug)]
pub struct Truth {
    /// How it was made.
    pub reference: Reference,
    /// Simulated time (s).
    pub seconds: f64,
    /// The motion.
    pub trace: Trace,
}

impl Truth {
    /// The number of coordinates.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.trace.samples.first().map_or(0, Vec::len)
    }
}

/// Makes the reference over at most `seconds`, within a limit of computing time; `cut` allows it to be shorter.
///
/// # Errors
/// A message if no two references agree, or none is finished in time.
pub fn make(subject: &dyn Subject, seconds: f64, cut: bool, limit: Duration) -> Result<Truth, String> {
    let (mut seconds, asked) = (seconds, seconds);
    let mut last = String::new();
    let end = clock::now() + limit;
    for _ in 0..CUTS {
        // Each attempt leaves some time for a shorter one.
        let left = end.saturating_sub(clock::now());
        let share = if cut { left / 3 } else { left };
        let (trace, text, differences) = match pair(subject, Time::new(seconds, share / 2)) {
            Ok(found) => found,
            Err(Stop::Late { reached, .. }) if cut && reached > LEAST * asked => {
                last =
                    format!("{} of computing are not enough for the reference of {seconds} s", words(limit));
                seconds = round_down(0.5 * reached);
                continue;
            }
            Err(late @ Stop::Late { .. }) => {
                let help = "give fewer --seconds, or --method and --step instead";
                return Err(format!("the reference solution was not finished in time: {late}; {help}"));
            }
            Err(Stop::Refused(why)) => return Err(why),
        };
        let agreeing = differences.iter().take_while(|d| **d <= subject.agreement()).count();
        let difference = differences.iter().copied().fold(0.0, f64::max);
        if agreeing == SAMPLES || (!cut && difference.is_finite()) {
            return Ok(Truth { reference: Reference { text, agreement: difference }, seconds, trace });
        }
        seconds = round_down(seconds * agreeing.max(1) as f64 / SAMPLES as f64);
        last = format!("after {seconds} s the two references still differ by {difference:.1e}");
    }
    Err(last)
}

/// The warning about a reference that covers only the start of a run of so many seconds.
#[must_use]
pub fn unexamined(truth: &Truth, asked: f64) -> Option<String> {
    (truth.seconds < asked).then(|| {
        format!(
            "errors are known over the first {} s of {asked} s only; later ones may be of any size, as where motion is chaotic or \
             friction decides",
            truth.seconds
        )
    })
}

fn words(time: Duration) -> String {
    format!("{:.0} s", time.as_secs_f64())
}

/// Reference, how it was made, and the difference of a second one at each sample.
fn pair(subject: &dyn Subject, time: Time) -> Result<(Trace, String, Vec<f64>), Stop> {
    let first = subject.reference(time)?;
    if let Some((name, exact)) = subject.closed_form(time.seconds) {
        let differences = exact.differences(&first);
        return Ok((
            exact,
            format!("closed form ({name}), checked by {}", subject.reference_name()),
            differences,
        ));
    }
    let (name, second) = subject.second_reference(time)?;
    let differences = first.differences(&second);
    Ok((first, format!("{}, checked by {name}", subject.reference_name()), differences))
}

/// Rounds down to two digits, so that a cut time can be typed.
fn round_down(x: f64) -> f64 {
    let digits = 10.0_f64.powf(x.log10().floor() - 1.0);
    let rounded = (x / digits + 1e-9).floor() * digits;
    // By its decimal digits: a product would be off by a rounding.
    format!("{rounded:.3e}").parse().unwrap_or(rounded)
}

#[cfg(test)]
mod tests {
    use super::round_down;

    #[test]
    fn times_are_round() {
        assert_eq!([0.3, 1.27, 2.999, 0.04].map(round_down), [0.3, 1.2, 2.9, 0.04]);
    }
}
