//! Implicit time integration: one formula that gives velocities from positions, and accelerations from velocities.
//!
//! In: a method and the number of stages done. Out: x' = b (x - x~) at the end of a stage. Backward Euler: b = 1/h, x~
//! = x_n. Trapezoidal rule: b = 2/h, x~ = x_n + h x'_n/2. Backward differences of order 2 (Gear 1971): b = 3/(2 h), x~
//! = (4 x_n - x_n-1)/3; after a stage of another length h_n, with w = h/h_n: b = (1 + 2 w)/((1 + w) h), x~ = x_n +
//! w^2/(1 + 2 w) (x_n - x_n-1). Trapezoid and backward differences alternating by half steps are the composite method
//! of Bank et al. 1985 and Bathe 2007. Where velocities or forces jump, the past does not predict the future: then one
//! stage of backward Euler is taken, whose local error is of order 2.

use smartbed_runtime::vec3::{Vec3, axpy, sub};

/// An integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Backward Euler, of order 1: strong numerical dissipation.
    BackwardEuler,
    /// The trapezoidal rule, of order 2: conserves the energy of a linear system.
    Trapezoid,
    /// Backward differences, of order 2.
    Bdf2,
    /// A trapezoidal half step, then a half step of backward differences; of order 2.
    TrBdf2,
}

/// The formula of one stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Formula {
    /// b (1/s).
    pub rate: f64,
    /// Length of the stage (s).
    pub seconds: f64,
    kind: Kind,
    /// Velocities or forces have jumped at the start of the stage.
    pub is_anew: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Euler,
    Trapezoid,
    /// Length of the stage divided by that of the stage before.
    Differences(f64),
}

impl Method {
    /// All methods, with their names in plans.
    pub const ALL: [(&'static str, Method); 4] = [
        ("backward_euler", Method::BackwardEuler),
        ("trapezoid", Method::Trapezoid),
        ("bdf2", Method::Bdf2),
        ("tr_bdf2", Method::TrBdf2),
    ];

    /// Number of stages per step.
    #[must_use]
    pub fn stages(self) -> usize {
        if self == Method::TrBdf2 { 2 } else { 1 }
    }

    /// The formula of the next stage, `done` stages after the start.
    #[must_use]
    pub fn formula(self, step: f64, done: usize) -> Formula {
        let kind = match self {
            Method::BackwardEuler => Kind::Euler,
            Method::Trapezoid => Kind::Trapezoid,
            // The first step has no earlier position to difference with.
            Method::Bdf2 if done == 0 => Kind::Trapezoid,
            Method::Bdf2 => Kind::Differences(1.0),
            Method::TrBdf2 if done.is_multiple_of(2) => Kind::Trapezoid,
            Method::TrBdf2 => Kind::Differences(1.0),
        };
        let seconds = step / self.stages() as f64;
        Formula::of(kind, seconds)
    }
}

impl Formula {
    fn of(kind: Kind, seconds: f64) -> Formula {
        let factor = match kind {
            Kind::Euler => 1.0,
            Kind::Trapezoid => 2.0,
            Kind::Differences(ratio) => (1.0 + 2.0 * ratio) / (1.0 + ratio),
        };
        Formula { rate: factor / seconds, seconds, kind, is_anew: false }
    }

    /// The formula for a stage that follows one of another length (s).
    #[must_use]
    pub fn behind(self, seconds: f64) -> Formula {
        match self.kind {
            Kind::Differences(_) => Formula::of(Kind::Differences(self.seconds / seconds), self.seconds),
            _ => self,
        }
    }

    /// The formula for a stage of the same length that uses nothing from before its start.
    #[must_use]
    pub fn anew(self) -> Formula {
        Formula { is_anew: true, ..Formula::of(Kind::Euler, self.seconds) }
    }

    /// Weights of the values at the start and at the end in a mean over the stage.
    #[must_use]
    pub fn means(&self) -> [f64; 2] {
        if self.is_anew { [0.0, 1.0] } else { [0.5, 0.5] }
    }

    /// x~ - x_n, from x'_n and x_n - x_n-1.
    #[must_use]
    pub fn ahead(&self, rate: Vec3<f64>, way: Vec3<f64>) -> Vec3<f64> {
        [0, 1, 2].map(|k| self.ahead_of(rate[k], way[k]))
    }

    /// [`Self::ahead`] for a scalar.
    #[must_use]
    pub fn ahead_of(&self, rate: f64, way: f64) -> f64 {
        match self.kind {
            Kind::Euler => 0.0,
            Kind::Trapezoid => 0.5 * self.seconds * rate,
            Kind::Differences(ratio) => way * (ratio * ratio) / (1.0 + 2.0 * ratio),
        }
    }
}

/// A point mass in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// Position (m).
    pub place: Vec3<f64>,
    /// Velocity (m/s).
    pub velocity: Vec3<f64>,
    /// Acceleration (m/s^2).
    pub acceleration: Vec3<f64>,
    /// Changes over the last stage: of the position (m) and of the velocity (m/s).
    pub change: [Vec3<f64>; 2],
}

impl Track {
    /// A point at rest, with an acceleration.
    #[must_use]
    pub fn at_rest(place: Vec3<f64>, acceleration: Vec3<f64>) -> Track {
        Track { place, velocity: [0.0; 3], acceleration, change: [[0.0; 3]; 2] }
    }

    /// x~, the position at which the formula gives velocity 0.
    #[must_use]
    pub fn resting(&self, formula: &Formula) -> Vec3<f64> {
        axpy(self.place, 1.0, formula.ahead(self.velocity, self.change[0]))
    }

    /// v~, the velocity at which the formula gives acceleration 0.
    fn steady(&self, formula: &Formula) -> Vec3<f64> {
        axpy(self.velocity, 1.0, formula.ahead(self.acceleration, self.change[1]))
    }

    /// x^ = x~ + v~/b; the acceleration at the end is b^2 (x - x^).
    #[must_use]
    pub fn expected(&self, formula: &Formula) -> Vec3<f64> {
        axpy(self.resting(formula), 1.0 / formula.rate, self.steady(formula))
    }

    /// The position at the end if the velocity were constant.
    #[must_use]
    pub fn onwards(&self, formula: &Formula) -> Vec3<f64> {
        axpy(self.place, formula.seconds, self.velocity)
    }

    /// The point with an impact that will change its velocity by `gain` in `ahead` seconds: shifted as if it had always
    /// had the new velocity and arrived at the same place at that time. `stage` is the length of the last stage (s).
    #[must_use]
    pub fn struck(&self, gain: Vec3<f64>, ahead: f64, stage: f64) -> Track {
        let change = [axpy(self.change[0], stage, gain), self.change[1]];
        let place = axpy(self.place, -ahead, gain);
        Track { place, velocity: axpy(self.velocity, 1.0, gain), change, ..*self }
    }

    /// The point at the end of a stage, at this position.
    #[must_use]
    pub fn after(&self, formula: &Formula, place: Vec3<f64>) -> Track {
        let derivative = |x: Vec3<f64>, tilde: Vec3<f64>| sub(x, tilde).map(|d| formula.rate * d);
        let velocity = derivative(place, self.resting(formula));
        let acceleration = derivative(velocity, self.steady(formula));
        let change = [sub(place, self.place), sub(velocity, self.velocity)];
        Track { place, velocity, acceleration, change }
    }
}
