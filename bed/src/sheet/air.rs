//! The air under a sheet: at a regulated pressure, or sealed, with a gas law.
//!
//! In: a volume. Out: energy, gauge pressure and stiffness n p/V, all by the runtime's gas.

use smartbed_runtime::gas::{Chamber, Gas, GasState, Source};

/// Ambient pressure (Pa).
pub const AMBIENT: f64 = 101_325.0;

/// The state of the air in a chamber.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Air {
    /// A regulator keeps this gauge pressure (Pa).
    Regulated(f64),
    /// Valves are shut.
    Sealed(Chamber<f64>, GasState<f64>),
}

/// A volume (m^3) at which there is no air left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapsed(pub f64);

impl Air {
    /// Seals air at a gauge pressure (Pa) and a volume (m^3); the polytropic exponent is 1 for slow changes, 1.4 for
    /// fast ones.
    #[must_use]
    pub fn sealed(gauge: f64, volume: f64, exponent: f64) -> Air {
        let chamber = Chamber { gas: Gas::air(), exponent, reference_volume: volume, ambient: AMBIENT };
        let inside = Source { pressure: AMBIENT + gauge, temperature: 293.15 };
        Air::Sealed(chamber, chamber.filled(inside, volume))
    }

    /// Gauge pressure (Pa).
    ///
    /// # Errors
    /// [`Collapsed`].
    pub fn gauge(&self, volume: f64) -> Result<f64, Collapsed> {
        match self {
            Air::Regulated(gauge) => Ok(*gauge),
            Air::Sealed(chamber, state) => {
                chamber.gauge_pressure(state, volume).map_err(|_| Collapsed(volume))
            }
        }
    }

    /// -dp/dV (Pa/m^3).
    ///
    /// # Errors
    /// [`Collapsed`].
    pub fn stiffness(&self, volume: f64) -> Result<f64, Collapsed> {
        match self {
            Air::Regulated(_) => Ok(0.0),
            Air::Sealed(chamber, state) => chamber.stiffness(state, volume).map_err(|_| Collapsed(volume)),
        }
    }

    /// Energy (J), whose derivative with respect to the volume is minus the gauge pressure.
    ///
    /// # Errors
    /// [`Collapsed`].
    pub fn energy(&self, volume: f64) -> Result<f64, Collapsed> {
        match self {
            Air::Regulated(gauge) => Ok(-gauge * volume),
            Air::Sealed(chamber, state) => chamber.potential(state, volume).map_err(|_| Collapsed(volume)),
        }
    }
}
