//! Sensors: what a controller sees of the world, late, coarse and noisy, and the same again from the same seed.
//!
//! In: a quantity at times in whole ticks. Out: the reading that is there at a tick.
//! ```text
//! quantity -> transducer (`kinds`) -> + bias + drift + noise -> range -> quantised -> sampled every period -> held, delayed
//! ```
//! Sensors observe: nothing here can change the state of what is observed. Time is counted in ticks, noise by sample
//! (`noise`), so that neither step size nor order of calls changes a reading.

pub mod kinds;
pub mod noise;

use crate::real::Scalar;
use noise::Noise;

/// How a channel samples and how wrong it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel<S> {
    /// Ticks from sample to sample, > 0.
    pub period: u32,
    /// Ticks from a sample to its reading.
    pub delay: u32,
    /// Standard deviation of the noise of one sample.
    pub noise: S,
    /// Standard deviation of the bias that a sensor of this make has for good.
    pub bias: S,
    /// Change of the reading per period.
    pub drift: S,
    /// Step of the reading; 0 for none.
    pub resolution: S,
    /// Smallest and largest reading.
    pub range: [S; 2],
}

/// Why a channel is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChannelFault {
    /// The period must be one tick or more.
    NoPeriod,
    /// The delay takes more samples on their way than there is room for: at most (`DEPTH` - 1) periods.
    TooLate,
    /// Noise, bias and resolution must be 0 or more, the range not empty.
    OutOfRange,
}

/// A sensor at work: what it has sampled and not yet shown. `DEPTH` samples may be on their way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor<S, const DEPTH: usize> {
    channel: Channel<S>,
    source: Noise,
    bias: S,
    memory: Remembered<S, DEPTH>,
}

/// What a sensor remembers: all that a run goes on from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remembered<S, const DEPTH: usize> {
    /// Sum of the drift.
    pub drifted: S,
    /// Number of the last sample.
    pub last: Option<u64>,
    /// Readings on their way, with their ticks of appearance, the newest first.
    pub pending: [Option<(u64, S)>; DEPTH],
    /// What is shown.
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
        if !(sizes.iter().all(|x| *x >= S::ZERO) && low <= high) {
            return Err(ChannelFault::OutOfRange);
        }
        let source = Noise::new(seed);
        let bias = channel.bias * source.normal(u64::MAX);
        let pending = [None; DEPTH];
        let memory = Remembered { drifted: S::ZERO, last: None, pending, shown: start };
        Ok(Sensor { channel, source, bias, memory })
    }

    /// What it remembers.
    #[must_use]
    pub fn memory(&self) -> &Remembered<S, DEPTH> {
        &self.memory
    }

    /// Goes on from what one of the same channel and seed remembered.
    pub fn resume(&mut self, memory: Remembered<S, DEPTH>) {
        self.memory = memory;
    }

    /// Shows the sensor the quantity at a tick; it takes a sample if one is due. To be called once a period at least:
    /// of samples that were missed the last alone is taken.
    pub fn observe(&mut self, tick: u64, quantity: S) {
        self.appear(tick);
        let number = tick / u64::from(self.channel.period);
        let missed = match self.memory.last {
            Some(last) if number <= last => return,
            Some(last) => number - last,
            None => 0,
        };
        self.memory.drifted = self.memory.drifted + self.channel.drift * noise::whole::<S>(missed);
        self.memory.last = Some(number);
        let reading = self.read(number, quantity);
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

    /// The newest sample that is there by now replaces what is shown; it and older ones are done with.
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
        quantised(noisy.max(low).min(high), resolution)
    }
}

/// The nearest whole multiple of a step; the value itself if the step is 0.
#[must_use]
pub fn quantised<S: Scalar>(value: S, step: S) -> S {
    if step > S::ZERO { nearest_whole(value / step) * step } else { value }
}

/// The nearest whole number, halves to even: adding and taking away what leaves no room for a fraction.
fn nearest_whole<S: Scalar>(x: S) -> S {
    let shift = S::from_f64(1.5) / S::EPSILON;
    if x.abs() < S::from_f64(0.25) / S::EPSILON { (x + shift) - shift } else { x }
}
