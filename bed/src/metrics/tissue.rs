//! Published models of tissue tolerance over time; they describe a load history and are no diagnosis.
//!
//! In: pressures (Pa) and times (s). Out: critical pressures and times, shares of them, doses. Interface pressure is
//! not the stress in tissue; the caller chooses the factor between them.

use crate::map::{MMHG, Recording};

/// Reswick and Rogers 1976: allowed product of pressure and time, about 300 mmHg h. Known to be wrong for short and
/// very long times.
pub const RESWICK_ROGERS: f64 = 300.0 * MMHG * 3600.0;

/// Margin to that hyperbola, 1 - PTI/K, for a pressure-time integral (Pa s).
#[must_use]
pub fn reswick_rogers_margin(pressure_time: f64) -> f64 {
    1.0 - pressure_time / RESWICK_ROGERS
}

/// Critical pressure of muscle over time: P(t) = K/(1 + exp(alpha (t - t0))) + C.
///
/// Linder-Ganz et al., J Biomech 39 (2006) 2725-2732, of rats: K = 23 kPa, C = 9 kPa, t0 = 90 min, alpha = 0.15/min.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigmoid {
    /// K (Pa): total decrease of the critical pressure.
    pub fall: f64,
    /// C (Pa): pressure that is tolerated for any time.
    pub floor: f64,
    /// t0 (s).
    pub middle: f64,
    /// alpha (1/s).
    pub rate: f64,
}

impl Default for Sigmoid {
    fn default() -> Self {
        Sigmoid { fall: 23e3, floor: 9e3, middle: 90.0 * 60.0, rate: 0.15 / 60.0 }
    }
}

impl Sigmoid {
    /// Critical pressure (Pa) after a time (s).
    #[must_use]
    pub fn pressure(&self, time: f64) -> f64 {
        self.fall / (1.0 + (self.rate * (time - self.middle)).exp()) + self.floor
    }

    /// Time (s) after which a pressure (Pa) in muscle is critical: t0 + ln(K/(P - C) - 1)/alpha; infinite below C, 0
    /// above the pressure that is critical at once.
    #[must_use]
    pub fn time(&self, pressure: f64) -> f64 {
        let over = pressure - self.floor;
        if over <= 0.0 {
            return f64::INFINITY;
        }
        if over >= self.fall {
            return 0.0;
        }
        (self.middle + (self.fall / over - 1.0).ln() / self.rate).max(0.0)
    }

    /// Largest share of the critical time that each site has been loaded: sum dt/t_crit(factor p), restarted whenever
    /// the site is free of contact. Under constant load it is t/t_crit; from 1 on it is critical.
    #[must_use]
    pub fn shares(&self, recording: &Recording, contact: f64, factor: f64) -> Vec<f64> {
        let site = |i: usize| {
            let (mut share, mut worst) = (0.0_f64, 0.0_f64);
            for frame in recording.frames() {
                let pressure = frame.pressure[i];
                share = if pressure > contact {
                    share + frame.seconds / self.time(factor * pressure)
                } else {
                    0.0
                };
                worst = worst.max(share);
            }
            worst
        };
        (0..recording.sites().len()).map(site).collect()
    }
}

/// Dose with recovery: dD/dt = max(0, p - p0)^a/K - D/tau. The form is in use (pmonitor), the constants are not
/// measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dose {
    /// p0 (Pa): harmless pressure.
    pub harmless: f64,
    /// a.
    pub exponent: f64,
    /// K (Pa^a s): gives dose 1 in one second.
    pub scale: f64,
    /// tau (s): recovery time.
    pub recovery: f64,
}

impl Default for Dose {
    /// Dose 1 after an hour at 60 mmHg with 32 mmHg harmless; recovery time one hour.
    fn default() -> Self {
        Dose { harmless: 32.0 * MMHG, exponent: 1.0, scale: 28.0 * MMHG * 3600.0, recovery: 3600.0 }
    }
}

impl Dose {
    /// Largest dose of each site; each frame is solved exactly: D -> D_e + (D - D_e) exp(-dt/tau), D_e = tau x rate.
    #[must_use]
    pub fn largest(&self, recording: &Recording) -> Vec<f64> {
        let site = |i: usize| {
            let (mut dose, mut most) = (0.0_f64, 0.0_f64);
            for frame in recording.frames() {
                let rate = (frame.pressure[i] - self.harmless).max(0.0).powf(self.exponent) / self.scale;
                let end = rate * self.recovery;
                dose = end + (dose - end) * (-frame.seconds / self.recovery).exp();
                most = most.max(dose);
            }
            most
        };
        (0..recording.sites().len()).map(site).collect()
    }
}
