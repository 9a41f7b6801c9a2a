//! The data of what observes a world and acts on it in samples: sensors and controllers, as the scene describes them.

use smartbed_codegen::model::unit::Unit;

/// A sensor: the value of the rows that it reads, and its errors (in the unit of that value).
#[derive(Clone, PartialEq, Debug)]
pub struct Sensing {
    /// Its name.
    pub name: String,
    /// The column that it reads.
    pub of: String,
    /// Unit of the scene's numbers in quotes; `None` if it names none.
    pub unit: Option<Unit>,
    /// The transformation of the quantity before it is sampled.
    pub transducer: Transducer,
    /// Sampling period (s); `None` for one step.
    pub period: Option<f64>,
    /// Delay between a sample and its reading (s).
    pub delay: f64,
    /// Standard deviation of the noise of a sample.
    pub noise: f64,
    /// Standard deviation of the bias.
    pub bias: f64,
    /// Change of the reading per period.
    pub drift: f64,
    /// Resolution of the reading.
    pub resolution: f64,
    /// Least and largest reading.
    pub range: [f64; 2],
    /// Seed of noise and bias: equal seeds give equal readings.
    pub seed: u64,
}

/// A controller: PI with limits; its output is held between samples.
#[derive(Clone, PartialEq, Debug)]
pub struct Controlling {
    /// Its name.
    pub name: String,
    /// The column, or `sensors.NAME`, that it reads.
    pub reads: String,
    /// Unit of the scene's targets in quotes; `None` if it names none.
    pub unit: Option<Unit>,
    /// The input that it drives.
    pub drives: String,
    /// Sampling period (s).
    pub period: f64,
    /// Times (s), in ascending order, and the targets from then on, in the unit of the value that it reads.
    pub target: Vec<[f64; 2]>,
    /// Output per error.
    pub gain: f64,
    /// Output per error and second.
    pub integral: f64,
    /// Output at zero error.
    pub bias: f64,
    /// Least and largest output.
    pub limits: [f64; 2],
}

impl Controlling {
    /// The target at a time (piecewise constant).
    #[must_use]
    pub fn target_at(&self, t: f64) -> f64 {
        // A sample belongs to the time of its step, despite rounding.
        let now = t + 1e-9 * self.period;
        self.target.iter().take_while(|[from, _]| *from <= now).last().map_or(0.0, |[_, value]| *value)
    }
}

/// How a quantity is transformed before it is sampled.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Transducer {
    /// No transformation.
    Plain,
    /// A displacement with a nonlinear characteristic.
    Lvdt {
        /// Half of its range.
        reach: f64,
        /// Largest deviation as a fraction of the reach.
        linearity: f64,
    },
    /// A pressure with first-order lag.
    Pressure {
        /// Time constant (s).
        lag: f64,
    },
    /// 1 beyond a threshold, else 0.
    Switch {
        /// Value above which it closes.
        closes: f64,
        /// It opens at this distance below that value.
        hysteresis: f64,
        /// Time for which its contact chatters (s).
        chatter: f64,
    },
}
