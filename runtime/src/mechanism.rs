//! The trait that generated equations implement, and the interpreter of `smartbed-codegen` too.
//!
//! State of a mechanism: x = [q, u], all coordinates and then the independent speeds, SI units.

use crate::real::Real;

/// Why an evaluation or a step was refused. The state given is left as it was.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// A slice does not have the length that the mechanism needs.
    Shape,
    /// The worst pivot of the elimination came too close to zero: a singular configuration.
    Singular,
    /// A value became infinite or not a number.
    NonFinite,
    /// An adaptive method shortened its step, or used up its steps, without meeting the tolerance; or it was asked for
    /// a step that does not lead forward in time, or for the inside of one that it did not take.
    StepSize,
    /// The iteration of an implicit method did not converge.
    Unsettled,
    /// More contacts at once than their lists have room for.
    TooManyContacts,
    /// Forces of lasting contacts were not found: friction jams a sliding body (Painleve's paradox).
    Jammed,
    /// Forces of lasting contacts were not found: the sweeps over them did not converge.
    Unbalanced,
}

impl Fault {
    /// The reason in words.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Shape => "a list has the wrong length",
            Self::Singular => "the configuration is singular: a pivot of the elimination has come to zero",
            Self::NonFinite => "a value has become infinite or not a number",
            Self::StepSize => "the tolerance is not met even with the smallest step",
            Self::Unsettled => "the iteration of an implicit step does not converge",
            Self::TooManyContacts => "there are more contacts at once than the memory allows",
            Self::Unbalanced => {
                "no contact forces were found: redundant contacts, the sweeps over them do not converge"
            }
            Self::Jammed => "no contact forces were found: friction jams a sliding contact",
        }
    }
}

impl core::fmt::Display for Fault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.reason())
    }
}

impl core::error::Error for Fault {}

/// A parameter that is not finite, or lies outside its range.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OutOfRange<S> {
    /// The parameter.
    pub name: &'static str,
    /// Its value, SI.
    pub value: S,
    /// Lowest and highest allowed value.
    pub range: [S; 2],
}

impl<S: core::fmt::Display> core::fmt::Display for OutOfRange<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { name, value, range: [low, high] } = self;
        write!(f, "parameter `{name}` is {value}; expected a finite number from {low} to {high}")
    }
}

impl<S: core::fmt::Debug + core::fmt::Display> core::error::Error for OutOfRange<S> {}

/// Checks that every parameter is finite and within its range; `Parameters::check` of derived code calls it.
///
/// # Errors
/// The first parameter that is not.
#[allow(clippy::eq_op, reason = "what is not finite leaves no number when taken from itself")]
pub fn check_parameters<S: Copy + PartialOrd + core::ops::Sub<Output = S>>(
    names: &[&'static str],
    values: &[S],
    ranges: &[[S; 2]],
) -> Result<(), OutOfRange<S>> {
    for ((&name, &value), &range) in names.iter().zip(values).zip(ranges) {
        let [low, high] = range;
        let rest = value - value;
        let is_finite = rest.partial_cmp(&rest).is_some();
        if !(is_finite && low <= value && value <= high) {
            return Err(OutOfRange { name, value, range });
        }
    }
    Ok(())
}

/// Equations of motion of one mechanism over the scalar `S`, with its parameters inside.
///
/// State: all coordinates `q` and the independent speeds `u`, SI units, in the model's order.
/// `&mut self` only because an interpreter keeps its scratch memory inside.
pub trait Mechanism<S: Real> {
    /// Number of coordinates q.
    fn n_q(&self) -> usize;
    /// Number of independent speeds u.
    fn n_u(&self) -> usize;
    /// Number of inputs.
    fn n_inputs(&self) -> usize;
    /// Writes q_dot (`n_q`) and u_dot (`n_u`) and returns the worst pivot of the eliminations: dimensionless, relative
    /// to its value at the nominal configuration, rescaled to the parameters in use; 1 without elimination.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice does not have the stated length.
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault>;
    /// Sets the time (s) for the next [`Mechanism::project`] and [`Mechanism::energy`], where positions depend on time
    /// explicitly; [`Mechanism::rates`] sets it too. Initially 0.
    fn set_time(&mut self, t: S) {
        let _ = t;
    }
    /// One Newton correction that puts the dependent coordinates back on the configuration
    /// constraints; returns the largest residual before the correction.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `q` has not `n_q` entries.
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault>;
    /// One correction that puts the speeds back on the constraints. Does something only where more speeds are state
    /// than are independent, because the motion passes dead points of the independent ones.
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn project_speeds(&mut self, q: &[S], u: &mut [S]) -> Result<(), Fault> {
        let _ = (q, u);
        Ok(())
    }
    /// Kinetic and potential energy (J).
    ///
    /// # Errors
    /// [`Fault::Shape`] if a slice has not the stated length.
    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault>;
    /// Whether coordinate number `index` is an angle that appears only inside sines and cosines, so
    /// that whole turns may be subtracted.
    fn is_angle(&self, index: usize) -> bool {
        let _ = index;
        false
    }
}
