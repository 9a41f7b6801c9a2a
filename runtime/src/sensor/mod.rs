//! Sensors: what a controller reads, delayed, quantised and noisy, reproducible from a seed.
//!
//! In: a quantity at times in whole ticks. Out: the reading available at a tick.
//! ```text
//! quantity -> transducer (`kinds`) -> + bias + drift + noise -> quantised -> range -> sampled every period -> held, delayed
//! ```
//! Sensors only observe: nothing here can change the state of what is measured. Time is counted in ticks and noise by
//! sample (`noise`), so neither step size nor order of calls changes a reading.

pub mod kinds;
pub mod noise;

use crate::real::Scalar;
use noise::Noise;

/// Sampling and errors of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel<S> {
    /// Ticks from sample to sample, > 0.
    pub period: u32,
    /// Ticks from a sample to its reading.
    pub delay: u32,
    /// Standard deviation of the noise of one sample.
    pub noise: S,
    /// Standard deviation of the constant bias of sensors of this kind.
    pub bias: S,
    /// Change of the reading per period.
    pub drift: S,
    /// Step of quantisation; 0 for none.
    pub resolution: S,
    /// Smallest and largest reading.
    pub range: [S; 2],
}

/// Why a channel is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChannelFault {
    /// The period must be one tick or more.
    NoPeriod,
    /// The delay needs more pending samples than there is room for: at most (`DEPTH` - 1) periods.
    TooLate,
    /// Noise, bias and resolution must be 0 or more and finite, drift finite, the range not empty.
    OutOfRange,
}

/// A sensor in operation, with samples taken but not yet shown: at most `DEPTH`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor<S, const DEPTH: usize> {
    channel: Channel<S>,
    source: Noise,
    bias: S,
    shows_first: bool,
    memory: Remembered<S, DEPTH>,
}

/// Memory of a sensor: everything that is needed to resume it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remembered<S, const DEPTH: usize> {
    /// Accumulated drift.
    pub drifted: S,
    /// Number of the last sample.
    pub last: Option<u64>,
    /// Samples not yet shown, newest first: (tick at which each is shown, reading).
    pub pending: [Option<(u64, S)>; DEPTH],
    /// The reading shown now.
    pub shown: S,
}

impl<S: Scalar, const DEPTH: usize> Sensor<S, DEPTH> {
    /// A sensor that shows `start` until its first sample appears; the same seed makes the same sensor.
    ///
    /// # Errors
    /// [`ChannelFault`].
    pub fn new(channel: Channel<S>, seed: u64, start: S) -> Result<Sensor<S, DEPTH>, ChannelFault> {
        if channel.period == 0 {
            return Err(ChannelFault::NoPeriod);
        }
        let room = u64::from(channel.period) * (DEPTH as u64).saturating_sub(1);
        if DEPTH == 0 || u64::from(channel.delay) > room {
            return Err(ChannelFault::TooLate);
        }
        let [low, high] = channel.range;
        let sizes = [channel.noise, channel.bias, channel.resolution];
        let are_sizes = sizes.iter().all(|x| *x >= S::ZERO && x.is_finite());
        if !(are_sizes && channel.drift.is_finite() && low <= high) {
            return Err(ChannelFault::OutOfRange);
        }
        let source = Noise::new(seed);
        let bias = channel.bias * source.normal(u64::MAX);
        let pending = [None; DEPTH];
        let memory = Remembered { drifted: S::ZERO, last: None, pending, shown: start };
        Ok(Sensor { channel, source, bias, shows_first: false, memory })
    }

    /// The same sensor, but its first sample is shown at once, whatever the delay: as if the quantity had been constant
    /// before.
    #[must_use]
    pub fn showing_first(self) -> Self {
        Sensor { shows_first: true, ..self }
    }

    /// Its memory.
    #[must_use]
    pub fn memory(&self) -> &Remembered<S, DEPTH> {
        &self.memory
    }

    /// Resumes from the memory of a sensor with the same channel and seed.
    pub fn resume(&mut self, memory: Remembered<S, DEPTH>) {
        self.memory = memory;
    }

    /// Updates the sensor with the quantity at a tick; it takes a sample if one is due. Call it at least once per
    /// period: of missed samples only the last is taken.
    pub fn observe(&mut self, tick: u64, quantity: S) {
        self.appear(tick);
        let number = tick / u64::from(self.channel.period);
        let is_first = self.memory.last.is_none();
        let missed = match self.memory.last {
            Some(last) if number <= last => return,
            Some(last) => number - last,
            None => 0,
        };
        self.memory.drifted = self.memory.drifted + self.channel.drift * noise::whole::<S>(missed);
        self.memory.last = Some(number);
        let reading = self.read(number, quantity);
        if is_first && self.shows_first {
            self.memory.shown = reading;
        }
        self.memory.pending.rotate_right(1);
        if let Some(newest) = self.memory.pending.first_mut() {
            *newest = Some((tick.saturating_add(u64::from(self.channel.delay)), reading));
        }
        self.appear(tick);
    }

    /// The reading at a tick.
    pub fn reading(&mut self, tick: u64) -> S {
        self.appear(tick);
        self.memory.shown
    }

    /// Shows the newest sample that is due by now, and drops it and older ones from the list.
    fn appear(&mut self, tick: u64) {
        let due = |sample: &Option<(u64, S)>| sample.is_some_and(|(at, _)| at <= tick);
        let Some(newest) = self.memory.pending.iter().position(due) else { return };
        if let Some(Some((_, reading))) = self.memory.pending.get(newest) {
            self.memory.shown = *reading;
        }
        self.memory.pending.iter_mut().skip(newest).for_each(|sample| *sample = None);
    }

    fn read(&self, number: u64, quantity: S) -> S {
        let Channel { noise, resolution, range: [low, high], .. } = self.channel;
        let exact = quantity + self.bias + self.memory.drifted;
        let noisy = if noise > S::ZERO { exact + noise * self.source.normal(number) } else { exact };
        quantised(noisy, resolution).max(low).min(high)
    }
}

/// The nearest whole multiple of a step; the value itself if the step is 0.
#[must_use]
pub fn quantised<S: Scalar>(value: S, step: S) -> S {
    if step > S::ZERO { nearest_whole(value / step) * step } else { value }
}

/// The nearest whole number, halves to even: adds and subtracts a number so large that no fraction fits.
fn nearest_whole<S: Scalar>(x: S) -> S {
    let shift = S::from_f64(1.5) / S::EPSILON;
    if x.abs() < S::from_f64(0.25) / S::EPSILON { (x + shift) - shift } else { x }
}
